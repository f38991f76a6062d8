"""Parts of the report on made-up data with known answers."""

import sys
import types

import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from coapt_report import closure, figures, pictures, plots
from coapt_report.__main__ import times_of

failures = 0


def check(what, condition):
    """Reports one assertion."""
    global failures
    failures += not condition
    print(what + (": ok" if condition else ": FAILED"))


def rotating_blood(n=21, size=.04):
    """Blood that rotates about the z axis with 10 rad/s, on voxels."""
    image = vtk.vtkImageData()
    image.SetDimensions(n, n, n)
    image.SetSpacing(*[size / (n - 1)] * 3)
    image.SetOrigin(*[-size / 2] * 3)
    grid = vtk.vtkAppendFilter()
    grid.AddInputData(image)
    grid.Update()
    grid = grid.GetOutput()
    x = vtk_to_numpy(grid.GetPoints().GetData())
    velocity = numpy_to_vtk(
        numpy.column_stack([-10 * x[:, 1], 10 * x[:, 0], 0 * x[:, 0]]),
        deep=True)
    velocity.SetName("velocity")
    grid.GetPointData().AddArray(velocity)
    return grid


def check_streamlines():
    """Streamlines of a rotation are circles."""
    seeds = [(.005, 0, 0), (0, .012, .004)]
    lines = pictures.streamlines(rotating_blood(), seeds, 1e-6)
    x = vtk_to_numpy(lines.GetPoints().GetData())
    radius = numpy.hypot(x[:, 0], x[:, 1])
    speed = vtk_to_numpy(lines.GetPointData().GetArray("speed"))
    check("streamlines of a rotation are circles",
          len(x) > 20 and numpy.minimum(
              abs(radius - .005), abs(radius - .012)).max() < 1e-4)
    check("their speed is that of the rotation",
          abs(speed - 10 * radius).max() < 1e-5)


def check_cut():
    """The half on the left, and all that is not cut."""
    blood = rotating_blood(4)
    half = pictures.clipped(blood, pictures.half_plane())
    x = [half.GetCell(i).GetBounds()[:2]
         for i in range(half.GetNumberOfCells())]
    check("a cut leaves the left half",
          numpy.allclose((numpy.min(x), numpy.max(x)), (-.02, 0)))
    check("without one all is left", pictures.clipped(blood, None) is blood)


def check_times():
    """Fields nearest to chosen times, or worth a look."""
    times = numpy.array([0., .01, .02, .03])
    run = types.SimpleNamespace(
        times=list(times), summary={"sealed": False},
        statistics={"time_s": times,
                    "outflow_mL_per_s": numpy.array([0., 2., 5., 3.])},
        frame_at=lambda time: int(abs(times - time).argmin()))
    check("times are in milliseconds",
          numpy.allclose(times_of("10, 20.5"), [.01, .0205]))
    check("at the largest flow and at the end",
          [frame for _, frame in pictures.flow_frames(run)] == [2, 3])
    check("at chosen times, each field once",
          [frame for _, frame in pictures.flow_frames(
              run, [.011, .009, .05])] == [1, 3])


def check_volume():
    """What passes the leaflets, with and without drainage."""
    table = {"outflow_volume_mL": numpy.array([1., 3.]),
             "swept_volume_mL": numpy.array([1., 2.])}
    check("volume past the leaflets",
          list(plots.volume_past_leaflets(table)) == [0, 1])
    table["drained_volume_mL"] = numpy.array([0., .5])
    check("with what is drained",
          list(plots.volume_past_leaflets(table)) == [0, 1.5])


def check_leaks():
    """The leak in words."""
    check("a leak, most of it numerical", figures.leak_text(.92, .01) ==
          "The leak is 0.92 mL/s, 0.01 mL/s of it through gaps.")
    check("a leak whose ways are not known",
          figures.leak_text(.92, None) == "The leak is 0.92 mL/s.")
    check("no leak", figures.leak_text(.004, .004).startswith("No leak"))
    check("too short a run", "too short" in figures.leak_text(None, None))


def check_verdicts():
    """A sealed valve with a gap in its belt."""
    gap = {"leaflet": "posterior", "length_mm": 1.34, "position_mm": 20.2}
    summary = {"sealed": True, "closing_time_s": .05, "end_time_s": .1,
               "leak_mL_per_s": .2, "coaptation_area_mm2": 300.,
               "coaptation_belt_continuous": False,
               "widest_path": {}, "gaps": {"number": 1, "gap_1": gap}}
    run = types.SimpleNamespace(summary=summary, in_blood=True)
    sealed, text = figures.verdict(run)
    check("sealed", sealed and "Shut from 50 ms on" in text)
    check("and yet its belt has a gap", closure.belt_sentence(run) ==
          "Belt of coaptation: 1 gap, 1.3 mm long.")
    check("whose place is told", len(closure.gap_sentences(run)) == 1 and
          "20.2 mm along the free edge" in closure.gap_sentences(run)[0])
    summary["gaps"] = {"number": 2, "gap_1": gap,
                       "gap_2": {**gap, "length_mm": 3.}}
    check("the longest of two gaps", closure.belt_sentence(run) ==
          "Belt of coaptation: 2 gaps, the longest 3.0 mm long.")
    del summary["gaps"]
    check("gaps that are not known",
          closure.belt_sentence(run) == "Belt of coaptation: broken.")
    summary["coaptation_belt_continuous"] = True
    check("a belt without a gap", "unbroken" in closure.belt_sentence(run))


def check_regions():
    """Figures by region, of which a run may lack some."""
    summary = {"regions": {"anterior": {
        "stress_mean_kPa": 75.4, "principal_stress_mean_kPa": 72.6,
        "principal_stress_95_percent_kPa": 158.2, "strain_mean": .3086}}}
    rows = closure.region_rows([types.SimpleNamespace(summary=summary)])
    check("figures of the anterior leaflet", rows[:8] == [
        ("Anterior",), ["Mean von Mises stress, kPa", "75"],
        ["… exceeded by 5 %, kPa", "–"],
        ["Mean of the largest principal stress, kPa", "73"],
        ["… exceeded by 5 %, kPa", "158"],
        ["Mean of the largest strain", "0.309"],
        ["… exceeded by 5 %", "–"], ["Bulging volume, mL", "–"]])


def check_sections():
    """All places where leaflets are cut."""
    tables = [{"x_mm": numpy.array([-8.75, -8.75, -0., 8.75])},
              {"x_mm": numpy.array([0., 9.])}, None]
    runs = [types.SimpleNamespace(table=lambda name, t=t: t) for t in tables]
    check("places of sections",
          closure.section_places(runs) == [-8.75, 0, 8.75, 9])


def check_map():
    """The map of the gap is blank where nothing is near."""
    grid = vtk.vtkPolyData()
    for name, values in (("gap", [.001, .01, -.0001]),
                         ("coaptation_pressure", [1e3, 2e3, 3e3]),
                         ("coapts", [1., 0., 1.])):
        array = numpy_to_vtk(numpy.array(values, numpy.float32), deep=True)
        array.SetName(name)
        grid.GetPointData().AddArray(array)
    gap = closure.map_values(grid, "gap")
    check("gap on the map", list(numpy.isnan(gap)) == [False, True, False] and
          abs(gap[0] - .001) < 1e-9)
    check("pressure only where it coapts", list(
        closure.map_values(grid, "coaptation_pressure")) == [1e3, 0, 3e3])


check_streamlines()
check_cut()
check_times()
check_volume()
check_leaks()
check_verdicts()
check_regions()
check_sections()
check_map()
sys.exit(1 if failures else 0)
