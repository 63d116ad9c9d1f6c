"""check() and explain(): a scene and a pixel as objects."""

import unittest
import xml.etree.ElementTree

from support import BALL, Scratch

import numpy as np

import verisim


class Check(Scratch):
    def test_wrong_scene(self):
        with self.assertRaises(verisim.SceneError) as caught:
            verisim.check("sphere { 0, 1 }\nbx { 0, 1 }\n")
        self.assertEqual((caught.exception.line, caught.exception.column), (2, 1))
        self.assertEqual(str(caught.exception.diagnostics[0]).splitlines()[1], "     2 | bx { 0, 1 }")

    def test_tree_warnings_and_picture(self):
        checked = verisim.check(BALL, 30, 20)
        self.assertEqual([o["type"] for o in checked.tree["objects"]], ["light_source", "sphere", "plane"])
        self.assertEqual(checked.warnings, [])
        self.assertEqual(checked.picture.png(), verisim.render(BALL, 30, 20).png())
        self.assertIs(checked.picture, checked.picture)
        self.assertIn("sphere", checked._repr_html_())

        dark = verisim.check("#version 3.7; global_settings { assumed_gamma 1 } camera { location -3*z } sphere { 0, 1 pigment { rgb 1 } }")
        self.assertEqual([w.code for w in dark.warnings], ["no-light"])

    def test_bytes_that_are_no_text(self):
        with self.assertRaises(verisim.SceneError) as caught:
            verisim.check(b"sphere { 0, 1 }\n\xff\xfe { }")
        self.assertEqual(caught.exception.line, 2)


class Explain(Scratch):
    def test_tree(self):
        told = verisim.explain(BALL, 30, 20, 61, 41)
        (ray,) = told.tree
        self.assertEqual((ray.kind, ray.origin), ("camera", (0, 0, -4)))
        self.assertAlmostEqual(ray.distance, 3, places=6)
        (layer,) = ray.layers
        self.assertTrue(layer.object.startswith("sphere"))
        self.assertEqual(layer.lights[0].state, "lit")
        np.testing.assert_allclose(sum(np.array(term.adds) for term in ray.sum), told.color, atol=1e-5)
        self.assertEqual(told.stored, tuple(verisim.render(BALL, 61, 41).pixels[20, 30]))
        self.assertIn("hits sphere", str(told))

    def test_secondary_rays(self):
        mirror = BALL.replace("phong 0.5", "reflection 0.5")
        rays = list(verisim.explain(mirror, 30, 25, 61, 41).tree[0].walk())
        self.assertEqual([r.kind for r in rays], ["camera", "reflected"])
        self.assertEqual(rays[1].weight, 0.5)

    def test_picture_and_drawing(self):
        told = verisim.explain(BALL, 30, 20, 61, 41)
        plain = verisim.render(BALL, 61, 41).pixels
        changed = np.argwhere((told.picture.pixels != plain).any(-1))
        self.assertTrue(len(changed) > 50 and all(y == 20 or x == 30 for y, x in changed))
        np.testing.assert_array_equal(told.picture.pixels[20, 30], plain[20, 30])
        drawing = xml.etree.ElementTree.fromstring(told.drawing(azimuth=90, elevation=10))
        self.assertTrue(drawing.tag.endswith("svg"))
        self.assertNotEqual(told.drawing(0, 0), told.drawing(90, 0))
        self.assertIn("<svg", told._repr_html_())

    def test_outside(self):
        for x, y in [(-1, 0), (61, 0), (0, 41)]:
            with self.assertRaisesRegex(ValueError, "no pixel"):
                verisim.explain(BALL, x, y, 61, 41)


if __name__ == "__main__":
    unittest.main()
