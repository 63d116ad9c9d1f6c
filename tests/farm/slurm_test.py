#!/usr/bin/env python3
"""share/verisim/verisim-slurm on a real Slurm of two nodes that this test starts on this machine: jobs in which programs die
end in the same bytes as one machine's pictures. Skips itself (77) without Slurm or without being root.

    slurm_test.py VERISIM VERISIM_SLURM
    slurm_test.py VERISIM VERISIM_SLURM STORY...   only these (plain, requeued ...)
"""
import os
import pathlib
import random
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

SCENES = {
    "radiosity": ("#version 3.7; global_settings { assumed_gamma 1 radiosity { count 80 error_bound 0.4 recursion_limit 2 } }\n"
                  "camera { location <0, 1, -5> look_at 0 } light_source { <3, 5, -6> rgb 1 }\n"
                  "sphere { 0, 1 pigment { rgb <1, 0.5, 0.2> } finish { reflection 0.3 } } plane { y, -1 pigment { checker rgb 1 rgb 0.3 } }\n",
                  ["+W192", "+H144", "+A0.1"]),
    "photons": ("#version 3.7; global_settings { assumed_gamma 1 photons { spacing 0.02 } }\n"
                "camera { location <0, 2, -5> look_at 0 } light_source { <3, 5, -6> rgb 1 }\n"
                "sphere { 0, 1 pigment { rgbf 1 } interior { ior 1.5 } photons { target refraction on reflection on } }\n"
                "plane { y, -1 pigment { rgb 0.8 } }\n", ["+W160", "+H120", "+A0.3"]),
    "blur": ("#version 3.7; global_settings { assumed_gamma 1 }\n"
             "camera { location <0, 1, -5> look_at 0 aperture 0.4 focal_point 0 blur_samples 40 }\n"
             "light_source { <3, 5, -6> rgb 1 area_light x * 2, y * 2, 6, 6 jitter }\n"
             "sphere { <clock * 2 - 1, 0, 0>, 1 pigment { granite } } plane { y, -1 pigment { checker rgb 1 rgb 0.3 } }\n",
             ["+W160", "+H120", "+A0.05", "+AM2", "+R2"]),
}


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


class Slurm:
    """munged, slurmctld and two slurmd of our own; only what it started is ended."""

    def __init__(self, folder):
        self.folder = folder
        host = socket.gethostname().split(".")[0]
        key = folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        (folder / "state").mkdir()
        self.conf = folder / "slurm.conf"
        nodes = "".join(f"NodeName={n} NodeHostname={host} NodeAddr=127.0.0.1 Port={free_port()} CPUs=1 State=UNKNOWN\n" for n in ("n1", "n2"))
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
SchedulerType=sched/builtin
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MinJobAge=600
MailProg=/bin/true
{nodes}PartitionName=main Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
""")
        os.environ["SLURM_CONF"] = str(self.conf)
        subprocess.run(["munged", f"--key-file={key}", f"--socket={folder}/munge.socket", f"--pid-file={folder}/munged.pid",
                        f"--log-file={folder}/munged.log", f"--seed-file={folder}/munge.seed", "--force"], check=True)
        self.start("slurmctld")
        self.start("n1")
        self.start("n2")
        self.until(lambda: self.ask("sinfo", "-h", "-o", "%T %D").strip() == "idle 2", "the nodes do not become idle")

    def start(self, which):
        subprocess.run(["slurmctld" if which == "slurmctld" else "slurmd", "-f", str(self.conf), *([] if which == "slurmctld" else ["-N", which])],
                       check=True)

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
                os.kill(pid, number)
            except ProcessLookupError:
                pass
        return pid

    def ask(self, *call):
        return subprocess.run(call, capture_output=True, text=True).stdout

    def until(self, true, what, seconds=120):
        end = time.time() + seconds
        while not true():
            if time.time() > end:
                sys.exit(f"{what}\n{self.ask('squeue')}\n{self.ask('sinfo')}")
            time.sleep(0.3)

    def idle(self):
        self.until(lambda: not self.ask("squeue", "-h", "-t", "PD,R,CG,RQ").strip(), "the jobs do not end", 240)

    def stop(self):
        subprocess.run(["scancel", "--quiet", "--me"], capture_output=True)
        for which in ("n1", "n2", "slurmctld"):
            self.kill(which, signal.SIGTERM)
        time.sleep(1)
        for which in ("n1", "n2", "slurmctld", "munged"):
            self.kill(which, signal.SIGTERM if which == "munged" else signal.SIGKILL)


class Test:
    def __init__(self, verisim, script):
        self.verisim, self.script = verisim, script
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="verisim_slurm_"))
        os.environ["VERISIM"] = str(verisim)
        self.wholes = {}
        for name, (text, words) in SCENES.items():
            (self.folder / f"{name}.pov").write_text(text)
        self.slurm = Slurm(self.folder)

    def run(self, *call):
        done = subprocess.run([str(c) for c in call], cwd=self.folder, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{call}: status {done.returncode}\n{done.stdout}{done.stderr}")
        return done.stdout

    def whole(self, scene):
        if scene not in self.wholes:
            self.run(self.verisim, "render", f"{scene}.pov", *SCENES[scene][1], "--output", f"{scene}-whole.png")
            self.wholes[scene] = (self.folder / f"{scene}-whole.png").read_bytes()
        return self.wholes[scene]

    def submit(self, job, scene, parts=12):
        self.run(self.script, "still", job, parts, f"{job}.png", f"{scene}.pov", *SCENES[scene][1])

    def check(self, job, scene):
        picture = self.folder / f"{job}.png"
        if not picture.exists():
            self.fail(job, "there is no picture")
        if picture.read_bytes() != self.whole(scene):
            self.fail(job, "the picture is another one")
        print(f"{job}: the same bytes")

    def fail(self, job, what):
        logs = "".join(f"== {log.name}\n{log.read_text()[-500:]}\n" for log in sorted((self.folder / job / "logs").iterdir()))
        sys.exit(f"{job}: {what}\n{self.run(self.script, 'status', job)}\n{logs[-6000:]}")

    def running(self, job):
        """Process ids of renders of this job."""
        found = []
        for entry in pathlib.Path("/proc").iterdir():
            if entry.name.isdigit():
                try:
                    words = (entry / "cmdline").read_bytes().decode(errors="replace").split("\0")
                except OSError:
                    continue
                if words[:2] == [str(self.verisim), "render"] and any(f"/{job}/" in w for w in words):
                    found.append(int(entry.name))
        return found

    # ---- the stories

    def plain(self):
        for scene in SCENES:
            self.submit(f"plain-{scene}", scene)
        self.run(self.script, "animation", "frames", 7, 30, "blur.pov", "+W64", "+H48", "+A0.3", "+Oframe.png")
        self.run(self.verisim, "render", "blur.pov", "+W64", "+H48", "+A0.3", "+KFI1", "+KFF30", "+Owhole-frame.png")
        self.slurm.idle()
        for scene in SCENES:
            self.check(f"plain-{scene}", scene)
        for number in range(1, 31):
            if (self.folder / f"frame{number:02}.png").read_bytes() != (self.folder / f"whole-frame{number:02}.png").read_bytes():
                self.fail("frames", f"frame {number} is another one")
        print("frames: the same bytes")
        if "12 of 12" not in self.run(self.script, "status", "plain-blur"):
            self.fail("plain-blur", "status does not tell that all is done")

    def killed_renders(self):
        self.submit("killed", "blur")
        kills, rng, end = 0, random.Random(5), time.time() + 60
        while kills < 10 and time.time() < end:
            for pid in self.running("killed"):
                try:
                    os.kill(pid, signal.SIGKILL)
                    kills += 1
                except ProcessLookupError:
                    pass
                break
            time.sleep(rng.uniform(0.05, 0.4))
        self.slurm.idle()
        if not (self.folder / "killed.png").exists():
            self.run(self.script, "resume", "killed")
            self.slurm.idle()
        print(f"({kills} renders were killed)")
        if kills == 0:
            self.fail("killed", "nothing was there to be killed")
        self.check("killed", "blur")

    def damaged_part(self):
        part = self.folder / "plain-radiosity" / "parts" / "5.vsp"
        others = {p: p.stat().st_mtime_ns for p in part.parent.iterdir() if p != part}
        os.truncate(part, part.stat().st_size // 2)
        (self.folder / "plain-radiosity.png").unlink()
        self.run(self.script, "resume", "plain-radiosity")
        self.slurm.idle()
        self.check("plain-radiosity", "radiosity")
        if any(p.stat().st_mtime_ns != t for p, t in others.items()):
            self.fail("plain-radiosity", "parts that were whole were rendered again")

    def requeued(self):
        """What the time limit does: USR1 to the script, which saves the state and asks to be put back."""
        self.submit("requeued", "blur", 2)
        self.slurm.until(lambda: self.running("requeued"), "no task begins")
        time.sleep(0.5)
        ids = (self.folder / "requeued" / "slurm").read_text().split()
        subprocess.run(["scancel", "--batch", "--signal=USR1", ids[1]], capture_output=True)
        self.slurm.idle()
        self.check("requeued", "blur")

    def refusals(self):
        for call, word in [(["still", "plain-blur", 2, "x.png", "blur.pov"], "already"),
                           (["still", "new", "two", "x.png", "blur.pov"], "whole numbers"),
                           (["resume", "nowhere"], "no job folder")]:
            done = subprocess.run([str(self.script), *map(str, call)], cwd=self.folder, capture_output=True, text=True)
            if done.returncode != 2 or word not in done.stderr:
                sys.exit(f"{call}: status {done.returncode}: {done.stderr}")
        shown = {**os.environ, "DRY_RUN": "1"}
        done = subprocess.run([str(self.script), "still", "dry", "3", "x.png", "blur.pov"], cwd=self.folder, capture_output=True, text=True, env=shown)
        if done.returncode != 0 or "--array=1-3" not in done.stderr or (self.folder / "dry").exists():
            sys.exit(f"a dry run: {done.stdout}{done.stderr}")
        print("refusals: clear")


def main():
    verisim, script = (pathlib.Path(p).resolve() for p in sys.argv[1:3])
    if os.geteuid() != 0 or not all(shutil.which(p) for p in ("munged", "slurmctld", "slurmd", "sbatch")):
        print("skipped: needs root and the packages slurm-wlm and munge")
        return 77
    test = Test(verisim, script)
    try:
        for story in [getattr(test, name) for name in sys.argv[3:]] or (test.plain, test.damaged_part, test.killed_renders, test.requeued, test.refusals):
            begin = time.time()
            story()
            print(f"-- {story.__name__}: {time.time() - begin:.0f} s", flush=True)
    finally:
        test.slurm.stop()
        shutil.rmtree(test.folder, ignore_errors=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
