#!/usr/bin/env python3
"""Shots a second of `carom shots` as WebAssembly under Node, without SIMD and with it, beside the native
program, in turns; the hashes must be equal.

wasm.py CAROM FOLDER [--rounds N] [--json FILE]   FOLDER has carom.js and carom-simd.js"""

import argparse
import json
import pathlib
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Scene or level, and shots a round: about half a second each.
SCENES = [("scenes/break.json", 400), ("levels/01-first-steps.json", 400), ("levels/10-the-fortress.json", 200)]


def shots(program, scene, count):
    # Node's own fetch would be taken for the browser's.
    command = ["node", "--no-experimental-fetch"] if program.suffix == ".js" else []
    done = subprocess.run([*command, program, "shots", scene, "--count", str(count), "--seed", "1", "--json"],
                          capture_output=True, check=True, cwd=ROOT, text=True)
    return json.loads(done.stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("carom", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--json", type=pathlib.Path)
    options = parser.parse_args()
    programs = {"native": options.carom.resolve(),
                "wasm": (options.folder / "carom.js").resolve(),
                "wasm-simd": (options.folder / "carom-simd.js").resolve()}
    rows = []
    print("| shots/s, one core | native | WebAssembly | with SIMD |\n|---|---|---|---|")
    for scene, count in SCENES:
        speeds, hashes = {name: [] for name in programs}, set()
        for _ in range(options.rounds):
            for name, program in programs.items():
                result = shots(program, scene, count)
                speeds[name].append(result["shots_per_second"])
                hashes.add(result["hash"])
        if len(hashes) != 1:
            sys.exit(f"{scene}: the hashes differ: {sorted(hashes)}")
        median = {name: statistics.median(values) for name, values in speeds.items()}
        share = {name: median[name] / median["native"] for name in programs}
        rows.append({"scene": scene, "count": count, "rounds": options.rounds, "hash": hashes.pop(),
                     "shots_per_second": median, "of_native": share})
        print(f"| {pathlib.Path(scene).stem} | {median['native']:.0f} | " +
              " | ".join(f"{median[name]:.0f} ({share[name]:.2f} ×)" for name in ("wasm", "wasm-simd")) + " |",
              flush=True)
    if options.json:
        options.json.write_text(json.dumps(rows, indent=2) + "\n")


main()
