#!/usr/bin/env python3
"""Checks that types, constants and functions in anonymous namespaces have names of their own within a part
of the program: most builds join sources, where two of one name would clash.

    check_names.py ROOT      prints one line per breach and exits with 1 if there is any
"""

import collections
import pathlib
import re
import sys

PARTS = ("renderer", "ui", "app", "tests/renderer", "tests/ui", "tests/end_to_end")
ANONYMOUS = re.compile(r"^namespace \{$(.*?)^\}  // namespace$", re.MULTILINE | re.DOTALL)
# At the beginning of a line: what stands in a function or class is its own.
NAMED = re.compile(r"^(?:(?:enum class|enum|class|struct) (\w+)[^;\n]*\{|(?:inline )?constexpr [^=({\n]*?\b(k\w+)\b)",
                   re.MULTILINE)
RAW_STRING = re.compile(r'R"(\w*)\(.*?\)\1"', re.DOTALL)  # shaders have functions
FUNCTION = re.compile(r"^(?!TEST|TYPED|INSTANTIATE|MATCHER|using|return|template|static_assert)"
                      r"[A-Za-z_][\w:<>,&* ]*?[ &*](\w+)\(([^()]*)\)[^;{]*\{", re.MULTILINE)


def signature(name, parameters):
    """Overloads do not clash: the name with the types of the parameters."""
    types = (re.sub(r"\s*=.*|\s*\b\w+\s*(=.*)?$", "", parameter.strip()) for parameter in parameters.split(","))
    return f"{name}({', '.join(types)})"


def names_in(text):
    """Types, constants and functions of the anonymous namespaces of a source."""
    names = set()
    for body in ANONYMOUS.findall(RAW_STRING.sub("", text)):
        names.update(name for match in NAMED.findall(body) for name in match if name)
        names.update(signature(*match) for match in FUNCTION.findall(body))
    return names


def clashes_in(sources):
    """(name, files) for each name that several of the sources {path: text} have."""
    files = collections.defaultdict(list)
    for path, text in sorted(sources.items()):
        for name in names_in(text):
            files[name].append(path)
    return sorted((name, paths) for name, paths in files.items() if len(paths) > 1)


def main():
    root = pathlib.Path(sys.argv[1])
    found = False
    for part in PARTS:
        sources = {file.relative_to(root).as_posix(): file.read_text(encoding="utf-8")
                   for file in (root / part).rglob("*.cpp")}
        for name, paths in clashes_in(sources):
            print(f"{name} is in {', '.join(paths)}: give one another name, or one place to both")
            found = True
    if not found:
        print("Every name in an anonymous namespace is its own.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
