"""Diagrams and tables of the closed valve: the contact map, the belt of
coaptation, stress by region."""

import numpy
import vtk
from matplotlib import pyplot
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from . import pictures, plots
from .colours import TRACTION, round_up
from .run import cell_array, point_array, points_of

LEAFLETS = ("Anterior", "Posterior")
SEGMENTS = ("A1", "A2", "A3", "P1", "P2", "P3")
ANTERIOR, POSTERIOR, COMMISSURE = 0, 1, 2
NO_GAP = .999e-2  # m; the gap of what faces nothing is 1e-2
REGIONS = ("anterior", "posterior", "commissures")


def map_of(run):
    """The unrolled leaflet of a run as a VTK grid; None if there is none."""
    if not run.has("contact_map.vtu"):
        return None
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(run.path("contact_map.vtu"))
    reader.Update()
    return reader.GetOutput()


def triangles_of(grid):
    """Corner numbers of the triangles of a grid."""
    return vtk_to_numpy(
        grid.GetCells().GetConnectivityArray()).reshape(-1, 3)


def pressure_range(runs):
    """Range of the coaptation pressure (kPa) that suits all runs."""
    tops = [numpy.percentile(point_array(grid, TRACTION.name)[
        point_array(grid, "coapts") > 0] / 1e3, 98)
        for grid in map(map_of, runs)
        if grid is not None and (point_array(grid, "coapts") > 0).any()]
    return round_up(max(tops, default=1.))


def belt_actor(run, region, top):
    """The deformed mid-surface of one region and the commissures, coloured by
    the pressure of coaptation."""
    grid, table = map_of(run), run.table("contact_map.csv")
    chosen = numpy.isin(cell_array(grid, "region"), (region, COMMISSURE))
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(numpy.column_stack(
        [1e-3 * table[f"{d}_mm"] for d in "xyz"]), deep=True))
    cells = vtk.vtkCellArray()
    for triangle in triangles_of(grid)[chosen]:
        cells.InsertNextCell(3, [int(corner) for corner in triangle])
    surface = vtk.vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(cells)
    values = numpy_to_vtk(numpy.ascontiguousarray(
        table["coaptation_pressure_kPa"] * (table["coapts"] > 0)), deep=True)
    values.SetName("shown")
    surface.GetPointData().AddArray(values)
    whole = vtk.vtkCleanPolyData()  # the map is cut open
    whole.SetInputData(surface)
    whole.ToleranceIsAbsoluteOn()
    whole.SetAbsoluteTolerance(1e-8)
    whole.Update()
    return pictures.surface_actor(whole.GetOutput(), TRACTION, top)


def belt_pictures(run, top):
    """The belt of coaptation on the closed leaflets, each seen from the other
    one: pairs of caption and data URL."""
    return [(f"The {name} leaflet, seen from the {other} one: belt of "
             "coaptation and its pressure",
             pictures.picture([belt_actor(run, region, top)], look))
            for name, other, region, look in (
                ("anterior", "posterior", ANTERIOR, pictures.FROM_POSTERIOR),
                ("posterior", "anterior", POSTERIOR, pictures.FROM_ANTERIOR))]


def draw_outline(ax, points, triangles, region):
    """The borders of the regions."""
    edges = {}
    for triangle, number in zip(triangles, region):
        for i in range(3):
            edge = tuple(sorted((triangle[i], triangle[(i + 1) % 3])))
            edges.setdefault(edge, []).append(number)
    for (a, b), numbers in edges.items():
        if len(numbers) == 1 or numbers[0] != numbers[1]:
            ax.plot(points[[a, b], 0], points[[a, b], 1], color="#999",
                    linewidth=.7)


def map_values(grid, name):
    """What a map shows of a quantity: pressure where there is coaptation, the
    gap where something faces the place."""
    values = point_array(grid, name)
    if name == TRACTION.name:
        return values * (point_array(grid, "coapts") > 0)
    if name == "gap":
        return numpy.where(values < NO_GAP, values, numpy.nan)
    return values


def map_figure(run, name, title, factor, table, bottom, top):
    """A quantity on the unrolled leaflet; blank where it is no number."""
    grid = map_of(run)
    points, triangles = 1e3 * points_of(grid), triangles_of(grid)
    values = map_values(grid, name) / factor
    figure, axes = pyplot.subplots(figsize=(5.6, 2.2), layout="constrained")
    shown = axes.tripcolor(points[:, 0], points[:, 1], triangles,
                           numpy.nan_to_num(values), cmap=table,
                           mask=numpy.isnan(values)[triangles].any(axis=1),
                           vmin=bottom, vmax=top, shading="gouraud",
                           rasterized=True)
    draw_outline(axes, points, triangles, cell_array(grid, "region"))
    figure.colorbar(shown, label=title, location="bottom", shrink=.6,
                    aspect=25)
    axes.set_aspect("equal")
    axes.grid(False)
    axes.set_xlabel("mm around the annulus from mid-anterior")
    axes.set_ylabel("height, mm")
    return plots.encoded(figure, dpi=150)


def belt_figure(runs):
    """Height in contact and apposition by position along each leaflet."""
    figure, axes = plots.figure_of(2, 1, 3.8, sharex=True, sharey=True)
    for i, run in enumerate(runs):
        table = run.table("coaptation.csv")
        if table is None:
            continue
        for leaflet, ax in enumerate(axes[:, 0]):
            chosen = table["leaflet"] == leaflet
            position = table["position"][chosen]
            ax.plot(position, table["contact_height_mm"][chosen],
                    color=plots.colour_of(i))
            ax.plot(position, table["apposition_mm"][chosen],
                    color=plots.colour_of(i), linestyle=":")
    for leaflet, ax in enumerate(axes[:, 0]):
        ax.set_ylabel(f"{LEAFLETS[leaflet].lower()}, mm")
        ax.set_ylim(bottom=0)
        for border in (1 / 3, 2 / 3):
            ax.axvline(border, color="#bbb", linewidth=.8)
        for k in range(3):
            ax.text((k + .5) / 3, .97, SEGMENTS[3 * leaflet + k], ha="center",
                    va="top", transform=ax.get_xaxis_transform(),
                    color="#888")
    axes[1, 0].set_xlabel("from the left to the right commissure")
    return plots.encoded(figure)


def distribution_figure(runs):
    """Share of the area of coaptation above a pressure."""
    figure, axes = plots.figure_of(height=2.8)
    for i, run in enumerate(runs):
        table = run.table("pressure_distribution.csv")
        if table is None:
            continue
        axes[0, 0].plot(table["pressure_kPa"], 100 * table["share_coaptation"],
                        color=plots.colour_of(i))
        axes[0, 0].plot(table["pressure_kPa"], 100 * table["share_contact"],
                        color=plots.colour_of(i), linestyle=":")
    axes[0, 0].set_xlabel("pressure t, kPa")
    axes[0, 0].set_ylabel("P(pressure > t), %")
    axes[0, 0].set_xlim(left=0)
    return plots.encoded(figure)


def section_places(runs):
    """Where the leaflets of any run are cut: x (mm), from left to right."""
    places = set()
    for run in runs:
        table = run.table("sections.csv")
        if table is not None:
            places |= set(numpy.round(table["x_mm"], 3) + 0.)
    return sorted(places)


def draw_section(ax, table, x, closed, **style):
    """The curves in which one plane cuts the leaflets."""
    chosen = ((numpy.abs(table["x_mm"] - x) < 1e-3) &
              (table["closed"] == closed))
    for curve in numpy.unique(table["curve"][chosen]):
        piece = chosen & (table["curve"] == curve)
        ax.plot(table["y_mm"][piece], table["z_mm"][piece], **style)


def section_figure(runs, x):
    """The closed leaflets cut at one place, and the open ones of the first
    run."""
    figure, axes = plots.figure_of(height=3.4)
    ax = axes[0, 0]
    for i, run in enumerate(runs):
        table = run.table("sections.csv")
        if table is None:
            continue
        if i == 0:
            draw_section(ax, table, x, 0, color="#aaa", linestyle="--")
        draw_section(ax, table, x, 1, color=plots.colour_of(i))
    ax.set_aspect("equal")
    ax.set_xlabel("posterior      y, mm      anterior")
    ax.set_ylabel("z, mm")
    return plots.encoded(figure)


def chorda_figure(runs):
    """The largest force of every chorda."""
    names = []
    tables = [run.table("chordae.csv") for run in runs]
    for table in filter(None, tables):
        names += [name for name in table
                  if name != "time_s" and name not in names]
    names.sort()
    figure, axes = plots.figure_of(height=2 + .16 * len(names))
    n = max(1, len(runs))
    for i, table in enumerate(tables):
        if table is None:
            continue
        axes[0, 0].barh(
            numpy.arange(len(names)) + (i - (n - 1) / 2) * .8 / n,
            [table[name].max() if name in table else 0 for name in names],
            .8 / n, color=plots.colour_of(i))
    axes[0, 0].set_yticks(range(len(names)),
                          [name.replace("_N", "") for name in names])
    axes[0, 0].invert_yaxis()
    axes[0, 0].set_xlabel("largest force, N")
    return plots.encoded(figure)


def segment_rows(runs):
    """Rows of the table of segments: name, and for each run the height in
    contact, its least value, and the apposition."""
    rows = []
    for name in SEGMENTS:
        row = [name]
        for run in runs:
            figures = run.summary.get("segments", {}).get(name)
            row += ["–"] * 3 if figures is None else [
                f"{figures[key]:.1f}" for key in (
                    "contact_height_mm", "contact_height_min_mm",
                    "apposition_mm")]
        rows.append(row)
    return rows


def region_rows(runs):
    """Rows of the table of regions."""
    rows = []
    for region in REGIONS:
        rows.append((region.capitalize(),))
        for title, key, pattern in (
                ("Mean von Mises stress, kPa", "stress_mean_kPa", "{:.0f}"),
                ("… exceeded by 5 %, kPa", "stress_95_percent_kPa", "{:.0f}"),
                ("Mean of the largest principal stress, kPa",
                 "principal_stress_mean_kPa", "{:.0f}"),
                ("… exceeded by 5 %, kPa", "principal_stress_95_percent_kPa",
                 "{:.0f}"),
                ("Mean of the largest strain", "strain_mean", "{:.3f}"),
                ("… exceeded by 5 %", "strain_95_percent", "{:.3f}"),
                ("Bulging volume, mL", "bulging_volume_mL", "{:.3f}")):
            row = [title]
            for run in runs:
                value = run.summary.get("regions", {}).get(region, {}).get(key)
                row.append(pattern.format(value)
                           if plots.is_finite(value) else "–")
            rows.append(row)
    return rows


def belt_sentence(run):
    """The verdict of the belt of coaptation: whether a way along it leads
    from commissure to commissure."""
    if run.summary["coaptation_belt_continuous"]:
        return "Belt of coaptation: unbroken from commissure to commissure."
    gaps = run.summary.get("gaps", {})
    number = int(gaps.get("number", 0))
    if number == 0:
        return "Belt of coaptation: broken."
    longest = max(gaps[f"gap_{i + 1}"]["length_mm"] for i in range(number))
    return (f"Belt of coaptation: {number} gap{'s' * (number > 1)}, "
            f"{'the longest ' * (number > 1)}{longest:.1f} mm long.")


def gap_sentences(run):
    """What is said of the gaps in the belt of coaptation."""
    gaps = run.summary.get("gaps", {})
    sentences = []
    for i in range(int(gaps.get("number", 0))):
        gap = gaps[f"gap_{i + 1}"]
        sentences.append(
            f"Gap in the belt of the {gap['leaflet']} leaflet: "
            f"{gap['length_mm']:.1f} mm long, {gap['position_mm']:.1f} mm "
            "along the free edge from the left.")
    return sentences
