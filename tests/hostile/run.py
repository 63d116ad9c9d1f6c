"""Hostile scenes under `--limits strangers`: each ends in time and memory, with a picture or a named error.

    run.py VERISIM [--seconds 60] [--memory 1073741824] [--only PATTERN] [--every N] [--sandbox MODE] [--keep FOLDER]

A render may go beyond the wall-clock limit by the second in which what does not end is ended by force, and by the
start-up of the machine's other work (--patience); beyond its memory by 5 %. Exit status 1: some bomb went off.
"""
import argparse
import fnmatch
import itertools
import os
import resource
import signal
import subprocess
import sys
import tempfile
import time

import bombs

NAMED = {2, 3, 4, 5, 130}  # usage, scene, not supported, input and output, a limit (docs/cli.md)


def peak(pid):
    """Most resident memory so far, in bytes (a child's ru_maxrss would count this program's before the exec)."""
    try:
        with open(f"/proc/{pid}/status") as status:
            return next((int(line.split()[1]) * 1024 for line in status if line.startswith("VmHWM")), 0)
    except OSError:
        return 0


def run(verisim, bomb, folder, options):
    for name, content in {"scene.pov": bomb.text.encode("latin-1", "replace"), **bomb.files}.items():
        with open(os.path.join(folder, name), "wb") as file:
            file.write(content)
    size = [] if any(s.startswith("+W") for s in bomb.switches) else ["+W64", "+H48"]
    words = [verisim, "render", "scene.pov", "+Opicture.png", "-D", "--limits=strangers", f"--max-seconds={options.seconds}",
             f"--max-cpu-seconds={4 * options.seconds}", f"--max-memory={options.memory}", f"--sandbox={options.sandbox}", *size, *bomb.switches]
    errors = open(os.path.join(folder, "errors.txt"), "wb+")
    start, memory = time.monotonic(), 0
    process = subprocess.Popen(words, cwd=folder, stdout=subprocess.DEVNULL, stderr=errors)
    deadline = start + options.seconds + options.patience + 60
    while True:
        memory = max(memory, peak(process.pid))
        pid, status = os.waitpid(process.pid, os.WNOHANG)
        if pid:
            break
        if time.monotonic() > deadline:
            process.kill()
            _, status = os.waitpid(process.pid, 0)
            break
        time.sleep(0.005)
    process.returncode = 0
    seconds = time.monotonic() - start
    errors.seek(0)
    said = errors.read(1 << 25).decode("utf-8", "replace")
    return os.WTERMSIG(status) if os.WIFSIGNALED(status) else 0, os.WEXITSTATUS(status), seconds, memory, said


def complaint(bomb, folder, options, signalled, status, seconds, memory, said):
    """Why this is not how a bomb should end; empty: it is."""
    if signalled:
        return f"killed by {signal.Signals(signalled).name}"
    if seconds > options.seconds + options.patience:
        return f"took {seconds:.1f} s"
    if memory > 1.05 * options.memory + (16 << 20):  # the program and its libraries
        return f"took {memory >> 20} MiB"
    if status == 0:
        if "+KFF" not in " ".join(bomb.switches) and not os.path.exists(os.path.join(folder, "picture.png")):
            return "no picture"
        return ""
    if status not in NAMED:
        return f"exit status {status}"
    if "error" not in said and "not supported" not in said and "verisim render:" not in said:
        return "nothing is said"
    return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("verisim")
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--memory", type=int, default=1 << 30)
    parser.add_argument("--patience", type=float, default=2.0, help="seconds beyond the limit, on a loaded machine")
    parser.add_argument("--only", default="*", help="names that match, e.g. 'media_*'")
    parser.add_argument("--every", type=int, default=1, help="each Nth of them")
    parser.add_argument("--sandbox", default="best-effort")
    parser.add_argument("--keep", help="a folder for the scenes that are not as they should be")
    options = parser.parse_args()
    verisim = os.path.abspath(options.verisim)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    chosen = (b for b in bombs.bombs() if fnmatch.fnmatch(b.name, options.only))
    wrong, ends, slowest, largest = 0, {}, 0, 0
    for bomb in itertools.islice(chosen, 0, None, options.every):
        with tempfile.TemporaryDirectory() as folder:
            result = run(verisim, bomb, folder, options)
            why = complaint(bomb, folder, options, *result)
            signalled, status, seconds, memory, said = result
            ends[status] = ends.get(status, 0) + 1
            slowest, largest = max(slowest, seconds), max(largest, memory)
            last = next((l for l in said.splitlines() if "error" in l), said.strip().splitlines()[-1] if said.strip() else "")
            print(f"{'WRONG' if why else 'ok':5} {bomb.name:32} {status:3} {seconds:6.2f} s {memory >> 20:5} MiB  {why or last[:90]}", flush=True)
            if why:
                wrong += 1
                if options.keep:
                    os.makedirs(options.keep, exist_ok=True)
                    for name in ("scene.pov", *bomb.files):
                        os.replace(os.path.join(folder, name), os.path.join(options.keep, f"{bomb.name}.{name}"))
    print(f"{sum(ends.values())} scenes, {wrong} not as they should be; exit statuses {ends}; at most {slowest:.1f} s and {largest >> 20} MiB")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
