# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Lengths and times: a scene drawn, driven and run at another scale has the same answer in its own units."""
import math

from extreme import Extreme
from scenes import channel

LENGTHS = [("1 nm", 1e-9), ("1 um", 1e-6), ("1 mm", 1e-3), ("1 m", 1.0), ("1 km", 1e3)]
TIMES = [("1 ns", 1e-9), ("1 ms", 1e-3), ("1 h", 3600.0), ("30 years", 9.46728e8)]


def poiseuille(y, t):
    """Start-up between plates over the final speed in the middle, y in widths, t in widths^2 / nu (Morris, Fox & Zhu
    1997)."""
    u = 4 * y * (1 - y)
    for n in range(60):
        k = (2 * n + 1) * math.pi
        u -= 32 / k**3 * math.sin(k * y) * math.exp(-k * k * t)
    return u


def start_up(width, period, speed):
    """The largest deviation of the speed in the middle, over the final one."""
    def deviation(results):
        pairs = zip(results.time, results.columns["u0_x"])
        return max(abs(u / speed - poiseuille(0.5, t / period)) for t, u in pairs)
    return deviation


def of_width(width, period, reynolds=0.0125, density=1000.0, numerics=None):
    nu = width**2 / period
    speed = reynolds * nu / width
    text, files = channel(width, period, speed, liquids=[(1, density, density * nu)],
                          drive=8 * density * nu * speed / width**2, numerics=numerics)
    return text, files, start_up(width, period, speed)


def extremes():
    for length_text, width in LENGTHS:
        for time_text, period in TIMES:
            text, files, deviation = of_width(width, period)
            yield Extreme("lengths and times", f"channel {length_text} wide, {time_text} to its steady flow",
                          text, files=files, deviation=deviation, bound=0.006)
