"""render(): the program's bytes, what a scene can be given, progress, and how it is stopped."""

import io
import os
import pathlib
import signal
import subprocess
import sys
import threading
import time
import unittest

from support import BALL, LONG, SOURCE, Scratch, in_python, program

import numpy as np

import verisim

FLAT = "#version 3.7; global_settings { assumed_gamma 1 } camera { orthographic location -z direction z right 2*x up 2*y }\n"
GLOW = "finish { ambient 0 diffuse 0 emission 1 }"


class Bytes(Scratch):
    def test_file_is_that_of_the_program(self):
        pathlib.Path("ball.pov").write_text(BALL)
        cases = [
            (["+A0.1", "+R4", "+AM2"], dict(antialias=0.1, antialias_depth=4, antialias_method=2)),
            (["+A", "+UA"], dict(antialias=True, alpha=True)),
            (["+Q5", "+K0.5", "Declare=n=2"], dict(quality=5, clock=0.5, declare={"n": 2})),
        ]
        for switches, options in cases:
            program("render", "ball.pov", "+W60", "+H40", *switches, "+Oprogram.png")
            picture = verisim.render("ball.pov", 60, 40, **options)
            picture.save("module.png")
            expected = pathlib.Path("program.png").read_bytes()
            self.assertEqual(pathlib.Path("module.png").read_bytes(), expected, switches)
            self.assertEqual(picture.png(), expected)
            self.assertEqual(picture._repr_png_(), expected)

    def test_text_path_bytes_and_stream_are_the_same_scene(self):
        pathlib.Path("scene.pov").write_text(BALL)
        expected = verisim.render("scene.pov", 20, 10).png()
        with open("scene.pov") as stream:
            for scene in (pathlib.Path("scene.pov"), BALL, BALL.encode(), stream, io.BytesIO(BALL.encode())):
                self.assertEqual(verisim.render(scene, 20, 10).png(), expected)

    def test_cornell_box_in_an_empty_folder(self):
        text = (SOURCE / "scenes/cornell_box/cornell_box.pov").read_text()
        image = np.asarray(verisim.render(text, 256, 256, name="cornell_box.pov"))
        self.assertEqual((image.shape, image.dtype), ((256, 256, 3), np.uint8))
        program("render", SOURCE / "scenes/cornell_box/cornell_box.pov", "+W256", "+H256", "+Oprogram.png")
        self.assertEqual(verisim.diff("program.png", image).max_abs, 0)
        self.assertEqual(os.listdir("."), ["program.png"])

    def test_other_formats(self):
        picture = verisim.render(BALL, 20, 10, layers=True)
        for name in ("a.ppm", "a.hdr", "a.png"):
            picture.save(name)
            self.assertGreater(os.path.getsize(name), 100)
        self.assertLess(verisim.diff(picture, "a.ppm").max_abs, 1)
        with self.assertRaisesRegex(ValueError, "ending"):
            picture.save("a.xyz")
        with self.assertRaisesRegex(OSError, "nowhere"):
            picture.save("nowhere/a.png")


class Views(Scratch):
    def test_no_copies(self):
        picture = verisim.render(BALL, 30, 20, layers=True)
        address = picture.__array_interface__["data"][0]
        for view in (np.asarray(picture), picture.pixels, np.frombuffer(picture, np.uint8)):
            self.assertEqual(view.__array_interface__["data"][0], address)
        self.assertEqual(memoryview(picture).shape, (20, 30, 3))
        self.assertTrue(memoryview(picture).readonly)
        for name, shape, kind in [("radiance", (20, 30, 3), "f4"), ("transmit", (20, 30), "f4"), ("depth", (20, 30), "f4"),
                                  ("normal", (20, 30, 3), "f8"), ("albedo", (20, 30, 3), "f4"), ("id", (20, 30), "u4")]:  # fmt: skip
            first, again = getattr(picture, name), getattr(picture, name)
            self.assertEqual((first.shape, first.dtype), (shape, np.dtype(kind)))
            self.assertEqual(first.__array_interface__["data"], again.__array_interface__["data"])

    def test_views_outlive_the_picture(self):
        view = verisim.render(BALL, 30, 20).radiance
        expected = verisim.render(BALL, 30, 20)
        np.testing.assert_array_equal(view, expected.radiance)

    def test_layers(self):
        picture = verisim.render(BALL, 61, 41, layers=["depth", "id", "normal", "albedo"])
        self.assertAlmostEqual(float(picture.depth[20, 30]), 3, places=4)
        self.assertEqual(picture.id[20, 30], 1)
        np.testing.assert_allclose(picture.normal[20, 30], [0, 0, -1], atol=0.05)
        np.testing.assert_allclose(picture.albedo[20, 30], [1, 0.5, 0.2], atol=1e-6)
        with self.assertRaisesRegex(ValueError, r"layers=\['depth'\]"):
            _ = verisim.render(BALL, 4, 4).depth
        with self.assertRaisesRegex(ValueError, "no layer 'z'"):
            verisim.render(BALL, 4, 4, layers=["z"])

    def test_radiance_is_what_bytes_are_made_of(self):
        picture = verisim.render(FLAT + "plane { z, 1 pigment { rgb <0.5, 0.2, 0> } %s }" % GLOW, 4, 4)
        np.testing.assert_allclose(picture.radiance[1, 1], [0.5, 0.2, 0], rtol=1e-6)
        np.testing.assert_array_equal(picture.pixels[1, 1], [188, 124, 0])


class Given(Scratch):
    """declare= and files=."""

    def color(self, value, **options):
        picture = verisim.render(FLAT + "plane { z, 1 pigment { rgb %s } %s }" % (value, GLOW), 4, 4, **options)
        return [round(float(v), 5) for v in picture.radiance[1, 1]]

    def test_values(self):
        given = dict(
            F=0.25, I=1, B=True, V=(0.1, 0.2, 0.3), N=np.array([0.3, 0.2, 0.1]), S="abc", L=[0.5, 0.75], M=[[1, 2], [0.125, 4]],
            A=np.array([[0.5, 0.25, 0], [0, 0.5, 0.75]]), Z=np.float32(0.5), T=[(0.5, 0, 0), (0, 0.5, 0)],
        )  # fmt: skip
        for text, expected in [("F", [0.25] * 3), ("I", [1] * 3), ("B", [1] * 3), ("V", [0.1, 0.2, 0.3]), ("N", [0.3, 0.2, 0.1]),
                               ("strlen(S)/6", [0.5] * 3), ("L[1]", [0.75] * 3), ("M[1][0]", [0.125] * 3), ("A[1]", [0, 0.5, 0.75]),
                               ("Z", [0.5] * 3), ("T[1]", [0, 0.5, 0]), ("dimension_size(A, 1)/4", [0.5] * 3)]:  # fmt: skip
            self.assertEqual(self.color(text, declare=given), expected, text)

    def test_wrong_values(self):
        for value, message in [({}, "declare.'X'.*expected"), ((1,), "2 to 5"), ([[1], [1, 2]], "different lengths"), ([1, [2]], "not both"),
                               (np.zeros((2, 2, 2)), "arrays of vectors"), (("a", "b"), "tuple of numbers")]:  # fmt: skip
            with self.subTest(value), self.assertRaisesRegex(TypeError, message):
                verisim.render(BALL, 4, 4, declare={"X": value})
        with self.assertRaises(verisim.SceneError):
            verisim.render(BALL, 4, 4, declare={"sphere": 1})

    def test_files_of_bytes(self):
        picture = verisim.render(FLAT + '#include "a.inc" plane { z, 1 pigment { Paint } %s }' % GLOW, 4, 4,
                                 files={"a.inc": "#declare Paint = pigment { rgb 0.5 };"})  # fmt: skip
        self.assertEqual(picture.radiance[0, 0, 0], 0.5)
        png = verisim.Picture(np.full((2, 2, 3), [255, 0, 0], np.uint8)).png()
        picture = verisim.render(FLAT + 'plane { z, 1 pigment { image_map { png "a.png" } } %s }' % GLOW, 4, 4, files={"a.png": png})
        np.testing.assert_array_equal(picture.pixels[2, 2], [255, 0, 0])

    def test_image_map(self):
        scene = FLAT + 'plane { z, 1 pigment { image_map { "a" } translate <-0.5, -0.5> scale 2 } %s }' % GLOW
        image = np.array([[[255, 0, 0], [0, 255, 0]], [[0, 0, 255], [255, 255, 255]]], np.uint8)
        for values in (image, image.astype(np.uint16) * 257, image / 255, (image / 255).astype(np.float32), image[:, ::-1][:, ::-1],
                       np.concatenate([image, np.full((2, 2, 1), 255, np.uint8)], 2), verisim.Picture(image)):  # fmt: skip
            picture = verisim.render(scene, 2, 2, files={"a": values})
            np.testing.assert_array_equal(picture.pixels, image)
        with self.assertRaisesRegex(TypeError, "not int64"):
            verisim.render(scene, 2, 2, files={"a": np.zeros((2, 2), np.int64)})
        with self.assertRaisesRegex(ValueError, "1 to 4"):
            verisim.render(scene, 2, 2, files={"a": np.zeros((2, 2, 5), np.uint8)})
        with self.assertRaisesRegex(TypeError, "expected"):
            verisim.render(scene, 2, 2, files={"a": 5})

    def test_height_field(self):
        heights = np.linspace(0, 65535, 16 * 16).reshape(16, 16).astype(np.uint16)
        scene = """#version 3.7; global_settings { assumed_gamma 1 } camera { orthographic location 3*y direction -y right x up z }
                   height_field { "h" translate <-0.5, 0, -0.5> pigment { rgb 1 } }"""
        depth = verisim.render(scene, 16, 16, files={"h": heights}, layers="depth").depth
        # The first row lies at the far side and the columns run along x; the camera looks from a height of 3.
        inside = 3 - depth[1:-1, 1:-1]
        self.assertGreater(float(np.diff(inside, axis=0).min()), 0)
        self.assertLess(abs(float(inside.mean()) - 0.5), 0.05)

    def test_density_file(self):
        voxels = np.zeros((4, 4, 4), np.uint8)
        voxels[:, :, 2:] = 200  # x beyond a half
        scene = FLAT + 'plane { z, 0.5 pigment { density_file df3 "d.df3" color_map { [0 rgb 0] [1 rgb 1] } translate <-0.5, -0.5, -0.5> scale 2 } %s }' % GLOW
        for values in (voxels, voxels.astype(np.uint16) * 257, voxels / 255):
            picture = verisim.render(scene, 4, 4, files={"d.df3": values})
            np.testing.assert_allclose(picture.radiance[1, :, 0], [0, 0, 200 / 255, 200 / 255], atol=1e-5)
        with self.assertRaisesRegex(ValueError, r"\(z, y, x\)"):
            verisim.render(scene, 4, 4, files={"d.df3": np.zeros((4, 4), np.uint8)})

    def test_mesh(self):
        vertices = np.array([[-1, -1, 3], [1, -1, 3], [1, 1, 3], [-1, 1, 3]], float)
        faces = np.array([[0, 1, 2], [0, 2, 3]])
        text = BALL.split("sphere")[0] + "%s"
        wanted = verisim.render(text % "mesh2 { vertex_vectors { 4, <-1,-1,3>, <1,-1,3>, <1,1,3>, <-1,1,3> } face_indices { 2, <0,1,2>, <0,2,3> } pigment { rgb 1 } }", 40, 30)
        for v, f in [(vertices, faces), (vertices.astype(np.float32), faces.astype(np.uint8)), (vertices.tolist(), faces.tolist())]:
            mesh = verisim.Mesh(v, f)
            self.assertEqual((mesh.vertices, mesh.faces), (4, 2))
            picture = verisim.render(text % "object { M pigment { rgb 1 } }", 40, 30, declare={"M": mesh})
            self.assertEqual(picture.pixels.tobytes(), wanted.pixels.tobytes())
        smooth = verisim.Mesh(vertices, faces, normals=vertices, uvs=vertices[:, :2], inside=(0, 0, 1))
        verisim.render(text % "object { M texture { uv_mapping pigment { checker rgb 1 rgb 0 } } }", 8, 8, declare={"M": smooth})
        for wrong, message in [((vertices[:, :2], faces), r"vertices have the shape \(n, 3\)"), ((vertices, faces + 9), "face 0 uses vertex 9"),
                               ((vertices, np.zeros((0, 3))), "must be vertices and faces")]:  # fmt: skip
            with self.assertRaisesRegex(ValueError, message):
                verisim.Mesh(*wrong)

    def test_a_million_triangles(self):
        """They reach the tracer in less than half a second, of all threads together."""
        n = 708
        u, v = np.meshgrid(np.linspace(-1, 1, n), np.linspace(-1, 1, n))
        vertices = np.stack([u, v, 0.2 * np.sin(5 * u)], -1).reshape(-1, 3)
        i = np.arange(n * n).reshape(n, n)
        a, b, c, d = i[:-1, :-1].ravel(), i[1:, :-1].ravel(), i[1:, 1:].ravel(), i[:-1, 1:].ravel()
        faces = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
        times = []
        for _ in range(2):
            start = time.process_time()
            mesh = verisim.Mesh(vertices, faces)
            self.assertEqual(verisim.check(BALL + "object { M }", declare={"M": mesh}).objects, 4)
            times.append(time.process_time() - start)
        self.assertLess(min(times), 0.5)

    def test_include_path_and_folder(self):
        os.makedirs("lib"), os.makedirs("scene")
        pathlib.Path("lib/a.inc").write_text("#declare A = 0.5;")
        pathlib.Path("scene/b.inc").write_text("#declare B = 0.25;")
        text = FLAT + '#include "a.inc" #include "b.inc" plane { z, 1 pigment { rgb <A, B, 0> } %s }' % GLOW
        pathlib.Path("scene/s.pov").write_text(text)
        for scene, name in [("scene/s.pov", None), (text, "scene/unsaved.pov")]:
            picture = verisim.render(scene, 4, 4, include_path=["lib"], name=name)
            np.testing.assert_array_equal(picture.radiance[0, 0], np.float32([0.5, 0.25, 0]))

    def test_messages(self):
        picture = verisim.render(BALL + '#debug "hello\\n" #warning "careful\\n"', 4, 4)
        self.assertIn("hello", picture.debug)
        self.assertEqual([w.code for w in picture.warnings], ["user-warning"])
        self.assertEqual(picture.warnings[0].line, 7)

    def test_wrong_options(self):
        for options, error, message in [(dict(width=0), ValueError, "width"), (dict(width=1 << 20, height=1 << 20), ValueError, "height"),
                                        (dict(antialias=0.3, antialias_depth=99), ValueError, "depth"), (dict(sampler="x"), ValueError, "sampler"),
                                        (dict(limits={"x": 1}), ValueError, "max_steps"), (dict(antialias="x"), TypeError, "")]:  # fmt: skip
            with self.assertRaisesRegex(error, message):
                verisim.render(BALL, **options)
        with self.assertRaises(FileNotFoundError):
            verisim.render("nothing.pov")
        with self.assertRaises(IsADirectoryError):
            verisim.render(self.folder)

    def test_limits(self):
        with self.assertRaisesRegex(verisim.SceneError, "max-steps|limit"):
            verisim.render("#while (true) #declare A = 1; #end", limits={"max_steps": 100000})

    def test_writing_is_confined(self):
        with self.assertRaises(verisim.SceneError) as caught:
            verisim.render('#fopen F "/var/tmp/verisim-out" write\nsphere { 0, 1 }')
        self.assertEqual(caught.exception.line, 1)


class Errors(Scratch):
    def test_all_mistakes_with_their_places(self):
        with self.assertRaises(verisim.SceneError) as caught:
            verisim.render("#version 3.7;\nsphere { 0, 1 pigmnt { rgb 1 } }\nbox { 0 1 }\ncone { }", name="wrong.pov")
        error = caught.exception
        self.assertEqual((error.file, error.line, error.column, error.span), ("wrong.pov", 2, 15, (15, 21)))
        self.assertIn("pigment", str(error))
        self.assertIn("^~~~~~", str(error))
        self.assertEqual([d.line for d in error.diagnostics], [2, 4])
        self.assertIn("pigment", error.diagnostics[0].advice)
        self.assertIsInstance(error, verisim.Error)


class Control(Scratch):
    def test_progress(self):
        told, threads = [], set()
        verisim.render(LONG, 60, 45, on_progress=lambda done: (told.append(done), threads.add(threading.get_ident())))
        self.assertEqual(told, sorted(set(told)))
        self.assertEqual(told[-1], 1)
        self.assertEqual(threads, {threading.get_ident()})

    def test_exception_of_progress_ends_the_render(self):
        def fail(done):
            raise RuntimeError("enough")

        start = time.monotonic()
        with self.assertRaisesRegex(RuntimeError, "enough"):
            verisim.render(LONG, 1600, 1200, on_progress=fail)
        self.assertLess(time.monotonic() - start, 60)

    def test_cancel(self):
        event = threading.Event()
        with self.assertRaises(verisim.Cancelled) as caught:
            verisim.render(LONG, 1600, 1200, cancel=event, on_progress=lambda done: event.set())
        self.assertEqual(caught.exception.picture.width, 1600)
        self.assertGreater(int(caught.exception.picture.pixels.max()), 0)
        with self.assertRaises(verisim.Cancelled) as caught:
            verisim.render("#while (true) #declare A = 1; #end", cancel=lambda: True)
        self.assertIsNone(caught.exception.picture)
        with self.assertRaises(verisim.Cancelled):
            verisim.check("#while (true) #declare A = 1; #end", cancel=lambda: True)

    def test_ctrl_c(self):
        code = f"import verisim, time\nscene = {LONG!r}\nprint('ready', flush=True)\ntry:\n  verisim.render(scene, 2000, 2000)\n" \
               "except KeyboardInterrupt:\n  print('interrupted')\n"  # fmt: skip
        process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
        self.assertEqual(process.stdout.readline(), "ready\n")
        time.sleep(0.5)
        start = time.monotonic()
        process.send_signal(signal.SIGINT)
        output, _ = process.communicate(timeout=60)
        self.assertEqual((process.returncode, output), (0, "interrupted\n"))
        self.assertLess(time.monotonic() - start, 60)

    def test_other_threads_run_meanwhile(self):
        counted, stop = [0], threading.Event()

        def count():
            while not stop.is_set():
                counted[0] += 1
                time.sleep(0.001)

        thread = threading.Thread(target=count)
        thread.start()
        verisim.render(LONG, 60, 45, threads=1)
        stop.set()
        thread.join()
        self.assertGreater(counted[0], 10)

    def test_after_fork(self):
        code = f"import os, verisim\nscene = {BALL!r}\nbefore = verisim.render(scene, 100, 80).png()\npid = os.fork()\n" \
               "if pid == 0:\n  os._exit(0 if verisim.render(scene, 100, 80).png() == before else 1)\nprint(os.waitpid(pid, 0)[1])"  # fmt: skip
        self.assertEqual(in_python(code).stdout, "0\n")


if __name__ == "__main__":
    unittest.main()
