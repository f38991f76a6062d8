"""check_streamline_files.py STEM NUMBER: asserts that there are so many files
STEM*.vtp and that each holds lines with the speed of their velocity."""

import glob
import sys

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

files = sorted(glob.glob(sys.argv[1] + "*.vtp"))
failed = len(files) != int(sys.argv[2])
print(files)
for name in files:
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(name)
    reader.Update()
    lines = reader.GetOutput()
    velocity, speed = (vtk_to_numpy(lines.GetPointData().GetArray(array))
                       for array in ("velocity", "speed"))
    error = numpy.abs(numpy.linalg.norm(velocity, axis=1) - speed).max()
    print(f"{name}: {lines.GetNumberOfLines()} lines, {speed.max():.3g} m/s, "
          f"error {error:.2g}")
    failed |= (lines.GetNumberOfLines() < 10 or not speed.max() > 0
               or error > 1e-5 * speed.max())
sys.exit(1 if failed else 0)
