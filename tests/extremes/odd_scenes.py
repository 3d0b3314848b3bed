# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes at the edge of what makes sense: next to nothing in them, bodies that touch, more than sound can carry."""
import math

from extreme import Extreme
from flows import WIDTH, from_couette
from scenes import channel, channel_geo, head, table

NU, SPEED = 1e-6, 1e-3  # [m^2/s], [m/s]


def dragged(numerics=None, lid=SPEED, across=20, density=1000.0, viscosity=None, duration=0.1, expected=SPEED):
    """A channel dragged by its lid, with any values."""
    viscosity = density * NU if viscosity is None else viscosity
    text, files = channel(WIDTH, WIDTH**2 / NU, lid, across=across, drive="lid", liquids=[(1, density, viscosity)],
                          duration=duration, numerics=numerics)
    return text.replace(f'largest_speed = "{lid!r} m/s"', f'largest_speed = "{expected!r} m/s"'), files


def start_up(lid=SPEED):
    """From rest, in the middle of the channel."""
    return lambda results: from_couette(results, (0.5,), lid, WIDTH**2 / NU)


def falling_box(across, viscosity=1e-3):
    """Periodic all around, in a uniform acceleration: the largest speed, and that by the kinetic energy, over the exact
    one."""
    text = head() + table("[geometry]", file="box.geo") + table("[particles]", spacing=(1e-3, "m"))
    text += table("[[part]]", name="layer0", kind="fluid", density=(1000.0, "kg/m^3"), viscosity=(viscosity, "Pa*s"))
    text += table("[flow]", periodic=["x", "y"], largest_speed=(1.0, "m/s"), acceleration=[(1.0, "m/s^2"), 0])
    text += table("[run]", duration=(1.0, "s")) + table("[output]", every=(1.0, "s"))
    text += table("[[measure]]", name="speed", kind="largest_speed")
    text += table("[[measure]]", name="energy", kind="kinetic_energy")
    side = across * 1e-3
    geo = channel_geo(side, [side]).split("Physical Curve")[0]

    def deviation(results):
        mean = math.sqrt(2 * results.last("energy") / (1000.0 * side**2))
        return max(abs(results.last("speed") - 1), abs(mean - 1))
    return text, {"box.geo": geo}, deviation


def discs(gap, radius=1e-3, across=20):
    """Two elastic discs in a closed box of liquid, at rest; `gap` between them in radii, below 0 if they overlap."""
    spacing = 2 * radius / across
    text = head() + table("[geometry]", file="discs.geo") + table("[particles]", spacing=(spacing, "m"))
    text += table("[[part]]", name="liquid", kind="fluid", density=(1000.0, "kg/m^3"), viscosity=(0.1, "Pa*s"))
    for name in ("left", "right"):
        text += table("[[part]]", name=name, kind="elastic", density=(1000.0, "kg/m^3"), youngs_modulus=(1e5, "Pa"),
                      poisson_ratio=0.25)
    text += table("[[part]]", name="wall", kind="rigid")
    text += table("[flow]", largest_speed=(1e-2, "m/s"), acceleration=[0, (-9.81, "m/s^2")])
    text += table("[run]", duration=(2e-2, "s")) + table("[output]", every=(2e-2, "s"))
    text += table("[[measure]]", name="speed", kind="largest_speed")
    away = radius * (1 + gap / 2)
    geo = "SetFactory(\"OpenCASCADE\");\n"
    geo += f"Rectangle(1) = {{{-3 * radius!r}, {-2 * radius!r}, 0, {6 * radius!r}, {4 * radius!r}}};\n"
    geo += f"Disk(2) = {{{-away!r}, 0, 0, {radius!r}}};\nDisk(3) = {{{away!r}, 0, 0, {radius!r}}};\n"
    geo += "BooleanDifference(4) = { Surface{1}; Delete; }{ Surface{2, 3}; };\n"
    geo += "Physical Surface(\"liquid\") = {4};\nPhysical Surface(\"left\") = {2};\nPhysical Surface(\"right\") = {3};\n"
    geo += "all() = Boundary{ Surface{4}; };\nPhysical Curve(\"wall\") = {all()};\n"

    def deviation(results):
        """They are as dense as the liquid, so nothing moves: the largest speed over sqrt(2 g r); the mass of all, over that
        drawn."""
        mass = results.summary["conserved"]["start"]["mass"]
        return max(results.last("speed") / math.sqrt(2 * 9.81 * radius), abs(mass / (1000.0 * 24 * radius**2) - 1))
    return text, {"discs.geo": geo}, deviation


def extremes():
    text, files, _ = falling_box(1)
    yield Extreme("one particle", "liquid of one particle, periodic, falls", text, files=files, ends="refused",
                  says="shorter than the kernel's support")
    for times in (0.5, 2.0, 100.0):
        text, files = dragged(lid=times, numerics={"sound_speed": (1.0, "m/s")}, expected=0.1)
        yield Extreme("faster than sound", f"lid at {times:g} times the speed of sound", text, files=files,
                      deviation=start_up(times), bound=0.01, ends="right" if times < 1 else "diverges",
                      says="numerics.sound_speed")
    for gravity in (1e3, 1e6):
        text, files = dragged(numerics={"sound_speed": (0.1, "m/s")})
        text = text.replace("[flow]", f'[flow]\nacceleration = [0, "{-gravity!r} m/s^2"]')
        yield Extreme("faster than sound", f"{gravity:g} m/s^2 where sound travels at 0.1 m/s", text, files=files,
                      ends="diverges", says="numerics.sound_speed")
    for density in (1e-20, 1e-3, 1e6, 1e20):
        text, files = dragged(density=density, duration=1)
        yield Extreme("values of a liquid", f"density of {density:g} kg/m^3", text, files=files, deviation=start_up(),
                      bound=0.01)
    for viscosity in (0.0, 1e-30):
        text, files = dragged(viscosity=viscosity)
        yield Extreme("values of a liquid", f"viscosity of {viscosity:g} Pa s", text, files=files,
                      deviation=lambda results: results.last("u0_x") / SPEED, bound=1e-6)
        text, files, deviation = falling_box(8, viscosity)
        yield Extreme("values of a liquid", f"periodic box falls, viscosity of {viscosity:g} Pa s", text, files=files,
                      deviation=deviation, bound=1e-9)
    text, files = dragged(viscosity=1e30)
    yield Extreme("values of a liquid", "viscosity of 1e+30 Pa s", text, files=files, ends="refused",
                  says="ruled by viscosity")
    text, files = dragged(viscosity=1e30, numerics={"viscosity_stepping": "implicit"})
    yield Extreme("values of a liquid", "viscosity of 1e+30 Pa s, implicit", text, files=files, ends="diverges",
                  says="implicit viscosity")
    text, files = dragged(duration=1e-30)
    yield Extreme("durations", "1e-30 periods", text, files=files,
                  deviation=lambda results: results.last("u0_x") / SPEED, bound=1e-6)
    text, files = dragged(duration=1e30)
    yield Extreme("durations", "1e+30 periods", text, files=files, ends="refused", says="would take")
    for across in (0.1, 0.4):
        text, files = dragged(across=across)
        yield Extreme("numbers of particles", f"channel of {across:g} particles across", text, files=files,
                      ends="refused", says="fits into its region")
    text, files = dragged(across=1e9)
    yield Extreme("numbers of particles", "channel of 1e+09 particles across", text, files=files, ends="resources",
                  says="this machine has")
    text, files = dragged(across=1e15)
    yield Extreme("numbers of particles", "channel of 1e+15 particles across", text, files=files, ends="refused",
                  says="has no area")
    for gap in (1.0, 0.0, -0.01):
        text, files, deviation = discs(gap)
        apart = f"elastic discs {gap:g} radii apart" if gap >= 0 else f"elastic discs {-gap:g} radii in each other"
        yield Extreme("touching at the start", apart, text, files=files,
                      deviation=deviation, bound=0.01)
    text, files, _ = discs(-0.5)
    yield Extreme("touching at the start", "elastic discs 0.5 radii in each other", text, files=files, ends="refused",
                  says="is drawn into 'left', an elastic solid")
