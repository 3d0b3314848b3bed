#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Table and pictures of stiffness.toml's runs for PUBLISHED.md, a row for each beat of a run.

    python3 cases/heart_valve/stiffness.py out/stiffness [out/table.csv [FIGURES_FOLDER]]

Instead of a study's folder it takes folders of single runs, separated by commas. Needs numpy; pictures need matplotlib and
python3-vtk9, as docs/python.md says.
"""

import csv
import json
import math
import pathlib
import re
import sys
import tomllib
import xml.etree.ElementTree

import numpy

CLOSED = 2  # spacings: a narrower gap counts as closed
RHO = 1056.0  # kg/m^3


def number(value):
    """A quantity of a resolved scene, which is in SI units: "5e-04 m", or 0.0005 for a geometry's parameter."""
    return float(value.split(" ")[0]) if isinstance(value, str) else float(value)


class Run:
    """Settings and measures of one run, in SI units."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        with open(self.folder / "scene.resolved.toml", "rb") as file:
            scene = tomllib.load(file)
        part = {each["name"]: each for each in scene["part"]}
        geometry = scene["geometry"]["parameters"]
        self.spacing = number(scene["particles"]["spacing"])
        self.stiffness = number(part["leaflets"]["bending_stiffness"])
        # what the lattice has: the program lowers EA to that
        self.stretch = min(number(part["leaflets"]["axial_stiffness"]), 2 * self.stiffness / self.spacing**2)
        self.viscosity = number(part["blood"]["viscosity"])
        self.length, self.half_width = number(geometry["leaflet_length"]), number(geometry["half_width"])
        radius, half_gap = number(geometry["chamber_radius"]), number(geometry["tip_gap"]) / 2
        drive = scene["flow"]["pressure_gradient"][0]  # ((-(2800 Pa/m))*sin((((2*pi)*t)/(1 s))))
        self.drive, self.period = (float(re.search(rf"([-+.\de]+) {unit}", drive)[1]) for unit in ("Pa/m", "s"))
        with open(self.folder / "measures.csv", encoding="utf-8") as file:
            rows = list(csv.reader(file))
        values = numpy.array([[float(value) for value in row] for row in rows[1:]])
        self.column = dict(zip((heading.split(" [")[0] for heading in rows[0]), values.T))
        self.time = self.column["time"]
        rise = self.half_width - half_gap
        run = math.sqrt(self.length**2 - rise**2)
        # the particle at the tip, half a spacing off the leaflet's middle, from the root
        x = run - self.spacing / 2 * rise / self.length
        y = half_gap - self.spacing / 2 * run / self.length
        self.tip_x = {side: x + self.column[f"{side}_tip_x"] for side in ("upper", "lower")}
        self.tip_y = {"upper": y + self.column["upper_tip_y"], "lower": -y + self.column["lower_tip_y"]}
        self.root = -math.sqrt(radius**2 - self.half_width**2)

    def asymmetry(self):
        """Sum of the tips' y over the half width."""
        return numpy.abs(self.column["upper_tip_y"] + self.column["lower_tip_y"]) / self.half_width

    def beat(self, beat):
        """What the table says of one beat, from 1 on."""
        start = (beat - 1) * self.period
        here = (self.time >= start - 1e-9) & (self.time <= start + self.period + 1e-9)
        time, flux = (self.time[here] - start) / self.period, self.column["inlet_flux"][here]
        centre, gap = self.column["inlet_velocity_x"][here], self.column["tip_gap"][here]

        def volume(y):
            return float(numpy.sum(0.5 * (y[1:] + y[:-1]) * numpy.diff(time))) * self.period

        def first(condition, after):
            found = numpy.flatnonzero(condition[after:])
            return time[after + found[0]] if found.size else math.nan

        # closing and what follows, to where the next beat has opened the valve again
        closing = (self.time >= start + 0.5 * self.period) & (self.time <= start + 1.4 * self.period)
        upper, lower = (self.tip_x[side][closing] for side in ("upper", "lower"))
        back = numpy.maximum(upper, lower)  # the tip that is further downstream
        passed = (self.tip_y["lower"] - self.tip_y["upper"])[closing]
        peak = centre.max()
        after = int(flux.argmax())
        return {
            "run": self.folder.name, "spacing [mm]": 1e3 * self.spacing, "EI [N*m^2]": self.stiffness,
            "drive [Pa/m]": self.drive, "beat": beat, "until": time[-1], "widest_gap [mm]": 1e3 * gap.max(),
            "centre_peak [m/s]": peak, "mean_peak [m/s]": flux.max() / (2 * self.half_width),
            "mean_backward [m/s]": -flux.min() / (2 * self.half_width), "reverses [beats]": first(flux < 0, after),
            "closed [beats]": first(gap < CLOSED * self.spacing, max(after, int(gap.argmax()))),
            "gap_at_end [mm]": 1e3 * gap[-1], "forward [cm^2]": 1e4 * volume(numpy.maximum(flux, 0)),
            "net_over_forward": volume(flux) / volume(numpy.maximum(flux, 0)),
            "largest_tip_displacement [mm]": 1e3 * max(
                numpy.hypot(self.column[f"{side}_tip_x"][here], self.column[f"{side}_tip_y"][here]).max()
                for side in ("upper", "lower")),
            "one_tip_upstream_of_root [mm]": -1e3 * min(upper.min(), lower.min()), "both_upstream [mm]": -1e3 * back.min(),
            "both_for [s]": float((back < 0).sum() * (self.time[1] - self.time[0])),
            # how far the tips are past each other while both are downstream of their roots
            "overlap [mm]": 1e3 * float(passed[numpy.minimum(upper, lower) > 0].max()),
            "largest_asymmetry": float(self.asymmetry()[here].max()),
            "reynolds": RHO * peak * self.half_width / self.viscosity,
            "cauchy": RHO * peak**2 * self.length**3 / self.stiffness, "n_r": self.n_r(peak),
        }

    def n_r(self, peak):
        """Re N_f = (rho U Z / mu) (rho f^2 d^5 L / EI), 1 m deep, with the thickness d = sqrt(12 EI / EA)."""
        thickness = math.sqrt(12 * self.stiffness / self.stretch)
        return (RHO * peak * self.half_width / self.viscosity
                * RHO * thickness**5 * self.length / self.period**2 / self.stiffness)

    def beats(self):
        """Rows of all beats that are there by three quarters."""
        return [self.beat(n) for n in range(1, 10) if self.time[-1] > (n - 0.25) * self.period]

    def growth(self):
        """When the asymmetry passes some levels [s], and its rate of growth from 1e-4 to 1e-2 of the half width [1/s]."""
        asymmetry = self.asymmetry()
        passed = {level: self.time[numpy.flatnonzero(asymmetry > level)[0]] if (asymmetry > level).any() else math.nan
                  for level in (1e-10, 1e-7, 1e-4, 1e-2, 0.1)}
        return {"run": self.folder.name, **passed, "early": math.log(1e3) / (passed[1e-7] - passed[1e-10]),
                "late": math.log(1e2) / (passed[1e-2] - passed[1e-4])}


def runs_of(where):
    """The runs of a study's folder, or of folders separated by commas."""
    study = pathlib.Path(where)
    if (study / "results.csv").exists():
        return [Run(folder) for folder in sorted((study / "runs").iterdir()) if (folder / "measures.csv").exists()]
    return [Run(folder) for folder in where.split(",")]


def frame(run, series, time):
    """Positions [mm] and speeds, if the frame has any, of a series of frames at a time."""
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
    sets = list(xml.etree.ElementTree.parse(run.folder / f"{series}.pvd").iter("DataSet"))
    nearest = min(sets, key=lambda each: abs(float(each.get("timestep")) - time))
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(run.folder / nearest.get("file")))
    reader.Update()
    data = reader.GetOutput()
    velocity = data.GetPointData().GetArray("velocity")
    return (1e3 * vtk_to_numpy(data.GetPoints().GetData()),
            None if velocity is None else numpy.linalg.norm(vtk_to_numpy(velocity), axis=1))


def pictures(runs, names, times, folder):
    """states.png, frames of each run, and course.png, gap, place and asymmetry of the tips over time."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from PIL import Image
    figure, axes = plt.subplots(len(times), len(runs), figsize=(8.4, 1.6 * len(times)))
    for column, (run, name) in enumerate(zip(runs, names)):
        for row, time in enumerate(times):
            axis = axes[row, column]
            place, speed = frame(run, "fluid", time)
            shown = axis.scatter(place[:, 0], place[:, 1], c=speed, s=3.6, marker="s", linewidths=0, vmin=0, vmax=1.2)
            place, _ = frame(run, "solid", time)
            axis.scatter(place[:, 0], place[:, 1], c="#e01030", s=5, linewidths=0)
            axis.set(aspect="equal", xlim=(-34, 34), ylim=(-22, 22))
            axis.set_axis_off()
            axis.set_title(f"{name}, {time:.2f} s" if row == 0 else f"{time:.2f} s", fontsize=8, pad=2)
    figure.subplots_adjust(0.01, 0.07, 0.99, 0.97, 0.03, 0.12)
    bar = figure.colorbar(shown, cax=figure.add_axes([0.3, 0.045, 0.4, 0.012]), orientation="horizontal")
    bar.set_label("speed [m/s]", fontsize=8, labelpad=1)
    bar.ax.tick_params(labelsize=7)
    figure.savefig(folder / "stiffness_states.png", dpi=75)
    with Image.open(folder / "stiffness_states.png") as picture:  # 160 colours: smaller
        small = picture.convert("RGB").quantize(160)
    small.save(folder / "stiffness_states.png", optimize=True)

    figure, axes = plt.subplots(3, 1, figsize=(8, 7))
    for run, name in zip(runs, names):
        axes[0].plot(run.time, 1e3 * run.column["tip_gap"], lw=0.9, label=name)
        further = numpy.maximum(run.tip_x["upper"], run.tip_x["lower"])
        axes[1].plot(run.time, 1e3 * further, lw=0.9)
        axes[2].loglog(run.time[1:], numpy.maximum(run.asymmetry(), 1e-17)[1:], lw=0.9)
    axes[0].set_ylabel("gap [mm]")
    axes[0].legend(fontsize=8, ncols=3)
    axes[1].set_ylabel("further downstream tip,\nfrom the root [mm]")
    axes[1].axhline(0, c="0.5", lw=0.8)
    axes[1].set_xlabel("time [s]")
    axes[2].set(ylabel="|y of upper + of lower tip|\n/ half width", xlabel="time [s]", ylim=(1e-16, 3))
    axes[2].axhline(0.1, c="0.5", lw=0.8)
    figure.tight_layout()
    figure.savefig(folder / "stiffness_course.png", dpi=75)


def main():
    """Writes the table and the pictures."""
    runs = runs_of(sys.argv[1])
    rows = [row for run in runs for row in run.beats()]
    with open(sys.argv[2], "w", encoding="utf-8", newline="") if len(sys.argv) > 2 else sys.stdout as file:
        writer = csv.DictWriter(file, rows[0].keys())
        writer.writeheader()
        for row in rows:
            writer.writerow({key: f"{value:.4g}" if isinstance(value, float) else value for key, value in row.items()})
        for run in runs:
            print(json.dumps({key: float(f"{value:.3g}") if isinstance(value, float) else value
                              for key, value in run.growth().items()}), file=sys.stderr)
    if len(sys.argv) > 3:
        pictures(runs, ["soft", "intermediate", "hard"], [0.2, 0.46, 0.8, 0.86, 0.94, 1.0], pathlib.Path(sys.argv[3]))


main()
