# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""A run with a value far from the usual, what is known of its answer, and how it has to end.

An extreme ends `right` (what it found is within a bound of what is known), `warned` (it is not, and a warning says why),
or with an error of exit code 2 (`refused`), 3 (`diverges`) or 4 (`resources`) that says why. It must not end `silent`:
with exit code 0, a wrong answer, and no word about it."""
import csv
import json
import os
import pathlib
import re
import subprocess
import tempfile
from dataclasses import dataclass, field
from typing import Callable, Optional

ROOT = pathlib.Path(__file__).resolve().parents[2]
CODES = {2: "refused", 3: "diverges", 4: "resources"}


class Results:
    """What a run that ended well has written."""

    def __init__(self, folder):
        self.summary = json.loads((folder / "summary.json").read_text())
        self.columns = {}
        table = folder / "measures.csv"
        if table.exists():
            with table.open(newline="") as file:
                rows = list(csv.reader(file))
            for k, title in enumerate(rows[0]):
                self.columns[title.split(" [")[0]] = [float(row[k]) if row[k] else float("nan") for row in rows[1:]]

    @property
    def time(self):
        return self.columns["time"]

    def last(self, name):
        return self.columns[name][-1]

    def warnings(self):
        """Without the places in the scene's file."""
        return [re.sub(r"^\S+:\d+:\d+: ", "", text) for text in self.summary["warnings"]]


@dataclass
class Extreme:
    """`scene`: a folder below cases/, or the text of a scene file; `files`: what lies beside it. `deviation` gives the
    relative deviation of a run from what is known of it; it may be at most `bound`. `says`: words of the message."""
    topic: str
    name: str
    scene: str
    sets: list = field(default_factory=list)
    until: str = ""
    deviation: Optional[Callable[[Results], float]] = None
    bound: float = 0.0
    ends: str = "right"
    says: str = ""
    files: dict = field(default_factory=dict)
    slow: bool = False  # takes more than a few seconds
    seconds: int = 3600  # of wall time: only a run that hangs takes as long

    def __post_init__(self):
        if self.ends == "right" and self.deviation is None:
            raise ValueError(f"{self.name}: nothing to compare it with")
        if self.ends != "right" and not self.says:
            raise ValueError(f"{self.name}: no words that name the cause")


@dataclass
class Ending:
    how: str
    message: str  # of the error, or the warnings
    deviation: Optional[float]
    wall: float


def error_text(stderr):
    """The error of a run, and what to do about it."""
    lines = stderr.splitlines()
    starts = [k for k, line in enumerate(lines) if line.startswith("error: ")]
    if not starts:
        return stderr.strip()
    return "; ".join(line.strip() for line in lines[starts[-1]:]).removeprefix("error: ")


def run(program, extreme):
    """Runs it in a folder of its own, on one thread."""
    with tempfile.TemporaryDirectory(prefix="dmp_extreme_") as place:
        folder = pathlib.Path(place)
        scene = ROOT / "cases" / extreme.scene
        if "\n" in extreme.scene:
            scene = folder / "scene.toml"
            scene.write_text(extreme.scene)
            for name, text in extreme.files.items():
                (folder / name).write_text(text)
        words = [program, "run", str(scene), "--out", str(folder / "out"), "--threads", "1",
                 "--leave-out", "frames,pictures,page,checkpoint"]
        for override in extreme.sets:
            words += ["--set", override]
        if extreme.until:
            words += ["--until", extreme.until]
        surroundings = dict(os.environ, OMP_WAIT_POLICY="passive", XDG_CACHE_HOME=str(folder / "cache"))
        began = os.times().elapsed
        try:
            done = subprocess.run(words, cwd=folder, env=surroundings, stdin=subprocess.DEVNULL, capture_output=True,
                                  text=True, timeout=extreme.seconds, check=False)
        except subprocess.TimeoutExpired:
            return Ending("hangs", f"not done after {extreme.seconds} s", None, extreme.seconds)
        wall = os.times().elapsed - began
        if done.returncode != 0:
            how = CODES.get(done.returncode, f"exit code {done.returncode}")
            text = error_text(done.stderr).replace(place + "/", "")
            return Ending(how, text.replace(str(ROOT) + "/", ""), None, wall)
        results = Results(folder / "out")
        off = extreme.deviation(results) if extreme.deviation else 0.0
        said = results.warnings()
        if abs(off) <= extreme.bound:  # false for nan, too
            how = "right"
        else:
            how = "warned" if extreme.says and any(extreme.says in text for text in said) else "silent"
        return Ending(how, "; ".join(said), off, wall)


def as_expected(extreme, ending):
    """Whether it ended as it has to, and with the words that name the cause."""
    return ending.how == extreme.ends and (extreme.ends == "right" or extreme.says in ending.message)
