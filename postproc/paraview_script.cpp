// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/paraview_script.hpp"

#include <array>
#include <cstdio>

namespace dmp::postproc {

namespace {

constexpr const char* script = R"python(# Opens this run in ParaView:  paraview --script=open_in_paraview.py
# (from this folder; or in ParaView: View > Python Shell > Run Script).
# A view for each of speed, stress, concentration and residence time that the frames hold, with one camera for all.
import os

import numpy
from paraview import servermanager
from paraview.simple import *
from vtk.util.numpy_support import vtk_to_numpy

here = os.path.dirname(os.path.abspath(__file__)) if "__file__" in globals() else os.getcwd()
spacing = SPACING  # of the particles [m]
grey, red, blue = [0.6, 0.6, 0.6], [0.6, 0.05, 0.1], [0.2, 0.4, 0.8]


def opened(name):
    path = os.path.join(here, name)
    if not os.path.exists(path):
        return None
    source = OpenDataFile(path)
    RenameSource(name.rsplit(".", 1)[0], source)
    source.UpdatePipeline()
    return source


fluid, solid, spheres = opened("fluid.pvd"), opened("solid.pvd"), opened("spheres.pvd")
walls = [source for source in (opened("walls.vtp"), opened("moving_walls.pvd")) if source]
GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
times = list(GetTimeKeeper().TimestepValues or [0])

low_x, high_x, low_y, high_y, low_z, high_z = (fluid or spheres or solid).GetDataInformation().GetBounds()
sides = [high_x - low_x, high_y - low_y, high_z - low_z]
flat = sides[2] < spacing / 100 and not spheres
across = sides.index(min(sides))  # in 3-D: what is looked along


def largest_values(source):
    """For each field of particles: its unit, and the value that a thousandth of them exceeds in one of five frames."""
    fields = {}
    for time in sorted({times[k * (len(times) - 1) // 4] for k in range(5)}):
        source.UpdatePipeline(time)
        data = servermanager.Fetch(source)
        for k in range(data.GetPointData().GetNumberOfArrays()):
            array = data.GetPointData().GetArray(k)
            if array is None or not array.GetNumberOfTuples():
                continue
            unit = data.GetFieldData().GetAbstractArray("units:" + array.GetName())
            values = vtk_to_numpy(array)
            values = numpy.linalg.norm(values, axis=1) if values.ndim > 1 else values
            values = values[numpy.isfinite(values)]
            high = float(numpy.quantile(values, 0.999)) if len(values) else 0
            before = fields.get(array.GetName(), (None, 0))[1]
            fields[array.GetName()] = (unit.GetValue(0) if unit else "", max(high, before))
    return fields


moving_fields = largest_values(fluid or spheres) if fluid or spheres else {}
solid_fields = largest_values(solid) if solid else {}


def half(source):
    """In 3-D what lies behind the middle: walls would hide it."""
    if flat or spheres:
        return source
    clip = Clip(Input=source, ClipType="Plane")
    clip.ClipType.Origin = [(low_x + high_x) / 2, (low_y + high_y) / 2, (low_z + high_z) / 2]
    clip.ClipType.Normal = [float(axis == across) for axis in range(3)]
    return clip


def tubes():
    lines = Threshold(Input=solid, Scalars=["CELLS", "is_bond"], LowerThreshold=1, UpperThreshold=1)
    # Those across a periodic boundary would be drawn across the whole box.
    lengths = CellSize(Input=lines, ComputeVertexCount=0, ComputeArea=0, ComputeVolume=0)
    short = Threshold(Input=lengths, Scalars=["CELLS", "Length"], LowerThreshold=0, UpperThreshold=10 * spacing)
    return Tube(registrationName="bonds", Input=ExtractSurface(Input=short), Radius=spacing / 8, NumberofSides=8)


def show_particles(source, view, colour, height, radius=spacing / 2):
    display = Show(source, view)
    display.SetRepresentationType("Point Gaussian")
    display.GaussianRadius = radius
    display.ShaderPreset = "Plain circle" if flat else "Sphere"
    display.AmbientColor = display.DiffuseColor = colour
    display.ColorArrayName = ["POINTS", ""]
    display.Position = [0, 0, height if flat else 0]  # which group is visible where they overlap
    return display


def show_spheres(view):
    display = show_particles(spheres, view, blue, 0, 1)
    display.ScaleByArray = 1  # in their own size
    display.SetScaleArray = ["POINTS", "radius"]
    display.UseScaleFunction = 0
    return display


def show_surface(source, view, colour, opacity, height=0):
    display = Show(source, view)
    display.SetRepresentationType("Surface")
    display.AmbientColor = display.DiffuseColor = colour
    display.ColorArrayName = ["POINTS", ""]
    display.Opacity = opacity
    display.Position = [0, 0, height if flat else 0]
    return display


def colour(displays, fields, array, title, preset, view, left):
    """Colours the displays by an array, with one range for all times, and shows its bar."""
    unit, high = fields[array]
    vector = array == "velocity"
    for display in displays:
        ColorBy(display, ("POINTS", array, "Magnitude") if vector else ("POINTS", array))
        display.SetScalarBarVisibility(view, False)
    table = GetColorTransferFunction(array)
    table.ApplyPreset(preset, True)
    table.AutomaticRescaleRangeMode = "Never"
    table.RescaleTransferFunction(0, high if high > 0 else 1)
    displays[0].SetScalarBarVisibility(view, True)
    bar = GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = f"{title} [{unit}]", ""
    bar.Orientation, bar.WindowLocation, bar.Position = "Vertical", "Any Location", [left, 0.1]
    bar.ScalarBarLength, bar.ScalarBarThickness = 0.75, 12
    bar.TitleFontSize = bar.LabelFontSize = 14
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%-#.3g", "%-#.3g"


shown_fluid = half(fluid) if fluid else None
shown_walls = [half(source) for source in walls]
bonds = tubes() if solid else None
viridis, plasma = "Viridis (matplotlib)", "Plasma (matplotlib)"


def fill(view, of_moving, of_solid):
    """Shows everything in a view; the fields, if any, that colour what flows and the solid."""
    for source in shown_walls:
        if spheres:
            show_surface(source, view, grey, 0.4)  # triangles
        else:
            show_particles(source, view, grey, -spacing)
    if shown_fluid or spheres:
        display = show_spheres(view) if spheres else show_particles(shown_fluid, view, blue, 0, 0.6 * spacing)
        if of_moving in moving_fields:
            title = {"velocity": "speed"}.get(of_moving, of_moving.replace("_", " "))
            colour([display], moving_fields, of_moving, title, viridis, view, 0.9)
    if solid:
        displays = [show_surface(bonds, view, red, 1, 2 * spacing),
                    show_particles(solid, view, red, spacing, 0.4 * spacing)]
        if of_solid in solid_fields:
            colour(displays, solid_fields, of_solid, "von Mises stress of the solid", plasma, view, 0.02)
    view.OrientationAxesVisibility = 0 if flat else 1
    view.InteractionMode = "2D" if flat else "3D"


# What colours the fluid (or spheres) and the solid in each view.
wanted = [("velocity", None)] if "velocity" in moving_fields else []
if "shear_stress" in moving_fields or "von_mises" in solid_fields:
    wanted.append(("shear_stress", "von_mises"))
wanted += [(name, None) for name in sorted(moving_fields) if name.startswith(("concentration", "residence_time"))]
wanted = wanted or [(None, None)]

first = GetActiveViewOrCreate("RenderView")
layout = GetLayout(first)
if layout is None:
    layout = CreateLayout()
    layout.AssignView(0, first)
cell = layout.GetViewLocation(first)
split = layout.SplitVertical if sides[0] > sides[1] else layout.SplitHorizontal
views = [first]
for left in range(len(wanted), 1, -1):  # each takes its share of what is left
    cell = split(cell, 1 / left) + 1
    views.append(CreateRenderView())
    layout.AssignView(cell, views[-1])
for view, fields in zip(views, wanted):
    fill(view, *fields)

GetAnimationScene().GoToLast()
SetActiveView(first)
if not flat and not spheres:
    first.CameraFocalPoint = [(low_x + high_x) / 2, (low_y + high_y) / 2, (low_z + high_z) / 2]
    first.CameraPosition = [c + sides[0] * (axis == across) for axis, c in enumerate(first.CameraFocalPoint)]
    first.CameraViewUp = [0, 0, 1] if across == 1 else [0, 1, 0]
for view in views:
    if view is not first:
        AddCameraLink(first, view, f"camera {views.index(view)}")
# As close as it goes, with places for the bars.
first.ResetCamera([low_x - 0.1 * sides[0], high_x + 0.15 * sides[0],
                   low_y - 4 * spacing, high_y + 4 * spacing, low_z, high_z], True)
RenderAllViews()
)python";

}  // namespace

std::string paraview_script(double spacing) {
    std::array<char, 32> number{};
    std::snprintf(number.data(), number.size(), "%.9g", spacing);
    std::string text = script;
    const std::string placeholder = "SPACING";
    return text.replace(text.find(placeholder), placeholder.size(), number.data());
}

}  // namespace dmp::postproc
