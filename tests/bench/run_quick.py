#!/usr/bin/env python3
"""Runs carom-bench on the smallest size of every scene: our hashes must be the golden ones, nobody's
balls may get lost, and a wrong or missing golden hash must be noticed."""

import json
import pathlib
import subprocess
import sys
import tempfile

LEVELS = {f"LEVEL-{n:02}" for n in range(1, 11)}
OURS_ONLY = {"BILLIARDS", "BREAKS", "SCATTERED"} | LEVELS
WITHOUT_STREAMING = OURS_ONLY | {"TABLE"}


def main():
    program, bench = sys.argv[1], pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        check(program, bench, pathlib.Path(folder))


def check(program, bench, folder):
    def run(*options):
        return subprocess.run([program, "--quick", *options], capture_output=True, encoding="utf-8",
                              timeout=300)

    figures = folder / "bench.json"
    done = run("--json", figures)
    print(done.stderr)
    assert done.returncode == 0, "carom-bench failed"
    rows = json.loads(figures.read_text(encoding="utf-8"))["rows"]
    by_scene = {}
    for row in rows:
        assert "wrong" not in row, row
        assert row["ball_steps"] > 0 and row["ns_per_ball_step"] > 0, row
        by_scene.setdefault(row["scene"], set()).add(row["by"])
    assert set(by_scene) == OURS_ONLY | {"BREAK", "TABLE", "GAS", "DENSE", "PILE"}, by_scene
    for scene, by in by_scene.items():
        expected = {"carom"}
        if scene not in OURS_ONLY:
            expected |= {"chipmunk-tree", "chipmunk-hash", "box2d"}
        if scene not in WITHOUT_STREAMING:
            expected.add("streaming")
        assert expected <= by, (scene, by)

    # The tables and the picture can be made of it.
    tables = subprocess.run([sys.executable, bench / "report.py", figures], check=True,
                            capture_output=True, encoding="utf-8").stdout
    for scene in by_scene:
        assert f"| {scene} " in tables, tables
    subprocess.run([sys.executable, bench / "plot.py", figures, folder / "cost.svg"], check=True)

    # A hash that is off by one digit, and one that is not there.
    golden = folder / "golden.txt"
    right = (bench / "golden.txt").read_text(encoding="utf-8")
    lines = right.splitlines()
    at = next(n for n, line in enumerate(lines) if line.startswith("BREAK/37 "))
    off = lines[at][:-1] + ("0" if lines[at][-1] != "0" else "1")
    for name, wrong in (("off", lines[:at] + [off] + lines[at + 1:]),
                        ("missing", lines[:at] + lines[at + 1:])):
        golden.write_text("\n".join(wrong) + "\n", encoding="utf-8")
        noticed = run("--scene", "BREAK", "--by", "carom", "--golden", golden)
        assert noticed.returncode == 1 and "WRONG" in noticed.stderr, (name, noticed)
    # Missing rows can be added, rows that are there stay.
    added = run("--scene", "BREAK", "--by", "carom", "--golden", golden, "--update-golden")
    assert added.returncode == 0, added
    assert sorted(golden.read_text(encoding="utf-8").splitlines()) == sorted(lines)


main()
