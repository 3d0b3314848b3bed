#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Draws CLOTS.md's pictures: python3 clots.py CALCIFICATION BREAKUP FREE_CLOTS, the folders of the three runs.

Writes calcification.png and clots.png into the working folder. Needs python3-vtk9 and matplotlib, as docs/python.md says.
"""

import csv
import pathlib
import sys
import xml.etree.ElementTree

import matplotlib
import numpy
import vtk
from PIL import Image
from vtk.util.numpy_support import vtk_to_numpy

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402


def frame(series, time):
    """Points [mm], arrays and bonds (pairs of points) of the frame of a .pvd file nearest to a time."""
    series = pathlib.Path(series)
    sets = list(xml.etree.ElementTree.parse(series).iter("DataSet"))
    nearest = min(sets, key=lambda each: abs(float(each.get("timestep")) - time))
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(series.parent / nearest.get("file")))
    reader.Update()
    data = reader.GetOutput()
    arrays = {data.GetPointData().GetArrayName(i): vtk_to_numpy(data.GetPointData().GetArray(i))
              for i in range(data.GetPointData().GetNumberOfArrays())}
    lines = vtk_to_numpy(data.GetLines().GetConnectivityArray()).reshape(-1, 2) if data.GetNumberOfLines() else ()
    return 1e3 * vtk_to_numpy(data.GetPoints().GetData()), arrays, lines


def draw(axes, run, time, title):
    """Speed of the blood, bonds, leaflets (red) and clots (black)."""
    points, arrays, _ = frame(run / "fluid.pvd", time)
    speed = numpy.linalg.norm(arrays["velocity"], axis=1)
    shown = axes.scatter(points[:, 0], points[:, 1], c=speed, s=2.5, cmap="viridis", vmin=0, vmax=1.2)
    points, arrays, bonds = frame(run / "solid.pvd", time)
    for a, b in bonds:
        if abs(points[a, 0] - points[b, 0]) < 10:  # not one across the periodic ends
            clot = arrays["part"][a] > 0 or arrays["part"][b] > 0
            axes.plot(points[[a, b], 0], points[[a, b], 1], color="black" if clot else "red", linewidth=1)
    axes.set(title=title, xlim=(-22, 30), ylim=(-22, 22), aspect="equal", xlabel="x [mm]", ylabel="y [mm]")
    return shown


def save(figure, name):
    """In 64 colours, a third of the bytes."""
    figure.savefig(name, dpi=75)
    Image.open(name).convert("RGB").quantize(64).save(name, optimize=True)


def main():
    """Draws both pictures."""
    calcification, breakup, free = (pathlib.Path(name) for name in sys.argv[1:4])
    figure = pyplot.figure(figsize=(11, 5.6), layout="constrained")
    upper, lower = figure.subfigures(2, 1)
    for axes, time in zip(upper.subplots(1, 3), (0.4, 1.4, 2.4)):
        shown = draw(axes, calcification, time, f"{time} s")
    upper.colorbar(shown, label="speed [m/s]")
    with open(calcification / "measures.csv", encoding="utf-8") as file:
        columns = {heading.split(" [")[0]: values for heading, *values in zip(*csv.reader(file))}
    time = numpy.array(columns["time"], float)
    axes = lower.subplots(1, 1)
    for name, at in (("upper_tip", 2), ("lower_tip", -2)):
        axes.plot(time, at + 1e3 * numpy.array(columns[name + "_y"], float), label=name.replace("_", " "))
    axes.set(xlabel="time [s]", ylabel="y of the tip [mm]", xlim=(0, 3))
    axes.legend(loc="lower right", ncols=2)
    save(figure, "calcification.png")

    figure, axes = pyplot.subplots(1, 3, figsize=(11, 3.2), layout="constrained")
    draw(axes[0], breakup, 0.4, "clot on the leaflet, 0.40 s")
    draw(axes[1], breakup, 0.44, "in two pieces, 0.44 s")
    figure.colorbar(draw(axes[2], free, 0.16, "round clot and thread, 0.16 s"), label="speed [m/s]")
    save(figure, "clots.png")


if __name__ == "__main__":
    main()
