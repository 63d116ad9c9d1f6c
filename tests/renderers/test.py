"""Another renderer on both sides (docs/any-renderer.md): test.py VERISIM. Exit status 77: no Blender with Cycles."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

VERISIM = os.path.abspath(sys.argv[1]) if len(sys.argv) > 1 else "verisim"
SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "box.py")
CYCLES = "blender -b --factory-startup -noaudio -P {scene} -- {out} {width} {height} {seed}"


def compare(*options):
    with tempfile.TemporaryDirectory() as folder:
        scene = shutil.copy(SCENE, folder)
        words = [VERISIM, "compare", scene, "+W64", "+H48", "--class", "stochastic", "--runs", "2", *options]
        return subprocess.run(words, capture_output=True, text=True)


class Cycles(unittest.TestCase):
    def test_itself_is_within_its_noise(self):
        run = compare("--reference", CYCLES, "--test", CYCLES)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def test_missing_bounces_are_found(self):
        run = compare("--reference", CYCLES, "--test", CYCLES + " 0")
        self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
        self.assertIn("blurred", run.stdout + run.stderr)


def cycles():
    """Debian's Blender has Cycles; others may not."""
    if not shutil.which("blender"):
        return False
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out.png")
        subprocess.run(["blender", "-b", "--factory-startup", "-noaudio", "-P", SCENE, "--", out, "8", "6", "1"], capture_output=True)
        return os.path.exists(out)


if __name__ == "__main__":
    if not cycles():
        sys.exit(77)
    unittest.main(argv=[sys.argv[0]] + sys.argv[2:])
