#!/usr/bin/env python3
"""Shows that check_text.py finds bare markers and accepts those with a reason."""

import unittest

from check_text import breaches_in


class CheckText(unittest.TestCase):
    def test_bare_markers(self):
        self.assertEqual(breaches_in("int x;\n// TODO\n// FIXME later\n// TODO: soon\n"), [2, 3, 4])

    def test_markers_with_reason(self):
        self.assertEqual(breaches_in("// TODO: needs Embree 4, which Debian 12 does not have\n"), [])

    def test_other_words(self):
        self.assertEqual(breaches_in("TODOS xxx hacked\n"), [])


if __name__ == "__main__":
    unittest.main()
