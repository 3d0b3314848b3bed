#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Checks which target `./dmp test` builds and which tests it runs, by its options: in a folder of its own, where
stand-ins for cmake, ninja and ctest write down what they are asked."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
STAND_IN = """#!/bin/sh
echo "$(basename "$0") $*" >>"$DMP_TEST_CALLS"
case "$(basename "$0") $*" in
cmake*) touch build/build.ninja ;;
*--show-only*nothing*) echo 'Total Tests: 0' ;;
esac
"""


class Options(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        shutil.copy(ROOT / "dmp", self.folder / "dmp")
        (self.folder / "cmake").mkdir()
        (self.folder / "cmake/packages.txt").write_text("# none\n")
        (self.folder / "bin").mkdir()
        for program in ("cmake", "ninja", "ctest", "apt-get", "dpkg-query"):
            path = self.folder / "bin" / program
            path.write_text(STAND_IN)
            path.chmod(0o755)

    def run_dmp_test(self, *options):
        """Exit code, messages, target that was built, and what ctest was asked when it was to run tests."""
        calls = self.folder / "calls"
        calls.write_text("")
        environment = {**os.environ, "PATH": f"{self.folder}/bin:{os.environ['PATH']}", "DMP_TEST_CALLS": str(calls)}
        for name in ("OMPI_COMM_WORLD_SIZE", "PMI_SIZE"):
            environment.pop(name, None)
        result = subprocess.run([self.folder / "dmp", "test", *options], capture_output=True, text=True,
                                env=environment, stdin=subprocess.DEVNULL)
        lines = calls.read_text().splitlines()
        built = [line.split()[-1] for line in lines if line.startswith("ninja ")]
        asked = [line.removeprefix("ctest --parallel 2 --output-on-failure").strip() for line in lines
                 if line.startswith("ctest --parallel")]
        return result.returncode, result.stdout + result.stderr, built, asked

    def expect(self, options, target, asked):
        code, said, built, tests = self.run_dmp_test(*options)
        self.assertEqual((code, built, tests), (0, [target], [asked]), said)

    def refused(self, options, words):
        code, said, built, tests = self.run_dmp_test(*options)
        self.assertEqual((code, built, tests), (2, [], []), said)
        self.assertIn(words, said)

    def test_all(self):
        self.expect([], "all", "--label-exclude verification|quick_program")

    def test_filter(self):
        self.expect(["--filter", "Kernel"], "all", "--label-exclude verification|quick_program --tests-regex Kernel")
        self.expect(["--filter=Kernel"], "all", "--label-exclude verification|quick_program --tests-regex Kernel")
        self.refused(["--filter"], "--filter needs a name")

    def test_filter_that_matches_nothing(self):
        code, said, _, tests = self.run_dmp_test("--filter", "nothing")
        self.assertEqual((code, tests), (2, []))
        self.assertIn("no test matches 'nothing'", said)

    def test_quick(self):
        self.expect(["--quick"], "quick_tests", "--label-regex quick")

    def test_verification(self):
        self.expect(["--verification"], "all", "--label-exclude verification_long|quick_program")
        self.expect(["--verification", "--long"], "all", "--label-exclude quick_program")

    def test_what_does_not_go_together(self):
        self.refused(["--long"], "--long goes with --verification")
        self.refused(["--quick", "--long"], "--long goes with --verification")
        self.refused(["--quick", "--verification"], "--quick goes with no other option")
        self.refused(["--quick", "--filter", "Scene"], "--quick goes with no other option")
        self.refused(["--fast"], "test does not know --fast")

    def test_help(self):
        code, said, built, _ = self.run_dmp_test("--help")
        self.assertEqual((code, built), (0, []))
        for option in ("--filter", "--quick", "--verification", "--long"):
            self.assertIn(f"\n  {option}", said)


if __name__ == "__main__":
    unittest.main()
