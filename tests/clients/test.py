#!/usr/bin/env python3
"""Programs that call POV-Ray, unchanged, with `povray` a link to verisim: their pictures beside those with POV-Ray.

usage: test.py VERISIM CLIENT...    clients of clients.py, or `recorded`: the calls of recorded.py; without POV-Ray they only have to get their
                                    pictures
       test.py VERISIM --table      all that are installed, as the table of docs/clients.md
Exit status 77: nothing of what was named is installed.
"""
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from clients import CLIENTS, Failed  # noqa: E402
from recorded import RECORDED  # noqa: E402

ALL = {**CLIENTS, **{"recorded." + name: client for name, client in RECORDED.items()}}

SYSTEM_PATH = "/usr/local/bin:/usr/bin:/bin:/usr/games"


def oracle():
    """POV-Ray itself, or None."""
    found = shutil.which("povray", path=SYSTEM_PATH)
    if not found:
        return None
    said = subprocess.run([found, "--version"], capture_output=True, text=True, errors="replace")
    return found if "POV-Ray" in said.stdout + said.stderr and not (said.stdout + said.stderr).startswith("verisim") else None


def installed(client):
    """Its version; None: it is not there."""
    if not client.package:
        return "recorded"
    status = subprocess.run(["dpkg-query", "-W", "-f", "${db:Status-Status} ${Version}", client.package], capture_output=True, text=True).stdout.split()
    return status[1] if status[:1] == ["installed"] and all(shutil.which(p, path=SYSTEM_PATH) for p in client.needs) else None


def run(client, folder, povray, threads=None):
    """Runs the client in a new folder with a `povray` in its path that notes how it is called and goes on as the program `povray`, in its
    name. Returns the pictures and the calls."""
    folder.mkdir()
    for name in ("home/.povray/3.7", "bin", "link", "work", "run"):
        (folder / name).mkdir(parents=True)
    (folder / "run").chmod(0o700)
    (folder / "link/povray").symlink_to(povray)
    more = " -P" if threads else ""  # POV-Ray pauses when it is done even where nobody can press a key
    (folder / "bin/povray").write_text(f'#!/bin/sh\n{{ printf "%s\\n" "$@"; echo; }} >>{folder}/calls\nexec {folder}/link/povray "$@"{more}\n')
    (folder / "bin/povray").chmod(0o755)
    system_ini = pathlib.Path("/etc/povray/3.7/povray.ini")  # which a user's own takes the place of
    if threads:
        (folder / "home/.povray/3.7/povray.ini").write_text((system_ini.read_text() if system_ini.exists() else "") + f"\nWork_Threads={threads}\n")
    before, here = dict(os.environ), os.getcwd()
    os.environ.update(PATH=f"{folder}/bin:{SYSTEM_PATH}", HOME=str(folder / "home"), XDG_RUNTIME_DIR=str(folder / "run"), TMPDIR=str(folder / "run"), PWD=str(folder / "work"))
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "PYTHONPATH", "POVINI"):
        os.environ.pop(name, None)
    os.chdir(folder / "work")
    try:
        pictures = [folder / "work" / name for name in client().run()]
    finally:
        os.chdir(here)
        os.environ.clear()
        os.environ.update(before)
    for picture in pictures:
        if not picture.is_file() or picture.stat().st_size == 0:
            raise Failed(f"{picture.name} was not made")
    if not (folder / "calls").exists():
        raise Failed("it called another povray")
    calls = [block.split("\n") for block in (folder / "calls").read_text().strip("\n").split("\n\n")]
    return pictures, [shlex.join(["povray", *words]).replace(f"{folder}/", "") for words in calls]


def measured(verisim, reference, picture):
    ended = subprocess.run([verisim, "diff", reference, picture, "--antialiased", "--json", "-"], capture_output=True, text=True)
    if ended.returncode > 1:
        raise Failed(ended.stderr)
    return json.loads(ended.stdout)


def judged(verisim, ours, theirs, again):
    """What is said of a picture: POV-Ray twice, with other threads, says how far it is from itself."""
    ours_report, noise = measured(verisim, theirs, ours), measured(verisim, theirs, again)
    floor, rmse = noise["rmse"], ours_report["rmse"]
    if ours_report["status"] in ("exact", "match"):
        return True, ours_report["status"]
    if floor > 0:  # docs/comparison.md: POV-Ray differs from itself
        return rmse <= 1.5 * floor + 1, f"RMSE {rmse:.2f}, POV-Ray from itself {floor:.2f}"
    return False, f"differs: RMSE {rmse:.2f}"


def test(verisim, name, work):
    """(whether it is well, version, calls, what is said of each picture)"""
    client = ALL[name]
    version = installed(client)
    if not version:
        return None
    pictures, calls = run(client, work / f"{name}-verisim", verisim)
    povray = oracle()
    if not povray:
        return True, version, calls, ["made; POV-Ray is not installed"]
    theirs, _ = run(client, work / f"{name}-povray", povray, 1)
    again = run(client, work / f"{name}-again", povray, 2)[0] if getattr(client, "noisy", False) else theirs
    verdicts = [judged(verisim, *three) for three in zip(pictures, theirs, again)]
    return all(well for well, _ in verdicts), version, calls, [words for _, words in verdicts]


def main():
    verisim = os.path.abspath(sys.argv[1])
    table = sys.argv[2:] == ["--table"]
    names = list(CLIENTS) if table else [n for word in sys.argv[2:] for n in ALL if n == word or n.startswith(word + ".")]
    work = pathlib.Path(tempfile.mkdtemp(prefix="verisim_clients_"))
    status, found = 0, False
    for name in names:
        try:
            result = test(verisim, name, work)
        except (Failed, subprocess.TimeoutExpired) as error:
            print(f"{name}: FAILED: {error}")
            status, found = 1, True
            continue
        if result is None:
            print(f"{name}: not installed", file=sys.stderr)
            continue
        found = True
        well, version, calls, words = result
        status = status if well else 1
        shown = "; ".join(dict.fromkeys(calls)) if not table else "<br>".join(f"`{c}`" for c in dict.fromkeys(calls))
        print(f"| {name} | {version} | {shown} | {', '.join(words)} |" if table else f"{name} {version}: {shown}: {', '.join(words)}", flush=True)
    if status == 0:
        shutil.rmtree(work)
    else:
        print(f"pictures: {work}")
    return status if found else 77


sys.exit(main())
