#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Does what docs/tutorial.md says, in its order: saves its files, types its commands, and compares what they print.

    check_tutorial.py DMP SOURCE_FOLDER

Runs are cut short, and the study is tried with --dry-run only; so what the page shows of their results is not compared."""
import pathlib
import re
import sys
import tempfile
import unittest

import doc_page

RUN_NAME = re.compile(r"(\d{4})_[0-9a-f]{8}")


def cut_short(command, seconds):
    """The same command, for a run that ends at this time, and the study without its runs."""
    if command[0] == "sweep" and "--dry-run" not in command:
        return None
    if command[0] != "run" or "--dry-run" in command:
        return command
    if "--until" in command:
        at = command.index("--until")
        command = command[:at] + command[at + 2:]
    return [*command, "--until", f"{seconds} s", "--threads", "1", "--set", "output.pictures=false"]


class Tutorial(unittest.TestCase):
    dmp, source = None, None

    def save(self, block, folder):
        if block.language == "geo":
            (folder / "valve.geo").write_text(block.text)
        elif block.text.startswith("scene = "):
            (folder / "my_valve/study.toml").write_text(block.text)
        elif block.text.startswith("schema = "):
            (folder / "my_valve/scene.toml").write_text(block.text)
        else:  # a line to add
            scene = folder / "my_valve/scene.toml"
            changed = re.sub(r"^(largest_speed = .*\n)", r"\1" + block.text, scene.read_text(), flags=re.M)
            self.assertNotEqual(changed, scene.read_text())
            scene.write_text(changed)

    def test_can_be_followed(self):
        blocks = doc_page.blocks(self.source / "docs/tutorial.md")
        said, compared, seconds = None, 0, 0.02
        with tempfile.TemporaryDirectory(prefix="dmp_tutorial_") as folder:
            for at, block in enumerate(blocks):
                commands = doc_page.commands(block)
                if block.language:
                    self.save(block, pathlib.Path(folder))
                elif commands:
                    self.assertEqual(len(commands), 1, block.text)
                    if "--from" in commands[0]:
                        seconds += 0.01
                    command = cut_short(commands[0], seconds)
                    said = None
                    if command:
                        refused = at + 1 < len(blocks) and blocks[at + 1].text.startswith("error: ")
                        said, code = doc_page.run_dmp(self.dmp, command, folder)
                        self.assertEqual(code, 2 if refused else 0, f"{command}\n{said}")
                elif block.text.startswith(("paraview ", "Done: ")):
                    continue
                else:
                    self.assertIn(RUN_NAME.sub(r"\1_NAME", block.text), RUN_NAME.sub(r"\1_NAME", said))
                    compared += 1
            self.assertTrue((pathlib.Path(folder) / "out/my_valve/report.html").is_file())
        self.assertEqual(compared, 4)

    def test_pictures_are_there(self):
        text = (self.source / "docs/tutorial.md").read_text()
        pictures = re.findall(r"!\[.+\]\((.+)\)", text)
        self.assertGreaterEqual(len(pictures), 4)
        for picture in pictures:
            self.assertLess((self.source / "docs" / picture).stat().st_size, 150_000)


def main():
    Tutorial.dmp, Tutorial.source = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    unittest.main(argv=sys.argv[:1])


main()
