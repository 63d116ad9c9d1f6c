#!/usr/bin/env python3
"""`verisim explain --reduce` with the real POV-Ray: scenes in which one statement makes a difference.

usage: test.py VERISIM

The difference is planted: what stands in POV-Ray's place changes a colour of the scene, refuses a word or crashes on it, and
then calls the real one. Exit status 77: POV-Ray is not installed.
"""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

VERISIM = str(pathlib.Path(sys.argv.pop(1)).resolve()) if len(sys.argv) > 1 else "verisim"
POVRAY = shutil.which("povray")

STAND_IN = r"""#!/bin/sh
for a in "$@"; do case "$a" in +I*) in="${{a#+I}}";; esac; done
if [ -n "$in" ]; then {body}
fi
exec {povray} "$@"
"""
SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
#include "things.inc"
camera { location <0, 2, -8> look_at 0 }
light_source { <5, 9, -8> rgb 1 }
plane { y, -1 pigment { checker rgb 0.2 rgb 0.9 } }
#declare Finish = finish { phong 0.5 ambient 0.2 }
#for (I, -3, 3)
  sphere { <I, 0.5, 2>, 0.4 pigment { rgb <0.5, 0.1 * I, 0.7> } finish { Finish } }
#end
union {
  Thing(<-1.5, 0, 0>)
  cylinder { -y, 1.25 * y, 0.31 pigment { color rgb <0.9, 0.25, 0.125> } finish { Finish } }
  rotate 20 * y
}
cone { 2 * x, 0.5, 2 * x + y, 0 pigment { Green } }
"""
THINGS = """#macro Thing(Where)
  box { -0.5, 0.5 pigment { Blue } translate Where }
#end
"""


class Reduce(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        (self.folder / "scene.pov").write_text(SCENE)
        (self.folder / "things.inc").write_text(THINGS)

    def tearDown(self):
        shutil.rmtree(self.folder)

    def call(self, body, *more):
        stand_in = self.folder / "povray"
        stand_in.write_text(STAND_IN.format(body=body, povray=POVRAY))
        stand_in.chmod(0o755)
        return [VERISIM, "explain", "--reduce", str(self.folder / "scene.pov"), "--oracle", str(stand_in), "+W80", "+H60", *more]

    def run_it(self, body, *more, seconds=90):
        begin = time.monotonic()
        environment = dict(os.environ, XDG_CACHE_HOME=str(self.folder / "cache"))
        run = subprocess.run(self.call(body, *more), capture_output=True, text=True, env=environment, timeout=seconds)
        self.seconds = time.monotonic() - begin
        return run

    def reduced(self):
        lines = (self.folder / "scene.reduced.pov").read_text().splitlines()
        self.assertTrue(lines[0].startswith("// Reduced by verisim explain --reduce from scene.pov: "), lines[0])
        return [line.strip() for line in lines if not line.startswith("//")]

    def test_a_color_that_is_drawn_otherwise(self):
        run = self.run_it('sed -i "s/0.25, *0.125/0.75, 0.125/" "$in"')
        self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
        lines = self.reduced()
        text = " ".join(lines)
        self.assertIn("0.25, 0.125", text)
        self.assertIn("cylinder", text)
        for gone in ("things", "Finish", "#for", "union", "cone", "Green", "plane", "colors"):
            self.assertNotIn(gone, text)
        self.assertLessEqual(len(lines), 8, lines)
        self.assertLess(self.seconds, 75)
        self.assertIn("cylinder (scene.reduced.pov", run.stdout)  # the suspects are those of the reduced scene
        shown = (self.folder / "scene.reduced.pov").read_text().splitlines()[1]
        self.assertTrue(shown.startswith("// verisim compare scene.reduced.pov +W80 +H60"), shown)

    def test_what_only_verisim_accepts(self):
        run = self.run_it("""if grep -q phong "$in"; then echo "File '$in' line 1: Parse Error: No phong." >&2; exit 1; fi""")
        self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
        text = " ".join(self.reduced())
        self.assertIn("phong", text)
        self.assertNotIn("union", text)
        self.assertIn("only verisim draws it", run.stdout)

    def test_a_crash_of_povray(self):
        run = self.run_it("if grep -q cone $in; then kill -SEGV $$; fi")
        self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
        self.assertIn("cone", " ".join(self.reduced()))
        self.assertNotIn("sphere", " ".join(self.reduced()))

    def test_no_file_of_others_is_written_over(self):
        mine = self.folder / "scene.reduced.pov"
        mine.write_text("// mine\n")
        run = self.run_it("true")
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("--reduce-to", run.stderr)
        self.assertEqual(mine.read_text(), "// mine\n")

    def test_nothing_to_reduce(self):
        run = self.run_it("true")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertIn("nothing to reduce", run.stdout)
        self.assertFalse((self.folder / "scene.reduced.pov").exists())

    def test_interrupted_with_the_best_so_far(self):
        run = subprocess.Popen(self.call('sed -i "s/0.25, *0.125/0.75, 0.125/" "$in"'), stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True, env=dict(os.environ, XDG_CACHE_HOME=str(self.folder / "cache")))
        time.sleep(4)
        run.send_signal(signal.SIGINT)
        out, err = run.communicate(timeout=30)
        self.assertEqual(run.returncode, 130, out + err)
        self.assertIn("0.125", " ".join(self.reduced()))


if __name__ == "__main__":
    if not POVRAY:
        sys.exit(77)
    unittest.main()
