"""The cells of docs/notebooks, run from top to bottom as a notebook would: what the last line of a cell gives must show itself."""

import ast
import contextlib
import io
import json
import os
import unittest

from support import SOURCE

FOLDER = SOURCE / "docs/notebooks"


def run_cell(code, name, names):
    """What the cell prints, and the value of its last line; None if that is a statement."""
    tree = ast.parse(code, name)
    last = ast.Expression(tree.body.pop().value) if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, name, "exec"), names)
        value = eval(compile(last, name, "eval"), names) if last else None
    return printed.getvalue(), value


class Notebooks(unittest.TestCase):
    def test_all_cells(self):
        os.chdir(FOLDER)
        for path in sorted(FOLDER.glob("*.ipynb")):
            notebook = json.loads(path.read_text())
            self.assertEqual(notebook["nbformat"], 4)
            names, pictures = {}, 0
            for number, cell in enumerate(notebook["cells"], 1):
                if cell["cell_type"] != "code":
                    continue
                printed, value = run_cell("".join(cell["source"]), f"{path.name}, cell {number}", names)
                if os.environ.get("VERBOSE"):
                    print(number, printed, value)
                if hasattr(value, "_repr_png_"):
                    self.assertEqual(value._repr_png_()[:8], b"\x89PNG\r\n\x1a\n")
                    pictures += 1
                elif hasattr(value, "_repr_html_"):
                    self.assertIn("<", value._repr_html_())
            self.assertGreater(pictures, 5, path)


if __name__ == "__main__":
    unittest.main()
