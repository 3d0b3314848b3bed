# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""A million steps without drift."""
import math

from extreme import Extreme
from liquids import tank
from scenes import head, table
from solids import strip
from spheres import ball, contact, hertz_duration, mass, plane

STEPS = 1_000_000


def bouncing():
    """A ball that bounces without loss: the height that it reaches, by energy, after a million steps."""
    radius, density, modulus, speed, g = 1e-3, 1000.0, 1e7, 0.1, 9.81
    duration, _ = hertz_duration(radius, mass(radius, density), modulus / (1 - 0.25**2), speed)
    step = duration / 30
    text = head(3) + ball("ball", radius, density, modulus, (0, 0, 0), (0, 0, speed)) + plane(-radius) + contact()
    text += table("[flow]", acceleration=[0, 0, (-g, "m/s^2")]) + table("[numerics]", contact_step=(step, "s"))
    end = STEPS * step
    text += table("[run]", duration=(end, "s")) + table("[output]", every=(end, "s"), measure_every=(end / 20000, "s"))
    text += table("[[measure]]", name="v", kind="velocity", part="ball")

    def deviation(results):
        """Of the largest speed in the last hundredth of the time."""
        last = [abs(v) for t, v in zip(results.time, results.columns["v_z"]) if t > 0.99 * end]
        return max(last) / speed - 1
    return text, deviation


def swinging():
    """A strip of four cells: its amplitude at the end over that at the start."""
    text, files, _ = strip(cells=4, periods=2000.0, steps_per_period=STEPS / 2000)

    def deviation(results):
        tip = [abs(u) for u in results.columns["tip_y"]]
        count = len(tip) // 100
        return max(tip[-count:]) / max(tip[2 * count:3 * count]) - 1
    return text, files, deviation


def extremes():
    text, deviation = bouncing()
    yield Extreme("a million steps", "ball that bounces", text, deviation=deviation, bound=0.01, slow=True)
    text, files, deviation = swinging()
    yield Extreme("a million steps", "strip that swings", text, files=files, deviation=deviation, bound=0.01, slow=True)
    text, files, deviation = tank(2.0, across=4, periods=1.0, steps=STEPS)
    yield Extreme("a million steps", "two liquids at rest in a tank", text, files=files, deviation=deviation, bound=0.05,
                  slow=True)
