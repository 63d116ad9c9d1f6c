#!/usr/bin/env python3
"""What a package would find, without making one: usage: check_files.py BUILD

Installs BUILD into an empty tree and looks at debian/ beside it: every pattern of debian/*.install must find something, every installed file must
belong to one package, and none may hold the path of the sources or of the build. Every library that tools/setup.sh installs for the build must be
in Build-Depends, and every package of debian/control must have something to install.
"""
import glob
import os
import pathlib
import re
import subprocess
import sys
import tempfile

SOURCES = pathlib.Path(__file__).resolve().parents[2]
TESTS_ALONE = {"libgtest-dev", "libgmock-dev"}


def stanzas(text):
    """The paragraphs of a control file as dictionaries; continued lines are joined."""
    for paragraph in text.split("\n\n"):
        joined = re.sub(r"\n[ \t]+", " ", paragraph)
        yield dict(line.split(":", 1) for line in joined.splitlines() if ":" in line)


def names(field):
    return {re.split(r"[\s(|<]", entry.strip())[0] for entry in field.split(",") if entry.strip()}


def files_below(tree):
    return {os.path.relpath(os.path.join(folder, name), tree) for folder, _, found in os.walk(tree) for name in found}


def claims(tree, installed):
    """For each package the files that its patterns find; and what is wrong with the patterns."""
    wrong, by_package = [], {}
    for list_of_files in sorted(SOURCES.glob("debian/*.install")):
        found = set()
        for line in list_of_files.read_text().splitlines():
            pattern = line.split("#")[0].split(" ")[0].strip()
            matched = {os.path.relpath(path, tree) for path in glob.glob(os.path.join(tree, pattern))} if pattern else set()
            below = {file for file in installed for path in matched if file == path or file.startswith(path + "/")}
            if pattern and not below and not ("python" in pattern and not any("python" in file for file in installed)):
                wrong.append(f"{list_of_files.name}: '{pattern}' finds nothing")
            found |= below
        by_package[list_of_files.stem] = found
    return by_package, wrong


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    wrong = []
    with tempfile.TemporaryDirectory() as tree:
        subprocess.run(["cmake", "--install", build, "--prefix", "/usr"], env=dict(os.environ, DESTDIR=tree), check=True, stdout=subprocess.DEVNULL)
        installed = files_below(tree)
        by_package, wrong = claims(tree, installed)
        for file in sorted(installed):
            owners = [package for package, files in by_package.items() if file in files]
            if len(owners) != 1:
                wrong.append(f"{file} is in {' and '.join(owners) or 'no package'}")
            content = pathlib.Path(tree, file).read_bytes()
            for path in {str(SOURCES), str(build)}:
                if path.encode() in content:
                    wrong.append(f"{file} holds the path {path}")
    source, *packages = stanzas((SOURCES / "debian/control").read_text())
    needed = re.search(r'^build_packages="(.*?)"', (SOURCES / "tools/setup.sh").read_text(), re.M | re.S)[1].split()
    for package in sorted({p for p in needed if p.endswith("-dev")} - TESTS_ALONE - names(source["Build-Depends"])):
        wrong.append(f"debian/control: Build-Depends lacks {package}")
    for package in packages:
        name = package["Package"].strip()
        if name not in by_package and not (SOURCES / f"debian/{name}.postinst").exists():
            wrong.append(f"debian/control: nothing is installed by {name}")
    for fault in wrong:
        print(fault)
    print(f"{len(installed)} files in {len(by_package)} packages: {len(wrong) or 'nothing'} wrong")
    return 1 if wrong else 0


sys.exit(main())
