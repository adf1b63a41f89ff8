#!/usr/bin/env python3
"""The comparisons of Fan, Chenney & Lai, "Metropolis Photon Sampling with Optional User Guidance"
(2005), on scenes of the same kind.

    metropolis.py [--build DIR] [--seconds S] [--reference-seconds S] [--seeds N] [--scale F] [--out DIR]

Prints two Markdown tables: photon mapping against Metropolis photon sampling at equal time (RMS relative
error as the source defines it), and chains without guides against chains with guides after the same
number of mutations. Means over seeds. References are rendered once and kept in DIR.
"""

import argparse
import json
import pathlib
import statistics
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent

# Probabilities of the proposals and final gather as in the source; the multi-chain perturbation is ours.
SCENES = {
    "rooms": dict(size=(720, 405), gather=40,
                  mps=["guided=0.1", "bidirectional=0.3", "photon_map=0.2", "caustic=0", "lens=0.2",
                       "lens_subpath=0.2"]),
    "lantern": dict(size=(684, 513), gather=30,
                    mps=["guided=0", "bidirectional=0.4", "photon_map=0.2", "caustic=0", "lens=0.2",
                         "lens_subpath=0.2"]),
    "box": dict(size=(640, 480), gather=40,
                mps=["guided=0.1", "bidirectional=0.3", "photon_map=0.2", "caustic=0.12", "lens=0.08",
                     "lens_subpath=0.2"]),
}
# The small caustic of the box, in its full size.
REGION = {"box": (268, 428, 336, 460)}


def run(arguments):
    return subprocess.run([str(a) for a in arguments], check=True, capture_output=True, text=True).stdout


def render(args, scene, integrator, output, seed, stop, settings):
    size = [max(1, round(s * args.scale)) for s in SCENES[scene]["size"]]
    command = [f"{args.build}/guidelight", "render", ROOT / f"scenes/{scene}/scene.xml", "-o", output,
               "--float", "--integrator", integrator, "--size", f"{size[0]}x{size[1]}", "--threads", 2,
               "--seed", seed, "--statistics", *stop]
    for setting in settings:
        command += ["--set", setting]
    return run(command)


def compare(args, scene, picture, reference, region=None):
    command = [f"{args.build}/guidelight", "compare", picture, reference, "--json"]
    if region:
        command += ["--crop", ",".join(str(round(c * args.scale)) for c in region)]
    return json.loads(run(command))


def reference_of(args, scene):
    reference = args.out / f"{scene}-reference.exr"
    if not reference.exists():
        render(args, scene, args.reference_by, reference, 77, ["--time", args.reference_seconds], [])
    return reference


def photons(args, scene):
    """RMS relative error of photon mapping and of Metropolis photon sampling."""
    gather = f"gather_rays={SCENES[scene]['gather']}"
    methods = {"photon_map": [gather], "mps": [gather, *SCENES[scene]["mps"]]}
    errors = {}
    for method, settings in methods.items():
        values = []
        for seed in range(1, args.seeds + 1):
            picture = args.out / f"{scene}-{method}-{seed}.exr"
            render(args, scene, method, picture, seed, ["--time", args.seconds], settings)
            metrics = compare(args, scene, picture, reference_of(args, scene))["rms_relative_error"]
            values.append((metrics["plain"], metrics["robust"]))
        errors[method] = [statistics.mean(v) for v in zip(*values)]
    pm, mps = errors["photon_map"], errors["mps"]
    print(f"| {scene} | {pm[0]:.4g} ({pm[1]:.4g}) | {mps[0]:.4g} ({mps[1]:.4g}) | "
          f"{pm[0] / mps[0]:.2f} ({pm[1] / mps[1]:.2f}) |", flush=True)


def acceptance(report):
    line = next(l for l in report.splitlines() if "mutations," in l)
    return float(line.split()[2])


def guides(args, scene):
    """relMSE and acceptance of chains, without and with guides."""
    cells = []
    for guided in ("0", "0.1"):
        errors, regions, accepted = [], [], []
        for seed in range(1, args.seeds + 1):
            picture = args.out / f"{scene}-mlt-{guided}-{seed}.exr"
            report = render(args, scene, "mlt", picture, seed, ["--spp", args.passes], [f"guided={guided}"])
            reference = reference_of(args, scene)
            errors.append(compare(args, scene, picture, reference)["relative_mse"]["plain"])
            if scene in REGION:
                part = compare(args, scene, picture, reference, REGION[scene])
                regions.append(part["relative_mse"]["plain"])
            accepted.append(acceptance(report))
        cells.append((statistics.mean(errors), statistics.mean(regions) if regions else float("nan"),
                      statistics.mean(accepted)))
    without, with_guides = cells
    print(f"| {scene} | {without[0]:.4g} | {with_guides[0]:.4g} | {without[0] / with_guides[0]:.2f} | "
          f"{without[1] / with_guides[1]:.2f} | {without[2]:.1f} % | {with_guides[2]:.1f} % |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", default=ROOT / "build/release")
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--passes", type=int, default=16)
    parser.add_argument("--reference-seconds", type=float, default=1200)
    # Chains hardly visit dark pixels, which a relative error divides by.
    parser.add_argument("--reference-by", default="bdpt")
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--scale", type=float, default=1)
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("metropolis"))
    args = parser.parse_args()
    args.out.mkdir(exist_ok=True)
    print("| scene | photon_map | mps | ratio |\n|---|---|---|---|")
    for scene in SCENES:
        photons(args, scene)
    print("\n| scene | without | with guides | ratio | ratio in the region | accepted | with guides |")
    print("|---|---|---|---|---|---|---|")
    for scene in ("rooms", "box"):
        guides(args, scene)


if __name__ == "__main__":
    main()
