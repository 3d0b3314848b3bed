#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""What run_particles.py found beside the grid's solution, as a table.

    compare.py REFERENCES SPEED FOLDER...

REFERENCES holds heart_valve_grid.csv and heart_valve_grid_sections.csv (tests/data), each FOLDER a run at SPEED [m/s].
Velocities are over the mean inflow, which the drive of the particles holds only within a few per cent.
"""
import csv
import math
import pathlib
import sys

import sections as valve


BINS_CLEAR = 10  # of 12


def read_sections(path, speed=None):
    """Of each section its places along it [m] and u."""
    found = {}
    with open(path, encoding="utf-8") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            if speed is not None and float(row["inflow_m_s"]) != speed:
                continue
            place = float(row["x_mm"] if row["section"] == "axis" else row["y_mm"]) / 1e3
            found.setdefault(row["section"], []).append((place, float(row["u_m_s"])))
    return found


def at(rows, place):
    known = [row for row in rows if not math.isnan(row[1])]
    for low, high in zip(known, known[1:]):
        if low[0] <= place <= high[0]:
            return low[1] + (high[1] - low[1]) * (place - low[0]) / (high[0] - low[0])
    return math.nan


def difference(reference, found, low=-math.inf, high=math.inf):
    """Root mean square of found - reference over the largest |reference|, both over their mean inflow, and the largest."""
    size = max(abs(u) for _, u in reference if not math.isnan(u))
    squares, largest = [], 0.0
    for place, u in reference:
        other = at(found, place)
        if math.isnan(u) or math.isnan(other) or not low <= place <= high:
            continue
        squares.append(((other - u) / size)**2)
        largest = max(largest, abs(other - u) / size)
    return math.sqrt(sum(squares) / len(squares)), largest


def bins_of(rows, length, count):
    """Means of a section of the grid over the bins that run_particles.py counts particles in."""
    means = []
    for k in range(count):
        places = [length * (k + (n + 0.5) / 20) / count for n in range(20)]
        values = [value for value in (at(rows, place) for place in places) if not math.isnan(value)]
        means.append(sum(values) / len(values) if values else math.nan)
    return means


def compare_particles(grid, folder):
    """Of each section at the tips, by bins: near the axis (a third of the section), peak, and root mean square of the
    difference, all in % of the grid's peak."""
    with open(folder / "particles.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    found = {}
    for name, length in (("throat", valve.THROAT_HALF), ("tip", valve.TIP_GAP / 2)):
        mine = [row for row in rows if row["section"] == name]
        other = bins_of(grid[name], length, len(mine))
        counts = [int(row["count"]) for row in mine]
        u = [float(row["u_over_mean_inflow"]) for row in mine]
        used = [k for k, count in enumerate(counts) if count >= 3]
        top = max(other[k] for k in used)
        inner = [k for k in used if k < 4]
        axis = sum((u[k] - other[k]) * counts[k] for k in inner) / sum(counts[k] for k in inner)

        def rms(bins):
            return math.sqrt(sum((u[k] - other[k])**2 * counts[k] for k in bins) / sum(counts[k] for k in bins)) / top * 100

        found[name] = {"near the axis": axis / top * 100, "peak": (max(u[k] for k in used) / top - 1) * 100,
                       "rms": rms(used), "rms without the two bins at the leaflet": rms([k for k in used if k < BINS_CLEAR])}
    return found


def over_inflow(found):
    mean = valve.integral([(0, y) for y, _ in found["inlet"]], [u for _, u in found["inlet"]]) / valve.HALF_WIDTH
    return {name: [(place, u / mean) for place, u in rows] for name, rows in found.items()}


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    references, speed = pathlib.Path(sys.argv[1]), float(sys.argv[2])
    grid = over_inflow(read_sections(references / "heart_valve_grid_sections.csv", speed))
    with open(references / "heart_valve_grid.csv", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(line for line in file if not line.startswith("#"))
                if float(row["inflow_m_s"]) == speed]
    runs = {pathlib.Path(folder).name: pathlib.Path(folder) for folder in sys.argv[3:]}
    quantities = {name: dict(row for row in csv.reader(open(folder / "quantities.csv", encoding="utf-8")))
                  for name, folder in runs.items()}
    cells = [key for key in rows[0] if key.startswith("cells_")]
    print("| | " + " | ".join(cells + ["limit", *runs]) + " |")
    for row in rows:
        name = row["quantity"]
        print(f"| {name} | " + " | ".join([row[cell] for cell in cells] + [row["limit"]] +
                                          [f"{float(one[name]):.4g}" for one in quantities.values()]) + " |")
    particles = [compare_particles(grid, folder) for folder in runs.values()]
    for section in ("throat", "tip"):
        for what in particles[0][section]:
            print(f"| particles at the {section}: {what} [%] | " + " | ".join([""] * (len(cells) + 1)) + " | " +
                  " | ".join(f"{one[section][what]:+.1f}" for one in particles) + " |")
    ranges = {"inlet": {}, "throat": {}, "tip": {}, "chamber": {}, "axis": {"high": 0.02}}
    for section, limits in ranges.items():
        found = [difference(grid[section], over_inflow(read_sections(folder / "sections.csv"))[section], **limits)
                 for folder in runs.values()]
        print(f"| {section}: rms (largest) difference [%] | " + " | ".join([""] * (len(cells) + 1)) + " | " +
              " | ".join(f"{rms * 100:.1f} ({largest * 100:.1f})" for rms, largest in found) + " |")


if __name__ == "__main__":
    main()
