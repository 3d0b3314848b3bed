#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Checks open_in_paraview.py on runs of a fluid with elastic leaflets and of spheres.

    check_script.py DMP SOURCE_FOLDER [--keep FOLDER]

Without ParaView: the script is Python, and each array that it names is in the frames. Where pvpython and xvfb-run are
installed (Debian's python3-paraview and libvtk9-dev exclude each other), it also runs there without a screen, and its
screenshots, which --keep leaves in a folder, are of more than one colour."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SCREENSHOT = """
import sys
names = {"__file__": sys.argv[1], "__name__": "__main__"}
exec(compile(open(sys.argv[1]).read(), sys.argv[1], "exec"), names)
from paraview.simple import *
GetLayout().SetSize(1600, 1000)
SaveScreenshot(sys.argv[2], GetLayout())
from vtkmodules.vtkIOImage import vtkPNGReader
from vtk.util.numpy_support import vtk_to_numpy
import numpy
reader = vtkPNGReader()
reader.SetFileName(sys.argv[2])
reader.Update()
colours = len(numpy.unique(vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()), axis=0))
print("views", len(GetRenderViews()), "colours", colours)
"""
RUNS = {  # name: arguments of dmp run, views that the script opens
    "valve": (["vein_valve", "--set", 'particles.spacing="0.8 mm"', "--until", "50 ms"], 2),
    "spheres": (["carrier", "--until", "1 us"], 1),
}
ARRAYS = {  # that the script names and frames hold by default
    "valve": {"velocity", "shear_stress", "von_mises", "is_bond"},
    "spheres": {"velocity", "radius"},
}


class Script(unittest.TestCase):
    results, keep = None, None  # folders

    def script(self, name):
        return self.results / name / "open_in_paraview.py"

    def test_is_python(self):
        for name in RUNS:
            compile(self.script(name).read_text(), "open_in_paraview.py", "exec")

    def test_names_arrays_that_the_frames_hold(self):
        for name, arrays in ARRAYS.items():
            text = self.script(name).read_text()
            held = set()
            for frame in (self.results / name / "frames").glob("*.vtp"):
                held.update(re.findall(rb'<DataArray[^>]* Name="(\w+)"', frame.read_bytes()))
            for array in arrays:
                self.assertIn(f'"{array}"', text)
                self.assertIn(array.encode(), held)

    @unittest.skipUnless(shutil.which("pvpython") and shutil.which("xvfb-run"), "there is no ParaView here")
    def test_opens_its_views_in_paraview(self):
        for name, (_, views) in RUNS.items():
            picture = (self.keep or self.results) / f"{name}.png"
            with self.subTest(name):
                done = subprocess.run(["xvfb-run", "-a", "-s", "-screen 0 1600x1200x24 -noreset", "pvpython", "-c",
                                       SCREENSHOT, str(self.script(name)), str(picture)], capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stderr)
                found = re.search(r"views (\d+) colours (\d+)", done.stdout)
                self.assertEqual(int(found[1]), views)
                self.assertGreater(int(found[2]), 100)


def main():
    arguments = sys.argv[1:]
    if "--keep" in arguments:
        at = arguments.index("--keep")
        Script.keep = pathlib.Path(arguments[at + 1]).resolve()
        del arguments[at:at + 2]
    dmp, source = (pathlib.Path(argument).resolve() for argument in arguments)
    with tempfile.TemporaryDirectory(prefix="dmp_paraview_") as folder:
        Script.results = pathlib.Path(folder)
        for name, (options, _) in RUNS.items():
            subprocess.run([dmp, "run", source / "cases" / options[0], *options[1:], "--threads", "1", "--set",
                            "output.pictures=false", "--out", Script.results / name], check=True,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        unittest.main(argv=sys.argv[:1])


main()
