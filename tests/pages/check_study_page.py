#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Opens the page of a study in Chromium, where that is installed, and looks at what it shows.

    check_study_page.py DMP [--keep FOLDER]

makes the folders of two studies, one of 9600 runs, and has DMP write their pages. --keep leaves the screenshots in a
folder. Ends with 77 where there is no Chromium, which ctest takes as skipped."""
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

import browser
from check_page import DRAWN, SCHEMES, WIDTHS

READOUTS = "[...document.querySelectorAll('.readout')].map(p => p.textContent)"
TREATMENTS = "[...document.querySelectorAll('.treatment')].map(p => p.textContent)"
ROWS = """[...document.querySelectorAll('#run-table tbody tr:not([aria-hidden])')].map(
  row => [...row.children].map(cell => cell.textContent))"""


def choose(key, value):
    """A script that chooses one value of a key."""
    return f"""(() => {{
      const select = [...document.querySelectorAll('#choices label')].find(l => l.textContent.startsWith('{key} '))
        .querySelector('select');
      select.value = [...select.options].find(option => option.text === '{value}').value;
      select.dispatchEvent(new Event('change'));
    }})()"""


def study(folder, keys, rows, plots, results=("gap", "flux")):
    """What `dmp sweep` leaves of a study. `keys`: name, unit; `rows`: values, results or None, error."""
    (folder / "runs").mkdir(parents=True)
    (folder / "sweep.toml").write_text('study = "page"\n')
    for name in ("study.toml", "scene.toml"):
        (folder / name).write_text("# " + name + "\n")
    (folder / "sweep.log").write_text("2026-11-26 23:34:03 UTC  dmp 0.1.0\ndmp sweep study.toml\n\n")
    (folder / "study.json").write_text(json.dumps({
        "title": "A study", "purpose": "To look at its page.", "study_file": "study.toml", "scene_file": "scene.toml",
        "scene_title": "A scene", "combination": f"{len(rows)} runs: each value with each.", "runs": len(rows),
        "keys": [{"name": name, "unit": unit, "values": "several", "is_formula": False} for name, unit in keys],
        "results": [{"name": name, "meaning": "last of " + name} for name in results], "plots": plots}))
    heading = [f"{name} [{unit}]" if unit else name for name, unit in keys]
    lines = [",".join(["run", *heading, "gap [m]", "flux [m^3/s]", "exit_code", "error"])]
    timing = ["run,wall_time [s],processor_time [s],peak_memory [B],exit_code"]
    for number, (values, found, error) in enumerate(rows, 1):
        name = f"{number:04}_{number:08x}"
        lines.append(",".join([name, *map(str, values), *("" if one is None else repr(one) for one in found),
                               "3" if error else "0", error]))
        timing.append(f"{name},0.3,0.2,3e7,0")
    (folder / "results.csv").write_text("\n".join(lines) + "\n")
    (folder / "timing.csv").write_text("\n".join(timing) + "\n")
    return folder


def small_study(folder):
    """Two keys, two seeds, one run that failed, one without a value, one at 0 on a logarithmic axis."""
    rows = []
    for spacing in (0.1, 0.2, 0.4):
        for quality in ("draft", "fine"):
            for seed in (1, 2):
                gap = 10 * spacing + (1 if quality == "fine" else 0) + 0.1 * seed
                rows.append(((spacing, quality, seed), (gap, 1e-6 / spacing), ""))
    rows[3] = (rows[3][0], (None, None), "particle 12 <flew> away")
    rows[5] = (rows[5][0], (rows[5][1][0], 0.0), "")
    rows[7] = (rows[7][0], (math.nan, 1e-6), "")
    plot = {"title": "", "key": "particles.spacing", "lines_by": "quality", "log_x": True, "log_y": False}
    study(folder, [("particles.spacing", "mm"), ("quality", ""), ("particles.seed", "")], rows,
          [plot | {"result": "gap", "references": [{"file": "measured.csv", "x": [0.2], "y": [3.0], "problem": ""}]},
           plot | {"result": "flux", "lines_by": "", "log_y": True}, plot | {"result": "gap", "key": "quality", "log_x": False,
                                                                          "lines_by": "particles.seed"}])
    page = folder / "runs" / "0001_00000001" / "report.html"
    page.parent.mkdir()
    page.write_text("<title>the page of a run</title>")
    return folder


def large_study(folder):
    rows = []
    for speed in range(20):
        for angle in range(8):
            for wall in ("steel", "glass"):
                for spin in range(30):
                    gap = (speed + 1) * (angle + 1) / (spin + 1)
                    failed = len(rows) % 1000 == 77
                    rows.append(((0.5 * (speed + 1), 10 * (angle + 1), wall, 100 * spin),
                                 (None, None) if failed else (gap, math.sin(gap)),
                                 f"spheres {len(rows)} overlap" if failed else ""))
    plot = {"title": "", "key": "spin", "lines_by": "angle", "log_x": False, "log_y": False}
    return study(folder, [("speed", "m/s"), ("angle", "deg"), ("wall", ""), ("spin", "rad/s")], rows,
                 [plot | {"result": "gap"}, plot | {"result": "flux", "key": "speed", "lines_by": "wall"}])


class Pages(unittest.TestCase):
    dmp, folder, keep = None, None, None

    @classmethod
    def setUpClass(cls):
        cls.pages = {}
        for name, make in (("small", small_study), ("large", large_study)):
            folder = make(cls.folder / name)
            subprocess.run([cls.dmp, "report", str(folder)], check=True, stdout=subprocess.DEVNULL)
            cls.pages[name] = folder / "report.html"
        cls.browser = browser.Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()

    def open(self, name, width=1600, scheme="light", script=True):
        self.browser.open(self.pages[name], width, scheme, script)
        self.assertEqual(self.browser.complaints(), [])

    def test_are_small(self):
        self.assertLess(self.pages["small"].stat().st_size, 200_000)
        self.assertLess(self.pages["large"].stat().st_size, 1_500_000)

    def test_show_plots_at_every_width_in_both_schemes(self):
        for name, plots in (("small", 3), ("large", 2)):
            for width in WIDTHS:
                for scheme in SCHEMES:
                    with self.subTest(name=name, width=width, scheme=scheme):
                        self.open(name, width, scheme)
                        drawn = self.browser.value(DRAWN)
                        self.assertEqual(drawn, [True] * plots)
                        self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), width)
                        if self.keep:
                            self.browser.screenshot(self.keep / f"study_{name}_{width}_{scheme}.png")

    def test_lines_are_drawn_where_runs_differ_in_nothing_else(self):
        self.open("small")
        self.assertEqual(self.browser.value(TREATMENTS), [
            "Points: each run. Lines: the mean over particles.seed. 2 runs have no value here.",
            "Points: each run; no lines, as these vary, too: quality. Choose one value of each above to get lines. "
            "1 run has no value here. 1 value is not above 0 and not shown on the logarithmic axis.",
            "Points: each run; these vary, too: particles.spacing. 2 runs have no value here."])
        self.browser.value(choose("quality", "fine"))
        self.assertIn("Lines: the mean over particles.seed", self.browser.value(TREATMENTS)[1])
        self.browser.value(choose("particles.seed", "1"))
        self.assertEqual(self.browser.value(TREATMENTS)[:2], ["", ""])
        self.assertEqual(len(self.browser.value(ROWS)), 3, "the table shows the same runs")
        self.assertEqual(self.browser.complaints(), [])

    def test_plots_are_read_by_keyboard_and_pointer(self):
        self.open("small")
        self.browser.value("document.querySelector('.plot').focus()")
        self.browser.key("ArrowRight")
        self.assertEqual(self.browser.value(READOUTS)[0],
                         "0001_00000001: particles.spacing = 0.1 mm, gap = 1.1 m, quality = draft, particles.seed = 1")
        self.browser.key("ArrowRight")
        self.assertEqual(self.browser.value(READOUTS)[0],
                         "mean of 2 runs, particles.spacing = 0.1 mm, gap = 1.15 m, quality = draft")
        place = self.browser.value("""(() => {
          const ring = document.querySelector('.ring').getBoundingClientRect();
          return [ring.left + ring.width / 2, ring.top + ring.height / 2];
        })()""")
        self.browser.key("End")
        before = self.browser.value(READOUTS)[0]
        self.browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=place[0] + 1, y=place[1])
        self.assertNotEqual(self.browser.value(READOUTS)[0], before)
        self.assertIn("particles.spacing = 0.1 mm", self.browser.value(READOUTS)[0])
        self.assertIn("reference: measured.csv", self.browser.value("document.querySelector('.legend').textContent"))
        self.assertEqual(self.browser.complaints(), [])

    def test_enter_opens_the_page_of_the_run(self):
        self.open("small")
        self.browser.value("document.querySelector('.plot').focus()")
        self.browser.key("ArrowRight")
        self.browser.events = []
        self.browser.key("Enter")
        while not any(event.get("method") == "Page.loadEventFired" for event in self.browser.events):
            self.browser.events.append(self.browser.message())
        self.assertEqual(self.browser.value("document.title"), "the page of a run")

    def test_the_table_is_sorted_and_searched(self):
        self.open("small")
        rows = self.browser.value(ROWS)
        self.assertEqual(rows[0], ["0001_00000001", "0.1", "draft", "1", "1.1", "1e-5", ""])
        self.assertEqual(rows[3][-1], "code 3: particle 12 <flew> away")
        self.assertEqual(rows[7][4], "none")
        links = "[...document.querySelectorAll('#run-table a')].map(a => a.getAttribute('href'))"
        self.assertEqual(self.browser.value(links), ["runs/0001_00000001/report.html"])
        heading = "document.querySelectorAll('#run-table thead button')[4]"
        self.browser.value(heading + ".click()")
        gaps = [row[4] for row in self.browser.value(ROWS)]
        self.assertEqual(gaps[:2] + gaps[-2:], ["1.1", "1.2", "", "none"], "missing ones last")
        self.browser.value(heading + ".click()")
        gaps = [row[4] for row in self.browser.value(ROWS)]
        self.assertEqual(gaps[:1] + gaps[-2:], ["5.2", "", "none"], "also from the largest on")
        self.assertEqual(self.browser.value(heading + ".parentNode.getAttribute('aria-sort')"), "descending")
        self.browser.value("""(() => {
          const search = document.getElementById('search');
          search.value = 'FLEW';
          search.dispatchEvent(new Event('input'));
        })()""")
        self.assertEqual([row[0] for row in self.browser.value(ROWS)], ["0004_00000004"])
        self.assertIn("1 of 12 runs", self.browser.value("document.getElementById('table-controls').textContent"))

    def test_a_table_of_thousands_of_rows_draws_those_in_view(self):
        self.open("large")
        self.assertLess(len(self.browser.value(ROWS)), 100)
        self.assertEqual(self.browser.value(ROWS)[0][0], "0001_00000001")
        self.browser.value("document.querySelector('.run-rows').scrollTop = 1e9")
        self.browser.value("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(0))))")
        self.assertEqual(self.browser.value(ROWS)[-1][0], "9600_00002580")
        self.assertIn("9600 runs", self.browser.value("document.getElementById('table-controls').textContent"))
        self.browser.value(choose("wall", "glass"))
        self.assertIn("4800 of 9600 runs", self.browser.value("document.getElementById('table-controls').textContent"))

    def test_texts_can_be_read_without_scripts(self):
        self.open("small", 400, script=False)
        text = self.browser.value("document.body.innerText")
        for part in ("The plots need JavaScript", "The first runs", "0004_00000004", "particle 12 <flew> away",
                     "How to run it again", "To look at its page."):
            self.assertIn(part, text)
        self.assertEqual(self.browser.value("document.querySelectorAll('canvas').length"), 0)


def main():
    arguments = sys.argv[1:]
    if "--keep" in arguments:
        at = arguments.index("--keep")
        Pages.keep = pathlib.Path(arguments[at + 1])
        del arguments[at:at + 2]
    Pages.dmp, = arguments
    if browser.chromium() is None:
        print("skipped: there is no Chromium on this machine (apt-get install chromium)")
        sys.exit(77)
    with tempfile.TemporaryDirectory(prefix="dmp_study_page_") as folder:
        Pages.folder = pathlib.Path(folder)
        unittest.main(argv=sys.argv[:1])


if __name__ == "__main__":
    main()
