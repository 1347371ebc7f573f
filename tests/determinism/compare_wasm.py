#!/usr/bin/env python3
"""Gives the same files to the native `carom` and to the one for Node; every byte they print must be the
same: replays verified, written as JSON and as packed text, levels won, and numbers of every size.
compare_wasm.py CAROM CAROM.js"""

import json
import pathlib
import random
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def output(program, arguments, text=None):
    # Node's own fetch would be taken for the browser's.
    command = ["node", "--no-experimental-fetch"] if program.endswith(".js") else []
    done = subprocess.run(command + [program, *arguments], input=text, capture_output=True, cwd=ROOT,
                          text=True, timeout=300)
    return done.returncode, done.stdout, done.stderr


def numbers():
    """A scene whose speeds are powers of two, where most goes wrong, their neighbours, and others."""
    random.seed(20)
    speeds = [sign * 2.0 ** exponent * (1 + nudge * 2.0 ** -52)
              for exponent in range(-330, 17) for sign in (1, -1) for nudge in (0, 1, 2)]
    speeds += [random.uniform(-1, 1) * 10 ** random.uniform(-20, 4) for _ in range(3000)]
    balls = [{"x": 100 * i, "y": 50, "vx": speed, "vy": -speed / 3}
             for i, speed in enumerate(speeds)]
    edges = {side: "open" for side in ("left", "right", "bottom", "top")}
    return json.dumps({"carom": 1, "width": 1000, "height": 100, "edges": edges, "balls": balls})


def main():
    native, wasm = sys.argv[1:]
    replays = sorted(str(path.relative_to(ROOT)) for path in ROOT.glob("tests/replays/**/*.*"))
    cases = [(["replay", option, replay], None)
             for replay in replays for option in ("--verify", "--json", "--text")]
    cases.append((["prove", "--first", *(str(path) for path in sorted(ROOT.glob("levels/*.json")))], None))
    cases.append((["generate", "--difficulty", "0.05", "--seed", "1"], None))
    cases.append((["simulate", "-", "--steps", "0", "--trace", "-", "--quiet"], numbers()))
    for arguments, text in cases:
        expected, got = output(native, arguments, text), output(wasm, arguments, text)
        if expected != got:
            for line, pair in enumerate(zip(expected[1].split(","), got[1].split(",")), 1):
                if pair[0] != pair[1]:
                    print(f"value {line}: {pair[0]} natively, {pair[1]} as WebAssembly")
            sys.exit(f"{' '.join(arguments)}: not the same as WebAssembly\n"
                     f"{expected[0]} {expected[2]}\n{got[0]} {got[2]}")
        if text and expected[0] != 0:
            sys.exit(f"a wrong scene: {expected[2]}")
    if len(replays) < 10:
        sys.exit("few replays: the comparison shows little")
    print(f"{len(cases)} outputs: the same bytes as WebAssembly")


main()
