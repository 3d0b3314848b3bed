# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Each limit that docs/limits.md states: clean at 0.9 of it, and an error beyond it, at 1.5 of it or as far as the key goes."""
from extreme import Extreme
from liquids import diffusion
from scales import of_width
from solids import strip
from spheres import rebound
from vortices import VORTICES, decay, spacing

# The valve after 60 ms at its default step factor of 0.5, springs implicit [m^2/s, m/s, m]; the gap's change.
VALVE = {"inlet_flux": 1.711608e-6, "inlet_velocity_x": 2.294864e-4, "largest_speed": 2.715552e-4, "tip_gap": -3.6313e-7}


def as_by_default(results):
    """The valve's measures over those with the default steps."""
    return max(abs((results.last(name) - results.columns[name][0]) / value - 1) for name, value in VALVE.items())


def extremes():
    for factor, ends in ((0.69, "right"), (1.0, "diverges")):
        yield Extreme("step limits", f"vortices, step factor {factor:g}", VORTICES, [f"numerics.step_factor={factor}"],
                      "0.7 s", decay, 0.02, ends, "numerics.step_factor", slow=True)
    for factor, ends in ((0.55, "right"), (0.93, "diverges")):
        yield Extreme("step limits", f"vein valve, step factor {factor:g}", "vein_valve",
                      [f"numerics.step_factor={factor}"], "60 ms", as_by_default, 0.01, ends, "numerics.step_factor",
                      slow=True)
    for override, ends in (([], "right"), (["numerics.step_factor=0.5"], "diverges")):
        yield Extreme("step limits", f"vein valve, sub-cycled, {override[0] if override else 'step factor as lowered'}",
                      "vein_valve", ["numerics.spring_stepping=subcycled"] + override, "60 ms", as_by_default,
                      0.01, ends, "numerics.step_factor", slow=True)
    for factor, ends in ((0.58, "right"), (0.98, "diverges")):
        text, files, deviation = of_width(1e-3, 1.0, numerics={"viscous_step_factor": factor})
        yield Extreme("step limits", f"channel, viscous step factor {factor:g}", text, files=files, deviation=deviation,
                      bound=0.01, ends=ends, says="viscous_step_factor")
    for factor, ends in ((0.9, "right"), (1.5, "diverges")):
        text, files, deviation = diffusion(1e-9, numerics={"species_step_factor": factor})
        yield Extreme("step limits", f"diffusion between plates, species step factor {factor:g}", text, files=files,
                      deviation=deviation, bound=0.01, ends=ends, says="species_step_factor")
    for factor, ends in ((0.135, "right"), (0.225, "diverges")):
        yield Extreme("step limits", f"vortices, density diffusion step factor {factor:g}", VORTICES,
                      ["numerics.density_diffusion=1", f"numerics.density_diffusion_step_factor={factor}",
                       spacing(0.02)], "0.7 s", decay, 0.01, ends, "density_diffusion_step_factor")
    for factor in (0.9, 1.0):
        text, files, deviation = strip(stepping="subcycled", numerics={"spring_step_factor": factor})
        yield Extreme("step limits", f"sub-cycled strip, {factor:g} of the largest step of its springs", text, files=files,
                      deviation=deviation, bound=0.03)
    text, files, _ = strip(stepping="subcycled", numerics={"spring_step_factor": 1.5})
    yield Extreme("step limits", "sub-cycled strip, 1.5 of the largest step of its springs", text, files=files,
                  ends="refused", says="spring_step_factor")
    for steps, ends in ((5.5, "right"), (3.0, "refused")):
        text, deviation = rebound(numerics={"steps_per_contact": steps})
        yield Extreme("step limits", f"ball, {steps:g} steps in its impact", text, deviation=deviation, bound=0.05,
                      ends=ends, says="steps_per_contact")
    text, deviation = rebound(numerics={"contact_step": (1e-4, "s")})
    yield Extreme("step limits", "ball, steps longer than its impact", text, deviation=deviation, bound=0.05,
                  ends="refused", says="contact_step")
    for key, value in (("mach_number", 0.5), ("support", 1.5), ("support", 10.0), ("density_diffusion", 10.0),
                       ("shifting", -1.0), ("step_factor", 0.0), ("sound_speed", '"0 m/s"')):
        yield Extreme("step limits", f"numerics.{key} = {value}", VORTICES, [f"numerics.{key}={value}"], "0.1 s",
                      ends="refused", says=key)
