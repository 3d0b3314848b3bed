#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Draws published.png of the table of published.py, see PUBLISHED.md: python3 published_plot.py TABLE PICTURE [COARSER_TABLE]."""

import collections
import csv
import sys

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

K_A = {1.02e-6: 1e-4, 1.4e-6: 0.002, 2e-6: 0.005, 3e-6: 0.01, 5e-6: 0.02, 1.1e-5: 0.05}  # EI [N m^2]: k_a [J]
WORDS = {10.0: "short, 10 mm", 17.5: "medium, 17.5 mm", 25.6: "long, 25.6 mm"}
PANELS = (("total_sinus [Pa]", "largest total stress\nin the sinus [Pa]"),
          ("total_leaflets [Pa]", "largest total stress\nof the leaflets [Pa]"),
          ("sinus_displacement [mm]", "mean displacement\nof the sinus's blood [mm]"),
          ("leaflet_displacement [mm]", "mean displacement\nof the leaflets [mm]"))


def read(table):
    """{(leaflet [mm], velocity [m/s], EI [N m^2]): [rows of its cycles]}."""
    runs = collections.defaultdict(list)
    with open(table, encoding="utf-8") as file:
        for row in csv.DictReader(file):
            key = (float(row["leaflet [mm]"]), float(row["velocity [m/s]"]), float(row["EI [N*m^2]"]))
            runs[key].append({name: float(value) for name, value in row.items() if name != "run"})
    return runs


def draw(axes, runs, chosen, name, line, label=None):
    """A line through the means of a run's cycles, bars from the smallest to the largest."""
    points = sorted((x, [row[name] for row in runs[key]]) for x, key in chosen if runs.get(key))
    if points:
        means = [sum(values) / len(values) for _, values in points]
        low = [mean - min(values) for mean, (_, values) in zip(means, points)]
        high = [max(values) - mean for mean, (_, values) in zip(means, points)]
        axes.errorbar([x for x, _ in points], means, [low, high], fmt=line, capsize=3, label=label)


def main():
    """Draws the picture."""
    runs = read(sys.argv[1])
    coarser = read(sys.argv[3]) if len(sys.argv) > 3 else {}
    figure, axes = pyplot.subplots(2, len(PANELS), figsize=(13, 6), layout="constrained")
    for column, (name, text) in enumerate(PANELS):
        for length, word in WORDS.items():
            draw(axes[0, column], runs, [(v, (length, v, 3e-6)) for v in (0.03, 0.07, 0.13)], name, "o-", word)
        draw(axes[1, column], runs, [(k_a, (25.6, 0.07, ei)) for ei, k_a in K_A.items()], name, "o-", "0.2 mm")
        draw(axes[1, column], coarser, [(k_a, (25.6, 0.07, ei)) for ei, k_a in K_A.items()], name, "s", "0.4 mm")
        axes[0, column].set(xlabel="inlet velocity [m/s]", ylabel=text)
        axes[1, column].set(xlabel="$k_a$ [J]", ylabel=text, xscale="log")
        for row in axes:
            row[column].set_ylim(bottom=0)
        largest = max((row[name] for key, rows in runs.items() if key[0] == 25.6 for row in rows), default=1)
        axes[1, column].set_ylim(top=1.4 * largest)
    axes[0, 0].legend()
    axes[1, 0].legend()
    figure.savefig(sys.argv[2], dpi=80)


main()
