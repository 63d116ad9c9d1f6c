"""Programs written for vapory."""

import os
import shutil
import subprocess
import unittest

from support import Scratch

import numpy as np

import verisim
from verisim.vapory import *
from verisim.vapory import vectorize


def ball(*objects, **options):
    camera = Camera("location", [0, 2, -3], "look_at", [0, 1, 2])
    light = LightSource([2, 4, -3], "color", [1, 1, 1])
    return Scene(camera, objects=[light, Sphere([0, 1, 2], 2, Texture(Pigment("color", [1, 0, 1]))), *objects], **options)


class Text(unittest.TestCase):
    def test_elements(self):
        self.assertEqual(" ".join(str(Torus(1.5, 0.5, "rotate", [0, 90.0, -1])).split()), "torus { 1.5 , 0.5 rotate <0,90.0,-1> }")
        self.assertEqual(str(SkySphere()).split()[0], "sky_sphere")
        self.assertEqual(str(Mesh2()).split()[0], "mesh2")
        self.assertEqual(str(element("conserve_energy")()).split()[0], "conserve_energy")
        self.assertEqual(vectorize(np.array([1.5, 2])), "<1.5,2.0>")
        self.assertEqual(str(Macro("Round", [0, 0, 0], 1, False)), "Round(<0,0,0>, 1, off)\n")
        verisim.check(f"#version 3.7; {Cone([0, 0, 0], 1, [0, 1, 0], -0.5)} {Cylinder([0, 0, 0], [0, 1, -1], 1)}")


class Rendered(Scratch):
    def test_array(self):
        image = ball().render(width=60, height=40, antialiasing=0.1)
        self.assertEqual((image.shape, image.dtype), ((40, 60, 3), np.uint8))
        image[0, 0] = 7  # it is the caller's own
        self.assertEqual(ball().render(width=60, height=40, output_alpha=True).shape, (40, 60, 4))
        self.assertEqual(os.listdir("."), [])

    def test_file_and_notebook(self):
        self.assertIsNone(ball().render("ball.png", width=60, height=40))
        self.assertEqual(verisim.diff("ball.png", ball().render("ipython", width=60, height=40)).max_abs, 0)
        ball().render("ball.png", width=60, height=40, remove_temp=False)
        self.assertTrue(os.path.exists("__temp__.pov"))

    def test_all_arguments_of_a_scene(self):
        scene = ball(
            Sphere([-1, 1, 0], 0.5, Pigment("Red_Paint")),
            atmospheric=[Fog("distance", 10, "color", [1, 1, 1])],
            included=["colors.inc"],
            defaults=[Finish("ambient", 0.3)],
            declares=["Red_Paint = pigment { color rgb <1, 0, 0> }"],
            global_settings=["assumed_gamma 1", Radiosity("count", 10)],
        )
        os.makedirs("include")
        with open("include/colors.inc", "w") as file:
            file.write("#declare Any = 1;")
        self.assertEqual(scene.render(width=20, height=16, includedirs=["include"], quality=5).shape, (16, 20, 3))

    def test_copies(self):
        scene = ball()
        more = scene.add_objects([Background("color", [0, 0, 1])])
        self.assertEqual((len(scene.objects), len(more.objects)), (2, 3))
        self.assertNotEqual(str(scene.set_camera(Camera("location", [0, 0, -9]))), str(scene))

    def test_error(self):
        with self.assertRaisesRegex(OSError, "Undeclared"):
            ball(Sphere([0, 0, 0], "Radius")).render(width=8, height=6)

    @unittest.skipUnless(shutil.which("povray"), "povray is not installed")
    def test_is_what_povray_draws(self):
        scene = ball(Cone([0, 0, 0], 1, [0, 1, 0], 0.2, Texture(Pigment("color", [0.2, 1, 0.2]))), global_settings=["assumed_gamma 1"])
        scene = scene.set_camera(scene.camera.add_args(["right", [60 / 40, 0, 0]]))
        with open("scene.pov", "w") as file:
            file.write("#version 3.7;\n" + str(scene))
        subprocess.run(["povray", "+Iscene.pov", "+Opovray.png", "+W60", "+H40", "-D", "-A", "+FN"], capture_output=True, check=True)
        self.assertEqual(verisim.diff("povray.png", scene.render(width=60, height=40, auto_camera_angle=False)).status, "exact")


if __name__ == "__main__":
    unittest.main()
