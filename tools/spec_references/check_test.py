#!/usr/bin/env python3
"""The check of references finds what leads nowhere, and nothing else."""
import pathlib
import tempfile
import unittest

import check

DOCUMENT = """# 03 Shapes
## <a id="s4"></a>4 All of them
### <a id="s4.2"></a>4.2 cone
1. first
2. second
```
## 9 not a heading
```
"""


class References(unittest.TestCase):
    def faults(self, code, document=DOCUMENT):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "docs/spec").mkdir(parents=True)
            (root / "docs/spec/03-shapes.md").write_text(document)
            (root / "docs/spec/08-wild.md").write_text('## <a id="sA"></a>A Coincident\n- **G** substr\n')
            (root / "tracer").mkdir()
            (root / "tracer/cone.h").write_text(code)
            return check.check(root)

    def test_sections_lists_and_letters_are_found(self):
        self.assertEqual(self.faults("// Cones (spec 03 4.2, 4; 08 A and G; spec 03 section 4.2.2).\n"), [])

    def test_a_section_that_is_not_there(self):
        self.assertEqual(self.faults("\n// (spec 03 4.2, 4.3)\n"),
                         ["tracer/cone.h:2: there is no section 4.3 in specification 03"])

    def test_headings_in_code_do_not_count(self):
        self.assertEqual(len(self.faults("// spec 03 section 9\n")), 1)

    def test_a_reference_goes_on_in_the_next_line_of_a_comment(self):
        self.assertEqual(len(self.faults("// as POV-Ray does (spec 03\n  // 4.7)\n")), 1)

    def test_a_document_that_is_not_there(self):
        self.assertEqual(self.faults("// spec 04\n"), ["tracer/cone.h:1: there is no specification 04"])

    def test_words_after_a_reference_are_no_sections(self):
        self.assertEqual(self.faults("// spec 03. A ray may pass\n// spec 03 4.2: 17 cases\n"), [])

    def test_a_heading_without_anchor(self):
        self.assertEqual(self.faults("", "## 4 All\n"), ["docs/spec/03-shapes.md:1: section 4 lacks its anchor s4"])


if __name__ == "__main__":
    unittest.main()
