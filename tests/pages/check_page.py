#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Opens the page of a run in Chromium, where that is installed, and looks at what it shows.

    check_page.py DMP SOURCE_FOLDER [--keep FOLDER]

runs a coarse vein valve and spheres in 3-D with DMP and checks their report.html. --keep leaves the screenshots in a folder. Ends with 77
where there is no Chromium, which ctest takes as skipped."""
import pathlib
import shutil
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


# The particles at the first or the last time: how many pixels have a colour, a number that changes with the picture, the time.
PARTICLES = """new Promise(done => {
  const view = document.getElementById('particle-view'), slider = view.querySelector('.particle-time input');
  const at = WHICH;
  if (at != null) {
    slider.value = at < 0 ? slider.max : at;
    slider.dispatchEvent(new Event('input'));
  }
  requestAnimationFrame(() => {
    const canvas = view.querySelector('canvas'), copy = document.createElement('canvas');
    Object.assign(copy, { width: canvas.width, height: canvas.height });
    const to = copy.getContext('2d', { willReadFrequently: true });
    to.drawImage(canvas, 0, 0);
    const pixels = to.getImageData(0, 0, copy.width, copy.height).data;
    let coloured = 0, sum = 0;
    for (let i = 0; i < pixels.length; i += 4) {
      if (Math.max(...pixels.subarray(i, i + 3)) - Math.min(...pixels.subarray(i, i + 3)) > 40) ++coloured;
      sum = (31 * sum + pixels[i] + 7 * pixels[i + 1] + 13 * pixels[i + 2]) % 1000000007;
    }
    done({ share: coloured / (pixels.length / 4), sum, time: view.querySelector('.time-shown').textContent });
  });
})"""


class Pages(unittest.TestCase):
    dmp = None

    def particles(self, at=None):
        """`at`: the number of a frame, -1: the last, None: as it is, drawn again."""
        redraw = "window.dispatchEvent(new Event('resize'))" if at is None else "0"
        self.browser.value(redraw)
        return self.browser.value(PARTICLES.replace("WHICH", "null" if at is None else str(at)))

    def check_particles(self, first, last):
        before = self.particles(0)
        after = self.particles(-1)
        self.assertEqual((before["time"], after["time"]), (first, last))
        self.assertGreater(after["share"], 0.04)
        self.assertNotEqual(before["sum"], after["sum"])
        self.assertEqual(self.particles(0), before, "the same again")
        self.assertEqual(self.browser.complaints(), [])


class Page(Pages):
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

    def test_plots_values_that_differ_by_rounding_alone(self):
        copy = self.results.parent / "rounded"
        shutil.copytree(self.results, copy, ignore=shutil.ignore_patterns("frames", "*.png"))
        header, *rows = (copy / "measures.csv").read_text().splitlines()
        for at, row in enumerate(rows):
            values = row.split(",")
            values[1] = ("1", "1.0000000000000002", "0.9999999999999999")[at % 3]
            rows[at] = ",".join(values)
        (copy / "measures.csv").write_text("\n".join([header, *rows]) + "\n")
        subprocess.run([self.dmp, "report", copy], check=True, stdout=subprocess.DEVNULL)
        self.browser.open(copy / "report.html", 1600, "light")
        self.assertEqual(self.browser.complaints(), [])
        self.assertTrue(all(self.browser.value(DRAWN)))

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

    def test_particles_are_drawn_at_each_time(self):
        for width in WIDTHS:
            for scheme in SCHEMES:
                with self.subTest(width=width, scheme=scheme):
                    self.browser.open(self.page, width, scheme)
                    self.check_particles("0 ms", "200 ms")

    def test_groups_are_hidden_and_coloured(self):
        self.browser.open(self.page, 1600, "light")
        whole = self.particles(-1)
        names = "[...document.querySelectorAll('.group label')].map(label => label.textContent)"
        self.assertEqual(self.browser.value(names), ["Fluid", "Walls", "Solid"])
        self.browser.value("document.querySelector('.group input').click()")
        self.assertLess(self.particles(-1)["share"], whole["share"] / 2)
        self.browser.value("document.querySelector('.group input').click()")
        self.assertEqual(self.particles(-1), whole)
        fields = "[...document.querySelectorAll('.group select')].map(s => [...s.options].map(o => o.textContent))"
        fluid, solid = self.browser.value(fields)
        self.assertEqual(fluid, ["one colour", "speed", "pressure"])
        self.assertIn("von mises", solid)
        for field, unit in (("1", "Pa"), ("0", "m/s")):
            self.browser.value("(s => { s.value = %s; s.dispatchEvent(new Event('change')); })"
                               "(document.querySelector('.group select'))" % field)
            self.assertIn(unit, self.browser.value("document.querySelector('.scale').innerText"))
            self.assertEqual(self.particles(-1)["sum"] == whole["sum"], field == "0")
        self.assertEqual(self.browser.complaints(), [])

    def test_particles_play_and_are_moved_by_keyboard(self):
        self.browser.open(self.page, 1600, "light")
        whole = self.particles(0)
        self.browser.value("document.querySelector('.particle-stage canvas').focus()")
        for key in ("ArrowRight", "+"):
            moved = self.particles(0)
            self.browser.key(key)
            self.assertNotEqual(self.particles(0)["sum"], moved["sum"], key)
        self.browser.key("0")
        self.assertEqual(self.particles(0)["sum"], whole["sum"])
        self.browser.key(".")
        self.assertEqual(self.browser.value("document.querySelector('.time-shown').textContent"), "10 ms")
        self.browser.value("document.querySelector('.particle-time button').click()")
        self.browser.value("""new Promise(done => {
          const slider = document.querySelector('.particle-time input'), from = slider.value;
          const look = () => slider.value !== from ? done(0) : requestAnimationFrame(look);
          look();
        })""")
        self.assertEqual(self.browser.value("document.querySelector('.particle-time button').textContent"), "Pause")
        self.assertEqual(self.browser.complaints(), [])

    def test_without_webgl_says_so(self):
        with browser.Browser(webgl=False) as other:
            other.open(self.page, 400, "light")
            self.assertIn("offers no WebGL 2", other.value("document.getElementById('particle-view').innerText"))
            self.assertEqual(other.value("document.querySelectorAll('#particle-view canvas').length"), 0)
            self.assertTrue(all(other.value(DRAWN)))
            self.assertEqual(other.complaints(), [])

    def test_texts_can_be_read_without_scripts(self):
        self.browser.open(self.page, 400, "light", script=False)
        text = self.browser.value("document.body.innerText")
        for part in ("The plots need JavaScript", "What was conserved", "How to run it again", "inlet_flux [m^3/s]"):
            self.assertIn(part, text)
        self.assertEqual(self.browser.value("document.querySelectorAll('canvas').length"), 0)


class PageInSpace(Pages):
    """Spheres, in 3-D."""
    results, keep = None, None

    @classmethod
    def setUpClass(cls):
        cls.browser = browser.Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()

    def test_is_drawn_turned_and_cut(self):
        for width in WIDTHS:
            for scheme in SCHEMES:
                with self.subTest(width=width, scheme=scheme):
                    self.browser.open(self.results / "report.html", width, scheme)
                    last = self.browser.value("document.querySelector('.time-shown').textContent")
                    self.check_particles(self.particles(0)["time"], last)
                    if self.keep:
                        self.browser.screenshot(self.keep / f"spheres_{width}_{scheme}.png")
        whole = self.particles(-1)
        self.browser.value("document.querySelector('.particle-stage canvas').focus()")
        self.browser.key("ArrowRight")
        self.assertNotEqual(self.particles(-1)["sum"], whole["sum"])
        self.browser.key("0")
        self.assertEqual(self.particles(-1)["sum"], whole["sum"])
        self.browser.value("(s => { s.value = 1; s.dispatchEvent(new Event('change')); })"
                           "(document.querySelector('[aria-label=\"Cut across\"]'))")
        self.assertNotEqual(self.particles(-1)["sum"], whole["sum"])
        self.assertEqual(self.browser.complaints(), [])

    def test_with_damaged_frames_says_so(self):
        copy = self.results.parent / "damaged"
        shutil.copytree(self.results, copy)
        frames = sorted((copy / "frames").glob("spheres_*.vtp"))
        frames[0].write_bytes(frames[0].read_bytes()[:1000])
        frames[1].unlink()
        subprocess.run([self.dmp, "report", copy], check=True, stdout=subprocess.DEVNULL)
        self.browser.open(copy / "report.html", 1600, "light")
        text = self.browser.value("document.body.innerText")
        self.assertEqual(text.count("is left out of the particles: cannot be read"), 2)
        self.assertIn(f"{len(frames) - 2} of the {len(frames)} frames are shown", text)
        self.assertEqual(self.browser.complaints(), [])

    def test_without_frames_says_so(self):
        copy = self.results.parent / "without"
        shutil.copytree(self.results, copy, ignore=shutil.ignore_patterns("frames", "*.pvd", "walls.vtp"))
        subprocess.run([self.dmp, "report", copy], check=True, stdout=subprocess.DEVNULL)
        self.browser.open(copy / "report.html", 400, "dark")
        self.assertIn("No frames are there", self.browser.value("document.body.innerText"))
        self.assertIsNone(self.browser.value("document.getElementById('particle-view')"))
        self.assertEqual(self.browser.complaints(), [])


def main():
    arguments = sys.argv[1:]
    if "--keep" in arguments:
        at = arguments.index("--keep")
        Page.keep = PageInSpace.keep = pathlib.Path(arguments[at + 1])
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
        Pages.dmp = dmp
        PageInSpace.results = pathlib.Path(folder) / "spheres"
        subprocess.run([dmp, "run", source + "/cases/carrier", "--threads", "1", "--leave-out", "pictures", "--out",
                        str(PageInSpace.results)], check=True, stdout=subprocess.DEVNULL)
        unittest.main(argv=sys.argv[:1])


if __name__ == "__main__":
    main()
