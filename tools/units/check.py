#!/usr/bin/env python3
"""Whether sources may be compiled together (-DVERISIM_UNITS=ON), in whatever units of eight CMake puts them: each library as one source.

usage: tools/units/check.py BUILD [TARGET...]     BUILD: a folder configured with -DVERISIM_UNITS=ON

Names in unnamed namespaces must differ within a library. A name that two files want is mostly one function that stands twice: let it stand once.
Exit status: 0 all may, 1 some may not (the compiler's errors say which), 2 BUILD has no units.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile


def targets(build):
    """{target: (command without its source, folder, sources)} of all targets with units."""
    found = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        unit = re.search(r"CMakeFiles/([\w-]+)\.dir/Unity/", entry["command"])
        if not unit:
            continue
        command = re.sub(r" -o \S+ -c \S+|-include \S+|-Winvalid-pch|-D_FORTIFY_SOURCE=\d", "", entry["command"])
        sources = re.findall(r'#include "([^"]*)"', pathlib.Path(entry["file"]).read_text())
        found.setdefault(unit[1], (command, entry["directory"], []))[2].extend(sources)
    return found


def check(target, command, folder, sources):
    with tempfile.NamedTemporaryFile("w", suffix=".cpp") as unit:
        unit.writelines(f'#include "{source}"\n' for source in sources)
        unit.flush()
        result = subprocess.run(f"{command} -O0 -fsyntax-only {unit.name}", shell=True, cwd=folder, capture_output=True, text=True)
    errors = [line for line in result.stderr.splitlines() if " error: " in line]
    print(f"{target}: {len(sources)} sources, {len(errors)} errors", flush=True)
    print("".join(f"  {line}\n" for line in errors[:20]), end="")
    return result.returncode == 0


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    build, wanted = pathlib.Path(sys.argv[1]), sys.argv[2:]
    found = targets(build)
    if not found:
        print(f"{build} has no units: configure it with -DVERISIM_UNITS=ON", file=sys.stderr)
        return 2
    return 0 if all([check(t, *found[t]) for t in found if not wanted or t in wanted]) else 1


if __name__ == "__main__":
    sys.exit(main())
