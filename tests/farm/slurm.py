"""A real Slurm of two nodes on this machine: munged, slurmctld and two slurmd of our own, as root and without systemd. Only what it started
is ended."""
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import time

NODES = ("n1", "n2")


def why_not():
    """Why Slurm cannot be started here; empty: it may be tried."""
    missing = [p for p in ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel") if not shutil.which(p)]
    if missing:
        return f"the packages slurm-wlm and munge are missing ({', '.join(missing)})"
    return "" if os.geteuid() == 0 else "it must be root"


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


class CannotStart(Exception):
    pass


class Slurm:
    def __init__(self, folder):
        self.folder = folder
        self.daemons = {}  # the last pid of each, as its pid file told
        host = socket.gethostname().split(".")[0]
        key = folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        (folder / "state").mkdir()
        self.conf = folder / "slurm.conf"
        nodes = "".join(f"NodeName={n} NodeHostname={host} NodeAddr=127.0.0.1 Port={free_port()} CPUs=2 State=UNKNOWN\n" for n in NODES)
        self.conf.write_text(f"""ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmctldPort={free_port()}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
ReturnToService=2
SlurmdTimeout=10
MessageTimeout=5
KillWait=2
SchedulerType=sched/builtin
SchedulerParameters=batch_sched_delay=0,sched_min_interval=100000,sched_interval=2
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MinJobAge=600
MailProg=/bin/true
{nodes}PartitionName=main Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
""")
        os.environ["SLURM_CONF"] = str(self.conf)
        try:
            self.run("munged", f"--key-file={key}", f"--socket={folder}/munge.socket", f"--pid-file={folder}/munged.pid",
                     f"--log-file={folder}/munged.log", f"--seed-file={folder}/munge.seed", "--force")
            for daemon in ("slurmctld", *NODES):
                self.start(daemon)
            self.until(lambda: self.ask("sinfo", "-h", "-o", "%T %D").strip() == "idle 2", "the nodes do not become idle", 60)
        except (CannotStart, OSError) as error:
            logs = "".join(f"== {log.name}\n{log.read_text(errors='replace')[-1500:]}" for log in sorted(folder.glob("*.log")))
            self.stop()
            raise CannotStart(f"{error}\n{logs}") from None

    def run(self, *call):
        done = subprocess.run(call, capture_output=True, text=True, timeout=60)
        if done.returncode != 0:
            raise CannotStart(f"{' '.join(call)}: {done.stdout}{done.stderr}")

    def start(self, which, before=()):
        """`before`: a command that the daemon is started by."""
        self.run(*before, *(("slurmctld", "-f", str(self.conf)) if which == "slurmctld" else ("slurmd", "-f", str(self.conf), "-N", which)))

    def pid(self, which):
        name = which if which in ("slurmctld", "munged") else f"slurmd-{which}"
        try:
            return int((self.folder / f"{name}.pid").read_text())
        except (OSError, ValueError):
            return None

    def kill(self, which, number=signal.SIGKILL):
        pid = self.pid(which)
        if pid:
            try:
                if str(self.folder).encode() in pathlib.Path(f"/proc/{pid}/cmdline").read_bytes():  # a number may be another's by now
                    os.kill(pid, number)
            except OSError:
                pass

    def ask(self, *call):
        return subprocess.run(call, capture_output=True, text=True).stdout

    def until(self, true, what, seconds=120):
        end = time.time() + seconds
        while not true():
            if time.time() > end:
                raise CannotStart(f"{what}\n{self.ask('squeue')}\n{self.ask('sinfo')}")
            time.sleep(0.2)

    def answers(self):
        return subprocess.run(["scontrol", "ping"], capture_output=True, text=True).stdout.find("is UP") >= 0

    def idle(self, seconds=240):
        self.until(lambda: self.answers() and not self.ask("squeue", "-h", "-t", "PD,R,CG,RQ,CF").strip(), "the jobs do not end", seconds)

    def stop(self):
        if self.pid("slurmctld") and self.answers():
            subprocess.run(["scancel", "--quiet", "--me"], capture_output=True)
        for which in (*NODES, "slurmctld"):
            self.kill(which, signal.SIGTERM)
        time.sleep(0.5)
        for which in (*NODES, "slurmctld", "munged"):
            self.kill(which, signal.SIGTERM if which == "munged" else signal.SIGKILL)
