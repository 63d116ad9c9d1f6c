"""What the check of the layers must find, in a small house of its own."""
import pathlib
import tempfile
import unittest

from check import check

ORDER = "# ground up\ntracer/math  vectors\ntracer/shapes  shapes\ncli  the program\n"


class Layers(unittest.TestCase):
    def faults(self, files):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in {"tools/layers/order.txt": ORDER, **files}.items():
                path = root / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            return check(root)

    def test_downward_includes_pass(self):
        self.assertEqual(
            self.faults(
                {
                    "tracer/math/vec.h": "",
                    "tracer/shapes/sphere.cpp": '#include "tracer/math/vec.h"\n#include <vector>\n',
                }
            ),
            [],
        )

    def test_an_upward_include_is_named_with_its_line(self):
        faults = self.faults(
            {"tracer/math/vec.cpp": '\n#include "tracer/shapes/shape.h"\n', "tracer/shapes/shape.h": ""}
        )
        self.assertEqual(len(faults), 1)
        self.assertTrue(faults[0].startswith("tracer/math/vec.cpp:2: "), faults[0])

    def test_kernels_count_as_includes(self):
        self.assertTrue(
            self.faults(
                {"tracer/math/k.cpp": '#define VERISIM_KERNELS "tracer/shapes/k.inc"\n', "tracer/shapes/k.inc": ""}
            )
        )

    def test_tests_may_include_anything(self):
        self.assertEqual(
            self.faults(
                {"tracer/math/vec_test.cpp": '#include "tracer/shapes/shape.h"\n', "tracer/shapes/shape.h": ""}
            ),
            [],
        )

    def test_a_file_that_is_not_there_is_a_fault(self):
        self.assertTrue(self.faults({"cli/main.cpp": '#include "tracer/math/gone.h"\n'}))

    def test_a_folder_without_a_layer_is_a_fault(self):
        self.assertTrue(self.faults({"tracer/misc/helpers.h": ""}))

    def test_a_folder_that_outgrows_itself_is_a_fault(self):
        self.assertTrue(self.faults({f"tracer/math/f{k}.h": "" for k in range(40)}))


if __name__ == "__main__":
    unittest.main()
