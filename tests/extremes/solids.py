# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic solids: stiffness, length and mass over many decades."""
import math

from extreme import Extreme
from scenes import head, table

CLAMPED_FREE = 1.8751040687  # of cos(x) cosh(x) = -1


def strip(length=0.2, bending=1.0, weight=20.0, stepping="implicit", cells=40, periods=4.0, numerics=None,
          steps_per_period=0.0):
    """A clamped strip [m] of bending stiffness [N m] and mass [kg/m^2], bent by a hundredth of its length, released:
    the period of its swings, over that of a beam."""
    omega = (CLAMPED_FREE / length)**2 * math.sqrt(bending / weight)
    period, spacing = 2 * math.pi / omega, length / cells
    thickness = length / 10
    load = 0.01 * 3 * bending / length**2
    released = 1.5 * period
    end = released + periods * period
    geo = f"Point(1) = {{0, 0, 0}};\nPoint(2) = {{{length!r}, 0, 0}};\nLine(1) = {{1, 2}};\n"
    geo += "Physical Curve(\"strip\") = {1};\nPhysical Point(\"clamp\") = {1};\n"
    text = head() + table("[geometry]", file="strip.geo") + table("[particles]", spacing=(spacing, "m"))
    text += table("[[part]]", name="strip", kind="elastic", youngs_modulus=(12 * bending / thickness**3, "Pa"),
                  thickness=(thickness, "m"), poisson_ratio=0, mass_per_length=(weight, "kg/m"), anchor="clamp",
                  bond_damping=0)
    text += table("[flow]", largest_speed=(0.02 * length * omega, "m/s"))
    # Sound sets the steps, 1.5 spacings over its speed.
    sound = 1.5 * spacing * steps_per_period / period if steps_per_period else 100 * spacing * omega
    text += table("[numerics]", sound_speed=(sound, "m/s"), spring_stepping=stepping, **(numerics or {}))
    text += table("[contact]", range=0)
    ramp = f"(1 - cos(pi * min(t / {released!r} s, 1))) / 2"
    text += "[[force]]\nname = \"bend\"\npart = \"strip\"\namount = \"per_particle\"\n"
    text += f"force = [0, \"x > {length - spacing / 2!r} m ? {load / 2!r} N * {ramp} : 0\"]\nuntil = \"{released!r} s\"\n\n"
    text += table("[run]", duration=(end, "s"))
    text += table("[output]", every=(end, "s"), measure_every=(period / 100 if periods < 10 else end / 20000, "s"), fields=[])
    text += table("[[measure]]", name="tip", kind="displacement", part="strip", point=[(length, "m"), 0])

    def deviation(results):
        """From where the tip crosses its rest upwards."""
        pairs = [pair for pair in zip(results.time, results.columns["tip_y"]) if pair[0] > released]
        crossings = [t0 - u0 * (t1 - t0) / (u1 - u0) for (t0, u0), (t1, u1) in zip(pairs, pairs[1:]) if u0 < 0 <= u1]
        if len(crossings) < 2:
            return float("inf")
        return (crossings[-1] - crossings[0]) / (len(crossings) - 1) / period - 1
    return text, {"strip.geo": geo}, deviation


def extremes():
    for bending in (1e-4, 1e-2, 1.0, 1e2, 1e4):
        text, files, deviation = strip(bending=bending)
        yield Extreme("elastic solids", f"strip with a bending stiffness of {bending:g} N m", text, files=files,
                      deviation=deviation, bound=0.03)
    for name, length in (("1 nm", 1e-9), ("1 um", 1e-6), ("1 m", 1.0), ("1 km", 1e3)):
        text, files, deviation = strip(length=length)
        yield Extreme("elastic solids", f"strip {name} long", text, files=files, deviation=deviation, bound=0.03)
    for weight in (1e-9, 1e-3, 1e3, 1e9):
        text, files, deviation = strip(weight=weight)
        yield Extreme("elastic solids", f"strip of {weight:g} kg/m^2", text, files=files, deviation=deviation, bound=0.03)
    for bending in (1e-4, 1e4):
        text, files, deviation = strip(bending=bending, stepping="subcycled")
        yield Extreme("elastic solids", f"strip with a bending stiffness of {bending:g} N m, sub-cycled", text,
                      files=files, deviation=deviation, bound=0.03)
    for cells, ends, says in ((2, "refused", "columns of particles"), (4, "warned", "is 4 cells long"), (20, "right", "")):
        text, files, deviation = strip(cells=cells)
        yield Extreme("particles across", f"strip {cells} cells long", text, files=files, deviation=deviation, bound=0.06,
                      ends=ends, says=says)
