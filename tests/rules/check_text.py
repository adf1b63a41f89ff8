#!/usr/bin/env python3
"""Checks the words of the project: a TODO, FIXME, XXX or HACK must give its reason after a colon.

    check_text.py ROOT      prints one line per breach and exits with 1 if there is any
"""

import pathlib
import re
import sys

MARKER = re.compile(r"\b(TODO|FIXME|XXX|HACK)\b")
WITH_REASON = re.compile(r"\b(TODO|FIXME|XXX|HACK)(\([^)]+\))?: \w+(\W+\w+){2}")
FOLDERS = ("app", "bench", "docs", "renderer", "scenes", "tests", "tools", "ui")
ENDINGS = (".h", ".cpp", ".py", ".sh", ".md", ".txt", ".xml", ".json", ".glsl", ".cmake")


def breaches_in(text):
    """Line numbers with a marker that gives no reason of at least three words."""
    return [number for number, line in enumerate(text.splitlines(), 1)
            if MARKER.search(line) and not WITH_REASON.search(line)]


def main():
    root = pathlib.Path(sys.argv[1])
    found = False
    for file in sorted(root.glob("*.*")) + sorted(f for top in FOLDERS for f in (root / top).rglob("*")):
        path = file.relative_to(root).as_posix()
        if not file.is_file() or not (file.suffix in ENDINGS or path.startswith("tools/")):
            continue
        if path.startswith("tests/rules/"):  # names the words
            continue
        for number in breaches_in(file.read_text(encoding="utf-8")):
            print(f"{path}:{number}: a marker without its reason: do it, or say why not yet")
            found = True
    if not found:
        print("Every marker gives its reason.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
