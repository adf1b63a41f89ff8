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
    def test_types_and_constants_of_anonymous_namespaces(self):
        self.assertEqual(names_in(SOURCE), {"Corner", "kReach", "kPair"})

    def test_the_same_name_in_two_sources(self):
        other = "namespace {\nenum class Corner { A };\n}  // namespace\n"
        self.assertEqual(clashes_in({"a.cpp": SOURCE, "b.cpp": other}), [("Corner", ["a.cpp", "b.cpp"])])

    def test_different_names(self):
        other = "namespace {\nconstexpr int kOther = 1;\n}  // namespace\n"
        self.assertEqual(clashes_in({"a.cpp": SOURCE, "b.cpp": other}), [])


if __name__ == "__main__":
    unittest.main()
