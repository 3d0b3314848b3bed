# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes as text, with all of their values in SI units."""


def table(header, **values):
    """A table of a scene; a number becomes a quantity with the unit after it: (2.0, "m")."""
    return header + "\n" + "".join(f"{key} = {toml(value)}\n" for key, value in values.items()) + "\n"


def toml(value):
    if isinstance(value, tuple):
        number, unit = value
        return f'"{number!r} {unit}"'
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, list):
        return "[" + ", ".join(toml(one) for one in value) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml(one)}" for key, one in value.items()) + " }"
    return repr(value)


def head(dimension=2):
    return f"schema = 1\ntitle = \"extreme\"\ndimension = {dimension}\n\n"


def channel_geo(length, heights):
    """Layers upon each other from y = 0, between plates, as gmsh script: surfaces layer0, layer1, ... and curves floor,
    lid."""
    text = "SetFactory(\"Built-in\");\n"
    levels = [0.0]
    for height in heights:
        levels.append(levels[-1] + height)
    for k, level in enumerate(levels):
        text += f"Point({2 * k + 1}) = {{0, {level!r}, 0}};\nPoint({2 * k + 2}) = {{{length!r}, {level!r}, 0}};\n"
        text += f"Line({10 * k + 1}) = {{{2 * k + 1}, {2 * k + 2}}};\n"
    for k in range(len(heights)):
        text += f"Line({10 * k + 2}) = {{{2 * k + 1}, {2 * k + 3}}};\nLine({10 * k + 3}) = {{{2 * k + 2}, {2 * k + 4}}};\n"
        text += f"Curve Loop({k + 1}) = {{{10 * k + 1}, {10 * k + 3}, -{10 * k + 11}, -{10 * k + 2}}};\n"
        text += f"Plane Surface({k + 1}) = {{{k + 1}}};\nPhysical Surface(\"layer{k}\") = {{{k + 1}}};\n"
    return text + f"Physical Curve(\"floor\") = {{1}};\nPhysical Curve(\"lid\") = {{{10 * len(heights) + 1}}};\n"


def channel(width, period, speed, across=20, liquids=None, drive="gradient", numerics=None, measures=(0.5,), duration=1.0,
            length=8, samples=40):
    """Flow between plates from rest to `duration` periods [s]; liquids: (share of the width, density, viscosity) from the
    floor up. Driven by a pressure gradient [Pa/m], or by a lid of this `speed`. Probes at `measures` widths."""
    spacing = width / across
    text = head() + table("[geometry]", file="channel.geo") + table("[particles]", spacing=(spacing, "m"))
    for k, (_, density, viscosity) in enumerate(liquids):
        text += table("[[part]]", name=f"layer{k}", kind="fluid", density=(density, "kg/m^3"),
                      viscosity=(viscosity, "Pa*s"))
    text += table("[[part]]", name="floor", kind="rigid")
    if drive == "lid":
        text += table("[[part]]", name="lid", kind="rigid", surface_velocity=[(speed, "m/s"), 0])
        text += table("[flow]", periodic=["x"], largest_speed=(speed, "m/s"))
    else:
        text += table("[[part]]", name="lid", kind="rigid")
        text += table("[flow]", periodic=["x"], largest_speed=(speed, "m/s"), pressure_gradient=[(-drive, "Pa/m"), 0])
    if numerics:
        text += table("[numerics]", **numerics)
    text += table("[run]", duration=(duration * period, "s"))
    text += table("[output]", every=(duration * period, "s"), measure_every=(duration * period / samples, "s"))
    for k, place in enumerate(measures):
        text += table("[[measure]]", name=f"u{k}", kind="probe", field="velocity",
                      point=[(length / 2 * spacing, "m"), (place * width, "m")])
    return text, {"channel.geo": channel_geo(length * spacing, [share * width for share, _, _ in liquids])}
