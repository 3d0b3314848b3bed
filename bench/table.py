# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of bench/run, in Markdown."""


def failures(result):
    """Name and message of every case that ended in an error, LAMMPS' too."""
    found = []
    for name, case in result["cases"].items():
        if "failed" in case:
            found.append((name, case["failed"]))
        if "failed" in case.get("lammps", {}):
            found.append((f"{name}, LAMMPS", case["lammps"]["failed"]))
    return found


def _spread(values, digits=0):
    return f"{values['median']:.{digits}f} ({values['smallest']:.{digits}f} to {values['largest']:.{digits}f})"


def _millions(number):
    return f"{number / 1e6:.1f}"


def _row(cells):
    return "| " + " | ".join(cells) + " |"


def _speed_row(name, case):
    """One line; what is not known is a dash."""
    cells = dict.fromkeys(("particles", "pairs", "step", "steps", "sweeps", "pair_rate", "bytes", "yardstick", "ratio",
                           "lammps", "processor"), "-")
    if "failed" in case:
        return _row([name, *cells.values()])
    if "fluid_particles" not in case:  # the valve
        cells["particles"] = str(sum(case["particles"].values()))
        cells["step"] = _spread(case["ns_per_particle_step"])
        cells["steps"] = _millions(case["particle_steps_per_s_core"])
        return _row([name, *cells.values()])
    cells["particles"] = str(case["fluid_particles"] + case["wall_particles"])
    cells["pairs"] = f"{case['pairs_per_particle']:.1f}"
    cells["yardstick"] = _spread(case["yardstick"]["ns_per_particle_sweep"])
    had = case["yardstick"]["processor_percent"]
    engine = case["engine"]
    if engine is not None:
        had = min(had, engine["processor_percent"])
        resident = engine["bytes_per_particle_resident"]
        cells["step"] = _spread(engine["ns_per_particle_step"])
        cells["steps"] = _millions(engine["particle_steps_per_s_core"])
        cells["sweeps"] = _millions(engine["particle_sweeps_per_s_core"])
        cells["pair_rate"] = _millions(engine["pairs_per_s_core"])
        cells["bytes"] = f"{engine['bytes_per_particle_planned']} / {'?' if resident is None else round(resident)}"
        cells["ratio"] = f"{case['yardstick_sweep_over_engine_step']:.2f}"
    cells["processor"] = f"{had:.0f}"
    beside = case.get("lammps", {})
    if "particle_steps_per_s_core" in beside:
        cells["lammps"] = _millions(beside["particle_steps_per_s_core"])
    return _row([name, *cells.values()])


def _stage_rows(cases):
    by_case = {}
    for name, case in cases.items():
        stages = (case.get("engine") or case).get("ns_by_stage")
        if stages:
            by_case[name] = stages
    names = sorted({stage for stages in by_case.values() for stage in stages},
                   key=lambda stage: -max(stages.get(stage, {"median": 0})["median"] for stages in by_case.values()))
    if not names:
        return []
    rows = [_row(["ns per particle and step (%)", *names]), "|" + "---|" * (len(names) + 1)]
    for name, stages in by_case.items():
        cells = [f"{stages[stage]['median']:.1f} ({stages[stage]['percent']:.0f})" if stage in stages else "-"
                 for stage in names]
        rows.append(_row([name, *cells]))
    return rows


def _option_rows(cases):
    """What each option adds to a step without any: rows of the cases that are called so."""
    steps = {name.removeprefix("options: "): case["engine"]["ns_per_particle_step"]["median"]
             for name, case in cases.items() if name.startswith("options: ") and case.get("engine")}
    if "none" not in steps or len(steps) < 2:
        return []
    plain = steps.pop("none")
    rows = [_row(["option", "adds to a step [ns per particle]", "%"]), "|---|---|---|"]
    return rows + [_row([name, f"{step - plain:.1f}", f"{100 * (step / plain - 1):.0f}"]) for name, step in steps.items()]


def text_of(result):
    machine = result["machine"]
    lines = [
        f"{machine['processor']}, {machine['processors']} processors; {machine['compiler']}; commit {machine['commit']},"
        f" {machine['date']}; load {machine['load_before']:.1f} before, {machine['load_after']:.1f} after.",
        f"Medians (extremes) of {result['repeat']} repeats of {result['steps']} steps, engine on {result['threads']}"
        " threads and yardstick in turns.",
        "",
        _row(["case", "particles", "pairs per particle", "step [ns per particle]", "10^6 particle-steps/s/core",
              "10^6 particle-sweeps/s/core", "10^6 pairs/s/core", "bytes per particle, planned / resident",
              "yardstick sweep [ns per particle]", "yardstick sweep / step", "LAMMPS, 10^6 particle-steps/s/core",
              "had a processor [%]"]),
        "|" + "---|" * 12,
    ]
    lines += [_speed_row(name, case) for name, case in result["cases"].items()]
    stages = _stage_rows(result["cases"])
    if stages:
        lines += ["", *stages]
    options = _option_rows(result["cases"])
    if options:
        lines += ["", *options]
    skipped = {}
    for name, case in result["cases"].items():
        if "skipped" in case:
            skipped.setdefault(case["skipped"], []).append(name)
    notes = [f"{'; '.join(names)}: {message}" for message, names in skipped.items()]
    if result["lammps"]:
        notes.append(f"LAMMPS: none found; {result['lammps']}")
    notes += [f"{name} FAILED: {message}" for name, message in failures(result)]
    if notes:
        lines += ["", *(f"- {note}" for note in notes)]
    return "\n".join(lines) + "\n"
