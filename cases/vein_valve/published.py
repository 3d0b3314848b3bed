#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a table of what the frames and measures of published.toml's runs hold that no [[result]] can: PUBLISHED.md.

    python3 cases/vein_valve/published.py out/published out/published.csv [LAST_CYCLE]

A row is a run and one of its cycles of 4 s from the second on. Needs python3-vtk9 and python3-scipy, as docs/python.md says.
"""

import csv
import pathlib
import sys
import xml.etree.ElementTree

import numpy
import scipy.spatial
import vtk
from vtk.util.numpy_support import vtk_to_numpy

PERIOD = 4.0  # s
DOMAIN = 0.092  # m, the period of the channel
BESIDE = 0.8e-3  # m: blood nearer than that to a leaflet is beside it
CLOSED = 0.6e-3  # m: a narrower gap counts as closed, as in README.md


def frames(series, start, end):
    """(time [s], arrays in the order of ids) of the frames of a .pvd file from start to end."""
    series = pathlib.Path(series)
    for data_set in xml.etree.ElementTree.parse(series).iter("DataSet"):
        time = float(data_set.get("timestep"))
        if start - 1e-9 <= time <= end + 1e-9:
            reader = vtk.vtkXMLPolyDataReader()
            reader.SetFileName(str(series.parent / data_set.get("file")))
            reader.Update()
            points = reader.GetOutput().GetPointData()
            order = numpy.argsort(vtk_to_numpy(points.GetArray("id")))
            arrays = {points.GetArrayName(i): vtk_to_numpy(points.GetArray(i))[order]
                      for i in range(points.GetNumberOfArrays())}
            arrays["position"] = vtk_to_numpy(reader.GetOutput().GetPoints().GetData())[order].astype(float)
            yield time, arrays


def in_sinus(position):
    """Which particles are in the sinuses: outside the vein's width, away from the sharp corners and the roots."""
    return (numpy.abs(position[:, 0]) < 0.018) & (numpy.abs(position[:, 1]) > 0.0045)


def of_measures(run, start, end):
    """Flow, gap and closing of a cycle, from measures.csv."""
    with open(run / "measures.csv", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    names = [heading.split(" [")[0] for heading in rows[0]]
    values = numpy.array([[float(value) for value in row] for row in rows[1:]])
    values = values[(values[:, 0] >= start - 1e-9) & (values[:, 0] <= end + 1e-9)]
    column = dict(zip(names, values.T))
    time, flux, gap = column["time"], column["inlet_flux"], column["tip_gap"]
    volume = lambda y: float(numpy.sum(0.5 * (y[1:] + y[:-1]) * numpy.diff(time)))
    widest = int(gap.argmax())
    closed = numpy.where(gap[widest:] < CLOSED)[0]
    result = {"inlet_peak [m/s]": column["inlet_velocity_x"].max(), "forward [cm^2]": 1e4 * volume(numpy.maximum(flux, 0)),
              "net [cm^2]": 1e4 * volume(flux), "widest_gap [mm]": 1e3 * gap.max(), "narrowest_gap [mm]": 1e3 * gap.min(),
              "closed_at [s]": float("nan"), "closing_takes [s]": float("nan")}
    if closed.size:
        at = widest + closed[0]
        result["closed_at [s]"] = time[at] - start
        # from the last time at 90 % of the widest gap
        result["closing_takes [s]"] = time[at] - time[numpy.where(gap[:at] > 0.9 * gap.max())[0][-1]]
    return result


def of_frames(run, start, end):
    """Stresses, displacements and residence times of a cycle, from its frames."""
    stress, moved, leaflets = [], [], {}
    for time, solid in frames(run / "solid.pvd", start, end):
        stress.append(solid["von_mises"].max())
        if stress[-1] == max(stress):  # from the root, 0, to the tip, 1, along the straight leaflet
            x = (solid["position"] - solid["displacement"])[:, 0]
            at_leaflet = (x[solid["von_mises"].argmax()] - x.min()) / (x.max() - x.min())
        moved.append(numpy.linalg.norm(solid["displacement"], axis=1))
        leaflets[round(time, 6)] = solid["position"]
    moved = numpy.array(moved)
    shear, opening, sinus, total, beside, away = [], [], [], [], [], []
    inside = None
    for time, fluid in frames(run / "fluid.pvd", start, end):
        position, here = fluid["position"], in_sinus(fluid["position"])
        stay = fluid["residence_time_upper_sinus"] + fluid["residence_time_lower_sinus"]
        leaflet = leaflets[round(time, 6)]
        between = (numpy.abs(position[:, 0] - leaflet[:, 0].max()) < 0.002) & (numpy.abs(position[:, 1]) < 0.004)
        opening.append(fluid["shear_stress"][between].max())
        sinus.append(fluid["shear_stress"][here].max())
        total.append(fluid["von_mises"][here].max())
        shear.append(fluid["shear_stress"].max())
        if shear[-1] == max(shear):
            at = 1e3 * position[fluid["shear_stress"].argmax()]
        chamber = numpy.abs(position[:, 0]) < 0.02
        distance, _ = scipy.spatial.cKDTree(leaflet[:, :2]).query(position[chamber][:, :2])
        beside.append(fluid["von_mises"][chamber][distance < BESIDE].mean())
        away.append(fluid["von_mises"][chamber][distance >= BESIDE].mean())
        if inside is None:
            inside, before, way, stay_0 = here, position, numpy.zeros_like(position), stay
            ways = []
        step = position - before
        step[:, 0] -= DOMAIN * numpy.round(step[:, 0] / DOMAIN)
        way, before = way + step, position
        ways.append(numpy.linalg.norm(way[inside], axis=1))
    ways = numpy.mean(ways, axis=0)
    stays = (stay - stay_0)[inside]
    return {"shear_opening [Pa]": max(opening), "shear_sinus [Pa]": max(sinus),
            "mean_shear_opening [Pa]": numpy.mean(opening), "mean_shear_sinus [Pa]": numpy.mean(sinus),
            "shear_anywhere [Pa]": max(shear), "shear_at_x [mm]": at[0], "shear_at_y [mm]": at[1],
            "mean_total_beside [Pa]": numpy.mean(beside), "mean_total_away [Pa]": numpy.mean(away),
            "leaflets_at": at_leaflet, "total_sinus [Pa]": max(total), "total_leaflets [Pa]": max(stress),
            "leaflet_displacement [mm]": 1e3 * moved.mean(), "tip_displacement [mm]": 1e3 * moved.mean(axis=0).max(),
            "sinus_displacement [mm]": 1e3 * ways.mean(), "median_sinus_displacement [mm]": 1e3 * numpy.median(ways),
            "residence [s]": stays.mean(), "never_left": (stays > 0.98 * (end - start)).mean()}


def main():
    """Writes the table."""
    study, table = pathlib.Path(sys.argv[1]), sys.argv[2]
    last = int(sys.argv[3]) if len(sys.argv) > 3 else 2
    with open(study / "results.csv", encoding="utf-8") as file:
        runs = [row for row in csv.DictReader(file) if row["exit_code"] == "0"]
    writer = None
    with open(table, "w", encoding="utf-8", newline="") as file:
        for row in runs:
            given = {"run": row["run"], "velocity [m/s]": row["velocity [m/s]"],
                     "leaflet [mm]": row["geometry.parameters.leaflet_length [mm]"],
                     "EI [N*m^2]": row["part.leaflets.bending_stiffness [N*m^2]"]}
            for cycle in range(2, last + 1):
                run, start, end = study / "runs" / row["run"], (cycle - 1) * PERIOD, cycle * PERIOD
                values = {**given, "cycle": cycle, **of_measures(run, start, end), **of_frames(run, start, end)}
                writer = writer or csv.DictWriter(file, values.keys())
                if cycle == 2 and row is runs[0]:
                    writer.writeheader()
                writer.writerow({k: f"{v:.6g}" if isinstance(v, float | numpy.floating) else v for k, v in values.items()})
                file.flush()


if __name__ == "__main__":
    main()
