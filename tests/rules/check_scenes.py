#!/usr/bin/env python3
"""Checks that the meshes and pictures in scenes/ are what scenes/generate/generate.py writes, that each
scene uses them all, says where they come from, and stays below 8 MiB.

    check_scenes.py ROOT    prints one line per difference and exits with 1 if there is any
"""

import pathlib
import subprocess
import sys
import tempfile

LARGEST = 8 << 20  # bytes in a scene's folder


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
        files = [file for file in scene.parent.iterdir() if file.is_file()]
        if sum(file.stat().st_size for file in files) > LARGEST:
            print(f"{scene.parent}: holds more than 8 MiB")
            found = True
        text = scene.read_text(encoding="utf-8")
        for file in files:
            if file.suffix in (".obj", ".ply", ".png", ".hdr") and f'"{file.name}"' not in text:
                print(f"{file}: scene.xml does not use it")
                found = True
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
