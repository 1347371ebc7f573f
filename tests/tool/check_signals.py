#!/usr/bin/env python3
"""Every long work of the tool ends at once when it is told to (SIGTERM, SIGINT), and leaves no
unfinished file. Each command is one that would take minutes; it is told half a second after its
start, whatever it is doing then: reading, checking, or the first step of many balls."""

import argparse
import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

PATIENCE = 3  # s; the answer takes milliseconds, unless the machine does much else


def large_scene(file, balls):
    row = 1000
    lines = (f'{{"x":{20 + 21 * (n % row)},"y":{20 + 21 * (n // row)},"vx":{n % 7 - 3}}}'
             for n in range(balls))
    file.write_text(f'{{"carom":1,"width":{21 * row + 40},"height":{21 * (balls // row) + 60},'
                    f'"balls":[{",".join(lines)}]}}')


def level(file, **more):
    scene = {"carom": 1, "width": 20_000, "height": 20_000, "gravity": 600,
             "balls": [{"x": 100, "y": 100, "role": "projectile"},
                       {"x": 19_000, "y": 19_990, "role": "enemy"}]}
    scene["balls"] += [{"x": 300 + 30 * (n % 600), "y": 300 + 30 * (n // 600), "vy": 300}
                       for n in range(5_000)]
    file.write_text(json.dumps(scene | more))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("carom")
    carom = str(pathlib.Path(parser.parse_args().carom).resolve())
    faults = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        scene = folder / "scene.json"
        large_scene(scene, 400_000)
        level(folder / "level.json")
        out = folder / "out"
        works = [
            ("simulate", scene, "--steps", "1000000", "--quiet"),
            ("simulate", scene, "--steps", "1000000", "--trace", out),
            ("simulate", scene, "--steps", "1000000", "--broad-phase", "pairs"),
            ("simulate", scene, "--steps", "1000000", "--threads", "4"),
            ("simulate", "scenes/two-balls.json", "--steps", "1000000000000", "--no-skip"),
            ("simulate", "scenes/two-balls.json", "--steps", "1000000000000", "--trace", out),
            ("check",) + (folder / "level.json",) * 50,
            ("shots", "scenes/break.json", "--count", "1000000000", "--csv", out),
            ("shots", "scenes/break.json", "--count", "1000000000", "--threads", "4"),
            ("soak", "--games", "1000000"),
            ("level-link", "-"),  # waits for its input
        ]
        for work in works:
            for ending in (signal.SIGTERM, signal.SIGINT):
                shown = " ".join(str(word) for word in ("carom", *work)).replace(name, "…")[:90]
                process = subprocess.Popen([carom, *map(str, work)], stdin=subprocess.PIPE,
                                           stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
                time.sleep(0.5)
                if process.poll() is not None:
                    faults.append(f"{shown}: is no long work: {process.stderr.read()[:200]}")
                    break
                process.send_signal(ending)
                try:
                    status = process.wait(PATIENCE)
                    if status != -ending:
                        faults.append(f"{shown}: ended with {status}, not by {ending.name}")
                except subprocess.TimeoutExpired:
                    faults.append(f"{shown}: goes on after {ending.name}")
                    process.kill()
                    process.wait()
                if out.exists():
                    faults.append(f"{shown}: left {out.stat().st_size} bytes after {ending.name}")
                    out.unlink()
    if faults:
        sys.exit("\n".join(faults))
    print(f"{len(works)} works ended at once")


main()
