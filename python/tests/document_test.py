"""All code of docs/python.md, from top to bottom: ```python is run, ```pycon must say what it says there."""

import doctest
import re
import shutil
import unittest

from support import SOURCE, Scratch

import verisim

DOCUMENT = SOURCE / "docs/python.md"


class Document(Scratch):
    def test_all_code(self):
        text = DOCUMENT.read_text()
        blocks = [(m[1], m[2], text[: m.start(2)].count("\n")) for m in re.finditer(r"^```(python|pycon)\n(.*?)^```$", text, re.M | re.S)]
        self.assertGreater(len(blocks), 10)
        names = {"__name__": "document"}
        for language, code, line in blocks:
            if "verisim.compare(" in code and not shutil.which("povray"):
                continue
            if language == "python":
                exec(compile("\n" * line + code, str(DOCUMENT), "exec"), names)
            else:
                test = doctest.DocTestParser().get_doctest(code, names, DOCUMENT.name, str(DOCUMENT), line)
                out = []
                result = doctest.DocTestRunner().run(test, out=out.append, clear_globs=False)
                names.update(test.globs)
                self.assertEqual(result.failed, 0, "".join(out))


if __name__ == "__main__":
    unittest.main()
