# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""A Slurm of one node on this machine's loopback, in a folder of its own, for tests of jobs. Debian's packages slurm-wlm
and munge; it needs neither root nor a configuration outside the folder."""
import os
import pathlib
import pwd
import shutil
import socket
import subprocess
import tempfile
import time

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol", "scancel")
SECONDS_TO_START = 60
# Debian keeps the daemons where only root's PATH looks.
PATH = os.environ.get("PATH", "") + ":/usr/sbin:/sbin"

# Jobs are told apart by process group, so that no control groups are needed; times between looks are short, as tests
# wait for them. Few elements are allowed in an array, so that a study of some runs needs more than one.
CONFIGURATION = """\
ClusterName=test
SlurmctldHost=localhost
SlurmctldPort={controller_port}
SlurmdPort={node_port}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
ReturnToService=2
SchedulerParameters=sched_interval=1,bf_interval=1,batch_sched_delay=1
KillWait=10
MaxArraySize={array}
NodeName=localhost CPUs={processors} State=UNKNOWN
PartitionName=main Nodes=localhost Default=YES MaxTime=INFINITE State=UP
"""


def missing():
    """The first of Slurm's programs that this machine does not have; '' where it has all."""
    return next((name for name in PROGRAMS if shutil.which(name, path=PATH) is None), "")


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for each in sockets:
        each.bind(("127.0.0.1", 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


class Slurm:
    """Starts it; `with` ends it. `environment` is for those who use it."""

    def __init__(self, processors=2, most_elements=1000):
        # Below /tmp, as the path of a socket may not be long.
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="dmp_slurm_", dir="/tmp"))
        self.environment = {**os.environ, "PATH": PATH, "SLURM_CONF": str(self.folder / "slurm.conf")}
        ports = free_ports(2)
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
            folder=self.folder, user=pwd.getpwuid(os.getuid()).pw_name, controller_port=ports[0], node_port=ports[1],
            processors=processors, array=most_elements + 1))
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        try:
            self._start("munged", "--force", f"--key-file={key}", f"--socket={self.folder}/munge.socket",
                        f"--pid-file={self.folder}/munged.pid", f"--log-file={self.folder}/munged.log",
                        f"--seed-file={self.folder}/munge.seed")
            self._start("slurmctld")
            self._start("slurmd", "-N", "localhost")
            self._wait_for_the_node()
        except BaseException:
            self.__exit__()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        subprocess.run(["scancel", "--user", str(os.getuid())], env=self.environment, capture_output=True, check=False)
        for name in ("slurmd", "slurmctld", "munged"):
            self._end(self.folder / f"{name}.pid")
        shutil.rmtree(self.folder, ignore_errors=True)

    def call(self, *words):
        """What one of Slurm's programs says."""
        return subprocess.run(words, env=self.environment, capture_output=True, text=True, check=True).stdout

    def queue(self):
        """(job, element, state, reason) of each element that waits or runs."""
        lines = self.call("squeue", "--noheader", "--array", "--format=%F|%K|%t|%r").splitlines()
        return [tuple(line.split("|")) for line in lines]

    def _start(self, *words):
        started = subprocess.run(words, env=self.environment, capture_output=True, text=True, check=False)
        if started.returncode != 0:
            raise RuntimeError(f"{words[0]} does not start: {started.stderr}{self.logs()}")

    def _wait_for_the_node(self):
        end = time.monotonic() + SECONDS_TO_START
        while time.monotonic() < end:
            said = subprocess.run(["sinfo", "--noheader", "--format=%T"], env=self.environment, capture_output=True,
                                  text=True, check=False)
            if "idle" in said.stdout:
                return
            time.sleep(0.2)
        raise RuntimeError(f"the node does not come up: {self.logs()}")

    def logs(self):
        """The ends of what its programs have written."""
        return "".join(f"\n{log.name}:\n{log.read_text(errors='replace')[-2000:]}" for log in self.folder.glob("*.log"))

    @staticmethod
    def _end(pid_file):
        """Ends the process that has written this file, and waits for that."""
        if not pid_file.exists():
            return
        pid = int(pid_file.read_text())
        for signal, tries in ((15, 100), (9, 50)):
            for _ in range(tries):
                try:
                    os.kill(pid, signal if _ == 0 else 0)
                except ProcessLookupError:
                    return
                time.sleep(0.1)
