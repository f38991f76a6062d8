"""Off-screen pictures of a valve, as data URLs."""

import base64

import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk

from .colours import SPEED, STRAIN, STRESS, round_up
from .run import point_array, points_of

WIDTH, HEIGHT = 900, 760

# Direction towards the camera, its upper side, height of the centre and half
# the height of the picture (m).
ATRIAL = ((0, 0, 1), (0, 1, 0), 0., .0175)
SIDE = ((.45, -1, .3), (0, 0, 1), -.0125, .0215)
FROM_ANTERIOR = ((0, 1, .15), (0, 0, 1), -.0065, .0155)
FROM_POSTERIOR = ((0, -1, .15), (0, 0, 1), -.0065, .0155)
CUT = ((1, 0, 0), (0, 0, 1), -.0115, .0195)


def look_up_table(field, top):
    """The colours of a field from zero to @p top for VTK."""
    table = vtk.vtkLookupTable()
    colours = field.colours(256)
    table.SetNumberOfTableValues(len(colours))
    for i, (red, green, blue) in enumerate(colours):
        table.SetTableValue(i, red / 255, green / 255, blue / 255, 1)
    table.SetRange(0, top)
    return table


def clipped(grid, plane):
    """What a plane leaves of a grid; all of it without a plane."""
    if plane is None:
        return grid
    clip = vtk.vtkClipDataSet()
    clip.SetInputData(grid)
    clip.SetClipFunction(plane)
    clip.Update()
    return clip.GetOutput()


def leaflet_actor(grid, field=None, top=1, plane=None):
    """The leaflet coloured by a field, or plain; cut by a plane if one is
    given."""
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(clipped(with_points_values(grid, field), plane))
    surface.Update()
    return surface_actor(surface.GetOutput(), field, top)


def surface_actor(surface, field, top):
    """A surface with the point data "shown" in the colours of a field, or
    plain."""
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(surface)
    normals.SetFeatureAngle(50)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    if field is None:
        mapper.ScalarVisibilityOff()
        actor.GetProperty().SetColor(.93, .80, .74)
    else:
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray("shown")
        mapper.SetLookupTable(look_up_table(field, top))
        mapper.UseLookupTableScalarRangeOn()
    actor.GetProperty().SetAmbient(.28)
    actor.GetProperty().SetSpecular(.12)
    actor.GetProperty().SetSpecularPower(15)
    return actor


def with_points_values(grid, field):
    """A copy of the grid with the values to show."""
    copy = vtk.vtkUnstructuredGrid()
    copy.CopyStructure(grid)
    if field is not None:
        values = numpy_to_vtk(
            numpy.ascontiguousarray(field.on_points(grid), numpy.float64),
            deep=True)
        values.SetName("shown")
        copy.GetPointData().AddArray(values)
    return copy


def chordae_actor(grid, plane=None):
    """Chordae as tubes, cut like the leaflet."""
    lines = vtk.vtkDataSetSurfaceFilter()
    lines.SetInputData(clipped(grid, plane))
    tubes = vtk.vtkTubeFilter()
    tubes.SetInputConnection(lines.GetOutputPort())
    tubes.SetRadius(2.5e-4)
    tubes.SetNumberOfSides(10)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(tubes.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(.55, .43, .31)
    actor.GetProperty().SetAmbient(.28)
    return actor


def slice_actor(grid, name, table):
    """The fluid on the plane x = 0, coloured by data of its cells. It lies
    behind the cut face of the leaflet."""
    plane = vtk.vtkPlane()
    plane.SetNormal(1, 0, 0)
    plane.SetOrigin(-1e-4, 0, 0)
    cutter = vtk.vtkCutter()
    cutter.SetCutFunction(plane)
    cutter.SetInputData(grid)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(cutter.GetOutputPort())
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray(name)
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    return actor


def picture(actors, look, width=WIDTH, height=HEIGHT):
    """Renders actors; returns a data URL."""
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    add_lamps(renderer)
    direction, up, centre, half_height = look
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(0, 0, centre)
    camera.SetPosition(*(.1 * numpy.array(direction) + (0, 0, centre)))
    camera.SetViewUp(*up)
    renderer.ResetCameraClippingRange()
    camera.SetParallelScale(half_height)

    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(width, height)
    window.AddRenderer(renderer)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkJPEGWriter()  # a third of a PNG
    writer.WriteToMemoryOn()
    writer.SetQuality(90)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
    data = bytes(memoryview(writer.GetResult()))
    return "data:image/jpeg;base64," + base64.b64encode(data).decode()


def add_lamps(renderer):
    """Lamps near whoever looks, so that nothing that is seen is dark."""
    renderer.AutomaticLightCreationOff()
    for position, intensity in (((-.1, .2, 1), .6), ((.7, -.5, .9), .25)):
        lamp = vtk.vtkLight()
        lamp.SetLightTypeToCameraLight()
        lamp.SetPosition(*position)
        lamp.SetFocalPoint(0, 0, 0)
        lamp.SetIntensity(intensity)
        renderer.AddLight(lamp)


def pressure_table(top):
    """Colours of the blood's pressure (Pa)."""
    table = vtk.vtkLookupTable()
    table.SetHueRange(.6, .02)
    table.SetSaturationRange(.45, .55)
    table.SetValueRange(.97, .93)
    table.SetRange(-.05 * top, top)
    table.SetNanColor(.93, .93, .93, 1)
    table.Build()
    return table


def half_plane():
    """Keeps x < 0."""
    plane = vtk.vtkPlane()
    plane.SetNormal(-1, 0, 0)
    return plane


# From where a valve is shown, and how it is cut.
VIEWS = {"from the atrium": (ATRIAL, None),
         "from the posterior side": (SIDE, None),
         "cut through the middle": (CUT, half_plane())}


def valve_picture(run, frame, view, field, top):
    """The leaflets, coloured by a field, and the chordae."""
    look, plane = view
    return picture([leaflet_actor(run.fields("leaflet", frame), field, top,
                                  plane),
                    chordae_actor(run.fields("chordae", frame), plane)], look)


def blood_picture(run, top):
    """The pressure of the blood (Pa) on the cut through the closed valve."""
    return picture([leaflet_actor(run.fields("leaflet"), plane=half_plane()),
                    slice_actor(run.fields("fluid"), "pressure",
                                pressure_table(top))], CUT)


def valve_pictures(run, ranges):
    """Pairs of caption and data URL: the valve open, at the beginning, and
    closed, in the colours of stress and of strain; each from all sides. In
    blood, also the pressure on the cut."""
    time = f"at {1e3 * run.times[-1]:.0f} ms"
    pictures = [
        (f"{title}, {name}",
         valve_picture(run, frame, view, field, ranges[field]))
        for title, frame, field in (
            (f"Open: {STRESS.title}", 0, STRESS),
            (f"Open: {STRAIN.title}", 0, STRAIN),
            (f"{STRESS.title} {time}", -1, STRESS),
            (f"{STRAIN.title} {time}", -1, STRAIN))
        for name, view in VIEWS.items()]
    if run.in_blood:
        top = max(1., float(run.statistics["ventricular_pressure_Pa"].max()))
        pictures.append((f"Pressure of the blood {time}, cut through the "
                         f"middle: blue 0, red {1e-3 * top:.3g} kPa",
                         blood_picture(run, top)))
    return pictures


def fastest_points(grid, n_seeds=100, share=.01):
    """Some of the points where the blood is fastest, spread evenly over that
    share of all, and their speeds."""
    speed = numpy.linalg.norm(point_array(grid, "velocity"), axis=1)
    fast = numpy.flatnonzero(speed >= numpy.quantile(speed, 1 - share))
    seeds = fast[:: max(1, len(fast) // n_seeds)]
    return points_of(grid)[seeds], speed[seeds]


def streamlines(grid, seeds, terminal_speed):
    """Lines along the flow through the seeds, both ways, with the point data
    "velocity" and "speed"."""
    cloud = vtk.vtkPolyData()
    points = vtk.vtkPoints()
    for seed in seeds:
        points.InsertNextPoint(seed)
    cloud.SetPoints(points)
    tracer = vtk.vtkStreamTracer()
    tracer.SetInputData(grid)
    tracer.SetInputArrayToProcess(0, 0, 0, 0, "velocity")
    tracer.SetSourceData(cloud)
    tracer.SetIntegratorTypeToRungeKutta4()
    tracer.SetIntegrationDirectionToBoth()
    tracer.SetMaximumPropagation(.08)
    tracer.SetTerminalSpeed(terminal_speed)
    norm = vtk.vtkArrayCalculator()
    norm.SetInputConnection(tracer.GetOutputPort())
    norm.AddVectorArrayName("velocity")
    norm.SetFunction("mag(velocity)")
    norm.SetResultArrayName("speed")
    norm.Update()
    return norm.GetOutput()


def streamline_actor(lines, top):
    """Streamlines as tubes, coloured by speed."""
    tubes = vtk.vtkTubeFilter()
    tubes.SetInputData(lines)
    tubes.SetRadius(1.2e-4)
    tubes.SetNumberOfSides(6)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(tubes.GetOutputPort())
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("speed")
    mapper.SetLookupTable(look_up_table(SPEED, top))
    mapper.UseLookupTableScalarRangeOn()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return actor


class Flow:
    """The blood of a run at one of its fields: streamlines through where it is
    fastest, its largest speed, and the end of the scale (m/s)."""

    def __init__(self, run, frame):
        fluid = run.fields("fluid", frame)
        seeds, speeds = fastest_points(fluid)
        self.fastest = speeds.max()
        self.top = round_up(numpy.quantile(speeds, .9))
        self.lines = streamlines(fluid, seeds, 1e-3 * self.top)


def flow_times(run):
    """When streamlines are worth a look: at the largest flow, and at the end
    if something flows there."""
    table = run.statistics
    times = [("largest flow",
              table["time_s"][table["outflow_mL_per_s"].argmax()])]
    if not run.summary["sealed"]:
        times.append(("the end", run.times[-1]))
    return times


def flow_frames(run, times=()):
    """Names and numbers of the fields that are nearest to the given times (s),
    or to those that are worth a look; each once."""
    wanted = [("", time) for time in times] or flow_times(run)
    frames = {}
    for name, time in wanted:
        frames.setdefault(run.frame_at(time), name)
    return [(name, frame) for frame, name in frames.items()]


def streamline_pictures(run, times=()):
    """Triples of caption, data URL and largest speed on the scale."""
    pictures = []
    for name, frame in flow_frames(run, times):
        flow = Flow(run, frame)
        leaflet = leaflet_actor(run.fields("leaflet", frame))
        leaflet.GetProperty().SetOpacity(.35)
        source = picture([streamline_actor(flow.lines, flow.top), leaflet,
                          chordae_actor(run.fields("chordae", frame))], SIDE)
        caption = f"{name}, {1e3 * run.times[frame]:.3g} ms".lstrip(", ")
        pictures.append((f"At {caption}; up to {flow.fastest:.1f} m/s", source,
                         flow.top))
    return pictures


def write_streamlines(run, times, stem):
    """Writes streamlines at the given times (s) as VTK files whose names begin
    with @p stem; returns their names."""
    files = []
    for _, frame in flow_frames(run, times):
        files.append(f"{stem}_{1e3 * run.times[frame]:.3f}ms.vtp")
        writer = vtk.vtkXMLPolyDataWriter()
        writer.SetInputData(Flow(run, frame).lines)
        writer.SetFileName(files[-1])
        if not writer.Write():
            raise OSError(f"{files[-1]} cannot be written")
    return files
