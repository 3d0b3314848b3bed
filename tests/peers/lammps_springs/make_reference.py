#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Springs as LAMMPS sees them: a reference for dmp's bonds and angles in 3-D.

    make_reference.py REFERENCE [FOLDER]

Draws a random tree of nodes with extra bonds, strained bonds and angles and moving nodes, lets LAMMPS (`lmp`) find the
forces, the energies and the places after 1000 steps, and writes all of it to the text file REFERENCE. LAMMPS works in
FOLDER, or in one that is removed again.
"""
import math
import pathlib
import random
import subprocess
import sys
import tempfile

NODES, EXTRA_BONDS, ANGLES = 40, 12, 50
STEPS, DT = 1000, 0.004  # the stiffest bond alone has a period of 0.5


def configuration(rng):
    """Nodes as (mass, place, velocity), bonds as (a, b, k, r0), angles as (a, centre, b, k, degrees)."""
    def vector(size):
        return [rng.uniform(-size, size) for _ in range(3)]

    nodes = [(rng.uniform(0.5, 2), vector(0.5), vector(0.3))]
    pairs = []
    while len(nodes) < NODES:
        root = rng.randrange(len(nodes))
        arm = vector(1)
        length = math.dist(arm, (0, 0, 0))
        if not 0.5 < length < 1:
            continue
        place = [x + a / length * rng.uniform(0.8, 1.2) for x, a in zip(nodes[root][1], arm)]
        if any(math.dist(place, other[1]) < 0.4 for other in nodes):
            continue
        pairs.append((root, len(nodes)))
        nodes.append((rng.uniform(0.5, 2), place, vector(0.3)))
    while len(pairs) < NODES - 1 + EXTRA_BONDS:
        a, b = sorted(rng.sample(range(NODES), 2))
        if (a, b) not in pairs and math.dist(nodes[a][1], nodes[b][1]) < 2:
            pairs.append((a, b))

    def bond(a, b):
        return a, b, rng.uniform(10, 60), math.dist(nodes[a][1], nodes[b][1]) * rng.uniform(0.8, 1.2)

    ends = {}
    for a, b in pairs:
        ends.setdefault(a, []).append(b)
        ends.setdefault(b, []).append(a)
    corners = [(a, centre, b) for centre, others in sorted(ends.items())
               for k, a in enumerate(others) for b in others[:k]]

    def degrees(a, centre, b):
        p, q = ([x - y for x, y in zip(nodes[n][1], nodes[centre][1])] for n in (a, b))
        cosine = sum(x * y for x, y in zip(p, q)) / math.dist(p, (0, 0, 0)) / math.dist(q, (0, 0, 0))
        return math.degrees(math.acos(cosine))

    corners = [corner for corner in corners if 30 < degrees(*corner) < 150]
    angles = [(*corner, rng.uniform(1, 8), min(175, max(5, degrees(*corner) + rng.uniform(-30, 30))))
              for corner in rng.sample(corners, min(ANGLES, len(corners)))]
    return nodes, [bond(a, b) for a, b in pairs], angles


def row(*values):
    return " ".join(f"{value:.17g}" if isinstance(value, float) else str(value) for value in values)


def write_input(folder, nodes, bonds, angles):
    sections = {
        "Masses": [row(n, mass) for n, (mass, _, _) in enumerate(nodes, 1)],
        "Atoms": [row(n, 1, n, *place) for n, (_, place, _) in enumerate(nodes, 1)],
        "Velocities": [row(n, *velocity) for n, (_, _, velocity) in enumerate(nodes, 1)],
        "Bonds": [row(n, n, a + 1, b + 1) for n, (a, b, _, _) in enumerate(bonds, 1)],
        "Angles": [row(n, n, a + 1, c + 1, b + 1) for n, (a, c, b, _, _) in enumerate(angles, 1)],
    }
    counts = {"atoms": nodes, "bonds": bonds, "angles": angles}
    head = ["springs", ""] + [f"{len(items)} {name}" for name, items in counts.items()]
    head += [f"{len(nodes)} atom types", f"{len(bonds)} bond types", f"{len(angles)} angle types"]
    head += ["20 extra bond per atom", "60 extra angle per atom", "60 extra special per atom"]
    head += [f"-20 20 {axis}lo {axis}hi" for axis in "xyz"]
    text = "\n".join(head) + "\n\n" + "\n".join(
        f"{name}\n\n" + "\n".join(rows) + "\n" for name, rows in sections.items())
    (folder / "springs.data").write_text(text, encoding="utf-8")
    coefficients = [row("bond_coeff", n, k, r0) for n, (_, _, k, r0) in enumerate(bonds, 1)]
    coefficients += [row("angle_coeff", n, k, rest) for n, (_, _, _, k, rest) in enumerate(angles, 1)]
    (folder / "coefficients.in").write_text("\n".join(coefficients) + "\n", encoding="utf-8")


def read_dump(path):
    """Each snapshot as rows of x, y, z, fx, fy, fz by node."""
    snapshots, lines = [], path.read_text(encoding="utf-8").splitlines()
    for k, line in enumerate(lines):
        if line.startswith("ITEM: ATOMS"):
            snapshots.append([[float(x) for x in text.split()[1:]] for text in lines[k + 1:k + 1 + NODES]])
    return snapshots


def read_energies(path):
    """Bond and angle energy of the start."""
    lines = path.read_text(encoding="utf-8").splitlines()
    first = next(k for k, line in enumerate(lines) if line.split()[:1] == ["Step"]) + 1
    return [float(value) for value in lines[first].split()[1:]]


def make(reference, folder):
    nodes, bonds, angles = configuration(random.Random(20240229))
    write_input(folder, nodes, bonds, angles)
    script = pathlib.Path(__file__).resolve().with_name("springs.in")
    subprocess.run(["lmp", "-in", str(script), "-var", "dt", repr(DT), "-log", "log.txt", "-screen", "none"],
                   cwd=folder, check=True)
    start, end = read_dump(folder / "springs.dump")
    lines = ["# Bonds and angles in 3-D by LAMMPS; made by tests/peers/lammps_springs/make_reference.py"]
    lines += [row("step", STEPS, DT), row("energy", *read_energies(folder / "log.txt"))]
    lines += [row("bond", *bond) for bond in bonds]
    lines += [row("angle", *angle) for angle in angles]
    for (mass, place, velocity), first, last in zip(nodes, start, end):
        lines.append(row("node", mass, *place, *velocity, *first[3:], *last[:3]))
    pathlib.Path(reference).write_text("\n".join(lines) + "\n", encoding="utf-8")


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    if len(sys.argv) == 3:
        make(sys.argv[1], pathlib.Path(sys.argv[2]))
        return
    with tempfile.TemporaryDirectory() as folder:
        make(sys.argv[1], pathlib.Path(folder))


if __name__ == "__main__":
    main()
