#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the commands and the scripts of docs/python.md as they stand.

    check_python.py DMP SOURCE_FOLDER [--print]

compares what a script prints, but for its numbers, with what the page says. --print prints it instead, to be copied into
the page. Ends with 77, which ctest takes as skipped, where there is no Python with the packages that the page names."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import doc_page


def python_with_packages():
    """The first Python that has what the scripts import, or None; Debian's packages are seen by Debian's Python only."""
    for python in ("/usr/bin/python3", sys.executable):
        tried = subprocess.run([python, "-c", "import h5py, matplotlib, numpy, pandas, vtk"], capture_output=True)
        if tried.returncode == 0:
            return python
    return None


class Scripts(unittest.TestCase):
    dmp, source, print_only, python = None, None, False, None

    def test_run_as_they_stand_and_print_what_the_page_says(self):
        blocks = doc_page.blocks(self.source / "docs/python.md")
        scripts = [(block, blocks[at + 1]) for at, block in enumerate(blocks) if block.language == "python"]
        self.assertEqual(len(scripts), 5)
        with tempfile.TemporaryDirectory(prefix="dmp_python_") as folder:
            (pathlib.Path(folder) / "cases").symlink_to(self.source / "cases")
            asked = [command for block in blocks for command in doc_page.commands(block)]
            self.assertEqual([command[0] for command in asked], ["run", "run", "sweep"])
            for command in asked:
                said, code = doc_page.run_dmp(self.dmp, command, folder)
                self.assertEqual(code, 0, said)
            for script, output in scripts:
                with self.subTest(script.heading):
                    done = subprocess.run([self.python, "-c", script.text], cwd=folder, capture_output=True, text=True)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    if self.print_only:
                        print(f"--- {script.heading}\n{done.stdout}")
                    else:
                        self.assertEqual(doc_page.shape(done.stdout), doc_page.shape(output.text))
            for picture in ("measures.png", "study.png", "gaps.png"):
                self.assertGreater((pathlib.Path(folder) / picture).stat().st_size, 5000)


def main():
    arguments = sys.argv[1:]
    if "--print" in arguments:
        arguments.remove("--print")
        Scripts.print_only = True
    Scripts.dmp, Scripts.source = (pathlib.Path(argument).resolve() for argument in arguments)
    Scripts.python = python_with_packages()
    if Scripts.python is None:
        print("skipped: no Python here has pandas, matplotlib, h5py and vtk (docs/python.md names Debian's packages)")
        sys.exit(doc_page.SKIPPED)
    unittest.main(argv=sys.argv[:1])


main()
