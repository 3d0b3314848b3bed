#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""The heart valve with rigid leaflets by dmp, to compare with tests/data/heart_valve_grid*.csv.

    run_particles.py DMP SPEED SPACING FOLDER

Runs cases/heart_valve/rigid.toml with an inflow of SPEED [m/s] on the axis, particles SPACING [mm] apart, into FOLDER. All
speeds of the scene go with SPEED, pressures with its square, times with its inverse. It writes FOLDER/sections.csv and
FOLDER/quantities.csv, averages of lines over the second half of the run, and FOLDER/particles.csv: then the run goes on by a
fifth with 30 frames, and the velocities of the particles themselves that are within BAND of the two sections at the tips are
averaged in BINS from the axis to the leaflet. Lines smooth over the kernel's support, which at the tips is as wide as the jet.
Needs Debian's python3-vtk9.
"""
import csv
import math
import pathlib
import re
import subprocess
import sys

import sections as valve

CASE = pathlib.Path(__file__).resolve().parents[3] / "cases/heart_valve"
BASE_SPEED, BASE_END = 0.2, 0.1  # of the runs [m/s, s]
FRAMES, BAND, BINS = 30, 0.15e-3, 12


def scene(speed, spacing):
    ratio = speed / BASE_SPEED
    text = (CASE / "rigid.toml").read_text(encoding="utf-8")

    def scaled(pattern, factor):
        nonlocal text
        text, count = re.subn(pattern, lambda found: f"{found[1]}{float(found[2]) * factor:.10g}{found[3]}", text)
        assert count > 0, pattern

    scaled(r'(largest_speed = ")([0-9.]+)( m/s")', ratio)
    scaled(r'(\? )([0-9.]+)( m/s\^2 \* sin)', ratio**2)
    scaled(r'([:?]\s+)([1-9][0-9.]*)( Pa)', ratio**2)
    scaled(r'(\?\s+)([0-9.]+)( m/s \* 12.5 mm)', ratio)
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


def averages(folder, start, end):
    with open(folder / "measures.csv", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    names = [name.split(" ")[0] for name in rows[0]]
    values = [[float(value) for value in row] for row in rows[1:] if start <= float(row[0]) <= 1.001 * end]

    def mean(column):
        known = [value for value in column if not math.isnan(value)]
        return sum(known) / len(known) if known else math.nan

    return dict(zip(names, map(mean, zip(*values)))), [row[:2] for row in values]


def along(found, name, count, part):
    width = len(str(count))
    ways = [f"{name}_{{:0{width}d}}", f"{name}_{{}}"]
    way = next(way for way in ways if way.format(1) + part in found)
    return [found[way.format(k) + part] for k in range(1, count + 1)]


def read_frame(path):
    """Time, places and velocities of the fluid particles."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutput()
    time = data.GetFieldData().GetArray("TimeValue").GetValue(0)
    return time, vtk_to_numpy(data.GetPoints().GetData()), vtk_to_numpy(data.GetPointData().GetArray("velocity"))


def particles_at(results, start, ends):
    """Of each section in `ends` (x, length) the mean of u over the mean inflow of that time, and the count, by bin."""
    with open(results / "measures.csv", encoding="utf-8") as file:
        flux = [(float(row[0]), float(row[1])) for row in list(csv.reader(file))[1:]]
    sums = {name: [[0.0, 0] for _ in range(BINS)] for name in ends}
    for path in sorted((results / "frames").glob("fluid_*.vtp")):
        time, places, velocities = read_frame(path)
        if time < start:
            continue
        (t0, q0), (t1, q1) = next((a, b) for a, b in zip(flux, flux[1:]) if b is flux[-1] or b[0] >= time)
        mean = (q0 + (q1 - q0) * (time - t0) / (t1 - t0)) / valve.HALF_WIDTH
        for name, (x, length) in ends.items():
            for (px, py, _), (u, _, _) in zip(places, velocities):
                if abs(px - x) < BAND and py < length:
                    entry = sums[name][int(py / length * BINS)]
                    entry[0] += float(u) / mean
                    entry[1] += 1
    return sums


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    program, speed, spacing, folder = sys.argv[1], float(sys.argv[2]), float(sys.argv[3]), pathlib.Path(sys.argv[4])
    end = BASE_END * BASE_SPEED / speed
    if not (folder / "out/summary.json").exists():
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "scene.toml").write_text(scene(speed, spacing), encoding="utf-8")
        subprocess.run([program, "run", folder / "scene.toml", "--out", folder / "out", "--threads", "1", "--until",
                        f"{end:.9g} s"], check=True)
    if not (folder / "particles.csv").exists():
        subprocess.run([program, "run", folder / "scene.toml", "--out", folder / "out", "--threads", "1", "--resume",
                        "--until", f"{1.2 * end:.9g} s", "--set", f"output.every={0.2 * end / FRAMES:.9g} s",
                        "--set", "output.pictures=false"], check=True)
        ends = {"throat": (valve.THROAT, valve.THROAT_HALF), "tip": (valve.TIP, valve.TIP_GAP / 2)}
        with open(folder / "particles.csv", "w", encoding="utf-8") as file:
            file.write("section,bin,u_over_mean_inflow,count\n")
            for name, bins in particles_at(folder / "out", 1.001 * end, ends).items():
                for k, (total, count) in enumerate(bins):
                    file.write(f"{name},{k},{total / count if count else math.nan:.5g},{count}\n")
    found, history = averages(folder / "out", end / 2, end)
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
