"""diff(), compare() and animation()."""

import pathlib
import shutil
import unittest

from support import BALL, Scratch, program

import numpy as np

import verisim


class Diff(Scratch):
    def test_kinds_of_pictures(self):
        picture = verisim.render(BALL, 40, 30)
        picture.save("a.png")
        for other in (picture, "a.png", pathlib.Path("a.png"), picture.pixels, picture.pixels.astype(np.uint16) * 257):
            difference = verisim.diff(picture, other)
            self.assertEqual((difference.status, round(difference.rmse, 4)), ("exact", 0))
            self.assertTrue(difference)

    def test_figures(self):
        a = np.full((20, 20, 3), 100, np.uint8)
        b = a.copy()
        b[5, 5:9] = 110
        difference = verisim.diff(a, b)
        self.assertEqual((difference.status, difference.max_abs), ("differ", 10))
        self.assertAlmostEqual(difference.rmse, 1)
        self.assertEqual(difference.within_1_pct, 99)
        self.assertFalse(difference)
        self.assertEqual(difference.heat_map.width, 20)
        self.assertGreater(int(difference.heat_map.pixels[5, 5].max()), int(difference.heat_map.pixels[10, 10].max()))
        self.assertEqual(verisim.diff(a, b, thresholds={"max_rmse": 1.1}).status, "match")
        self.assertIn("rmse", difference._repr_html_())

    def test_errors(self):
        picture = verisim.render(BALL, 8, 6)
        with self.assertRaisesRegex(ValueError, "8"):
            verisim.diff(picture, verisim.render(BALL, 6, 8))
        with self.assertRaisesRegex(ValueError, "max_nonsense"):
            verisim.diff(picture, picture, thresholds={"max_nonsense": 1})
        with self.assertRaises((OSError, RuntimeError)):
            verisim.diff(picture, "nothing.png")
        with self.assertRaisesRegex(TypeError, "uint8"):
            verisim.diff(picture, np.zeros((6, 8, 3), np.int32))


@unittest.skipUnless(shutil.which("povray"), "povray is not installed")
class Compare(Scratch):
    def test_exact(self):
        pathlib.Path("paint.inc").write_text("#declare Paint = rgb <0.2, 0.5, 1>;")
        text = '#include "paint.inc"\n' + BALL.replace("rgb <1, 0.5, 0.2>", "rgb Paint*Half")
        for scene, files in [(text, {"paint.inc": pathlib.Path("paint.inc").read_bytes()}), (text, {})]:
            same = verisim.compare(scene, 32, 24, declare={"Half": 0.5}, files=files, antialias=0.3, use_cache=False)
            self.assertEqual(same.status, "exact", same.reason)
            self.assertEqual((same.reference.width, same.picture.width, same.heat_map.width), (32, 32, 32))
            self.assertIn("<html", same.html)

    def test_refused(self):
        with self.assertRaises(verisim.SceneError):
            verisim.compare("spher { 0, 1 }")
        with self.assertRaisesRegex(ValueError, "numbers and strings"):
            verisim.compare(BALL, declare={"A": (1, 2)})
        with self.assertRaisesRegex(ValueError, "bytes or str"):
            verisim.compare(BALL, files={"a": np.zeros((2, 2))})


class Animation(Scratch):
    SCENE = BALL.replace("sphere { 0, 1", "sphere { clock*x + frame_number*0.1*y, 1")

    def test_frames_are_the_programs(self):
        pathlib.Path("a.pov").write_text(self.SCENE)
        program("render", "a.pov", "+W24", "+H18", "+KFF3", "+KI-1", "+KF1")
        frames = list(verisim.animation("a.pov", 24, 18, frames=3, clock=(-1, 1)))
        self.assertEqual([(f.frame, f.clock) for f in frames], [(1, -1), (2, 0), (3, 1)])
        for frame in frames:
            self.assertEqual(verisim.diff(f"a{frame.frame}.png", frame).max_abs, 0)

    def test_cyclic(self):
        clocks = [f.clock for f in verisim.animation(self.SCENE, 4, 3, frames=4, cyclic=True)]
        self.assertEqual(clocks, [0, 0.25, 0.5, 0.75])

    def test_is_an_iterator(self):
        frames = verisim.animation(self.SCENE, 4, 3, frames=1 << 30)
        self.assertEqual([next(frames).frame, next(frames).frame], [1, 2])
        with self.assertRaises(ValueError):
            verisim.animation(self.SCENE, frames=0)


if __name__ == "__main__":
    unittest.main()
