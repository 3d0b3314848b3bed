# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of write_page.py."""
import json
import os
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
import write_page  # noqa: E402


class Page(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.rows = folder.name
        self.page = os.path.join(folder.name, "page.md")

    def record(self, case, setting, figure, bound, side="at most"):
        row = {"quantity": "error", "figure": figure, "bound": bound, "side": side, "unit": "%"}
        with open(os.path.join(self.rows, f"{case}_{setting}.json"), "w", encoding="utf-8") as file:
            json.dump({"case": case, "setting": setting, "particles": 10, "wall_s": 2, "particle_steps_per_s": 3e6,
                       "rows": [row]}, file)

    def lines(self):
        write_page.main(self.rows, self.page)
        with open(self.page, encoding="utf-8") as file:
            return [line for line in file.read().splitlines() if line.startswith("| [")]

    def test_a_row_has_figure_bound_and_speed(self):
        self.record("cavity", "fine", -0.5, 1)
        self.assertEqual(self.lines(), ["| [cavity](../cases/verification/cavity/README.md) | fine | error | -0.5 % "
                                        "| at most 1 % | 10 | 2.0 | 3.00 |"])

    def test_cases_outside_the_suites_folder_are_linked_too(self):
        self.record("tricuspid_valve", "a", 0, 1)
        self.assertIn("(../cases/tricuspid_valve/README.md)", self.lines()[0])

    def test_what_is_beyond_its_bound_is_bold(self):
        self.record("cavity", "a", -2, 1)
        self.record("cavity", "b", 0.9, 1, "at least")
        self.record("cavity", "c", 1.1, 1, "at least")
        self.assertEqual(["**" in line for line in self.lines()], [True, True, False])

    def test_rows_of_runs_that_did_not_run_stay(self):
        self.record("cavity", "coarse", 0.7, 1)
        self.record("vortices", "coarse", 0.8, 1)
        self.lines()
        for name in os.listdir(self.rows):
            if name.endswith(".json"):
                os.remove(os.path.join(self.rows, name))
        self.record("cavity", "coarse", 0.6, 1)
        self.assertEqual([line.split("|")[4].strip() for line in self.lines()], ["0.6 %", "0.8 %"])


if __name__ == "__main__":
    unittest.main()
