"""The package itself: quick to import, its stub complete."""

import ast
import inspect
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from support import in_python

import verisim
from verisim import _core

FOLDER = pathlib.Path(verisim.__file__).parent


class Package(unittest.TestCase):
    def test_import_is_quick_and_without_numpy(self):
        code = "import sys, time; start = time.process_time(); import verisim; print(time.process_time() - start, 'numpy' in sys.modules)"
        runs = [in_python(code).stdout.split() for _ in range(5)]
        self.assertEqual({run[1] for run in runs}, {"False"})
        self.assertLess(min(float(run[0]) for run in runs), 0.05)

    def test_stub_and_module_have_the_same_names(self):
        def public(names):
            return {n for n in names if not n.startswith("_") or n in ("__array_interface__", "_repr_png_")}

        stub = {n.name if hasattr(n, "name") else n.target.id: n for n in ast.parse((FOLDER / "_core.pyi").read_text()).body
                if isinstance(n, (ast.ClassDef, ast.FunctionDef, ast.AnnAssign))}  # fmt: skip
        self.assertEqual(set(stub), public(vars(_core)))
        for name, node in stub.items():
            if isinstance(node, ast.ClassDef):
                members = {m.name if hasattr(m, "name") else m.target.id for m in node.body if isinstance(m, (ast.FunctionDef, ast.AnnAssign))}
                self.assertEqual(public(members), public(vars(getattr(_core, name))), name)
        self.assertTrue((FOLDER / "py.typed").exists())

    def test_options_are_those_of_render(self):
        """Options, the type, and what the other functions take."""
        source = ast.parse((FOLDER / "_job.py").read_text())
        types = [n for n in ast.walk(source) if isinstance(n, ast.ClassDef) and n.name in ("FrameOptions", "Options")]
        declared = {n.target.id for options in types for n in options.body if isinstance(n, ast.AnnAssign)}
        own = {"scene", "width", "height", "layers", "on_progress", "cancel"}
        self.assertEqual(declared, set(inspect.signature(verisim.render).parameters) - own)
        self.assertEqual(declared, set(inspect.signature(verisim._job.job).parameters) - own)
        with self.assertRaisesRegex(TypeError, "nonsense"):
            verisim.check("sphere { 0, 1 }", nonsense=1)

    def test_all_names_are_there_and_documented(self):
        for name in verisim.__all__:
            self.assertTrue(inspect.getdoc(getattr(verisim, name)), name)

    @unittest.skipUnless("VERISIM_BUILD" in os.environ, "run by ctest only")
    def test_installed(self):
        """The installed package works alone, wherever it is, with the image plug-ins beside it."""
        with tempfile.TemporaryDirectory() as folder:
            install = ["cmake", "--install", os.environ["VERISIM_BUILD"], "--prefix", folder, "--component"]
            for component in ("python", "runtime"):
                subprocess.run([*install, component], check=True, capture_output=True)
            module = next(pathlib.Path(folder).glob("**/verisim/__init__.py")).parent.parent
            code = f"import verisim; assert verisim.__file__.startswith({folder!r}); verisim.render('sphere {{ 5*z, 1 }}', 8, 6).save('a.jpg')"
            result = in_python(code, cwd=folder, env={"PYTHONPATH": str(module), "PATH": os.environ["PATH"]})
            self.assertEqual(result.stderr, "")
            self.assertTrue(os.path.exists(f"{folder}/a.jpg"))

    @unittest.skipUnless(shutil.which("mypy"), "mypy is not installed")
    def test_types(self):
        result = subprocess.run(["mypy", "--strict", "--enable-incomplete-feature=Unpack", "--cache-dir=/dev/null", "--python-version", "3.11", str(FOLDER)], capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stdout)


if __name__ == "__main__":
    unittest.main()
