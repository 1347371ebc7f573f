#!/usr/bin/env python3
"""bench/report.py and bench/plot.py on figures made up so that every ratio is known."""

import json
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

FIGURES = {
    "machine": {"processor": "P", "cores": 2, "compiler": "C", "flags": "-O3", "chipmunk": "7",
                "box2d": "2"},
    "rows": [
        {"scene": "GAS", "balls": 1000, "by": "carom", "nanoseconds": [100, 110, 125],
         "ns_per_ball_step": 10, "all_steps": 220, "rms_speed_before": 300, "rms_speed": 150,
         "mean_height": 40, "deepest_overlap": 0.5},
        {"scene": "GAS", "balls": 1000, "by": "carom-pairs", "nanoseconds": [100],
         "ns_per_ball_step": 2000},
        {"scene": "GAS", "balls": 1000, "by": "chipmunk-tree", "nanoseconds": [100, 101],
         "ns_per_ball_step": 343},
        {"scene": "GAS", "balls": 1000, "by": "chipmunk-hash", "nanoseconds": [100, 102],
         "ns_per_ball_step": 228},
        {"scene": "GAS", "balls": 1000, "by": "box2d", "wrong": "3 balls are outside"},
        {"scene": "GAS", "balls": 1000, "by": "streaming", "nanoseconds": [9],
         "ns_per_ball_step": 0.5},
        {"scene": "GAS", "balls": 100000, "by": "carom", "nanoseconds": [100],
         "ns_per_ball_step": 20},
        {"scene": "BILLIARDS", "balls": 16, "by": "carom", "nanoseconds": [50, 52], "shots": 100,
         "ns_per_ball_step": 5, "shots_per_second": 25400},
    ],
}

COST = """
| scene |   balls | ours | Chipmunk | Box2D | streaming | to Chipmunk | to Box2D | noise |
| ----- | ------: | ---: | -------: | ----: | --------: | ----------: | -------: | ----: |
| GAS   |   1 000 |   10 |      228 | wrong |       0.5 |      22.8 × |        – |  25 % |
| GAS   | 100 000 |   20 |        – |     – |         – |           – |        – |   0 % |
""".strip()
SHOTS = """
| BILLIARDS |    16 | 25 400 |        – |     – |               2 540 |           – |        – |       10 × |   4 % |
""".strip()
VARIANTS = """
| scene | balls | ours | pairs |
| ----- | ----: | ---: | ----: |
| GAS   | 1 000 |   10 | 2 000 |
""".strip()
MOTION = "| GAS   | 1 000 |   220 | carom |        0.25 |         150 |              40 |                 0.5 |"


def main():
    bench = pathlib.Path(sys.argv[1])
    with tempfile.TemporaryDirectory() as name:
        check(bench, pathlib.Path(name))


def check(bench, folder):
    figures = folder / "bench.json"
    figures.write_text(json.dumps(FIGURES), encoding="utf-8")

    def script(*arguments):
        return subprocess.run([sys.executable, bench / arguments[0], *arguments[1:]], check=True,
                              capture_output=True, encoding="utf-8").stdout

    printed = script("report.py", figures)
    for part in (COST, SHOTS, VARIANTS):
        assert part in printed, f"expected\n{part}\nin\n{printed}"

    document = folder / "document.md"
    document.write_text("Before\n<!-- table cost -->\nold\n<!-- end -->\nbetween\n"
                        "<!-- table motion --><!-- end -->\nafter\n", encoding="utf-8")
    script("report.py", figures, "--update", document)
    once = document.read_text(encoding="utf-8")
    assert COST in once and MOTION in once and "old" not in once, once
    assert once.startswith("Before\n") and "\nbetween\n" in once and once.endswith("\nafter\n"), once
    script("report.py", figures, "--update", document)
    assert document.read_text(encoding="utf-8") == once, "a second update changed the document"

    picture = folder / "cost.svg"
    script("plot.py", figures, picture)
    svg = xml.etree.ElementTree.parse(picture).getroot()
    lines = svg.findall("{http://www.w3.org/2000/svg}polyline")
    # Ours, Chipmunk, streaming: Box2D was wrong.
    assert len(lines) == 3, len(lines)
    ours = next(line.get("points") for line in lines if len(line.get("points").split()) == 2)
    (x1, y1), (x2, y2) = (map(float, point.split(",")) for point in ours.split())
    assert x2 > x1 and y2 < y1, "more balls are to the right, and higher cost is higher up"


main()
