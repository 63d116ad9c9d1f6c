"""verisim: POV-Ray's scenes, rendered and checked from Python.

    picture = verisim.render("scene.pov", 640, 480, antialias=0.3)
    picture.save("scene.png")

A scene is the name of a file, its text (a str with a line break, `{`, `;` or `#` in it, or bytes), or something that can
be read. See docs/python.md.
"""

from verisim._animation import animation
from verisim._check import Check, check
from verisim._compare import Comparison, compare
from verisim._core import Mesh, Picture
from verisim._core import version as __version__
from verisim._diff import Difference, diff
from verisim._explain import Explanation, explain
from verisim._render import render
from verisim.errors import Cancelled, Diagnostic, Error, LimitExceeded, OracleMissing, SceneError, Unsupported

__all__ = [
    "Cancelled", "Check", "Comparison", "Diagnostic", "Difference", "Error", "Explanation", "LimitExceeded", "Mesh", "OracleMissing",
    "Picture", "SceneError", "Unsupported", "animation", "check", "compare", "diff", "explain", "render",
]
