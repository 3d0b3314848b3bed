# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Flows: viscosity ratios of layers, Mach and Reynolds numbers, few particles across."""
import math

from extreme import Extreme
from scales import of_width, poiseuille
from scenes import channel

WIDTH = 1e-3  # [m]


def couette(y, t):
    """Start-up of a lid over its speed, y in widths, t in widths^2 / nu (Morris, Fox & Zhu 1997)."""
    return y + sum((2 if n % 2 == 0 else -2) / (n * math.pi) * math.sin(n * math.pi * y) *
                   math.exp(-n * n * math.pi**2 * t) for n in range(1, 120))


def dragged_layers(viscosity_ratio, across=20):
    """Two layers of half the width under a lid, the upper one more viscous by the ratio (below 1: less): steady
    velocities in the middle of each, over the lid's. The less viscous one is water."""
    nu, speed, density = 1e-6, 1e-5, 1000.0
    lower, upper = density * nu * max(1.0, 1 / viscosity_ratio), density * nu * max(1.0, viscosity_ratio)
    at_face = upper / (lower + upper)
    exact = [0.5 * at_face, 0.5 * (1 + at_face)]
    period = (WIDTH / 2)**2 / nu  # of the slower layer
    implicit = viscosity_ratio > 30 or viscosity_ratio < 1 / 30
    text, files = channel(WIDTH, period, speed, across=across, drive="lid", measures=(0.25, 0.75),
                          liquids=[(0.5, density, lower), (0.5, density, upper)], duration=1,
                          numerics={"viscosity_stepping": "implicit"} if implicit else None)

    def deviation(results):
        return max(abs(results.last(f"u{k}_x") / speed - exact[k]) for k in range(2))
    return text, files, deviation


def dragged(reynolds, across=20, numerics=None, periods=1.0, speed=1e-5):
    """Of one liquid; the largest deviation at three heights and the second half of the time."""
    nu = speed * WIDTH / reynolds
    period = WIDTH**2 / nu
    places = (0.25, 0.5, 0.75)
    text, files = channel(WIDTH, period, speed, across=across, drive="lid", measures=places,
                          liquids=[(1, 1000.0, 1000.0 * nu)], duration=periods, numerics=numerics)

    def deviation(results):
        worst = 0.0
        for k, place in enumerate(places):
            for t, u in zip(results.time, results.columns[f"u{k}_x"]):
                if t > 0.5 * periods * period:
                    worst = max(worst, abs(u / speed - couette(place, t / period)))
        return worst
    return text, files, deviation


def of_mach(mach):
    """Poiseuille flow at Re 10, where sound sets the steps."""
    nu = 1e-6
    speed = 10 * nu / WIDTH
    text, files = channel(WIDTH, WIDTH**2 / nu, speed, liquids=[(1, 1000.0, 1000.0 * nu)], drive=8e3 * nu * speed / WIDTH**2,
                          numerics={"sound_speed": (speed / mach, "m/s")}, duration=0.5)

    def deviation(results):
        return max(abs(u / speed - poiseuille(0.5, t * nu / WIDTH**2))
                   for t, u in zip(results.time, results.columns["u0_x"]))
    return text, files, deviation


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
        text, files, deviation = dragged_layers(ratio)
        yield Extreme("viscosity ratios", f"upper layer {ratio:g} times as viscous as the lower one", text, files=files,
                      deviation=deviation, bound=0.01)
    for reynolds in (1e-6, 1e-3, 1.0, 100.0, 1e4):
        text, files, deviation = dragged(reynolds, periods=1.0 if reynolds < 1000 else 0.01)
        yield Extreme("Reynolds numbers", f"dragged by a lid at Re {reynolds:g}", text, files=files, deviation=deviation,
                      bound=0.01, ends="right" if reynolds < 1000 else "warned", says="is coarse for this flow")
    for mach in (0.001, 0.01, 0.1, 0.3, 0.5, 0.9):
        text, files, deviation = of_mach(mach)
        yield Extreme("Mach numbers", f"channel at Mach {mach:g}", text, files=files, deviation=deviation, bound=0.01,
                      slow=mach < 0.01)
    for across in (1, 2, 3, 4, 5, 10):
        text, files, deviation = across_gap(across)
        yield Extreme("particles across", f"channel of {across}", text, files=files, deviation=deviation, bound=0.05,
                      ends="right" if across > 5 else "warned", says="a gap of" if across == 1 else "particles.spacing")
