#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""The heart valve with rigid leaflets by dmp, to compare with tests/data/heart_valve_grid*.csv.

    run_particles.py DMP SPEED SPACING FOLDER

Runs cases/heart_valve/rigid.toml with an inflow of SPEED [m/s] on the axis, particles SPACING [mm] apart, into FOLDER, and
writes FOLDER/sections.csv and FOLDER/quantities.csv: averages over the second half of the run. All speeds of the scene go
with SPEED, pressures with its square, times with its inverse.
"""
import csv
import math
import pathlib
import re
import subprocess
import sys

import sections as valve

CASE = pathlib.Path(__file__).resolve().parents[3] / "cases/heart_valve"
BASE_SPEED, BASE_END = 0.2, 0.15  # of rigid.toml


def scene(speed, spacing):
    ratio = speed / BASE_SPEED
    text = (CASE / "rigid.toml").read_text(encoding="utf-8")

    def scaled(pattern, factor):
        nonlocal text
        text, count = re.subn(pattern, lambda found: f"{found[1]}{float(found[2]) * factor:.10g}{found[3]}", text)
        assert count > 0, pattern

    scaled(r'(largest_speed = ")([0-9.]+)( m/s")', ratio)
    scaled(r'(\? )([0-9.]+)( m/s\^2 \* sin)', ratio**2)
    scaled(r'([:?] )([1-9][0-9.]*)( Pa)', ratio**2)
    scaled(r'(\? )([0-9.]+)( m/s \* 12.5 mm)', ratio)
    scaled(r'(duration = ")([0-9.]+)( s")', 1 / ratio)
    scaled(r'(\nevery = ")([0-9.]+)( s")', 1 / ratio)
    scaled(r'(measure_every = ")([0-9.]+)( ms")', 1 / ratio)
    scaled(r'(spacing = ")([0-9.]+)( mm")', spacing / 0.5)
    text = text.replace('file = "rigid.geo"', f'file = "{CASE}/rigid.geo"')
    for name, places in valve.chamber_columns().items():
        ends = [f'["{x:.9g} m", "{y:.9g} m"]' for x, y in (places[0], places[-1])]
        text += (f'\n[[measure]]\nname = "{name}"\nkind = "line"\nfield = "velocity"\nfrom = {ends[0]}\nto = {ends[1]}\n'
                 f"points = {len(places)}\n")
    return text


def averages(folder, start):
    with open(folder / "measures.csv", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    names = [name.split(" ")[0] for name in rows[0]]
    values = [[float(value) for value in row] for row in rows[1:] if float(row[0]) >= start]

    def mean(column):
        known = [value for value in column if not math.isnan(value)]
        return sum(known) / len(known) if known else math.nan

    return dict(zip(names, map(mean, zip(*values)))), [row[:2] for row in values]


def along(found, name, count, part):
    width = len(str(count))
    ways = [f"{name}_{{:0{width}d}}", f"{name}_{{}}"]
    way = next(way for way in ways if way.format(1) + part in found)
    return [found[way.format(k) + part] for k in range(1, count + 1)]


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    program, speed, spacing, folder = sys.argv[1], float(sys.argv[2]), float(sys.argv[3]), pathlib.Path(sys.argv[4])
    if not (folder / "out/summary.json").exists():
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "scene.toml").write_text(scene(speed, spacing), encoding="utf-8")
        subprocess.run([program, "run", folder / "scene.toml", "--out", folder / "out", "--threads", "1"], check=True)
    end = BASE_END * BASE_SPEED / speed
    found, history = averages(folder / "out", end / 2)
    places = valve.sections()
    u = {name: along(found, name, len(where), "_x") for name, where in places.items()}
    v = {name: along(found, name, len(where), "_y") for name, where in places.items()}
    columns = {name: along(found, name, len(where), "_x") for name, where in valve.chamber_columns().items()}
    pressure = along(found, "pressure_on_axis", 141, "")
    results = valve.quantities(u, pressure, columns)
    fluxes = [row[1] for row in history]
    results["flux_least_over_mean"] = min(fluxes) / (sum(fluxes) / len(fluxes))
    results["flux_largest_over_mean"] = max(fluxes) / (sum(fluxes) / len(fluxes))
    with open(folder / "sections.csv", "w", encoding="utf-8") as file:
        file.write("section,x_mm,y_mm,u_m_s,v_m_s,p_pa\n")
        for name, where in places.items():
            for k, (x, y) in enumerate(where):
                p = f"{pressure[k]:.5g}" if name == "axis" else ""
                file.write(f"{name},{x * 1e3:.4f},{y * 1e3:.4f},{u[name][k]:.5g},{v[name][k]:.5g},{p}\n")
    with open(folder / "quantities.csv", "w", encoding="utf-8") as file:
        file.writelines(f"{name},{value:.6g}\n" for name, value in results.items())
    print((folder / "quantities.csv").read_text(encoding="utf-8"))


if __name__ == "__main__":
    main()
