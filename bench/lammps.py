#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""LAMMPS on dmp_bench's particles.

    bench/lammps.py PARTICLES FOLDER     PARTICLES as `dmp_bench --particles-to` writes them;
                                         leaves channel.data and channel.in in FOLDER: lmp -in channel.in

The physics are those of `dmp_bench --plain --kernel lucy`: Tait, Morris, continuity and plain walls. LAMMPS makes one
sweep over the pairs in a step and knows no other kernel in its SPH package.
"""
import json
import os
import re
import subprocess
import sys

PAIR_STYLE = "sph/taitwater/morris"
FLUID, WALL = 1, 2
SKIN_OF_SUPPORT = 0.1
# It advances densities half a step ahead of the forces, which stays quiet to about this c0 dt / R only.
COURANT_NUMBER = 0.008
WARM_UP_STEPS = 20


class LammpsError(Exception):
    """LAMMPS did not do what it was asked."""


def read_particles(path):
    """The head, a dictionary, and (fixed, x, y, z) of each particle."""
    with open(path, encoding="utf-8") as file:
        head = json.loads(file.readline())
        rows = [(fixed == "1", float(x), float(y), float(z)) for fixed, x, y, z in map(str.split, file)]
    if len(rows) != head["particles"]:
        raise LammpsError(f"{path} has {len(rows)} particles, its head says {head['particles']}")
    return head, rows


def box_of(head):
    """Low and high of the box by axis; room beside the walls, and one spacing deep in 2-D."""
    dx = head["spacing"]
    bounds = []
    for axis, (low, high) in enumerate(zip(head["low"], head["high"])):
        if axis == 2 and head["dimension"] == 2:
            low, high = -dx / 2, dx / 2
        elif not head["periodic"][axis]:
            low, high = low - dx, high + dx
        bounds.append((low, high))
    return bounds


def data_text(head, rows):
    """The data file: particles with density at rest, the liquid at its speed."""
    lines = ["dmp_bench's particles, SI units", "", f"{len(rows)} atoms", "2 atom types", ""]
    lines += [f"{low:.17g} {high:.17g} {axis}lo {axis}hi" for axis, (low, high) in zip("xyz", box_of(head))]
    lines += ["", "Masses", ""]
    lines += [f"{kind} {head['particle_mass']:.17g}" for kind in (FLUID, WALL)]
    lines += ["", "Atoms", ""]
    for number, (fixed, x, y, z) in enumerate(rows, 1):
        # id, type, density, internal energy, heat capacity, place
        lines.append(f"{number} {WALL if fixed else FLUID} {head['density']:.17g} 0 1 {x:.17g} {y:.17g} {z:.17g}")
    lines += ["", "Velocities", ""]
    lines += [f"{number} {0 if row[0] else head['speed']} 0 0" for number, row in enumerate(rows, 1)]
    return "\n".join(lines) + "\n"


def input_text(head, data, steps):
    """The input script; the last of its runs is the one to time."""
    support = head["support"]
    step = COURANT_NUMBER * support / head["sound_speed"]
    # A box that is not periodic in the z of 2-D is refused.
    periodic = [flag or (axis == 2 and head["dimension"] == 2) for axis, flag in enumerate(head["periodic"])]
    return f"""units si
dimension {head['dimension']}
boundary {' '.join('p' if flag else 'f' for flag in periodic)}
newton on
atom_style sph
read_data {data}
group fluid type {FLUID}
group wall type {WALL}
neighbor {SKIN_OF_SUPPORT * support:.17g} bin
neigh_modify every 1 delay 0 check yes exclude group wall wall
pair_style {PAIR_STYLE}
pair_coeff * * {head['density']:.17g} {head['sound_speed']:.17g} {head['viscosity']:.17g} {support:.17g}
fix push fluid gravity {head['acceleration']:.17g} vector 1 0 0
fix flow fluid sph
fix rest wall sph/stationary
timestep {step:.17g}
thermo 1000000000
run {WARM_UP_STEPS}
run {steps}
"""


def has_sph(lmp):
    """Whether this LAMMPS has the SPH package. Throws LammpsError when it cannot be asked."""
    try:
        told = subprocess.run([lmp, "-h"], capture_output=True, text=True, check=False, timeout=60)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise LammpsError(f"{lmp} -h: {error}") from error
    if told.returncode != 0:
        raise LammpsError(f"{lmp} -h ended with code {told.returncode}: {told.stderr.strip()}")
    return PAIR_STYLE in told.stdout.split()


def read_log(text):
    """What the last run of a log says: rate, share of the pair loop, neighbours."""
    loops = list(re.finditer(r"Loop time of (\S+) on (\d+) procs for (\d+) steps with (\d+) atoms", text))
    if not loops:
        raise LammpsError("no 'Loop time' in LAMMPS' log")
    seconds, ranks = float(loops[-1][1]), int(loops[-1][2])
    steps, atoms = int(loops[-1][3]), int(loops[-1][4])
    tail = text[loops[-1].start():]

    def number(pattern):
        found = re.search(pattern, tail, re.MULTILINE)
        if not found:
            raise LammpsError(f"no '{pattern}' in LAMMPS' log")
        return float(found[1])

    return {
        "atoms": atoms,
        "steps": steps,
        "particle_steps_per_s_core": atoms * steps / (seconds * ranks),
        "pair_percent": number(r"^Pair *\|.*\| *([\d.]+)\s*$"),
        "cpu_percent": number(r"^([\d.]+)% CPU use"),
        "pairs_listed_per_particle": number(r"^Ave neighs/atom = (\S+)"),
        "list_builds": int(number(r"^Neighbor list builds = (\d+)")),
    }


def write_case(particles, folder, steps):
    """channel.data and channel.in; returns the input's path."""
    head, rows = read_particles(particles)
    with open(os.path.join(folder, "channel.data"), "w", encoding="utf-8") as file:
        file.write(data_text(head, rows))
    script = os.path.join(folder, "channel.in")
    with open(script, "w", encoding="utf-8") as file:
        file.write(input_text(head, "channel.data", steps))
    return script


def run(lmp, particles, folder, steps):
    """One run on one core; what read_log returns. Throws LammpsError."""
    script = write_case(particles, folder, steps)
    log = os.path.join(folder, "log.lammps")
    command = [lmp, "-in", os.path.basename(script), "-log", log, "-screen", "none"]
    ended = subprocess.run(command, cwd=folder, env={**os.environ, "OMP_NUM_THREADS": "1"}, capture_output=True,
                           text=True, check=False)
    text = ""
    if os.path.exists(log):
        with open(log, encoding="utf-8", errors="replace") as file:
            text = file.read()
    if ended.returncode != 0:
        said = re.findall(r"^ERROR.*", text, re.MULTILINE) or [ended.stderr.strip()]
        raise LammpsError(f"{lmp} ended with code {ended.returncode}: {said[0]}")
    return read_log(text)


def main(arguments):
    if len(arguments) != 2 or arguments[0].startswith("-"):
        print(__doc__.strip(), file=sys.stderr)
        return 2
    try:
        print(write_case(*arguments, steps=100))
    except (OSError, ValueError, LammpsError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
