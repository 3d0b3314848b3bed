# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres: sizes, masses, speeds and stiffness far apart, spheres that overlap at the start."""
import math

from extreme import Extreme
from scenes import head, table


def mass(radius, density):
    return density * 4 / 3 * math.pi * radius**3


def hertz_duration(radius, reduced_mass, modulus, speed):
    """Of an elastic impact at this speed, and the largest overlap (Hertz 1882; Johnson, Contact Mechanics, 1985)."""
    overlap = (1.25 * reduced_mass * speed**2 / (4 / 3 * modulus * math.sqrt(radius)))**0.4
    return 2.943 * overlap / speed, overlap


def ball(name, radius, density, modulus, centre, velocity=None):
    values = {"name": name, "kind": "spheres", "radius": (radius, "m"), "density": (density, "kg/m^3"),
              "youngs_modulus": (modulus, "Pa"), "poisson_ratio": 0.25, "centres": [[(one, "m") for one in centre]]}
    if velocity:
        values["initial_velocity"] = [(one, "m/s") for one in velocity]
    return table("[[part]]", **values)


def plane(level):
    return table("[[part]]", name="floor", kind="plane", point=[0, 0, (level, "m")], normal=[0, 0, 1])


def contact(restitution=1.0):
    return table("[[contact_pair]]", name="touch", parts=["any", "any"], restitution=restitution, friction=0)


def ending(duration, parts=("ball",), numerics=None, samples=1):
    text = table("[numerics]", **numerics) if numerics else ""
    text += table("[run]", duration=(duration, "s"))
    text += table("[output]", every=(duration, "s"), measure_every=(duration / samples, "s"))
    for part in parts:
        text += table("[[measure]]", name=part, kind="velocity", part=part)
    return text


def rebound(radius=1e-3, speed=1.0, density=1000.0, modulus=1e9, restitution=1.0, numerics=None):
    """A ball that falls onto a plane: its speed after it, over that expected; without loss also the force when the overlap
    is largest, over that of Hertz, and its speed then."""
    reduced = modulus / (1 - 0.25**2)
    duration, overlap = hertz_duration(radius, mass(radius, density), reduced, speed)
    gap = 0.1 * overlap
    text = head(3) + ball("ball", radius, density, modulus, (0, 0, 0), (0, 0, -speed)) + plane(-radius - gap)
    halfway = gap / speed + duration / 2
    text += contact(restitution)
    if restitution < 1:
        return text + ending(2 * duration / restitution, numerics=numerics), \
            lambda results: results.last("ball_z") / (restitution * speed) - 1
    force = 4 / 3 * reduced * math.sqrt(radius) * overlap**1.5

    def deviation(results):
        return max(abs(results.last("ball_z") / speed - 1), abs(results.columns["ball_z"][1] / speed),
                   abs(results.columns["push_z"][1] / force - 1))
    text += ending(4 * halfway, numerics=numerics, samples=4)
    return text + table("[[measure]]", name="push", kind="wall_force"), deviation


def head_on(size_ratio=1.0, density_ratio=1.0, radius=1e-3, speed=1.0):
    """A small or light ball that hits a resting one, elastically: its velocity after it, over its first one."""
    small, modulus, density = radius / size_ratio, 1e9, 1000.0
    light, heavy = mass(small, density), mass(radius, density * density_ratio)
    reduced_mass = light * heavy / (light + heavy)
    reduced = modulus / (1 - 0.25**2) / 2
    duration, overlap = hertz_duration(small * radius / (small + radius), reduced_mass, reduced, speed)
    text = head(3) + ball("ball", small, density, modulus, (radius + small + 0.1 * overlap, 0, 0), (-speed, 0, 0))
    text += ball("other", radius, density * density_ratio, modulus, (0, 0, 0)) + contact() + ending(2 * duration, ("ball", "other"))
    exact = -(light - heavy) / (light + heavy)

    def deviation(results):
        total = light * results.last("ball_x") + heavy * results.last("other_x")
        return max(abs(results.last("ball_x") / speed - exact), abs(total / (light * speed) + 1))
    return text, deviation


def overlapping(share):
    """Two alike balls that overlap by a share of their diameter at the start: the speed at which they part, over that by
    the energy of their overlap (Hertz 1882)."""
    radius, density, modulus = 1e-3, 1000.0, 1e9
    text = head(3) + ball("ball", radius, density, modulus, (0, 0, 0))
    text += ball("other", radius, density, modulus, (2 * radius * (1 - share), 0, 0))
    stiffness = 4 / 3 * modulus / (1 - 0.25**2) / 2 * math.sqrt(radius / 2)
    speed = math.sqrt(0.4 * stiffness * (2 * radius * share)**2.5 / mass(radius, density))

    def deviation(results):
        return max(abs(results.last("ball_x") / speed + 1), abs(results.last("other_x") / speed - 1))
    return text + contact() + ending(1e-4, ("ball", "other")), deviation


def free_fall():
    """One ball alone, thrown upwards, for 1 s."""
    text = head(3) + ball("ball", 1e-3, 1000.0, 1e9, (0, 0, 0), (0, 0, 3.0))
    text += table("[flow]", acceleration=[0, 0, (-9.81, "m/s^2")]) + ending(1.0)
    return text, lambda results: (results.last("ball_z") - (3 - 9.81)) / 9.81


def extremes():
    for text, radius in (("1 nm", 1e-9), ("1 um", 1e-6), ("1 mm", 1e-3), ("1 m", 1.0), ("1 km", 1e3)):
        scene, deviation = rebound(radius)
        yield Extreme("spheres", f"ball of radius {text} bounces", scene, deviation=deviation, bound=0.01)
    for modulus in (1e3, 1e5, 1e7, 1e11, 1e13):
        scene, deviation = rebound(modulus=modulus, speed=0.01)
        yield Extreme("spheres", f"ball of {modulus:g} Pa bounces", scene, deviation=deviation, bound=0.01)
    for speed in (1e-9, 1e-6, 1e-3, 10.0, 1e3, 1e5):
        scene, deviation = rebound(speed=speed)
        yield Extreme("spheres", f"ball at {speed:g} m/s bounces", scene, deviation=deviation, bound=0.01,
                      ends="right" if speed < 100 else "diverges", says="youngs_modulus is too small")
    for restitution in (0.9, 0.1, 0.01):
        scene, deviation = rebound(restitution=restitution)
        yield Extreme("spheres", f"ball with a restitution of {restitution:g}", scene, deviation=deviation, bound=0.02)
    for ratio in (10.0, 100.0, 1e3, 1e4):
        scene, deviation = head_on(size_ratio=ratio)
        yield Extreme("spheres", f"ball hits one {ratio:g} times as large", scene, deviation=deviation, bound=0.01)
    for ratio in (1e-6, 1e-3, 1e3, 1e6, 1e12):
        scene, deviation = head_on(density_ratio=ratio)
        yield Extreme("spheres", f"ball hits one {ratio:g} times as dense", scene, deviation=deviation, bound=0.01)
    for share in (0.01, 0.1, 0.5, 1.0):
        scene, deviation = overlapping(share)
        yield Extreme("touching at the start", f"spheres that overlap by {100 * share:g} % of their diameter", scene,
                      deviation=deviation, bound=0.01, ends="right" if share < 0.025 else "refused",
                      says="overlap by")
    scene, deviation = free_fall()
    yield Extreme("one particle", "ball in free flight", scene, deviation=deviation, bound=1e-9)
