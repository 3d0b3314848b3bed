#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Growth of the aggregates at P1 and P2, of the frames of agglomeration.toml's or agglomeration_free.toml's runs.

    python3 cases/vein_valve/agglomeration.py PICTURE TITLE=STUDY_FOLDER[@LIMIT] ...

Prints the ratio of P2 to P1 (geometric means over the seeds, 95 % interval of Welch's t of the logarithms), what lies within
6 mm of the place, and the blood within reach; draws the growth. Needs python3-vtk9, scipy, matplotlib, as docs/python.md says.
"""

import csv
import pathlib
import sys

import matplotlib
import numpy
from scipy import spatial, stats

from published import DOMAIN, frames

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

PLACES = {"P1": (-0.0097, -0.002), "P2": (-0.0185, -0.0045)}
NEAR = 0.006  # m
PRINTED = (1.6, 2, 3, 4, 5, 7, 9)  # s


def runs_of(study, limit):
    """(folder, place, spacing [m], number of the aggregate's part) of each run of a study with this limit of bonds [N]."""
    with open(study / "results.csv", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            values = {heading.split(" [")[0]: value for heading, value in row.items()}
            if limit and float(values["break.tear.force_above"]) != float(limit):
                continue
            free = "region.place.from" in values
            first = "-10" in values["region.place.from"] if free else float(values["geometry.parameters.seed_at"]) > 6
            yield (study / "runs" / values["run"], "P1" if first else "P2", 1e-3 * float(values["particles.spacing"]),
                   1 if free else 2)


def growth(run, place, spacing, part):
    """Rows of time, particles of the aggregate, those near the place, blood within reach of the aggregate."""
    rows = []
    for (time, solid), (_, liquid) in zip(frames(run / "solid.pvd", 1, 9), frames(run / "fluid.pvd", 1, 9)):
        mine, blood = solid["position"][solid["part"] == part, :2], liquid["position"][:, :2].copy()
        for positions in (mine, blood):
            positions[:, 0] -= DOMAIN * numpy.round(positions[:, 0] / DOMAIN)
        near = (numpy.linalg.norm(mine - PLACES[place], axis=1) < NEAR).sum()
        within = set().union(*spatial.cKDTree(blood).query_ball_point(mine, 2.5 * spacing)) if len(mine) else ()
        rows.append((time, len(mine), near, len(within)))
    return numpy.array(rows)


def at(runs, time, column):
    """The values of the runs that last until a time."""
    return numpy.array([rows[numpy.abs(rows[:, 0] - time).argmin(), column] for rows in runs if rows[-1, 0] > time - 0.05])


def ratio(first, second):
    """second / first, and its 95 % interval by Welch's t of the logarithms."""
    logs = [numpy.log(numpy.maximum(values, 0.5)) for values in (first, second)]
    squares = [values.var(ddof=1) / len(values) for values in logs]
    freedom = sum(squares)**2 / sum(square**2 / (len(values) - 1) for square, values in zip(squares, logs))
    middle, half = logs[1].mean() - logs[0].mean(), stats.t.ppf(0.975, freedom) * sum(squares)**0.5
    return "{:.2f} ({:.2f} to {:.2f})".format(*numpy.exp([middle, middle - half, middle + half]))


def main():
    """Prints the table and draws the picture."""
    studies = dict(argument.split("=", 1) for argument in sys.argv[2:])
    figure, axes = pyplot.subplots(2, len(studies), figsize=(3.6 * len(studies), 5), layout="constrained", squeeze=False)
    for column, (title, folder) in enumerate(studies.items()):
        grown = {"P1": [], "P2": []}
        folder, _, limit = folder.partition("@")
        for run, place, spacing, part in runs_of(pathlib.Path(folder), limit):
            grown[place].append(growth(run, place, spacing, part))
        print(title)
        for time in PRINTED:
            all_of, near, within = ([at(grown[place], time, k) for place in ("P1", "P2")] for k in (1, 2, 3))
            print(f"  {time} s: {all_of[0]} {all_of[1]} P2 / P1 {ratio(*all_of)}",
                  f"near {near[0]} {near[1]}, blood within reach {within[0].mean():.0f} {within[1].mean():.0f}")
        for k, what in ((1, "particles"), (2, "of them within 6 mm of the place")):
            panel = axes[k - 1, column]
            for place, colour in (("P1", "tab:red"), ("P2", "tab:blue")):
                for number, rows in enumerate(grown[place]):
                    panel.plot(rows[:, 0], rows[:, k], color=colour, linewidth=1, label=place if number == 0 else None)
            panel.set(xlabel="time [s]", ylabel=what, ylim=(0, None))
            panel.legend(loc="upper left")
        axes[0, column].set_title(title)
    figure.savefig(sys.argv[1], dpi=80)


if __name__ == "__main__":
    main()
