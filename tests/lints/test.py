#!/usr/bin/env python3
"""Lints, `--fix` and `--sarif` of `verisim check`: each lint on a scene that has the mistake, and none on its twin that has not.

    test.py VERISIM
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

VERISIM = str(pathlib.Path(sys.argv[1]).resolve())
START = ("#version 3.7; global_settings { assumed_gamma 1 }\ncamera { location <0, 2, -9> look_at 0 }\n"
         "light_source { <20, 30, -40>, rgb 1 }\n")
# Name of the lint, scene with the mistake, scene without.
CASES = [
    ("unused-name", "#declare Radius = 2;\nsphere { 0, 1 }\n", "#declare Radius = 2;\nsphere { 0, Radius }\n"),
    ("unused-name", "#macro Ball()\n sphere { 0, 1 }\n#end\nsphere { 0, 1 }\n", "#macro Ball()\n sphere { 0, 1 }\n#end\nBall()\n"),
    ("unused-name", "#declare A = 1;\nsphere { 0, 1 }\n", "#for (I, 1, 2)\nsphere { 0, 1 }\n#end\n"),
    ("shadowed-name", "#declare R = 1;\n#macro Ball(R)\n sphere { 0, R }\n#end\nBall(2) sphere { x, R }\n",
     "#declare R = 1;\n#macro Ball(Size)\n sphere { 0, Size }\n#end\nBall(2) sphere { x, R }\n"),
    ("constant-in-loop", "#for (I, 0, 3)\n #declare R = 0.5;\n sphere { I*x, R }\n#end\n",
     "#for (I, 0, 3)\n #declare R = 0.5 + I;\n sphere { I*x, R }\n#end\n"),
    ("constant-in-loop", "#for (I, 0, 3)\n #local C = rgb <1, 0, 0>;\n sphere { I*x, 1 pigment { C } }\n#end\n",
     "#declare N = 0;\n#for (I, 0, 3)\n #declare N = 0;\n #while (N < 2)\n  sphere { <I, N, 0>, 1 }\n  #declare N = N + 1;\n #end\n#end\n"),
    ("skipped-directive", "#if (0)\n #elif (1)\n sphere { 0, 1 }\n#end\n", "#if (0)\n #elseif (1)\n sphere { 0, 1 }\n#end\n"),
    ("skipped-directive", "#macro M()\n #endif\n#end\n", "#macro elif()\n#end\n#if (0)\n #elif()\n#end\n"),
    ("constant-in-loop", "#declare S = sphere { 0, 1 }\n#for (I, 0, 3)\n #declare N = <0, 0, 0>;\n#end\n",
     "#declare S = sphere { 0, 1 }\n#for (I, 0, 3)\n #declare N = <0, 0, 0>;\n #declare P = trace(S, -2*z, z, N);\n#end\n"),
    ("coincident-surfaces", "box { 0, 1 pigment { rgb x } }\nbox { <0.5, 0, -1>, <2, 1, 2> pigment { rgb y } }\n",
     "box { 0, 1 pigment { rgb x } }\nbox { <0, 1, 0>, <1, 2, 1> pigment { rgb y } }\nbox { <1, 0.1, 0>, <2, 1.1, 1> pigment { rgb z } }\n"),
    ("light-inside", "light_source { <3, 0, 0>, rgb 1 }\nsphere { 3*x, 1 pigment { rgb 1 } }\n",
     "light_source { <3, 0, 0>, rgb 1 }\nsphere { 3*x, 1 pigment { rgb 1 } no_shadow }\nsphere { 3*x, 1 pigment { rgbt 1 } }\n"),
    ("inward-normals", "smooth_triangle { 0, z, x, z, y, -z }\n", "smooth_triangle { 0, z, x, <0.1, 0, 1>, y, z }\n"),
    ("hidden-texture", "sphere { 0, 1 texture { pigment { rgb 1 } } texture { pigment { rgb x } } }\n",
     "sphere { 0, 1 texture { pigment { rgb 1 } } texture { pigment { rgbt <1, 0, 0, 0.5> } } }\n"),
    ("ambient-with-radiosity", "global_settings { radiosity { } }\nsphere { 0, 1 finish { ambient 0.5 } }\n",
     "global_settings { radiosity { } }\nsphere { 0, 1 finish { emission 0.5 } }\n"),
]


# Scenes like those above where a lint would be wrong.
QUIET = [
    ("shadowed-name", "#macro Ball(Size)\n #local R = Size;\n sphere { 0, R }\n#end\nBall(2)\n"),
    ("shadowed-name", "#macro Ball(N)\n #if (N < 1) #declare N = 1; #end\n sphere { 0, N }\n#end\n"
     "#macro Box(N)\n box { 0, N }\n#end\nBall(2) Box(2)\n"),
    ("light-inside", "light_source { <3, 1, 0>, rgb 1 }\nbox { <2, 0, -1>, <4, 1, 1> pigment { rgb 1 } }\n"),
    ("coincident-surfaces",  # seen from above, both stand on the floor
     "box { <0, -1, 0>, 1 pigment { rgb x } }\nbox { <0.5, -1, -1>, <2, 3, 2> pigment { rgb y } }\n"),
    ("light-inside", "light_source { 3*x, rgb 1 parallel point_at 0 }\nsphere { 3*x, 1 pigment { rgb 1 } }\n"),
    ("light-inside", "light_source { 3*x, rgb 1 shadowless }\nsphere { 3*x, 1 pigment { rgb 1 } }\n"),
    ("light-inside", "light_source { 3*x, rgb 1 }\nbox { -100, 100 pigment { rgb 1 } }\n"),  # a room
]


class Check(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def check(self, text, *options, name="scene.pov"):
        (self.folder / name).write_text(text)
        return subprocess.run([VERISIM, "check", name, *options], cwd=self.folder, capture_output=True, text=True, timeout=60)

    def lints(self, text, *options):
        run = self.check(START + text, "--json", *options)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return json.loads(run.stdout).get("lints", [])


class Lints(Check):
    def test_each_finds_its_mistake_alone(self):
        for name, wrong, right in CASES:
            self.assertEqual([f["name"] for f in self.lints(wrong, "--lint", name)], [name], wrong)
            self.assertEqual(self.lints(right, "--lint", name), [], right)

    def test_stay_quiet_where_nothing_is_wrong(self):
        for name, text in QUIET:
            self.assertEqual(self.lints(text, "--lint", name), [], text)

    def test_say_a_thing_once(self):
        inside = "light_source { <3, 0, 0>, rgb 1 }\n#for (I, 0, 3)\nsphere { 3*x, 1 + I/10 pigment { rgb 1 } }\n#end\n"
        self.assertEqual(len(self.lints(inside, "--lint", "light-inside")), 1)
        layers = "texture { pigment { rgb 1 } } texture { pigment { rgb x } }"
        many = "#for (I, 0, 3)\nsphere { 3*I*x, 1 %s }\n#end\n" % layers
        self.assertEqual(len(self.lints(many, "--lint", "hidden-texture")), 1)

    def test_names_for_another_scene_are_used(self):
        (self.folder / "main.pov").write_text('#include "scene.pov"\nsphere { 0, Radius }\n')
        self.assertEqual(self.lints("#declare Radius = 2;\nsphere { 0, 1 }\n", "--lint", "unused-name"), [])

    def test_names_local_to_another_file_are_not_hidden(self):
        (self.folder / "a.inc").write_text("#local R = 1;\n#declare R = R + 1;\n")
        (self.folder / "b.inc").write_text("#macro Ball(R)\n sphere { 0, R }\n#end\n")
        self.assertEqual(self.lints('#include "a.inc"\n#include "b.inc"\nBall(2)\n', "--lint", "shadowed-name"), [])

    def test_are_off_unless_they_are_asked_for(self):
        for name, wrong, _ in CASES:
            self.assertEqual(self.lints(wrong), [])
            self.assertEqual(self.lints(wrong, "--lint", "all", "--lint", "none"), [])
            self.assertIn(name, [f["name"] for f in self.lints(wrong, "--lint", "all")])

    def test_are_told_with_line_and_name(self):
        run = self.check(START + CASES[0][1], "--lint", "unused-name")
        self.assertIn("scene.pov:4:10: lint: Nothing uses 'Radius'. [unused-name]\n     4 | #declare Radius = 2;\n"
                      "       |          ^~~~~~\n", run.stderr)

    def test_are_explained_and_unknown_ones_refused(self):
        run = subprocess.run([VERISIM, "check", "--explain", "light-inside"], capture_output=True, text=True)
        self.assertIn("looks_like", run.stdout)
        run = self.check(START, "--lint", "unused")
        self.assertEqual(run.returncode, 2)
        self.assertIn("unused-name", run.stderr)

    def test_come_with_their_rules_in_sarif(self):
        self.check(START + CASES[0][1], "--lint", "all", "--sarif", "out.sarif")
        run = json.loads((self.folder / "out.sarif").read_text())["runs"][0]
        result = run["results"][-1]
        self.assertEqual(result["ruleId"], "unused-name")
        self.assertEqual(run["tool"]["driver"]["rules"][result["ruleIndex"]]["id"], "unused-name")
        self.assertEqual(result["locations"][0]["physicalLocation"]["region"]["startLine"], 4)


class Findings(Check):
    def test_a_camera_inside_an_opaque_object_is_told(self):
        for inside, color in ((True, "rgb 1"), (False, "rgbt 1")):
            run = self.check(START + "sphere { <0, 2, -9>, 1 pigment { %s } }\n" % color, "--json")
            self.assertEqual(["camera-inside"] if inside else [], [d["code"] for d in json.loads(run.stdout)["diagnostics"]])


class Fixes(Check):
    def test_are_applied_until_nothing_certain_is_left(self):
        run = self.check(START + "Sphere { 0, 1 }\n#declare A = 1\nBox { 0, A }\n", "--fix")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual((self.folder / "scene.pov").read_text(), START + "sphere { 0, 1 }\n#declare A = 1;\nbox { 0, A }\n")

    def test_put_what_old_scenes_leave_out(self):
        run = self.check("#version 3.7\ninclude \"colors.inc\"\ndeclare A = 1;\nsphere { 0, A }\n", "--fix")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual((self.folder / "scene.pov").read_text(),
                         "#version 3.7;\n#include \"colors.inc\"\n#declare A = 1;\nsphere { 0, A }\n")

    def test_stay_out_of_macros_that_gave_the_value(self):
        text = START + "#macro One() 1 #end\n#declare A = One()\nsphere { 0, A }\nbox { 0, One() }\n"
        run = self.check(text, "--fix")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual((self.folder / "scene.pov").read_text(), text.replace("A = One()", "A = One();"))

    def test_leave_a_good_scene_as_it_is(self):
        self.check(START + "sphere { 0, 1 }\n", "--fix")
        self.assertEqual((self.folder / "scene.pov").read_text(), START + "sphere { 0, 1 }\n")


class Sarif(Check):
    def test_names_places_and_rules(self):
        self.check(START + "sphere { 0, Raduis }\n", "--sarif", "out.sarif")
        log = json.loads((self.folder / "out.sarif").read_text())
        self.assertEqual(log["version"], "2.1.0")
        result = log["runs"][0]["results"][0]
        self.assertEqual((result["ruleId"], result["level"]), ("undeclared-identifier", "error"))
        self.assertEqual(log["runs"][0]["tool"]["driver"]["rules"][result["ruleIndex"]]["id"], "undeclared-identifier")
        self.assertEqual(result["locations"][0]["physicalLocation"]["region"],
                         {"startLine": 4, "startColumn": 13, "endColumn": 19})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
