"""What the tests have in common."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

try:
    import numpy  # noqa: F401
except ImportError:
    print("numpy is not installed")
    sys.exit(77)

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("VERISIM_PROGRAM", "verisim")

BALL = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -4*z look_at 0 angle 40 }
light_source { <3, 5, -6> rgb 1 }
sphere { 0, 1 pigment { rgb <1, 0.5, 0.2> } finish { phong 0.5 } }
plane { y, -1 pigment { checker rgb 0.9 rgb 0.2 } }
"""
LONG = BALL + "global_settings { max_trace_level 20 } " + "".join(
    f"sphere {{ <{i % 7 - 3}, {i // 7 % 5 - 2}, {i // 35}>, 0.6 pigment {{ rgbt 0.6 }} finish {{ reflection 0.6 }} interior {{ ior 1.3 }} }}\n" for i in range(70)
)  # minutes at a large size


class Scratch(unittest.TestCase):
    """A test in an empty folder of its own."""

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="verisim-python-test-")
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(shutil.rmtree, self.folder)
        self.addCleanup(os.chdir, before)


def program(*arguments, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, check=True, **options)


def in_python(code, *, timeout=60, **options):
    """Runs code in a Python of its own."""
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=timeout, **options)
