#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""write_page.py ROWS PAGE: puts what the runs of the verification suite have left in the folder ROWS into the page.
Rows of a case and setting that ran take the place of the old ones; rows of those that did not run stay."""
import glob
import json
import os
import platform
import sys

HEAD = """# Verification

Written by `./dmp test --verification`; each row was shown by the last run of its case. `--long` runs those of many
minutes too (the cavity at Re 1000). Each case is a scene under `cases/verification/` or `cases/`, whose README tells what
it is and what it is compared with. Tests assert the bounds; a figure beyond its bound stands in bold. Times and speeds are those of
the machine and moment at hand.

Last run on: {machine}.

| case | run | what | found | bound | particles | wall time [s] | 10^6 particle-steps/s |
|---|---|---|---|---|---|---|---|
"""


def machine():
    name = platform.machine()
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            name = next(line.split(":")[1].strip() for line in file if line.startswith("model name"))
    except (OSError, StopIteration):
        pass
    return f"{name}, {os.cpu_count()} processors"


def number(value, unit):
    return f"{value:.3g}" + (f" {unit}" if unit else "")


def readme_of(case):
    """From the page: below cases/verification/, or below cases/ itself."""
    cases = os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..", "cases")
    return f"../cases/{case if os.path.isdir(os.path.join(cases, case)) else 'verification/' + case}/README.md"


def lines_of(record):
    """The table's lines of one run, the run's own facts in the first."""
    case = f"[{record['case']}]({readme_of(record['case'])})"
    facts = f"{record['particles']} | {record['wall_s']:.1f} | {record['particle_steps_per_s'] / 1e6:.2f}"
    for row in record["rows"]:
        figure, bound = row["figure"], row["bound"]
        kept = figure >= bound if row["side"] == "at least" else abs(figure) <= bound
        found = number(figure, row["unit"])
        yield (f"| {case} | {record['setting']} | {row['quantity']} | {found if kept else f'**{found}**'} "
               f"| {row['side']} {number(bound, row['unit'])} | {facts} |")


def key_of(line):
    """Case and setting of a line of the table."""
    cells = [cell.strip() for cell in line.split("|")]
    return cells[1], cells[2]


def read_page(path):
    """The lines of the page's table by case and setting."""
    table = {}
    if not os.path.exists(path):
        return table
    with open(path, encoding="utf-8") as file:
        for line in file.read().splitlines():
            if line.startswith("| ["):
                table.setdefault(key_of(line), []).append(line)
    return table


def main(rows, page):
    table = read_page(page)
    for path in sorted(glob.glob(os.path.join(rows, "*.json"))):
        with open(path, encoding="utf-8") as file:
            lines = list(lines_of(json.load(file)))
        if lines:
            table[key_of(lines[0])] = lines
    text = HEAD.format(machine=machine())
    for key in sorted(table):
        text += "\n".join(table[key]) + "\n"
    with open(page, "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
