# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Taylor-Green vortices, the case that verifies the viscous decay."""
import math

VORTICES = "verification/taylor_green"


def spacing(metres):
    return f'particles.spacing="{metres!r} m"'


def stiffness(mach):
    """The speed of sound at which the vortices' 1 m/s has this Mach number."""
    return f'numerics.sound_speed="{1 / mach!r} m/s"'


def decay(results):
    """Of the vortices' energy [J] over the exact one (Taylor & Green 1937)."""
    return max(abs(energy / (0.25 * math.exp(-0.16 * math.pi**2 * t)) - 1)
               for t, energy in zip(results.time, results.columns["energy"]))
