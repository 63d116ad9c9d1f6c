#!/usr/bin/env python3
"""Reads the #includes of the code against the layers that tools/layers/order.txt declares.

usage: check.py [ROOT]
Fails (exit status 1) with file:line for an include that points upward or to no file, for a folder that the list does not name, and for a folder
that has outgrown itself. Tests, and what only tests use (names with `test_support`, `_test` or `fixture`), may include anything.
"""
import collections
import pathlib
import re
import sys

LIBRARIES = ("tracer", "parser", "compare", "cli", "python")  # from the ground up, too
SUFFIXES = (".h", ".cpp", ".inc")
MOST_FILES = 30  # of a folder, tests apart
INCLUDE = re.compile(r'\s*#\s*(?:include|define\s+VERISIM_KERNELS)\s+"([^"]+)"')
FOR_TESTS = re.compile(r"_test\.|test_support|fixture")


def declared(text):
    """The folders of the list, from the ground up."""
    return [line.split()[0] for line in text.splitlines() if line.strip() and not line.startswith("#")]


def check(root):
    """The faults of the tree below `root`, as lines of text."""
    rank = {folder: place for place, folder in enumerate(declared((root / "tools/layers/order.txt").read_text()))}
    faults = []
    files = collections.Counter()
    for path in sorted(p for library in LIBRARIES for p in (root / library).rglob("*") if p.suffix in SUFFIXES):
        name = path.relative_to(root).as_posix()
        folder = path.parent.relative_to(root).as_posix()
        if folder not in rank:
            faults.append(f"{name}:1: the folder {folder} is not in tools/layers/order.txt")
            continue
        if FOR_TESTS.search(path.name):
            continue
        files[folder] += 1
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            found = INCLUDE.match(line)
            if not found:
                continue
            included = pathlib.PurePosixPath(found[1])
            if included.parts[0] not in LIBRARIES:
                continue
            if not (root / included).is_file():
                faults.append(f"{name}:{number}: there is no {included}")
            elif rank.get(included.parent.as_posix(), -1) > rank[folder]:
                faults.append(
                    f"{name}:{number}: {folder} is below {included.parent}, and may not include {included.name}"
                )
    faults += [
        f"{folder}: {count} files, more than {MOST_FILES}: a concept is missing"
        for folder, count in files.items()
        if count > MOST_FILES
    ]
    return faults


if __name__ == "__main__":
    found = check(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "."))
    print("\n".join(found) or "Every include points downward.")
    sys.exit(bool(found))
