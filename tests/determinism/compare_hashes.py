#!/usr/bin/env python3
"""Runs shipped and random scenes through `carom simulate` and through golden_hashes as other compilers
built it; every step's hash must be the same."""

import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests/reference"))

import random_scene  # noqa: E402

STEPS = 600


def output(command, scene):
    return subprocess.run(command, input=scene, capture_output=True, text=True, check=True,
                          timeout=300).stdout


def main():
    carom, *variants = sys.argv[1:]
    scenes = {path.name: path.read_text()
              for pattern in ("scenes/*.json", "levels/*.json", "tests/scenes/*.json")
              for path in sorted(ROOT.glob(pattern)) if not path.name.endswith((".proof.json", "pack.json"))}
    for kind in ("billiards", "level", "mixed"):
        for seed in range(1, 11):
            scenes[f"{kind} {seed}"] = json.dumps(random_scene.random_scene(seed, kind))
    different_hashes = set()
    for name, scene in scenes.items():
        trace = output([carom, "simulate", "-", "--steps", str(STEPS), "--trace", "-", "--quiet"],
                       scene)
        expected = [json.loads(line)["hash"] for line in trace.splitlines()[1:]]
        different_hashes.update(expected)
        for variant in variants:
            actual = output([variant, "--steps", str(STEPS)], scene).split()
            if actual != expected:
                step = next(n for n, pair in enumerate(zip(expected, actual), 1)
                            if pair[0] != pair[1])
                sys.exit(f"{name}: {pathlib.Path(variant).parent.name} differs at step {step}")
    if len(different_hashes) < 1000 or not variants:
        sys.exit("nothing moved in these scenes: the comparison shows nothing")
    print(f"{len(scenes)} scenes, {len(variants)} other builds, {STEPS} steps: the same hashes")


main()
