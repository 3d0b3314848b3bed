# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of bench/run, bench/table.py and bench/lammps.py, with programs that only look like LAMMPS."""
import contextlib
import importlib.machinery
import importlib.util
import io
import json
import os
import stat
import subprocess
import sys
import tempfile
import unittest

BENCH = os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..", "..", "bench")
sys.dont_write_bytecode = True
sys.path.insert(0, BENCH)
import lammps  # noqa: E402
import table  # noqa: E402

PROGRAM = os.environ["DMP_BENCH_PROGRAM"]
HELP_WITH_SPH = "* Pair styles:\\n\\nlj/cut          sph/taitwater/morris            sph/lj\\n"
LOG = """Per MPI rank memory allocation (min/avg/max) = 3.044 | 3.044 | 3.044 Mbytes
Loop time of 9 on 1 procs for 20 steps with 400 atoms
99.5% CPU use with 1 MPI tasks x 1 OpenMP threads
Pair    | 1          | 1          | 1          |   0.0 | 50.00
Ave neighs/atom = 1.0000000
Neighbor list builds = 0
Loop time of 2 on 1 procs for 50 steps with 400 atoms

Performance: 139677448.559 tau/day, 323327.427 timesteps/s
98.5% CPU use with 1 MPI tasks x 1 OpenMP threads

Section |  min time  |  avg time  |  max time  |%varavg| %total
---------------------------------------------------------------
Pair    | 1.76       | 1.76       | 1.76       |   0.0 | 88.10
Neigh   | 0          | 0          | 0          |   0.0 |  0.00

Ave neighs/atom = 9.8500000
Neighbor list builds = 3
"""


def load_run():
    loader = importlib.machinery.SourceFileLoader("bench_run", os.path.join(BENCH, "run"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("bench_run", loader))
    loader.exec_module(module)
    return module


class WithFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def program(self, name, script):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write("#!/bin/sh\n" + script)
        os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)
        return path

    def lmp(self, help_text, run="exit 0"):
        return self.program("lmp", f"if [ \"$1\" = -h ]; then printf '{help_text}'; exit 0; fi\n{run}\n")

    def particles(self, *options):
        path = os.path.join(self.folder, "particles.txt")
        subprocess.run([PROGRAM, "--case", "channel2d", "--particles", "400", "--kernel", "lucy", *options,
                        "--particles-to", path], check=True)
        return path


class Lammps(WithFolder):
    def test_finds_the_sph_package(self):
        self.assertTrue(lammps.has_sph(self.lmp(HELP_WITH_SPH)))
        self.assertFalse(lammps.has_sph(self.lmp("sph/taitwater lj/cut\\n")))

    def test_a_program_that_fails_is_an_error(self):
        with self.assertRaisesRegex(lammps.LammpsError, "code 3"):
            lammps.has_sph(self.program("lmp", "exit 3\n"))
        with self.assertRaises(lammps.LammpsError):
            lammps.has_sph(os.path.join(self.folder, "none"))

    def test_data_has_every_particle_inside_the_box(self):
        for options in ([], ["--case", "channel3d"]):
            with self.subTest(options=options):
                path = os.path.join(self.folder, "particles.txt")
                case = options or ["--case", "channel2d"]
                subprocess.run([PROGRAM, *case, "--particles", "600", "--particles-to", path], check=True)
                head, rows = lammps.read_particles(path)
                text = lammps.data_text(head, rows)
                self.assertIn(f"{head['particles']} atoms\n", text)
                bounds = lammps.box_of(head)
                for row in rows:
                    for (low, high), x in zip(bounds, row[1:]):
                        self.assertTrue(low <= x < high)
                atoms = text.split("Atoms\n\n")[1].split("\n\nVelocities\n\n")
                places, speeds = atoms[0].splitlines(), atoms[1].splitlines()
                self.assertEqual([len(places), len(speeds)], [len(rows)] * 2)
                for row, place, speed in zip(rows, places, speeds):
                    words = place.split()
                    self.assertEqual(words[1], "2" if row[0] else "1")
                    self.assertEqual([float(x) for x in words[5:]], list(row[1:]))
                    self.assertEqual(float(speed.split()[1]), 0 if row[0] else 0.13)

    def test_input_has_the_problem(self):
        head, _ = lammps.read_particles(self.particles())
        lines = lammps.input_text(head, "channel.data", 70).splitlines()
        for line in ("dimension 2", "boundary p f p", "atom_style sph", "read_data channel.data", "run 70"):
            self.assertIn(line, lines)
        pair = next(line for line in lines if line.startswith("pair_coeff")).split()
        self.assertEqual([float(x) for x in pair[3:]], [1056, 10, 0.0035, head["support"]])
        self.assertEqual(lines[-1], "run 70")

    def test_a_truncated_file_is_an_error(self):
        path = self.particles()
        with open(path, encoding="utf-8") as file:
            lines = file.readlines()
        with open(path, "w", encoding="utf-8") as file:
            file.writelines(lines[:-1])
        with self.assertRaisesRegex(lammps.LammpsError, "its head says"):
            lammps.read_particles(path)

    def test_reads_the_last_run_of_a_log(self):
        read = lammps.read_log(LOG)
        self.assertEqual(read, {"atoms": 400, "steps": 50, "particle_steps_per_s_core": 1e4, "pair_percent": 88.1,
                                "cpu_percent": 98.5, "pairs_listed_per_particle": 9.85, "list_builds": 3})
        with self.assertRaisesRegex(lammps.LammpsError, "Loop time"):
            lammps.read_log("ERROR\n")

    def test_runs_where_the_files_are(self):
        # The last argument but two is the log; the input must be there, too.
        lmp = self.lmp(HELP_WITH_SPH, f'test -f "$2" && test -f channel.data && cat > "$4" <<END\n{LOG}END')
        self.assertEqual(lammps.run(lmp, self.particles(), self.folder, 50)["atoms"], 400)

    def test_tells_what_lammps_said(self):
        lmp = self.lmp(HELP_WITH_SPH, 'echo "ERROR: Unrecognized pair style" > "$4"; exit 1')
        with self.assertRaisesRegex(lammps.LammpsError, "code 1: ERROR: Unrecognized pair style"):
            lammps.run(lmp, self.particles(), self.folder, 50)

    def test_as_a_command(self):
        script = os.path.join(BENCH, "lammps.py")
        done = subprocess.run([sys.executable, "-B", script, self.particles(), self.folder], check=False,
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0)
        self.assertTrue(os.path.exists(done.stdout.strip()))
        for arguments in ([], ["--help"], ["nothing.txt", self.folder]):
            wrong = subprocess.run([sys.executable, "-B", script, *arguments], check=False, capture_output=True)
            self.assertEqual(wrong.returncode, 2)


class Run(WithFolder):
    """bench/run as a whole, with a dmp_bench of a few particles and a valve that is a script."""

    def measure(self, *arguments):
        run = load_run()
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = run.main(["--dmp-bench", PROGRAM, "--particles", "500", "--steps", "4", "--repeat", "1", "--out",
                             os.path.join(self.folder, "out"), "--lmp", "no_such_lmp", *arguments])
        with open(os.path.join(self.folder, "out", "speed.json"), encoding="utf-8") as file:
            return code, json.load(file), out.getvalue()

    def test_a_channel_and_no_lammps(self):
        code, result, text = self.measure("--only", "channel2d, Lucy")
        self.assertEqual(code, 0)
        self.assertEqual(len({row.count("|") for row in text.splitlines()[3:6]}), 1)
        case = result["cases"]["channel2d, Lucy"]
        self.assertGreater(case["engine"]["particle_steps_per_s_core"], 0)
        self.assertNotIn("lammps", case)
        self.assertIn("LAMMPS: none found; no 'no_such_lmp' on the path", text)
        with open(os.path.join(self.folder, "out", "speed.md"), encoding="utf-8") as file:
            self.assertEqual(file.read() + "\n", text)

    def test_what_options_cost(self):
        code, result, text = self.measure("--only", "options: shifting", "--only", "options: contact")
        self.assertEqual(code, 0)
        self.assertEqual(list(result["cases"]), ["options: none", "options: shifting", "options: contact"])
        step = {name: case["engine"]["ns_per_particle_step"]["median"] for name, case in result["cases"].items()}
        self.assertIn(f"| shifting | {step['options: shifting'] - step['options: none']:.1f} | ", text)
        self.assertIn("| contact | ", text)

    def test_lammps_without_sph_is_named(self):
        _, result, text = self.measure("--only", "channel2d, Lucy", "--lmp", self.lmp("lj/cut\\n"))
        self.assertIn("without the SPH package", result["lammps"])
        self.assertIn("LAMMPS: none found", text)

    def test_lammps_beside_the_engine_where_kernels_agree(self):
        lmp = self.lmp(HELP_WITH_SPH, f'cat > "$4" <<END\n{LOG}END')
        code, result, text = self.measure("--only", "channel2d, Lucy", "--only", "channel2d", "--lmp", lmp)
        self.assertEqual(code, 0)
        self.assertEqual(result["cases"]["channel2d, Lucy"]["lammps"]["particle_steps_per_s_core"], 1e4)
        self.assertNotIn("lammps", result["cases"]["channel2d"])
        self.assertNotIn("none found", text)

    def test_lammps_that_fails_is_a_failure(self):
        code, _, text = self.measure("--only", "channel2d, Lucy", "--lmp", self.lmp(HELP_WITH_SPH, "exit 9"))
        self.assertEqual(code, 1)
        self.assertIn("channel2d, Lucy, LAMMPS FAILED:", text)

    def fake_bench(self, code, message):
        return self.program("bench", f"""for word; do [ "$word" = --yardstick-only ] && exec {PROGRAM} "$@"; done
printf 'error: {message}\\n  Wait.\\n' >&2; exit {code}
""")

    def test_space_that_the_engine_refuses_is_skipped_with_its_words(self):
        refusing = self.fake_bench(2, "dimension: found 3")
        code, result, text = self.measure("--dmp-bench", refusing, "--only", "channel3d 2 dx, Lucy")
        case = result["cases"]["channel3d 2 dx, Lucy"]
        self.assertEqual(code, 0)
        self.assertEqual(case["skipped"], "not there yet: dimension: found 3; Wait.")
        self.assertIsNone(case["engine"])
        self.assertGreater(case["yardstick"]["ns_per_particle_sweep"]["median"], 0)
        self.assertIn("not there yet: dimension: found 3", text)

    def test_other_errors_are_failures(self):
        for exit_code, case in ((2, "channel2d"), (3, "channel3d 2 dx, Lucy")):
            code, _, text = self.measure("--dmp-bench", self.fake_bench(exit_code, "no"), "--only", case)
            self.assertEqual(code, 1)
            self.assertIn(f"{case} FAILED: exit code {exit_code}: no", text)

    def test_the_valve_from_its_summary(self):
        summary = {"particles": {"fluid": 90, "rigid": 10}, "steps": 10, "wall_s": 1e-3, "threads": 2,
                   "state_hash": "0", "seconds_by_stage": {"forces": 0.5e-3}}
        dmp = self.program("dmp", f"""while [ "$1" != --out ]; do shift; done
mkdir -p "$2" && echo '{json.dumps(summary)}' > "$2/summary.json"
""")
        code, result, text = self.measure("--only", "vein_valve", "--dmp", dmp)
        case = result["cases"]["vein_valve"]
        self.assertEqual(code, 0)
        self.assertAlmostEqual(case["ns_per_particle_step"]["median"], 2000)
        self.assertAlmostEqual(case["ns_by_stage"]["forces"]["percent"], 50)
        self.assertAlmostEqual(case["ns_by_stage"]["rest"]["median"], 1000)
        self.assertIn("| vein_valve | 100 |", text)
        heading, line, valve = text.splitlines()[3:6]
        self.assertEqual(len({row.count("|") for row in (heading, line, valve)}), 1)

    def test_a_valve_that_fails_is_a_failure(self):
        dmp = self.program("dmp", "echo 'error: it leaks' >&2; exit 3\n")
        code, _, text = self.measure("--only", "vein_valve", "--dmp", dmp)
        self.assertEqual(code, 1)
        self.assertIn("vein_valve FAILED: exit code 3: it leaks", text)

    def test_wrong_arguments_end_with_two(self):
        for arguments in (["--stepps", "3"], ["--steps", "0"], ["--only", "channel9d"], ["x"]):
            with self.assertRaises(SystemExit) as ended, contextlib.redirect_stderr(io.StringIO()):
                load_run().main(arguments)
            self.assertEqual(ended.exception.code, 2)


class Table(unittest.TestCase):
    def test_the_same_note_of_several_cases_is_said_once(self):
        yardstick = {"fluid_particles": 1, "wall_particles": 1, "pairs_per_particle": 1, "engine": None,
                     "yardstick": {"ns_per_particle_sweep": {"median": 1, "smallest": 1, "largest": 1},
                                   "processor_percent": 99},
                     "skipped": "not there yet"}
        result = {"machine": {"processor": "p", "processors": 1, "compiler": "c", "commit": "0", "date": "d",
                              "load_before": 0, "load_after": 0},
                  "threads": 1, "steps": 1, "repeat": 1, "lammps": "", "cases": {"a": yardstick, "b": yardstick}}
        self.assertIn("\n- a; b: not there yet\n", table.text_of(result))


if __name__ == "__main__":
    unittest.main()
