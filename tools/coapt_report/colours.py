"""Which fields are shown in which colours, and over which range."""

import base64

import matplotlib
import numpy
from vtk.util.numpy_support import vtk_to_numpy

from .run import cell_array, point_array, points_of


class Field:
    """A quantity on the leaflet, with its colours and unit."""

    def __init__(self, name, title, unit, factor, table):
        self.name, self.title, self.unit = name, title, unit
        self.factor, self.table = factor, table

    def colours(self, n=33):
        """RGB bytes of the colour table, from its low to its high end."""
        table = matplotlib.colormaps[self.table]
        return (255 * table(numpy.linspace(0.02, 0.92, n))[:, :3]).round(
        ).astype(numpy.uint8)

    def gradient(self):
        """The colour table in CSS."""
        return "linear-gradient(to right, " + ", ".join(
            "rgb(%d, %d, %d)" % tuple(colour)
            for colour in self.colours(9)) + ")"

    def encoded(self):
        """The colour table for the interactive view."""
        return base64.b64encode(self.colours().tobytes()).decode()

    def on_points(self, grid):
        """Values on the points of a leaflet, in the unit shown; None if the
        grid lacks them. Values of cells are averaged over neighbours: single
        tetrahedra alternate with their orientation."""
        values = point_array(grid, self.name)
        if values is None:
            cells = cell_array(grid, self.name)
            if cells is None:
                return None
            values = smooth(grid, cells)
        return values / self.factor


STRESS = Field("von_mises", "Von Mises stress", "kPa", 1e3, "YlOrRd")
PRINCIPAL = Field("max_principal_stress", "Largest principal stress", "kPa",
                  1e3, "YlOrRd")
STRAIN = Field("max_log_strain", "Largest principal logarithmic strain", "",
               1, "YlGnBu")
TRACTION = Field("coaptation_pressure", "Coaptation pressure", "kPa", 1e3,
                 "BuPu")
SPEED = Field("velocity", "Speed of the blood", "m/s", 1, "viridis")
CONTACT = Field("contact_pressure", "Contact pressure", "kPa", 1e3, "BuPu")
FIELDS = (STRESS, PRINCIPAL, STRAIN, TRACTION, CONTACT)


def tetrahedra(grid):
    """Corner numbers of the cells of a leaflet."""
    return vtk_to_numpy(
        grid.GetCells().GetConnectivityArray()).reshape(-1, 4)


def smooth(grid, values):
    """Point values of two passes of averages."""
    once = average_to_points(grid, values)
    return average_to_points(grid, once[tetrahedra(grid)].mean(axis=1))


def average_to_points(grid, values):
    """Means over the cells around each point, by volume."""
    cells, points = tetrahedra(grid), points_of(grid)
    edges = points[cells[:, 1:]] - points[cells[:, :1]]
    weights = numpy.repeat(numpy.abs(numpy.linalg.det(edges)), 4)
    nodes = cells.ravel()
    sums = numpy.bincount(nodes, weights * numpy.repeat(values, 4),
                          len(points))
    return sums / numpy.bincount(nodes, weights, len(points))


def common_ranges(runs):
    """Range of each field that suits all runs when closed: from zero to the
    value that 2 % of the points exceed."""
    ranges = {}
    for field in FIELDS:
        tops = []
        for run in runs:
            values = field.on_points(run.fields("leaflet"))
            if values is not None:
                tops.append(numpy.percentile(values, 98))
        if tops:
            ranges[field] = round_up(max(tops))
    return ranges


def round_up(value):
    """The next of 1, 1.5, 2, 3, 4, 5, 6, 8 times a power of ten."""
    if not value > 0:
        return 1.
    power = 10.**numpy.floor(numpy.log10(value))
    for step in (1, 1.5, 2, 3, 4, 5, 6, 8, 10):
        if value <= step * power * (1 + 1e-9):
            return step * power
    return 10 * power
