#!/usr/bin/env python3
"""Compares traces of `carom simulate` with reference.py, bit by bit and step by step."""

import argparse
import json
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import random_scene  # noqa: E402
import reference  # noqa: E402


def carom_trace(carom, scene_text, steps):
    run = subprocess.run(
        [carom, "simulate", "-", "--steps", str(steps), "--trace", "-", "--quiet"],
        input=scene_text, capture_output=True, text=True, timeout=300)
    if run.returncode != 0:
        sys.exit(f"carom simulate failed with {run.returncode}:\n{run.stderr}\n{scene_text}")
    return [json.loads(line) for line in run.stdout.splitlines()]


def reference_trace(scene_text, steps):
    world = reference.World(json.loads(scene_text))
    lines = [world.trace_line()]
    for _ in range(steps):
        world.step()
        lines.append(world.trace_line())
    return [json.loads(line) for line in lines]


def compare(carom, name, scene_text, steps):
    expected = reference_trace(scene_text, steps)
    actual = carom_trace(carom, scene_text, steps)
    if len(actual) != len(expected):
        sys.exit(f"{name}: {len(actual)} lines, expected {len(expected)}")
    for want, got in zip(expected, actual):
        got.pop("hash")
        if got != want:
            for key in want:
                if got.get(key) != want[key]:
                    print(f"{name}: step {want['step']}: {key} differ", file=sys.stderr)
                    for a, b in zip(want[key], got[key]):
                        if a != b:
                            print(f"  expected {a}\n  actual   {b}", file=sys.stderr)
            print(scene_text, file=sys.stderr)
            sys.exit(1)
    return sum(len(line["events"]) for line in expected)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--carom", required=True)
    parser.add_argument("--kind", required=True, choices=["billiards", "level", "mixed", "shipped"])
    parser.add_argument("--seeds", type=int, default=40)
    parser.add_argument("--first-seed", type=int, default=1)
    parser.add_argument("--steps", type=int, default=150)
    options = parser.parse_args()

    events = 0
    if options.kind == "shipped":
        root = HERE.parent.parent
        scenes = sorted(path for folder in ("scenes", "levels", "tests/scenes")
                        for path in root.glob(f"{folder}/*.json")
                        if not path.name.endswith((".proof.json", "pack.json")))
        for path in scenes:
            events += compare(options.carom, path.name, path.read_text(), 900)
        print(f"{len(scenes)} shipped scenes, {events} events: equal")
        if not scenes:
            sys.exit("no scenes found")
    else:
        for seed in range(options.first_seed, options.first_seed + options.seeds):
            scene = json.dumps(random_scene.random_scene(seed, options.kind))
            events += compare(options.carom, f"seed {seed}", scene, options.steps)
        print(f"{options.seeds} random {options.kind} scenes, {events} events: equal")
    if events == 0:
        sys.exit("nothing ever happened in these scenes: the comparison shows nothing")


main()
