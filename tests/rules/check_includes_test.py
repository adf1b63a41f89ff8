#!/usr/bin/env python3
"""Shows that check_includes.py finds each kind of breach, and nothing in files that obey."""

import pathlib
import tempfile
import unittest

from check_includes import check_tree


class CheckIncludes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for header in ("renderer/error.h", "renderer/math/vector.h", "renderer/image/film.h",
                       "renderer/scene/scene.h", "renderer/integrators/path.h", "ui/window.h",
                       "tests/statistics/chi_square.h"):
            self.write(header, "#pragma once\n")

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def breach(self, path, text):
        """The only breach that a tree with this file has."""
        self.write(path, text)
        breaches = check_tree(self.root)
        self.assertEqual(len(breaches), 1, breaches)
        return breaches[0]

    def test_downward_includes_are_free(self):
        self.write("app/main.cpp", '#include "ui/window.h"\n#include "renderer/math/vector.h"\n')
        self.write("renderer/math/frame.h", '#pragma once\n#include "renderer/error.h"\n'
                                            '#include "renderer/math/vector.h"\n#include <vector>\n')
        self.write("tests/ui/window_test.cpp", '#include "tests/statistics/chi_square.h"\n')
        self.assertEqual(check_tree(self.root), [])

    def test_upward_include(self):
        found = self.breach("renderer/scene/scene.cpp", '\n#include "renderer/integrators/path.h"\n')
        self.assertIn("renderer/scene/scene.cpp:2:", found)
        self.assertIn("lower floor", found)

    def test_renderer_does_not_know_the_window(self):
        self.assertIn("lower floor", self.breach("renderer/session/x.cpp", '#include "ui/window.h"\n'))

    def test_neighbours_do_not_know_each_other(self):
        self.assertIn("one floor", self.breach("renderer/sampling/x.cpp", '#include "renderer/image/film.h"\n'))

    def test_product_does_not_use_tests(self):
        self.assertIn("only tests", self.breach("ui/x.cpp", '#include "tests/statistics/chi_square.h"\n'))

    def test_libraries_have_one_home(self):
        for header, wrong in (("embree3/rtcore.h", "renderer/scene/shape.cpp"),
                              ("tbb/parallel_for.h", "renderer/integrators/x.cpp"),
                              ("GLFW/glfw3.h", "app/main.cpp"),
                              ("imgui.h", "renderer/session/x.cpp"),
                              ("pugixml.hpp", "renderer/scene/x.cpp"),
                              ("nlohmann/json.hpp", "ui/x.cpp"),
                              ("OpenEXR/ImfRgbaFile.h", "renderer/image/x.cpp"),
                              ("zlib.h", "app/x.cpp"),
                              ("CLI/CLI.hpp", "ui/x.cpp"),
                              ("spdlog/spdlog.h", "renderer/io/x.cpp")):
            with self.subTest(header):
                self.assertIn("only in", self.breach(wrong, f"#include <{header}>\n"))
                (self.root / wrong).unlink()

    def test_library_at_home(self):
        self.write("renderer/scene/accelerator.cpp", "#include <embree3/rtcore.h>\n")
        self.write("tests/renderer/io/x_test.cpp", "#include <zlib.h>\n")
        self.write("ui/window.cpp", "#include <GLFW/glfw3.h>\n#include <imgui.h>\n")
        self.assertEqual(check_tree(self.root), [])

    def test_relative_include(self):
        self.assertIn("from the root", self.breach("renderer/scene/x.cpp", '#include "scene.h"\n'))

    def test_header_without_guard(self):
        self.assertIn("#pragma once", self.breach("renderer/math/x.h", "struct X;\n"))

    def test_library_is_silent(self):
        self.assertIn("neither prints", self.breach("renderer/io/x.cpp", 'void f() { std::cerr << 1; }\n'))

    def test_comments_may_speak(self):
        self.write("renderer/io/x.cpp", "// never calls exit() or abort()\nvoid atexit_is_not_exit();\n")
        self.assertEqual(check_tree(self.root), [])


if __name__ == "__main__":
    unittest.main()
