#!/usr/bin/env python3
"""All integrators for the same time on the same scenes, against a long reference.

    equal_time.py [--build DIR] [--seconds S] [--reference-seconds S] [--size WxH] [--out DIR]
                  [--scene NAME=PATH:INTEGRATOR:LENGTH ...]

Prints a Markdown table of relMSE (the worst 0.1 % of the pixels left out in brackets) and leaves a PNG
of every picture in DIR. A reference is rendered once per scene, by the integrator given, and kept in
DIR.
"""

import argparse
import json
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent
INTEGRATORS = ["path", "bdpt", "sppm", "vcm", "bdpm", "photon_map"]
SCENES = [
    f"cornell={ROOT}/scenes/cornell/scene.xml:bdpt:12",
    f"mirror-glass-box={ROOT}/scenes/mirror-glass-box/scene.xml:vcm:12",
]


def length_key(integrator):
    return "max_depth" if integrator == "path" else "max_length"


def render(args, scene, integrator, length, seconds, outputs, seed=0):
    command = [f"{args.build}/guidelight", "render", scene, "--integrator", integrator,
               "--time", str(seconds), "--size", args.size, "--threads", "2", "--float",
               "--seed", str(seed),
               "--set", f"{length_key(integrator)}={length}"]
    for output in outputs:
        command += ["-o", str(output)]
    subprocess.run(command, check=True, capture_output=True)


def compare(args, picture, reference):
    command = [f"{args.build}/guidelight", "compare", str(picture), str(reference), "--json"]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", default=ROOT / "build/release")
    parser.add_argument("--seconds", type=float, default=20)
    parser.add_argument("--reference-seconds", type=float, default=300)
    parser.add_argument("--size", default="512x512")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("equal-time"))
    parser.add_argument("--scene", action="append", default=[])
    args = parser.parse_args()
    args.out.mkdir(exist_ok=True)

    print(f"| scene | {' | '.join(INTEGRATORS)} |")
    print("|---" * (len(INTEGRATORS) + 1) + "|")
    for scene in SCENES + args.scene:
        name, rest = scene.split("=", 1)
        path, reference_by, length = rest.rsplit(":", 2)
        reference = args.out / f"{name}-reference.exr"
        if not reference.exists():
            render(args, path, reference_by, length, args.reference_seconds,
                   [reference, reference.with_suffix(".png")], seed=1)
        cells = []
        for integrator in INTEGRATORS:
            picture = args.out / f"{name}-{integrator}.exr"
            render(args, path, integrator, length, args.seconds,
                   [picture, picture.with_suffix(".png")])
            error = compare(args, picture, reference)["relative_mse"]
            cells.append(f"{error['plain']:.4g} ({error['robust']:.4g})")
        print(f"| {name} | {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main()
