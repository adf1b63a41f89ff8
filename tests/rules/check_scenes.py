#!/usr/bin/env python3
"""Checks that the meshes and pictures in scenes/ are what scenes/generate/generate.py writes.

    check_scenes.py ROOT    prints one line per difference and exits with 1 if there is any
"""

import pathlib
import subprocess
import sys
import tempfile


def main():
    scenes = pathlib.Path(sys.argv[1]) / "scenes"
    found = False
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, "-B", scenes / "generate/generate.py", folder], check=True)
        for file in sorted(pathlib.Path(folder).rglob("*")):
            ours = scenes / file.relative_to(folder)
            if file.is_file() and not (ours.is_file() and ours.read_bytes() == file.read_bytes()):
                print(f"{ours}: differs from what scenes/generate/generate.py writes; run it")
                found = True
    for scene in sorted(scenes.rglob("scene.xml")):
        if not (scene.parent / "README.md").is_file():
            print(f"{scene.parent}: has no README.md that says where the geometry comes from")
            found = True
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
