// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/paraview_script.hpp"

#include <array>
#include <cstdio>

namespace dmp::postproc {

namespace {

constexpr const char* script = R"python(# Opens this run in ParaView:  paraview --script=open_in_paraview.py
# (from this folder; or in ParaView: View > Python Shell > Run Script).
import os

from paraview.simple import *

here = os.path.dirname(os.path.abspath(__file__)) if "__file__" in globals() else os.getcwd()
spacing = SPACING  # of the particles [m]


def show_particles(name, colour, height):
    path = os.path.join(here, name)
    if not os.path.exists(path):
        return None
    source = OpenDataFile(path)
    RenameSource(name, source)
    display = Show(source, view)
    display.SetRepresentationType("Point Gaussian")
    display.GaussianRadius = spacing / 2
    display.ShaderPreset = "Plain circle"
    display.AmbientColor = display.DiffuseColor = colour
    display.ColorArrayName = ["POINTS", ""]
    display.Position = [0, 0, height]  # 2-D: which group is visible where they overlap
    return source, display


def show_spheres(name, colour):
    shown = show_particles(name, colour, 0)
    if shown:  # in their own size
        display = shown[1]
        display.ShaderPreset = "Sphere"
        display.ScaleByArray = 1
        display.SetScaleArray = ["POINTS", "radius"]
        display.UseScaleFunction = 0
        display.GaussianRadius = 1
    return shown


def show_wall(name):
    if not spheres:
        show_particles(name, [0.6, 0.6, 0.6], -spacing)
        return
    path = os.path.join(here, name)
    if os.path.exists(path):  # triangles
        display = Show(OpenDataFile(path), view)
        display.SetRepresentationType("Surface")
        display.ColorArrayName = ["POINTS", ""]
        display.Opacity = 0.4


view = GetActiveViewOrCreate("RenderView")
spheres = show_spheres("spheres.pvd", [0.2, 0.4, 0.8])
view.InteractionMode = "3D" if spheres else "2D"

show_wall("walls.vtp")
show_wall("moving_walls.pvd")
solid = show_particles("solid.pvd", [0.6, 0.05, 0.1], spacing)
fluid = show_particles("fluid.pvd", [0.2, 0.4, 0.8], 0)
GetAnimationScene().UpdateAnimationUsingDataTimeSteps()

if solid:
    bonds = Threshold(registrationName="bonds", Input=solid[0])
    bonds.Scalars = ["CELLS", "is_bond"]
    bonds.LowerThreshold = bonds.UpperThreshold = 1
    lines = Show(bonds, view)
    lines.SetRepresentationType("Wireframe")
    lines.AmbientColor = lines.DiffuseColor = [0.6, 0.05, 0.1]
    lines.LineWidth = 2
    lines.ColorArrayName = ["POINTS", ""]
    lines.Position = [0, 0, spacing]

coloured = fluid or spheres
if coloured and coloured[0].PointData.GetArray("velocity"):
    ColorBy(coloured[1], ("POINTS", "velocity", "Magnitude"))
    coloured[1].RescaleTransferFunctionToDataRangeOverTime()
    GetColorTransferFunction("velocity").ApplyPreset("Viridis (matplotlib)", True)
    coloured[1].SetScalarBarVisibility(view, True)
    bar = GetScalarBar(GetColorTransferFunction("velocity"), view)
    bar.Title, bar.ComponentTitle = "speed [m/s]", ""

GetAnimationScene().GoToLast()
view.ResetCamera(True)  # closest view
Render(view)
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
