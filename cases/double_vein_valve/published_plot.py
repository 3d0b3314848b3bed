#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures and numbers of the study published.toml, see PUBLISHED.md. Needs python3-vtk9, numpy and matplotlib.

python3 published_plot.py paths STUDY PICTURE             # centres of the emboli over time
python3 published_plot.py states PICTURE RUN@TIME ...     # particles of the frame nearest to each time [s]
python3 published_plot.py table STUDY                     # when each embolus has passed the tips of valve 1
"""

import csv
import pathlib
import sys

import matplotlib
import numpy

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402
from PIL import Image  # noqa: E402

NAMES = ("D26", "D52", "D78", "F103", "L21", "L77", "L37", "L19", "L6", "none")
SINUS = ("L77", "L37", "L19", "L6")
TIPS = (-10.46, 77.54)  # of valves 1 and 2 [mm]
ROOTS = (-20.0, 68.0)
PERIOD = 176.0
HALF_LENGTH = {"D26": 1.3, "D52": 2.6, "D78": 3.9, "F103": 3.9, "L21": 10.5}  # [mm]


def save(figure, picture):
    """As a PNG of at most 200 colours, which is small."""
    figure.savefig(picture, dpi=75)
    Image.open(picture).convert("RGB").quantize(200, method=Image.Quantize.FASTOCTREE).save(picture, optimize=True)


def measures(run):
    """{column without its unit: array} of a run."""
    with open(run / "measures.csv", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    return {name.split(" [")[0]: numpy.array([float(row[i] or "nan") for row in rows[1:]])
            for i, name in enumerate(rows[0])}


def runs_of(study):
    """(name, measures) of each run of the study that has begun."""
    for run in sorted(p for p in (pathlib.Path(study) / "runs").iterdir() if p.is_dir()):
        if (run / "measures.csv").exists():
            yield NAMES[int(run.name[:4]) - 1], measures(run)


def squeezed(axes, end):
    """Shades the halves of the cycles in which channel 1, before valve 1, is squeezed."""
    for begin in numpy.arange(1.5, end, 3):
        axes.axvspan(begin, min(begin + 1.5, end), color="0.93", lw=0, zorder=0)


def draw_paths(study, picture):
    """Left the emboli of the channel, right those of the sinus."""
    figure, axes = pyplot.subplots(1, 2, figsize=(12, 4.4), layout="constrained")
    end = [0, 0]
    for name, run in runs_of(study):
        if name == "none":
            continue
        side = int(name in SINUS)
        x = 1e3 * run["embolus_x"]
        axes[side].plot(run["time"], x - x[0] if side else x, label=name)
        end[side] = max(end[side], run["time"][-1])
    top = axes[0].get_ylim()[1]
    for cycle in range(3):
        for valve, (root, tip) in enumerate(zip(ROOTS, TIPS)):
            low = root + cycle * PERIOD
            if low < top:
                axes[0].axhspan(low, tip + cycle * PERIOD, color="C3", alpha=0.15, lw=0, zorder=1)
                axes[0].text(0.05, low, f"valve {valve + 1}", fontsize=8, va="bottom")
    axes[0].set(title="channel 1", ylabel="x of the centre of mass [mm]")
    axes[1].set(title="sinus of valve 1", ylabel="displacement along the flow [mm]")
    for panel, last in zip(axes, end):
        squeezed(panel, last)
        panel.set(xlabel="time [s]", xlim=(0, last))
        panel.legend(loc="lower right" if panel is axes[0] else "center right")
    save(figure, picture)


def draw_states(picture, frames):
    """One panel for each RUN@TIME; blood by its velocity along x."""
    import vtk  # noqa: PLC0415
    from vtk.util.numpy_support import vtk_to_numpy  # noqa: PLC0415

    def read(path):
        reader = vtk.vtkXMLPolyDataReader()
        reader.SetFileName(str(path))
        reader.Update()
        points, data = reader.GetOutput().GetPoints().GetData(), reader.GetOutput().GetPointData()
        return 1e3 * vtk_to_numpy(points), {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i))
                                            for i in range(data.GetNumberOfArrays())}

    figure, axes = pyplot.subplots(len(frames), 1, figsize=(11, 1.75 * len(frames)), layout="constrained", squeeze=False)
    for panel, frame in zip(axes[:, 0], frames):
        run, time = frame.rsplit("@", 1)
        run = pathlib.Path(run)
        number = round(float(time) / 0.1)
        walls, _ = read(run / "walls.vtp")
        fluid, fields = read(run / "frames" / f"fluid_{number:06d}.vtp")
        solid, solid_fields = read(run / "frames" / f"solid_{number:06d}.vtp")
        dots = panel.scatter(*fluid[:, :2].T, s=7, c=1e3 * fields["velocity"][:, 0], cmap="coolwarm", vmin=-50, vmax=50, lw=0)
        panel.scatter(*walls[:, :2].T, s=7, c="0.6", lw=0)
        wrapped = (solid[:, 0] + PERIOD / 2) % PERIOD - PERIOD / 2
        name = NAMES[int(run.name[:4]) - 1]
        body = (solid_fields["part"] == 0) & (name != "none")
        panel.scatter(wrapped[~body], solid[~body, 1], s=7, c="k", lw=0)
        panel.scatter(wrapped[body], solid[body, 1], s=8, c="C2", lw=0)
        panel.set_title(f"{name}, t = {time} s", fontsize=9, loc="left")
        panel.set(aspect="equal", xlim=(-PERIOD / 2, PERIOD / 2), ylim=(-13, 13), yticks=(-8, 0, 8))
    axes[-1, 0].set_xlabel("x [mm]")
    figure.colorbar(dots, ax=axes[:, 0], label="velocity along x [mm/s]", shrink=0.5)
    save(figure, picture)


def crossing(time, x, level):
    """When x reaches the level for good, or nan."""
    below = numpy.flatnonzero(x < level)
    return time[below[-1] + 1] if len(below) and below[-1] + 1 < len(x) else (numpy.nan if len(below) else time[0])


def print_table(study):
    """A line for each run."""
    for name, run in runs_of(study):
        late = run["time"] >= 3
        peaks = [numpy.nanmax(run[f"velocity_{i}_x"][late], initial=0) for i in (1, 2)]
        flux, time = run["flux_1"], run["time"]
        cycles = [1e4 * numpy.trapz(flux[(time >= 3 * n) & (time <= 3 * n + 3)], dx=0.01)
                  for n in range(int(time[-1] / 3 + 0.01))]
        text = f"{name:5} to {time[-1]:5.2f} s, peaks {peaks[0]:.4f} {peaks[1]:.4f} m/s, net [cm^2] "
        text += " ".join(f"{value:.2f}" for value in cycles)
        if "embolus_x" in run:
            x = 1e3 * run["embolus_x"]
            half = HALF_LENGTH.get(name, 0)
            text += f"; tips at {crossing(time, x, TIPS[0]):.2f} s, all of it {crossing(time, x, TIPS[0] + half):.2f} s"
            text += f", valve 2 {crossing(time, x, TIPS[1] + half):.2f} s"
            text += f"; x {x[0]:.1f} to {x[-1]:.1f} (largest {x.max():.1f}) mm, turns {run['embolus_angle'][-1] / 6.2832:.2f}"
            text += f", stretch {run['embolus_least_stretch'].min():.3f} to {run['embolus_largest_stretch'].max():.3f}"
        text += f"; gaps {1e3 * run['gap_1'].min():.2f} {1e3 * run['gap_2'].min():.2f} mm"
        text += f"; density {run['density_low'].min():.3f} {run['density_high'].max():.3f}"
        print(text)


if __name__ == "__main__":
    if sys.argv[1] == "paths":
        draw_paths(sys.argv[2], sys.argv[3])
    elif sys.argv[1] == "states":
        draw_states(sys.argv[2], sys.argv[3:])
    else:
        print_table(sys.argv[2])
