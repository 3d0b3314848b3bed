#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Opens the page of a run in Chromium, where that is installed, and looks at what it shows.

    check_page.py DMP SOURCE_FOLDER [--keep FOLDER]

runs a coarse vein valve with DMP and checks its report.html. --keep leaves the screenshots in a folder. Ends with 77
where there is no Chromium, which ctest takes as skipped."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import browser

WIDTHS, SCHEMES = (400, 1600), ("light", "dark")
DRAWN = """[...document.querySelectorAll('.plot canvas')].map(canvas => {
  const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
  const box = canvas.getBoundingClientRect();
  let drawn = 0;
  for (let i = 3; i < pixels.length; i += 4) if (pixels[i] > 0) ++drawn;
  return box.width > 100 && box.height > 100 && drawn > 500;
})"""


class Page(unittest.TestCase):
    results, keep = None, None  # folders

    @classmethod
    def setUpClass(cls):
        cls.page = cls.results / "report.html"
        cls.browser = browser.Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()

    def test_is_small(self):
        self.assertLess(self.page.stat().st_size, 5_000_000)

    def test_shows_plots_and_pictures_at_every_width_in_both_schemes(self):
        for width in WIDTHS:
            for scheme in SCHEMES:
                with self.subTest(width=width, scheme=scheme):
                    self.browser.open(self.page, width, scheme)
                    self.assertEqual(self.browser.complaints(), [])
                    drawn = self.browser.value(DRAWN)
                    self.assertEqual(len(drawn), self.browser.value("document.querySelectorAll('.plot').length"))
                    self.assertGreaterEqual(len(drawn), 5)
                    self.assertTrue(all(drawn), drawn)
                    self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), width)
                    self.assertTrue(self.browser.value(
                        "[...document.images].length > 1 && [...document.images].every(i => i.naturalWidth > 100)"))
                    self.assertEqual(self.browser.value("getComputedStyle(document.body).backgroundColor"),
                                     "rgb(255, 255, 255)" if scheme == "light" else "rgb(13, 17, 23)")
                    if self.keep:
                        self.browser.screenshot(self.keep / f"report_{width}_{scheme}.png")

    def test_plots_are_read_and_zoomed_by_keyboard(self):
        self.browser.open(self.page, 1600, "light")
        self.browser.value("document.querySelector('.plot').focus()")
        legend = "[...document.querySelectorAll('.plot')].map(p => p.querySelectorAll('.u-value')[0].textContent)"
        self.browser.key("ArrowRight")
        self.assertEqual(set(self.browser.value(legend)), {"0"}, "the first time, in all plots")
        self.browser.key("ArrowRight")
        self.assertEqual(set(self.browser.value(legend)), {"0.01"})
        before = self.browser.value("document.querySelector('.plot canvas').toDataURL()")
        self.browser.key("+")
        self.browser.value("new Promise(done => requestAnimationFrame(() => done(0)))")
        self.assertNotEqual(self.browser.value("document.querySelector('.plot canvas').toDataURL()"), before)
        self.assertEqual(self.browser.complaints(), [])

    def test_texts_can_be_read_without_scripts(self):
        self.browser.open(self.page, 400, "light", script=False)
        text = self.browser.value("document.body.innerText")
        for part in ("The plots need JavaScript", "What was conserved", "How to run it again", "inlet_flux [m^3/s]"):
            self.assertIn(part, text)
        self.assertEqual(self.browser.value("document.querySelectorAll('canvas').length"), 0)


def main():
    arguments = sys.argv[1:]
    if "--keep" in arguments:
        at = arguments.index("--keep")
        Page.keep = pathlib.Path(arguments[at + 1])
        del arguments[at:at + 2]
    dmp, source = arguments
    if browser.chromium() is None:
        print("skipped: there is no Chromium on this machine (apt-get install chromium)")
        sys.exit(77)
    with tempfile.TemporaryDirectory(prefix="dmp_page_") as folder:
        Page.results = pathlib.Path(folder) / "out"
        subprocess.run([dmp, "run", source + "/cases/vein_valve", "--set", 'particles.spacing="0.8 mm"', "--set",
                        'output.every="10 ms"', "--until", "0.2 s", "--threads", "1", "--out", str(Page.results)],
                       check=True, stdout=subprocess.DEVNULL)
        unittest.main(argv=sys.argv[:1])


if __name__ == "__main__":
    main()
