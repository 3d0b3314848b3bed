#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres as LAMMPS sees them: a reference for dmp's contacts with history.

    make_reference.py REFERENCE [FOLDER]

Packs spheres of unlike radii and densities at random, pushed together and spinning, lets LAMMPS (`lmp`, pair_style
gran/hertz/history) find forces and torques at the start and everything after 1000 steps, and writes all of it to the
text file REFERENCE. LAMMPS works in FOLDER, or in one that is removed again.
"""
import math
import pathlib
import random
import subprocess
import sys
import tempfile

SPHERES, SOLID_FRACTION = 200, 0.64
STEPS, DT = 1000, 1e-7  # an impact at 0.5 m/s lasts about 4e-5 s
LAW = {"kn": 5e8, "kt": 6e8, "gn": 2e8, "gt": 1e8, "mu": 0.4}


def pack(rng):
    """Places of spheres in a ball, drawn at random and pushed apart until few overlap by more than 1 % of a radius."""
    radii = [rng.uniform(0.6e-3, 1.4e-3) for _ in range(SPHERES)]
    room = (sum(r**3 for r in radii) / SOLID_FRACTION) ** (1 / 3)

    def anywhere():
        while True:
            place = [rng.uniform(-room, room) for _ in range(3)]
            if math.dist(place, (0, 0, 0)) < room:
                return place

    places = [anywhere() for _ in radii]
    for _ in range(120):
        moves = [[0.0, 0.0, 0.0] for _ in radii]
        for i in range(SPHERES):
            for j in range(i):
                distance = math.dist(places[i], places[j])
                overlap = radii[i] + radii[j] - distance
                if overlap > 0.002 * min(radii[i], radii[j]):
                    for axis in range(3):
                        push = 0.4 * overlap * (places[i][axis] - places[j][axis]) / distance
                        moves[i][axis] += push
                        moves[j][axis] -= push
        places = [[0.9998 * x + dx for x, dx in zip(place, move)] for place, move in zip(places, moves)]
    return radii, places, room


def row(*values):
    return " ".join(f"{value:.17g}" if isinstance(value, float) else str(value) for value in values)


def write_input(folder, rng):
    radii, places, room = pack(rng)
    atoms, velocities = [], []
    for n, (radius, place) in enumerate(zip(radii, places), 1):
        atoms.append(row(n, 1, 2 * radius, rng.uniform(1000, 4000), *place))
        inward = [-2 * x / room + rng.uniform(-0.3, 0.3) for x in place]
        velocities.append(row(n, *inward, *(rng.uniform(-300, 300) for _ in range(3))))
    far = 2 * room
    head = ["spheres", "", f"{SPHERES} atoms", "1 atom types"]
    head += [f"{-far:.6g} {far:.6g} {axis}lo {axis}hi" for axis in "xyz"]
    text = "\n".join(head) + "\n\nAtoms\n\n" + "\n".join(atoms) + "\n\nVelocities\n\n" + "\n".join(velocities) + "\n"
    (folder / "spheres.data").write_text(text, encoding="utf-8")


def read_dump(path):
    """Each snapshot as rows of radius, mass, place, velocity, spin, force, torque by sphere."""
    snapshots, lines = [], path.read_text(encoding="utf-8").splitlines()
    for k, line in enumerate(lines):
        if line.startswith("ITEM: ATOMS"):
            snapshots.append([[float(x) for x in text.split()[1:]] for text in lines[k + 1:k + 1 + SPHERES]])
    return snapshots


def make(reference, folder):
    write_input(folder, random.Random(20110701))
    script = pathlib.Path(__file__).resolve().with_name("spheres.in")
    variables = {"dt": DT, "steps": STEPS, "skin": 2e-4, **LAW}
    arguments = [word for name, value in variables.items() for word in ("-var", name, repr(value))]
    subprocess.run(["lmp", "-in", str(script), *arguments, "-log", "log.txt", "-screen", "none"],
                   cwd=folder, check=True)
    start, end = read_dump(folder / "spheres.dump")
    lines = ["# Spheres in contact by LAMMPS; made by tests/peers/lammps_spheres/make_reference.py",
             "# step: number, dt. law: k_n, k_t [Pa], g_n, g_t [1/(m s)], mu. sphere: radius, mass, then place, velocity,",
             "# spin, force, torque at the start and after the last step, three numbers each. SI units.",
             row("step", STEPS, DT), row("law", *LAW.values())]
    lines += [row("sphere", *first, *last[2:]) for first, last in zip(start, end)]
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
