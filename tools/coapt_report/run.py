"""What a run has left in its output folder, read as it is asked for."""

import csv
import functools
import json
import os
import re
import xml.etree.ElementTree

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy


class OutputError(Exception):
    """An output folder lacks what a report needs."""


def read_csv(path):
    """A table with a header: a dictionary of columns, numbers where all are."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    columns = {}
    for i, name in enumerate(rows[0]):
        texts = [row[i] for row in rows[1:]]
        try:
            columns[name] = numpy.array([float(t or "nan") for t in texts])
        except ValueError:
            columns[name] = numpy.array(texts)
    return columns


def read_parameters(text):
    """Entries of a parameter file: {"Section/Name": "value"}, in order."""
    entries, sections = {}, []
    for line in text.splitlines():
        line = line.split("#")[0].strip()
        if line.startswith("subsection "):
            sections.append(line[len("subsection "):].strip())
        elif line == "end":
            sections.pop()
        elif line.startswith("set "):
            name, _, value = line[len("set "):].partition("=")
            entries["/".join(sections + [name.strip()])] = value.strip()
    return entries


def point_array(grid, name):
    """Point data of a VTK grid as an array; None if there is none."""
    array = grid.GetPointData().GetArray(name)
    return None if array is None else vtk_to_numpy(array)


def cell_array(grid, name):
    """Cell data of a VTK grid as an array; None if there is none."""
    array = grid.GetCellData().GetArray(name)
    return None if array is None else vtk_to_numpy(array)


def points_of(grid):
    """Points of a VTK grid (m)."""
    return vtk_to_numpy(grid.GetPoints().GetData())


class Run:
    """The output folder of one closure of a valve. A run of a study has its
    parameters in the folder of the study, @p above, but for those that the
    study has given to it, @p varied."""

    def __init__(self, folder, label, above="", varied=()):
        self.folder = folder
        self.label = label
        self.above = above
        self.varied = dict(varied)
        for name in ("summary.json", "statistics.csv",
                     above + "parameters.prm"):
            if not self.has(name):
                raise OutputError(
                    f"{folder}: there is no {name}; is this the output of a "
                    "valve that has run to its end?")
        if not self.has("fields/leaflet.pvd"):
            raise OutputError(
                f"{folder}: there are no fields; was Output/Fields interval "
                "zero?")

    def path(self, name):
        """Path of a file of this run."""
        return os.path.join(self.folder, name)

    def has(self, name):
        """Whether there is this file."""
        return os.path.isfile(self.path(name))

    def text(self, name):
        """Text of a file; empty if there is none."""
        if not self.has(name):
            return ""
        with open(self.path(name), encoding="utf-8") as file:
            return file.read()

    def table(self, name):
        """A CSV file as columns; None if there is none."""
        return read_csv(self.path(name)) if self.has(name) else None

    @functools.cached_property
    def summary(self):
        """The figures of the run."""
        return json.loads(self.text("summary.json"))

    @functools.cached_property
    def statistics(self):
        """Columns of statistics.csv."""
        return read_csv(self.path("statistics.csv"))

    @functools.cached_property
    def parameters(self):
        """All parameters in use."""
        return {**read_parameters(self.parameters_in_use), **self.varied}

    @property
    def parameters_in_use(self):
        """The file of all parameters."""
        return self.text(self.above + "parameters.prm")

    @property
    def parameters_as_read(self):
        """The parameter file as the user wrote it."""
        return self.text(self.above + "parameters-as-read.prm")

    @functools.cached_property
    def provenance(self):
        """Lines of the log that name versions, revision and machine."""
        return [line for line in self.text("coapt.log").splitlines()
                if re.match(r"Coapt |deal\.II |\d+ ranks? on ", line)]

    @functools.cached_property
    def timings(self):
        """The table of timings at the end of the log."""
        found = re.search(r"^part .*\Z", self.text("coapt.log"),
                          re.MULTILINE | re.DOTALL)
        return found.group(0) if found else ""

    def series(self, name):
        """Times (s) and files of a collection of fields."""
        tree = xml.etree.ElementTree.parse(self.path(f"fields/{name}.pvd"))
        return [(float(entry.get("timestep")), entry.get("file"))
                for entry in tree.iter("DataSet")]

    @functools.cached_property
    def times(self):
        """Times of the leaflet's fields (s)."""
        return [time for time, _ in self.series("leaflet")]

    def frame_at(self, time):
        """Number of the fields nearest to a time."""
        return int(numpy.argmin(numpy.abs(numpy.array(self.times) - time)))

    @functools.lru_cache(maxsize=4)
    def fields(self, name, frame=-1):
        """The VTK grid of "leaflet", "chordae" or "fluid"."""
        file = self.path("fields/" + self.series(name)[frame][1])
        reader = (vtk.vtkXMLPUnstructuredGridReader()
                  if file.endswith(".pvtu")
                  else vtk.vtkXMLUnstructuredGridReader())
        reader.SetFileName(file)
        reader.Update()
        return reader.GetOutput()

    @property
    def in_blood(self):
        """Whether the valve closes in blood."""
        return self.has("fields/fluid.pvd")

    @property
    def shut_width(self):
        """Width (mm) beyond contact below which a way through is shut."""
        if "shut_below_mm" in self.summary["widest_path"]:
            return self.summary["widest_path"]["shut_below_mm"]
        if self.in_blood:
            return .5 * self.cell_size
        return max(.5 * float(self.parameters["Contact/Clearance"]), .25)

    @property
    def cell_size(self):
        """Finest fluid cell (mm)."""
        return (float(self.parameters["Mesh/Coarse cell"]) /
                2**int(self.parameters["Mesh/Leaflet level"]))


def folder_of_file(name):
    """The output folder that a parameter file names."""
    try:
        with open(name, encoding="utf-8") as file:
            entries = read_parameters(file.read())
    except OSError as error:
        raise OutputError(f"{name}: {error.strerror}") from error
    return entries.get("Output/Folder", "output")


def runs_of(folder):
    """The runs of an output folder, or of the one that a parameter file
    names: itself, or those of a study."""
    folder = folder.rstrip("/")
    if folder.endswith(".prm"):
        folder = folder_of_file(folder)
    if not os.path.isdir(folder):
        raise OutputError(f"{folder}: there is no such folder")
    table = os.path.join(folder, "study.csv")
    if not os.path.isfile(table):
        return [Run(folder, os.path.basename(os.path.abspath(folder)))]
    with open(os.path.join(folder, "parameters.prm"),
              encoding="utf-8") as file:
        parameters = read_parameters(file.read())
    names = split(parameters["Study/Parameter"], ";")
    lists = [split(values, ",")
             for values in split(parameters["Study/Values"], ";")]
    runs = []
    for i in range(len(next(iter(read_csv(table).values())))):
        varied = {name: values[i] for name, values in zip(names, lists)}
        label = ", ".join(f"{name.split('/')[-1]} {value}"
                          for name, value in varied.items())
        runs.append(Run(os.path.join(folder, f"run_{i + 1}"), label, "../",
                        varied))
    return runs


def split(text, separator):
    """The parts of a list."""
    return [part.strip() for part in text.split(separator)]
