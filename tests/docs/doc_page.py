# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""A page of docs/ as a list of what a reader copies from it: commands, files and scripts."""
import os
import pathlib
import re
import shlex
import subprocess
import textwrap

SKIPPED = 77  # exit code that ctest takes as skipped


class Block:
    """A block of code: the heading above it, its language ("" for an indented one) and its text."""

    def __init__(self, heading, language, text):
        self.heading, self.language, self.text = heading, language, text


def blocks(page):
    """All blocks of code of a page of Markdown, fenced and indented, in order."""
    found, heading, lines = [], "", pathlib.Path(page).read_text().splitlines() + [""]
    at = 0
    while at < len(lines):
        line = lines[at]
        if line.startswith("#"):
            heading = line.lstrip("# ")
        if line.startswith("```"):
            end = lines.index("```", at + 1)
            found.append(Block(heading, line[3:], "\n".join(lines[at + 1:end]) + "\n"))
            at = end
        elif line.startswith("    ") and not lines[at - 1].strip():  # inside a list or a paragraph it is no code
            end = at
            while end < len(lines) and (lines[end].startswith("    ") or not lines[end].strip()):
                end += 1
            found.append(Block(heading, "", textwrap.dedent("\n".join(lines[at:end])).strip("\n") + "\n"))
            at = end - 1
        at += 1
    return found


def commands(block):
    """The ./dmp commands of a block, as lists of arguments without ./dmp; a line that ends in \\ goes on."""
    text = block.text.replace("\\\n", " ")
    return [shlex.split(line, comments=True)[1:] for line in text.splitlines() if line.startswith("./dmp ")]


def run_dmp(dmp, arguments, folder):
    """Starts dmp as ./dmp does; its output and errors together, and its exit code."""
    waiting = {"OMP_WAIT_POLICY": "passive", "GOMP_SPINCOUNT": "1000"}
    done = subprocess.run(["./dmp", *arguments], executable=dmp, cwd=folder, env=waiting | os.environ,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, stdin=subprocess.DEVNULL)
    return done.stdout, done.returncode


def shape(text):
    """What stays of a text when its numbers are values of a run: words, and where numbers stand."""
    return re.sub(r"\s+", " ", re.sub(r"[-+]?\d+(\.\d*)?(e[-+]?\d+)?", "#", text)).strip()
