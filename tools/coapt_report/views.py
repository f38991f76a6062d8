"""The data of the interactive views."""

import base64
import json

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from .colours import FIELDS
from .run import points_of

MOST_FRAMES = 25


def encoded(array):
    """Base64 of the bytes of an array."""
    return base64.b64encode(numpy.ascontiguousarray(array).tobytes()).decode()


def surface_of(grid):
    """Point numbers on the surface of a leaflet, and its triangles by their
    position in that list."""
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.PassThroughPointIdsOn()
    surface.SetInputData(grid)
    surface.Update()
    output = surface.GetOutput()
    nodes = vtk_to_numpy(output.GetPointData().GetArray("vtkOriginalPointIds"))
    triangles = vtk_to_numpy(output.GetPolys().GetConnectivityArray())
    return nodes, triangles.reshape(-1, 3)


def view_of(run, ranges):
    """All that the view of one run needs."""
    n_times = len(run.times)
    frames = sorted(set(numpy.linspace(
        0, n_times - 1, min(n_times, MOST_FRAMES)).round().astype(int)))
    nodes, triangles = surface_of(run.fields("leaflet", 0))
    positions, chordae = [], []
    fields = {field.name: [] for field in ranges}
    for frame in frames:
        grid = run.fields("leaflet", frame)
        positions.append(1e3 * points_of(grid)[nodes])
        for field, top in ranges.items():
            values = field.on_points(grid)
            if values is None:
                values = numpy.zeros(grid.GetNumberOfPoints())
            fields[field.name].append(
                (255 * numpy.clip(values[nodes] / top, 0, 1)).astype(
                    numpy.uint8))
        chordae.append(1e3 * points_of(run.fields("chordae", frame)))
    positions = numpy.array(positions)
    lower = positions.min(axis=(0, 1))
    upper = positions.max(axis=(0, 1))
    scaled = (positions - lower) / (upper - lower) * 65535
    return {
        "nodes": len(nodes),
        "times": [run.times[frame] for frame in frames],
        "lower": lower.tolist(),
        "upper": upper.tolist(),
        "positions": encoded(scaled.round().astype("<u2")),
        "triangles": encoded(triangles.astype("<u4")),
        "fields": {name: encoded(numpy.array(values))
                   for name, values in fields.items()},
        "n_chordae": len(chordae[0]) // 2,
        "chordae": encoded(numpy.array(chordae, "<f4")),
    }


def view_data(runs, ranges):
    """The JSON text that viewer.js reads."""
    return json.dumps({
        "tables": {field.name: field.encoded() for field in FIELDS},
        "runs": [view_of(run, ranges) for run in runs]})
