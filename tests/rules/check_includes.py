#!/usr/bin/env python3
"""Checks who includes what: docs/architecture.md, "The floors".

    check_includes.py ROOT      prints one line per breach and exits with 1 if there is any
"""

import pathlib
import re
import sys

# From the ground up; folders on one line do not know each other.
FLOORS = [
    ["renderer/math"],
    ["renderer/sampling", "renderer/image", "renderer/parallel"],
    ["renderer/scene"],
    ["renderer/transport"],
    ["renderer/photons", "renderer/metropolis", "renderer/io"],
    ["renderer/integrators"],
    ["renderer/session"],
    ["ui"],
    ["app"],
]
FLOOR_OF = {folder: number for number, folders in enumerate(FLOORS) for folder in folders}

# Included by every floor.
COMMON = {"renderer/error.h"}

# Libraries with one home: name, headers, where they may be included. Tests go with their subject.
HOMES = [
    ("Embree", r"embree\d?/", r"renderer/scene/accelerator\.(h|cpp)$"),
    ("oneTBB", r"(oneapi/)?tbb/", r"renderer/parallel/"),
    ("OpenGL", r"(epoxy|GL|GLES\d?)/", r"ui/"),
    ("GLFW", r"GLFW/", r"ui/"),
    ("Dear ImGui", r"(imgui/)?imgui(_\w+)?\.h", r"ui/"),
    ("pugixml", r"pugi(xml|config)\.hpp", r"renderer/io/"),
    ("nlohmann-json", r"nlohmann/", r"renderer/io/"),
    ("stb", r"(stb/)?stb_\w+\.h", r"renderer/io/"),
    ("OpenEXR", r"(OpenEXR/|Imath/|Imf|Imath)", r"renderer/io/"),
    ("zlib", r"zlib\.h", r"renderer/io/"),
    ("CLI11", r"CLI/", r"app/"),
    ("spdlog", r"spdlog/", r"(app|ui)/"),
]

# The library reports by exceptions only.
SPEAKING = re.compile(r"\b(std::(cout|cerr|clog|exit|abort|terminate)|fmt::print|(f|std::f?)?printf|"
                      r"puts|_?exit|abort)\s*(\(|<<)")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def folder_of(path):
    """The floor's folder that a file belongs to, or None for tests, bench and tools."""
    parts = path.split("/")
    for length in (2, 1):
        folder = "/".join(parts[:length])
        if len(parts) > length and folder in FLOOR_OF:
            return folder
    return None


def check_floor(path, included):
    """Why `path` may not include our own header `included`, or None."""
    user, used = folder_of(path), folder_of(included)
    if included in COMMON or user is None or user == used:
        return None
    if used is None:
        return f"{user} stands below {included.split('/')[0]}/, which only tests and tools may use"
    if FLOOR_OF[used] > FLOOR_OF[user]:
        return (f"{user} is a lower floor than {used}: move what both need down, "
                f"or let {used} hand it in")
    if FLOOR_OF[used] == FLOOR_OF[user]:
        return f"{user} and {used} stand on one floor and do not know each other"
    return None


def check_home(path, included):
    """Why `path` may not include the library header `included`, or None."""
    subject = path.removeprefix("tests/")
    for name, headers, home in HOMES:
        if re.match(headers, included) and not re.match(home, subject):
            return f"{name} may be used only in {home.rstrip('$')}"
    return None


def without_comments(text):
    """Blanks comments but keeps the lines."""
    blank = lambda match: "\n" * match.group().count("\n")
    return re.sub(r"//[^\n]*|/\*.*?\*/", blank, text, flags=re.DOTALL)


def check_file(root, path):
    """Yields (line number, reason) for every breach in a file."""
    lines = (root / path).read_text(encoding="utf-8").splitlines()
    if path.endswith(".h") and "#pragma once" not in lines:
        yield 1, "a header begins with #pragma once"
    for number, line in enumerate(lines, 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        quote, included = match.groups()
        if quote == "<":
            reason = check_home(path, included)
        elif (root / included).is_file():
            reason = check_floor(path, included)
        else:
            reason = check_home(path, included) or (
                "our own files are included by their path from the root of the repository, "
                "and others in angle brackets")
        if reason:
            yield number, f"#include {included}: {reason}"
    if path.startswith("renderer/"):
        code = without_comments("\n".join(lines))
        for number, line in enumerate(code.splitlines(), 1):
            if SPEAKING.search(line):
                yield number, "the library neither prints nor exits: throw guidelight::Error"


def check_tree(root):
    """All breaches under a root, as `path:line: reason`, in order."""
    root = pathlib.Path(root)
    breaches = []
    for top in ("renderer", "ui", "app", "tests", "bench"):
        for file in sorted((root / top).rglob("*")):
            if file.suffix in (".h", ".cpp"):
                path = file.relative_to(root).as_posix()
                breaches += [f"{path}:{line}: {why}" for line, why in check_file(root, path)]
    return breaches


def main():
    breaches = check_tree(sys.argv[1])
    print("\n".join(breaches) if breaches else "Every include obeys the floors.")
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main())
