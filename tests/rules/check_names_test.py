#!/usr/bin/env python3
"""Tests of check_names.py."""

import unittest

from check_names import clashes_in, names_in

SOURCE = """
namespace guidelight {
namespace {

struct Corner {
  constexpr int kInside = 1;
};
constexpr float kReach = 2;
constexpr std::array<int, 2> kPair{1, 2};
class Declared;
void f() { struct Local {}; }

}  // namespace

struct Public {};
}  // namespace guidelight
"""


class CheckNames(unittest.TestCase):
    def test_names_of_anonymous_namespaces(self):
        self.assertEqual(names_in(SOURCE), {"Corner", "kReach", "kPair", "f()"})

    def test_the_same_name_in_two_sources(self):
        other = "namespace {\nenum class Corner { A };\n}  // namespace\n"
        self.assertEqual(clashes_in({"a.cpp": SOURCE, "b.cpp": other}), [("Corner", ["a.cpp", "b.cpp"])])

    def test_functions_of_the_same_parameters(self):
        one = "namespace {\nint side(int a, const Box& box = {}) {\n}\n}  // namespace\n"
        same = "namespace {\nint side(int b, const Box& c) {\n}\n}  // namespace\n"
        overload = "namespace {\nint side(float a) {\n}\n}  // namespace\n"
        self.assertEqual(clashes_in({"a.cpp": one, "b.cpp": same, "c.cpp": overload}),
                         [("side(int, const Box&)", ["a.cpp", "b.cpp"])])

    def test_different_names(self):
        other = "namespace {\nconstexpr int kOther = 1;\n}  // namespace\n"
        self.assertEqual(clashes_in({"a.cpp": SOURCE, "b.cpp": other}), [])


if __name__ == "__main__":
    unittest.main()
