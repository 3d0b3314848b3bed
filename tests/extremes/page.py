# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""The page of the extremes, docs/extremes.md."""

HEAD = """# Extremes

Written by `./dmp test --verification --filter extremes`: {count} runs with values far from the usual ones. What a run
finds is compared with what is known of its answer; some are known to have none, and have to say so. A run ends

- **right**: within its bound of a closed form, of what conservation demands, or of the same run with its usual
  steps ({right});
- **warned**: outside of it, and a warning says why ({warned});
- **refused**, **diverges** or **resources**: with exit code 2, 3 or 4, and an error that says why ({stopped}).

None may end with exit code 0, a wrong answer and no word about it ({silent}). The scenes are written by `tests/extremes/`;
limits of the time step are those of [limits.md](limits.md).
"""


def cell(text):
    return text.replace("|", "\\|").replace("\n", " ")


def row(extreme, ending):
    figure = "" if ending.deviation is None or extreme.bound == 0 else f"{ending.deviation:.2g} of at most {extreme.bound:g}"
    message = "" if ending.how == "right" else ending.message
    message = message if len(message) <= 320 else message[:message.rfind(" ", 0, 320)] + " ..."
    found = "; ".join(part for part in (figure, message) if part)
    return f"| {cell(extreme.name)} | {ending.how} | {cell(found)} |"


def write(path, pairs):
    """`pairs` of extremes and endings."""
    endings = [ending.how for _, ending in pairs]
    right, warned, silent = (endings.count(how) for how in ("right", "warned", "silent"))
    lines = [HEAD.format(count=len(pairs), right=right, warned=warned, silent=silent,
                         stopped=len(pairs) - right - warned - silent)]
    for topic in dict.fromkeys(extreme.topic for extreme, _ in pairs):
        lines.append(f"## {topic[0].upper() + topic[1:]}\n\n| extreme | ends | deviation, or message |\n|---|---|---|")
        for extreme, ending in pairs:
            if extreme.topic == topic:
                lines.append(row(extreme, ending))
        lines.append("")
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(lines))
