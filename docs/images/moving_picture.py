#!/usr/bin/env python3
"""Makes docs/images/break.gif, the moving picture of README.md: a break of billiards, played by the
game itself without a display. moving_picture.py ANGRY_BALLS; needs ImageMagick."""

import json
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
# The first table's aim and shot, a click each; seconds.
SCRIPT = [{"at": 1, "click": [220, 383]}, {"at": 1.5, "click": [418, 379]},
          {"at": 2, "move": [600, 410]}, {"at": 2.8, "move": [840, 397]}, {"at": 3.2, "click": [840, 397]}]
FIRST, LAST, STEP = 2.4, 6.4, 0.2
WIDTH, HEIGHT = 480, 270


def main():
    game = sys.argv[1]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        frames = []
        for n in range(round((LAST - FIRST) / STEP)):
            time = FIRST + n * STEP
            lines = [entry for entry in SCRIPT if entry["at"] <= time] + [{"at": round(time, 2), "print": True}]
            script = folder / "script.jsonl"
            script.write_text("\n".join(map(json.dumps, lines)) + "\n")
            frames.append(folder / f"{n:03}.png")
            subprocess.run([game, "--lang", "en", "--script", script, "--screenshot", frames[-1]], check=True,
                           stdout=subprocess.DEVNULL)
        subprocess.run(["convert", "-delay", str(round(100 * STEP)), "-loop", "0", *map(str, frames),
                        "-resize", f"{WIDTH}x{HEIGHT}", "-dither", "None", "-colors", "32",
                        "-layers", "OptimizeTransparency", str(HERE / "break.gif")], check=True)
    print((HERE / "break.gif").stat().st_size, "bytes")


main()
