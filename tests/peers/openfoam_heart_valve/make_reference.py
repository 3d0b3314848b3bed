#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""The heart valve with rigid leaflets by OpenFOAM (Debian's openfoam and gmsh): a solution on a grid, independent of dmp.

    make_reference.py run FOLDER SPEED CELL [FROM]     one run; CELL in mm; started from the run of another CELL, FROM
    make_reference.py whole FOLDER SPEED CELL          as run, of both halves of the valve
    make_reference.py tables FOLDER REFERENCES CELLS   writes REFERENCES/heart_valve_grid.csv and heart_valve_grid_sections.csv
                                                       from the runs of three cells, such as 1,0.7,0.5

Laminar incompressible flow, of second order on the grid (linear upwind) and in time; a parabola with SPEED [m/s] on the axis
flows in 45 mm upstream of the chamber's middle, the pressure is 0 80 mm downstream of it. The start is that of rigid.toml.
Averages over time are sampled along the sections of sections.py. SPEED and times go together: a run lasts END / SPEED and
averages from AVERAGE_FROM / SPEED on.
"""
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys

import case_files
import sections as valve

GEOMETRY = pathlib.Path(__file__).resolve().parents[3] / "cases/heart_valve/rigid.geo"
UPSTREAM, DOWNSTREAM = 0.045, 0.080
END, AVERAGE_FROM = 0.020, 0.010  # way of the inflow on the axis [m]
INSET = 1e-6  # sections end that far before a wall or the axis: on it, no cell holds the point [m]


def call(folder, *command):
    with open(folder / "log", "a", encoding="utf-8") as log:
        log.write(f"== {' '.join(command)}\n")
        log.flush()
        environment = {**os.environ, "WM_PROJECT_DIR": "/usr/share/openfoam"}
        subprocess.run(command, cwd=folder, stdout=log, stderr=subprocess.STDOUT, check=True, env=environment)


def read_places():
    places = {**valve.sections(), **valve.chamber_columns()}

    def inside(x, y, ends):
        low, high = ends
        return x, min(max(y, low + INSET), high - INSET)

    return {name: [(x, INSET) for x, _ in where] if name == "axis" else
            [inside(x, y, (where[0][1], where[-1][1])) for x, y in where] for name, where in places.items()}


def write_start(folder, speed):
    call(folder, "postProcess", "-func", "writeCellCentres", "-time", "0")
    text = (folder / "0/C").read_text(encoding="utf-8")
    centres = re.findall(r"\(([^ ()]+) ([^ ()]+) [^ ()]+\)", text[text.index("internalField"):text.index("boundaryField")])
    cells = "".join(f"({case_files.start(speed, float(x), float(y)):.8g} 0 0)\n" for x, y in centres)
    field = folder / "0/U"
    text = field.read_text(encoding="utf-8")
    text = text.replace("uniform (0 0 0);", f"nonuniform List<vector> {len(centres)} (\n{cells});", 1)
    field.write_text(text, encoding="utf-8")


def name_of(speed, cell, whole=False):
    return f"{speed:g}_{cell:g}" + ("_whole" if whole else "")


def run(root, speed, cell, whole, start):
    folder = root / name_of(speed, cell, whole)
    folder.mkdir(parents=True)
    for source in (GEOMETRY, pathlib.Path(__file__).resolve().with_name("mesh.geo")):
        shutil.copy(source, folder)
    case_files.write_case(folder, speed, whole, END / speed, AVERAGE_FROM / speed, 1e-6 / speed, read_places())
    numbers = {"cell": cell / 1e3, "upstream": UPSTREAM, "downstream": DOWNSTREAM, "whole": int(whole)}
    settings = [word for name, value in numbers.items() for word in ("-setnumber", name, str(value))]
    call(folder, "gmsh", "-3", "mesh.geo", *settings, "-o", "mesh.msh")
    call(folder, "gmshToFoam", "mesh.msh")
    boundary = folder / "constant/polyMesh/boundary"
    text = boundary.read_text(encoding="utf-8")
    for patch, kind in (("frontAndBack", "empty"), ("axis", "symmetryPlane"), ("wall", "wall"), ("leaflets", "wall")):
        text = re.sub(rf"(\n\s*{patch}\s*\{{\s*type\s+)patch", rf"\g<1>{kind}", text)
    boundary.write_text(re.sub(r"physicalType\s+patch;", "", text), encoding="utf-8")
    call(folder, "checkMesh")
    if start is None:
        write_start(folder, speed)
    else:
        call(folder, "mapFields", f"../{name_of(speed, start)}", "-sourceTime", "latestTime", "-consistent")
    call(folder, "pimpleFoam")
    call(folder, "postProcess", "-func", "atSections", "-latestTime")


def read_run(folder):
    """u, v, p [Pa] and the scatter of u by section."""
    last = max((folder / "postProcessing/atSections").iterdir(), key=lambda path: float(path.name))
    found = {}
    for name, where in read_places().items():
        values = {}
        for path in last.glob(f"{name}_*.xy"):
            for line in path.read_text(encoding="utf-8").splitlines():
                row = [float(word) for word in line.split()]
                x, y, rest = row[0], row[1], row[3:]
                fields = [field for field in ("pMean", "UMean", "UPrime2Mean") if field in path.name]
                widths = {"pMean": 1, "UMean": 3, "UPrime2Mean": 6}
                for field in fields:
                    values.setdefault((round(x * 1e7), round(y * 1e7)), {})[field] = rest[:widths[field]]
                    rest = rest[widths[field]:]
        rows = [values.get((round(x * 1e7), round(y * 1e7)), {}) for x, y in where]
        nan = [math.nan] * 6
        found[name] = {"u": [row.get("UMean", nan)[0] for row in rows], "v": [row.get("UMean", nan)[1] for row in rows],
                       "p": [row.get("pMean", nan)[0] * valve.DENSITY for row in rows],
                       "scatter": [math.sqrt(max(row.get("UPrime2Mean", nan)[0], 0)) for row in rows]}
    return found


def quantities(found):
    u = {name: values["u"] for name, values in found.items()}
    return valve.quantities(u, found["axis"]["p"], u)


def extrapolated(values, cells):
    """Richardson's limit of three values, coarse to fine, and the error of the finest: with the order that they show, from 1
    to 2. Where they do not go one way there is no limit, and the error is the largest difference between them."""
    coarse, middle, fine = values
    change, before = fine - middle, middle - coarse
    if change * before <= 0:
        return math.nan, max(values) - min(values)
    ratio = cells[1] / cells[2]
    order = min(max(math.log(before / change) / math.log(ratio), 1.0), 2.0)
    limit = fine + change / (ratio**order - 1)
    return limit, abs(limit - fine)


def tables(root, references, cells):
    head = ("by OpenFOAM v1912 (laminar, averaged over time) on quadrilaterals of gmsh, upper half of "
            "cases/heart_valve/rigid.geo; made by tests/peers/openfoam_heart_valve/make_reference.py")
    columns = [f"cells_{cell:g}_mm" for cell in cells]
    lines = [f"# Heart valve with rigid leaflets: what was compared, {head}. limit: Richardson's, error: of the finest",
             "inflow_m_s,quantity," + ",".join(columns) + ",limit,error"]
    rows = [f"# Heart valve with rigid leaflets: averages along sections, {head}. u_middle: of the middle mesh; "
            "scatter: standard deviation of u in time",
            "inflow_m_s,section,x_mm,y_mm,u_middle_m_s,u_m_s,scatter_m_s,p_pa"]
    for speed in valve.SPEEDS:
        runs = [read_run(root / name_of(speed, cell)) for cell in cells]
        found = [quantities(one) for one in runs]
        for name in found[0]:
            values = [one[name] for one in found]
            lines.append(",".join([f"{speed:g}", name, *(f"{value:.5g}" for value in (*values, *extrapolated(values, cells)))]))
        for name, where in valve.sections().items():
            fine = runs[-1][name]
            for k, (x, y) in enumerate(where):
                if k % {"axis": 4, "chamber": 4, "inlet": 2}.get(name, 1):
                    continue
                numbers = [runs[-2][name]["u"][k], fine["u"][k], fine["scatter"][k], fine["p"][k]]
                if not any(math.isnan(n) for n in numbers):
                    places = [f"{speed:g}", name, f"{x * 1e3:.3f}", f"{y * 1e3:.3f}"]
                    rows.append(",".join(places + [f"{n:.3g}" if n == numbers[2] else f"{n:.4g}" for n in numbers]))
    for name, text in (("heart_valve_grid.csv", lines), ("heart_valve_grid_sections.csv", rows)):
        (references / name).write_text("\n".join(text) + "\n", encoding="utf-8")


def main():
    words = sys.argv[1:]
    if len(words) in (4, 5) and words[0] in ("run", "whole"):
        run(pathlib.Path(words[1]), float(words[2]), float(words[3]), words[0] == "whole",
            float(words[4]) if len(words) == 5 else None)
    elif len(words) == 4 and words[0] == "tables":
        tables(pathlib.Path(words[1]), pathlib.Path(words[2]), [float(cell) for cell in words[3].split(",")])
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
