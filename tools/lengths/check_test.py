"""What the check of lengths must find and what it must let pass."""
import unittest

from check import functions, too_long


def body(lines):
    return "{\n" + "  step();\n" * (lines - 2) + "}\n"


class Lengths(unittest.TestCase):
    def found(self, text, name="a.cpp"):
        return list(too_long(name, text))

    def test_a_wide_line_is_named_wherever_it_stands(self):
        self.assertEqual(self.found("int a;\n" + "x" * 121 + "\n"), ["a.cpp:2: 121 columns"])
        self.assertEqual(len(self.found('auto s = R"(' + "x" * 121 + ')";\n')), 1)
        self.assertEqual(self.found("x" * 120 + "\n"), [])

    def test_a_function_of_81_lines_is_too_long(self):
        self.assertEqual(self.found("int f(int a) " + body(80)), [])
        self.assertEqual(len(self.found("int f(int a) " + body(81))), 1)
        self.assertEqual(self.found("TEST(A, B) " + body(81), "a_test.cpp"), [])

    def test_bodies_are_found_in_namespaces_and_classes(self):
        heads = [
            "bool A::b() const noexcept ",
            "template <class T = int> auto f(T t) -> decltype(t) ",
            "A::A(int a) : b_{a}, c_(a) ",
            "bool operator==(const A& a) ",
            'extern "C" int f() ',
        ]
        for head in heads:
            for around in ("%s", "namespace a {\n%s}\n", "class A final : public B {\n public:\n%s};\n"):
                with self.subTest(head=head, around=around):
                    self.assertEqual([lines for _, lines, _ in functions(around % (head + body(90)))], [90])

    def test_tables_and_types_are_no_functions(self):
        for head in ("struct A ", "const int a[] = ", "std::vector<int> a", "enum class A : int ", "auto a = f() + B"):
            with self.subTest(head=head):
                self.assertEqual(list(functions(head + "{\n" + "1,\n" * 90 + "};\n")), [])

    def test_braces_in_text_do_not_count(self):
        text = 'void f() {\n  g("{", \'{\', R"(}})");  // {\n#if A\n  if (a) {\n#else\n  if (b) {\n#endif\n  }\n}\n'
        self.assertEqual([(line, lines) for line, lines, _ in functions(text)], [(1, 9)])


if __name__ == "__main__":
    unittest.main()
