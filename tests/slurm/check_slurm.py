#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Studies in jobs of a real Slurm, which this test starts on loopback (slurm.py).

    check_slurm.py DMP SOURCE_FOLDER [unittest's options]

Ends with 77 where Slurm is not installed (Debian: slurm-wlm, munge), which ctest takes as skipped."""
import contextlib
import csv
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import slurm

MOST_SECONDS = 600  # that anything may take, on a busy machine
MOST_ELEMENTS = 4  # of an array: the study has more runs

STUDY = """scene = "scene.toml"

[[vary]]
key = "particles.spacing"
values = ["0.8 mm", "30 mm"]

[[vary]]
key = "part.blood.viscosity"
values = ["3.5 mPa*s", "4 mPa*s", "4.5 mPa*s"]

[[result]]
name = "fastest"
measure = "largest_speed"
reduce = "maximum"
"""


class Sweep:
    """A dmp sweep that is running."""

    def __init__(self, *words, folder, environment):
        self.said = tempfile.TemporaryFile(mode="w+")
        self.process = subprocess.Popen(words, cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=self.said,
                                        stderr=subprocess.STDOUT)

    def has_said(self, words):
        return words in os.pread(self.said.fileno(), 1 << 20, 0).decode()

    def end(self):
        """Its exit code, and what it has said."""
        code = self.process.wait(MOST_SECONDS)
        with self.said:
            self.said.seek(0)
            return code, self.said.read()


class Jobs(unittest.TestCase):
    dmp, source, slurm = None, None, None

    @classmethod
    def setUpClass(cls):
        cls.slurm = slurm.Slurm(most_elements=MOST_ELEMENTS)
        cls.environment = {**cls.slurm.environment, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                           "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_btl": "self,vader",
                           "OMPI_MCA_btl_vader_single_copy_mechanism": "none", "OMPI_MCA_mpi_yield_when_idle": "1"}

    @classmethod
    def tearDownClass(cls):
        cls.slurm.__exit__()

    def setUp(self):
        # What a path may hold that a shell, an #SBATCH line or Slurm's names of files would read otherwise.
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="dmp test's 100%a "))
        for file in (self.source / "cases/vein_valve").iterdir():
            if file.is_file():
                shutil.copy(file, self.folder)
        scene = (self.folder / "scene.toml").read_text()
        for old, new in (('spacing = "0.2 mm"', 'spacing = "0.8 mm"'), ('duration = "4 s"', 'duration = "0.2 s"'),
                         ('every = "40 ms"', 'every = "10 ms"\npictures = false')):
            self.assertIn(old, scene)
            scene = scene.replace(old, new)
        (self.folder / "scene.toml").write_text(scene)
        (self.folder / "my study.toml").write_text(STUDY)
        self.environment["XDG_CACHE_HOME"] = str(self.folder / ".cache")

    def run(self, result=None):
        result = super().run(result)
        if not result.wasSuccessful():
            print(f"Slurm after {self.id()}:{self.slurm.logs()}", file=sys.stderr)
        return result

    def tearDown(self):
        subprocess.run(["scancel", "--user", str(os.getuid())], env=self.environment, capture_output=True, check=False)
        self.wait_until(lambda: not self.slurm.queue(), "jobs of this test go on")
        shutil.rmtree(self.folder)

    def start(self, *words, environment=None):
        return Sweep(self.dmp, "sweep", "my study.toml", *words, folder=self.folder,
                     environment=environment or self.environment)

    def sweep(self, *words, **more):
        return self.start(*words, **more).end()

    def table(self, out):
        return (self.folder / out / "results.csv").read_text()

    def rows(self, out, name="results.csv"):
        with open(self.folder / out / name, encoding="utf8") as file:
            return list(csv.DictReader(file))

    def local(self):
        """results.csv of the study as it is made without Slurm."""
        code, said = self.sweep("--out", "local")
        self.assertIn(code, (0, 2), said)
        return self.table("local")

    def make_longer(self, duration):
        """All runs take longer, so that something can be done to them meanwhile; none fails."""
        file = self.folder / "scene.toml"
        file.write_text(file.read_text().replace('duration = "0.2 s"', f'duration = "{duration}"'))
        study = self.folder / "my study.toml"
        study.write_text(STUDY.replace(', "30 mm"', "").replace(', "4.5 mPa*s"', ""))

    def wait_until(self, condition, otherwise):
        end = time.monotonic() + MOST_SECONDS
        while not condition():
            if time.monotonic() > end:
                self.fail(otherwise)
            time.sleep(0.02)

    @contextlib.contextmanager
    def halfway(self, out, count):
        """Within it so many runs stand still, each after its frame at 0.05 s: none ends before the test has acted."""
        stopped = {}

        def all_stand():
            for frame in (self.folder / out / "runs").glob("*/frames/fluid_000005.vtp"):
                if frame not in stopped:
                    stopped[frame] = self.process_of(frame.parents[1])
                    os.kill(stopped[frame], signal.SIGSTOP)
            return len(stopped) >= count

        try:
            self.wait_until(all_stand, f"no {count} runs of {out} are half-way")
            yield
        finally:
            for process in stopped.values():
                with contextlib.suppress(ProcessLookupError):
                    os.kill(process, signal.SIGCONT)

    @staticmethod
    def process_of(run):
        return int((run / "dmp.lock").read_text().split("pid = ")[1].split()[0])

    def logs(self, out):
        return [file.read_text() for file in sorted((self.folder / out / "runs").glob("*/run.log"))]

    def test_arrays_give_the_table_of_a_sweep_on_this_machine(self):
        code, said = self.sweep("--slurm", "--out", "out", "--time", "10 min")
        self.assertEqual(code, 2, said)
        self.assertIn("Done: 3 of 6 runs done, 3 failed", said)
        self.assertEqual(self.table("out"), self.local())
        self.assertEqual([row["exit_code"] for row in self.rows("out")], ["0"] * 3 + ["2"] * 3)
        self.assertEqual(len(self.rows("out", "timing.csv")), 6)
        jobs = sorted(folder.name for folder in (self.folder / "out/slurm").iterdir())
        self.assertEqual(jobs, ["1", "2", "ends"], "an array has at most four elements")
        script = (self.folder / "out/slurm/1/job.sh").read_text()
        self.assertIn("\n#SBATCH --array=1-4\n", script)
        self.assertIn("\n#SBATCH --time=0-00:10:00\n", script)
        self.assertEqual(list((self.folder / "out/slurm/ends").iterdir()), [])
        code, said = self.sweep("--slurm", "--out", "out", "--only", "particles.spacing=0.8 mm", "--resume")
        self.assertEqual(code, 0, said)
        self.assertNotIn("Job ", said, "nothing is left to do")

    def test_runs_at_their_time_limit_go_on_though_the_sweep_is_gone(self):
        self.make_longer("0.6 s")
        whole = self.local()
        sweep = self.start("--slurm", "--out", "out")
        with self.halfway("out", 2):
            sweep.process.kill()
            sweep.end()
            # As Slurm does it before the limit. The jobs come back on their own.
            (job,) = {element[0] for element in self.slurm.queue()}
            for element in (1, 2):
                self.slurm.call("scancel", "--signal=USR1", "--batch", f"{job}_{element}")
        self.wait_until(lambda: [e[2] for e in self.slurm.queue()] == ["PD"] * 2, "the jobs are not put back")
        sweep = self.start("--out", "out", "--resume")
        self.wait_until(lambda: sweep.has_said("2 runs in the queue already."), "the jobs are not found in the queue")
        # They would wait two minutes. Slurm refuses a start in the second in which the one before was cleared up.
        self.wait_until(lambda: not list((self.slurm.folder / "spool").glob("job*")), "the first start is not cleared up")
        for element in (1, 2):
            self.slurm.call("scontrol", "update", f"JobId={job}_{element}", "StartTime=now+3")
        code, said = sweep.end()
        self.assertEqual(code, 0, said)
        self.assertEqual(self.table("out"), whole)
        for log in self.logs("out"):
            self.assertIn("Stopped before its end, by SIGUSR1", log)
            self.assertIn("Going on in ", log)
        self.assertEqual(sorted(row["exit_code"] for row in self.rows("out", "timing.csv")), ["0", "0", "138", "138"])

    def test_ends_while_nobody_collects_are_not_lost(self):
        sweep = self.start("--slurm", "--out", "out")
        self.wait_until(lambda: len(self.slurm.queue()) >= 2, "nothing is handed in")
        sweep.process.send_signal(signal.SIGINT)
        code, said = sweep.end()
        self.assertEqual(code, 130, said)
        self.assertIn("The jobs stay in the queue, and their runs go on", said)
        self.assertIn("  scancel ", said)
        self.wait_until(lambda: not self.slurm.queue(), "the jobs do not end")
        code, said = self.sweep("--slurm", "--out", "out", "--resume")
        self.assertEqual(code, 2, said)
        self.assertEqual(self.table("out"), self.local())

    def test_cancelled_jobs_are_rows_and_go_on(self):
        self.make_longer("0.6 s")
        whole = self.local()
        sweep = self.start("--slurm", "--out", "out")
        with self.halfway("out", 2):
            self.slurm.call("scancel", "--user", str(os.getuid()))
        code, said = sweep.end()
        self.assertEqual(code, 143, said)
        for row in self.rows("out"):
            self.assertEqual(row["exit_code"], "143")
            self.assertRegex(row["error"], r"its job \d+_\d ended before the run did: .*CANCELLED")
        code, said = self.sweep("--slurm", "--out", "out", "--resume")
        self.assertEqual(code, 0, said)
        self.assertEqual(self.table("out"), whole)
        for log in self.logs("out"):
            self.assertIn("Going on in ", log)

    def test_killed_runs_are_rows_that_say_so(self):
        self.make_longer("0.6 s")
        sweep = self.start("--slurm", "--out", "out")
        with self.halfway("out", 2):
            first_run = min(run for run in (self.folder / "out/runs").glob("*_*") if run.is_dir())
            # As the system does it for lack of memory: the run alone, and all that its job has started.
            (job,) = {element[0] for element in self.slurm.queue()}
            os.kill(self.process_of(first_run), signal.SIGKILL)
            self.slurm.call("scancel", "--signal=KILL", "--full", f"{job}_2")
        code, said = sweep.end()
        self.assertEqual(code, 137, said)
        first, second = self.rows("out")
        self.assertEqual((first["exit_code"], first["error"]),
                         ("137", "it was ended by signal 9 (Killed), perhaps for lack of memory"))
        self.assertIn(f"its job {job}_2 ended before the run did", second["error"])

    def test_ranks_of_a_run_change_nothing(self):
        # Ranks that wait for each other take long where other processes have the processors.
        scene, study = self.folder / "scene.toml", self.folder / "my study.toml"
        scene.write_text(scene.read_text().replace('duration = "0.2 s"', 'duration = "0.03 s"'))
        study.write_text(STUDY.replace(', "4.5 mPa*s"', "") + "\n[slurm]\nranks = 2\nruns_per_job = 2\n")
        whole = self.local()
        code, said = self.sweep("--slurm", "--out", "out")
        self.assertEqual(code, 2, said)
        self.assertRegex(said, r"Job \d+: 4 runs in 2 elements")
        self.assertEqual(self.table("out"), whole)
        self.assertEqual(len(list((self.folder / "out/slurm/1").glob("element_*.log"))), 2)

    def test_what_jobs_write_into_is_not_removed(self):
        self.make_longer("0.6 s")
        sweep = self.start("--slurm", "--out", "out", "--jobs", "1")
        with self.halfway("out", 1):
            self.assertEqual(sorted(element[2] for element in self.slurm.queue()), ["PD", "R"])
            sweep.process.terminate()
            self.assertEqual(sweep.end()[0], 143)
            code, said = self.sweep("--out", "out", "--overwrite")
            self.assertEqual(code, 2, said)
            self.assertIn("jobs of the study in it wait or run", said)
        self.slurm.call("scancel", "--user", str(os.getuid()))
        self.wait_until(lambda: not self.slurm.queue(), "the jobs do not end")
        code, said = self.sweep("--out", "out", "--overwrite", "--slurm")
        self.assertEqual(code, 0, said)
        self.assertEqual([folder.name for folder in sorted((self.folder / "out/slurm").iterdir())], ["1", "ends"])

    def test_a_job_of_a_study_that_was_changed_meanwhile_says_so(self):
        self.slurm.call("scontrol", "update", "PartitionName=main", "State=DOWN")
        try:
            sweep = self.start("--slurm", "--out", "out")
            self.wait_until(lambda: len(self.slurm.queue()) == 6, "nothing is handed in")
            scene = self.folder / "scene.toml"
            scene.write_text(scene.read_text().replace("1056 kg/m^3", "1050 kg/m^3"))
            words = "waits for something that does not come by itself: PartitionDown"
            self.wait_until(lambda: sweep.has_said(words), "it does not say what the job waits for")
        finally:
            self.slurm.call("scontrol", "update", "PartitionName=main", "State=UP")
        code, said = sweep.end()
        self.assertEqual(code, 2, said)
        for row in self.rows("out"):
            self.assertIn("run " + row["run"][:4] + " of the study is ", row["error"])
            self.assertEqual(row["exit_code"], "2")

    def test_a_refusal_of_sbatch_is_shown(self):
        code, said = self.sweep("--slurm", "--out", "out", "--partition", "nowhere")
        self.assertEqual(code, 2)
        self.assertIn("error: sbatch refuses the job: ", said)
        self.assertIn("invalid partition specified: nowhere", said)
        self.assertIn("--partition", said)
        code, said = self.sweep("--slurm", "--out", "out")
        self.assertIn("Done: 3 of 6 runs done, 3 failed", said, "no run has begun: nothing is asked about the folder")

    def test_without_slurm_nothing_is_written(self):
        code, said = self.sweep("--slurm", "--out", "out", environment={**self.environment, "PATH": "/nowhere"})
        self.assertEqual(code, 2)
        self.assertIn("error: there is no 'sbatch' on this machine", said)
        self.assertFalse((self.folder / "out").exists())

    def test_job_scripts_may_be_ones_own(self):
        form = self.folder / "form.sh"
        form.write_text("#!/bin/bash\n@options@\n# one's own\nruns=$(sed -n \"${SLURM_ARRAY_TASK_ID}p\" @runs@)\n"
                        "exec @command@\n")
        code, said = self.sweep("--slurm", "--out", "out", "--job-template", "form.sh")
        self.assertEqual(code, 2, said)
        self.assertIn("# one's own", (self.folder / "out/slurm/1/job.sh").read_text())
        self.assertEqual(self.table("out"), self.local())
        form.write_text("#!/bin/bash\n@options@\n@commands@\n")
        code, said = self.sweep("--slurm", "--out", "other", "--job-template", "form.sh")
        self.assertEqual(code, 2)
        self.assertIn("form.sh: the job script has @commands@", said)

    def test_a_trade_in_jobs_finds_what_one_on_this_machine_finds(self):
        found = {}
        for out, words in (("jobs", ["--slurm", "--time", "10 min"]), ("local", [])):
            code, said = Sweep(self.dmp, "trade", "scene.toml", "--out", out, "--measures", "inlet_flux", "--set",
                               'particles.spacing="0.4 mm"', "--set", 'flow.largest_speed="0.4 m/s"', *words,
                               folder=self.folder, environment=self.environment).end()
            self.assertEqual(code, 0, said)
            self.assertEqual("in jobs of Slurm" in said, out == "jobs")
            found[out] = json.loads((self.folder / out / "trade.json").read_text())
            found[out].pop("front")  # by what they cost
            for setting in found[out]["settings"]:
                self.assertGreater(setting.pop("processor_s"), 0)
        self.assertEqual(len(found["jobs"]["settings"]), 6)
        self.assertEqual(found["jobs"], found["local"])

    def test_the_dry_run_shows_the_script(self):
        code, said = self.sweep("--slurm", "--out", "out", "--dry-run", "--account", "veins")
        self.assertEqual(code, 0, said)
        self.assertIn("#SBATCH --account=veins\n", said)
        self.assertFalse((self.folder / "out").exists())

    def test_runs_are_done_in_jobs_of_other_systems(self):
        """What a job of another queueing system does for itself."""
        for number in range(1, 7):
            code, _ = self.sweep("--out", "out", "--run", str(number))
            self.assertEqual(code, 0 if number <= 3 else 2)
        environment = {**self.environment, "PATH": "/nowhere"}
        self.assertEqual(self.sweep("--out", "out", "--resume", environment=environment)[0], 2)
        self.assertEqual(self.table("out"), self.local())


if __name__ == "__main__":
    if absent := slurm.missing():
        print(f"skipped: there is no {absent} here (Debian: apt-get install slurm-wlm munge)")
        sys.exit(77)
    Jobs.dmp, Jobs.source = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).absolute()
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
