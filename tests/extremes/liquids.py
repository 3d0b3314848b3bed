# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Liquids of unlike density upon each other, in gravity, and species with extreme diffusivities."""
import math

from extreme import Extreme
from scenes import channel_geo, head, table

G = 9.81  # [m/s^2]


def tank_geo(width, heights):
    """Layers in a closed tank: as channel_geo, with the sides as walls."""
    text = channel_geo(width, heights)
    sides = [10 * k + side for k in range(len(heights)) for side in (2, 3)]
    return text + f"Physical Curve(\"sides\") = {{{', '.join(map(str, sides))}}};\n"


def tank(density_ratio, height=1.0, across=16, gravity=G, scheme="corrected", periods=2.0, steps=0):
    """Two layers at rest, the upper one lighter by the ratio, for two periods of free fall: the largest speed at the
    end, over sqrt(g H)."""
    speed = math.sqrt(2 * gravity * height)
    text = head() + table("[geometry]", file="tank.geo") + table("[particles]", spacing=(height / across, "m"))
    for k, density in enumerate((1000.0, 1000.0 / density_ratio)):
        # Overdamped at the scale of the spacing.
        text += table("[[part]]", name=f"layer{k}", kind="fluid", density=(density, "kg/m^3"),
                      viscosity=(density * 0.05 * math.sqrt(gravity * height) * height, "Pa*s"))
    for wall in ("floor", "lid", "sides"):
        text += table("[[part]]", name=wall, kind="rigid")
    text += table("[flow]", acceleration=[0, (-gravity, "m/s^2")], largest_speed=(speed, "m/s"))
    end = periods * math.sqrt(2 * height / gravity)
    # Sound sets the steps, 1.5 spacings over its speed.
    sound = {"sound_speed": (1.5 * height / across * steps / end, "m/s")} if steps else {}
    text += table("[numerics]", scheme=scheme, **sound)
    text += table("[run]", duration=(end, "s")) + table("[output]", every=(end, "s"))
    for k, place in enumerate((0.25, 0.75)):
        text += table("[[measure]]", name=f"p{k}", kind="probe", field="pressure",
                      point=[(0.25 * height, "m"), (place * height, "m")])
    text += table("[[measure]]", name="speed", kind="largest_speed")

    def deviation(results):
        """Of the pressure's fall between both probes, and the speed that is left."""
        fall = gravity * 0.25 * height * 1000.0 * (1 + 1 / density_ratio)
        return max(abs((results.last("p0") - results.last("p1")) / fall - 1), results.last("speed") / speed)
    return text, {"tank.geo": tank_geo(0.5 * height, [0.5 * height, 0.5 * height])}, deviation


def diffusion(diffusivity, width=1e-3, across=20, stepping="explicit", numerics=None, samples=1):
    """Between plates held at 1 and 0, at rest: the concentration in the middle after a tenth of a diffusion time. Steps
    end at each sample."""
    period = width**2 / diffusivity
    spacing = width / across
    text = head() + table("[geometry]", file="channel.geo") + table("[particles]", spacing=(spacing, "m"))
    text += table("[[part]]", name="layer0", kind="fluid", density=(1000.0, "kg/m^3"), viscosity=(1e-3, "Pa*s"))
    text += table("[[part]]", name="floor", kind="rigid") + table("[[part]]", name="lid", kind="rigid")
    text += table("[[species]]", name="drug", unit="mol/m^3", diffusivity=(diffusivity, "m^2/s"),
                  wall_concentration={"floor": (1.0, "mol/m^3"), "lid": (0.0, "mol/m^3")})
    text += table("[flow]", periodic=["x"], largest_speed=(1e-3, "m/s"))
    text += table("[numerics]", species_stepping=stepping, **(numerics or {}))
    text += table("[run]", duration=(0.1 * period, "s"))
    text += table("[output]", every=(0.1 * period, "s"), measure_every=(0.1 * period / samples, "s"),
                  fields=["concentration"], picture_field="concentration")
    text += table("[[measure]]", name="c", kind="probe", field="concentration",
                  point=[(4 * spacing, "m"), (0.5 * width, "m")])

    def exact(y, t):
        return 1 - y - sum(2 / (n * math.pi) * math.sin(n * math.pi * y) * math.exp(-n * n * math.pi**2 * t)
                           for n in range(1, 60))
    return text, {"channel.geo": channel_geo(8 * spacing, [width])}, lambda results: results.last("c") / exact(0.5, 0.1) - 1


def backward_euler(y, t, steps):
    """Of diffusion between plates held at 1 and 0, mode by mode: 9 % below the exact one at 0.1 in 4 steps."""
    return 1 - y - sum(2 / (n * math.pi) * math.sin(n * math.pi * y) * (1 + n * n * math.pi**2 * t / steps)**-steps
                       for n in range(1, 400))


def extremes():
    for ratio in (1.001, 2.0, 10.0, 100.0, 1000.0):
        text, files, deviation = tank(ratio)
        yield Extreme("density ratios", f"liquid upon one {ratio:g} times as dense", text, files=files, deviation=deviation,
                      bound=0.02, ends="right" if ratio <= 10 else "refused", says="times as dense as")
    for ratio in (100.0, 1000.0):
        text, files, deviation = tank(ratio, scheme="plain")
        yield Extreme("density ratios", f"liquid upon one {ratio:g} times as dense, plain scheme", text, files=files,
                      deviation=deviation, bound=0.05, ends="warned", says="stirs the interface")
    for gravity in (1e-6, 1e6):
        text, files, deviation = tank(2.0, gravity=gravity)
        yield Extreme("density ratios", f"two liquids in a gravity of {gravity:g} m/s^2", text, files=files,
                      deviation=deviation, bound=0.02)
    for diffusivity in (1e-20, 1e-9, 1.0, 1e10):
        text, files, deviation = diffusion(diffusivity)
        yield Extreme("diffusivities", f"{diffusivity:g} m^2/s between plates", text, files=files, deviation=deviation,
                      bound=0.01)
    text, files, deviation = diffusion(1e10, stepping="implicit", samples=100)
    yield Extreme("diffusivities", "1e+10 m^2/s between plates, implicit, 100 steps", text, files=files,
                  deviation=deviation, bound=0.01)
    text, files, _ = diffusion(1e10, stepping="implicit", samples=4)
    yield Extreme("diffusivities", "1e+10 m^2/s between plates, implicit, over 4 steps of backward Euler", text, files=files,
                  deviation=lambda results: results.last("c") / backward_euler(0.5, 0.1, 4) - 1, bound=0.01)
    text, files, deviation = diffusion(1e-20, stepping="implicit")
    yield Extreme("diffusivities", "1e-20 m^2/s between plates, implicit", text, files=files, ends="refused",
                  says="would take")
