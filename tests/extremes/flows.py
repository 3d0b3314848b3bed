# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Flows: viscosity ratios of layers, Mach and Reynolds numbers, few particles across."""
import math

from extreme import Extreme
from scenes import channel
from vortices import VORTICES, decay, spacing, stiffness

WIDTH = 1e-3  # [m]


def couette(y, t):
    """Start-up of a lid over its speed, y in widths, t in widths^2 / nu (Morris, Fox & Zhu 1997)."""
    return y + sum((2 if n % 2 == 0 else -2) / (n * math.pi) * math.sin(n * math.pi * y) *
                   math.exp(-n * n * math.pi**2 * t) for n in range(1, 120))


def from_couette(results, places, speed, period):
    """The largest deviation of probes u0, u1, ... at `places`, over the lid's speed, from 0.05 diffusion times on."""
    return max(abs(u / speed - couette(place, t / period)) for k, place in enumerate(places)
               for t, u in zip(results.time, results.columns[f"u{k}_x"]) if t > 0.0499 * period)


def dragged_layers(viscosity_ratio, across=20, tolerance=1e-6):
    """Two layers of half the width under a lid, the upper one more viscous by the ratio (below 1: less): the steady
    velocity in the middle of each, relative to its own wall, over the exact one. The less viscous one is water."""
    nu, speed, density = 1e-6, 1e-5, 1000.0
    lower, upper = density * nu * max(1.0, 1 / viscosity_ratio), density * nu * max(1.0, viscosity_ratio)
    at_face = upper / (lower + upper)
    shears = [0.5 * at_face, 0.5 * lower / (lower + upper)]
    period = (WIDTH / 2)**2 / nu  # of the slower layer
    implicit = viscosity_ratio > 30 or viscosity_ratio < 1 / 30
    text, files = channel(WIDTH, period, speed, across=across, drive="lid", measures=(0.25, 0.75),
                          liquids=[(0.5, density, lower), (0.5, density, upper)], duration=1,
                          numerics={"viscosity_stepping": "implicit", "viscosity_tolerance": tolerance} if implicit else None)

    def deviation(results):
        found = [results.last("u0_x") / speed, 1 - results.last("u1_x") / speed]
        return max(abs(one / exact - 1) for one, exact in zip(found, shears))
    return text, files, deviation


def dragged(reynolds, across=20, numerics=None, periods=1.0, speed=1e-5):
    """Of one liquid, measured at three heights."""
    nu = speed * WIDTH / reynolds
    period = WIDTH**2 / nu
    places = (0.25, 0.5, 0.75)
    text, files = channel(WIDTH, period, speed, across=across, drive="lid", measures=places,
                          liquids=[(1, 1000.0, 1000.0 * nu)], duration=periods, numerics=numerics)
    return text, files, lambda results: from_couette(results, places, speed, period)


def across_gap(across):
    """Steady flow between plates that hold few particles."""
    nu, speed = 1e-6, 1e-5
    text, files = channel(WIDTH, WIDTH**2 / nu, speed, across=across, liquids=[(1, 1000.0, 1000.0 * nu)],
                          drive=8e3 * nu * speed / WIDTH**2)

    def deviation(results):
        return results.last("u0_x") / speed - 1
    return text, files, deviation


def extremes():
    for ratio in (1e-6, 1e-4, 1e-2, 1e2, 1e4, 1e6):
        name = f"upper layer {ratio:g} times as viscous as the lower one"
        far = not 1e-5 < ratio < 1e5
        text, files, deviation = dragged_layers(ratio)
        # At 1e-6 and 1e6 the stiff layer's velocity is half of the default tolerance: up to 0.26 off in near-by scenes.
        yield Extreme("viscosity ratios", name, text, files=files, deviation=deviation, bound=0.4 if far else 0.01)
        if far:
            text, files, deviation = dragged_layers(ratio, tolerance=3e-8)
            yield Extreme("viscosity ratios", name + ", viscosity_tolerance 3e-8", text, files=files, deviation=deviation,
                          bound=0.1)
    for reynolds, periods in ((1e-6, 1.0), (1e-3, 1.0), (1.0, 1.0), (100.0, 1.0), (1e3, 0.1), (1e4, 0.06)):
        text, files, deviation = dragged(reynolds, periods=periods)
        yield Extreme("Reynolds numbers", f"dragged by a lid at Re {reynolds:g}", text, files=files, deviation=deviation,
                      bound=0.01, slow=reynolds > 1e3)
    for mach, ends in ((0.01, "right"), (0.1, "right"), (0.3, "warned"), (0.5, "warned"), (0.9, "refused")):
        says = "the equation of state knows" if ends == "refused" else "numerics.sound_speed is too low"
        yield Extreme("Mach numbers", f"vortices at Mach {mach:g}", VORTICES, [spacing(0.02), stiffness(mach)], "0.3 s",
                      decay, 0.02, ends, says)
    # Without their low pressure, which liquid of this stiffness cannot have.
    yield Extreme("Mach numbers", "vortices at Mach 0.9, from a pressure of 0", VORTICES,
                  [spacing(0.02), stiffness(0.9), 'flow.initial_pressure="0 Pa"'], "0.3 s", decay, 0.02, "diverges",
                  "numerics.sound_speed")
    for across in (1, 2, 3, 4, 5, 10):
        text, files, deviation = across_gap(across)
        yield Extreme("particles across", f"channel of {across}", text, files=files, deviation=deviation, bound=0.05,
                      ends="right" if across > 5 else "warned",
                      says="a gap of 1 spacings" if across == 1 else "particles.spacing is coarse for this flow")
