#!/usr/bin/env python3
"""The fixed set of invented scenes that every test run compares. Exit status 77 (skip) without POV-Ray.

usage: test.py VERISIM
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

SCENES = 200
SEED = 33

if not shutil.which("povray"):
    print("POV-Ray is not installed")
    sys.exit(77)
with tempfile.TemporaryDirectory() as folder:
    done = subprocess.run(
        [
            sys.executable,
            pathlib.Path(__file__).with_name("invent.py"),
            "--out",
            folder,
            "--verisim",
            sys.argv[1],
            "--seed",
            str(SEED),
            "--count",
            str(SCENES),
            "--no-reduce",
        ]
    )
    if done.returncode:
        print((pathlib.Path(folder) / "classes.md").read_text())
        for path in sorted((pathlib.Path(folder) / "found").glob("*.pov")):
            print(f"--- {path.name}\n{path.read_text('latin-1')}")
sys.exit(done.returncode)
