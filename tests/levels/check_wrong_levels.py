#!/usr/bin/env python3
"""Runs `carom check` on every level in tests/levels/wrong and compares the messages with the text
beside it. UPDATE_GOLDEN=1 writes the texts anew: read them afterwards."""

import os
import pathlib
import subprocess
import sys

FOLDER = pathlib.Path(__file__).resolve().parent / "wrong"


def main():
    carom = str(pathlib.Path(sys.argv[1]).resolve())
    levels = sorted(FOLDER.glob("*.json"))
    different = []
    for level in levels:
        run = subprocess.run([carom, "check", level.name], cwd=FOLDER, capture_output=True,
                             encoding="utf-8", timeout=120)
        actual = f"{run.stdout}{run.stderr}exit {run.returncode}\n"
        golden = level.with_suffix(".txt")
        if os.environ.get("UPDATE_GOLDEN"):
            golden.write_text(actual, encoding="utf-8")
        expected = golden.read_text(encoding="utf-8") if golden.exists() else "(no golden text)\n"
        if actual != expected:
            different.append(f"{level.name}\nexpected:\n{expected}actual:\n{actual}")
        if run.returncode == 0 and "warning" not in actual:
            different.append(f"{level.name}: nothing is said against it")
    if different or len(levels) < 40 or len(list(FOLDER.glob("*.txt"))) != len(levels):
        sys.exit("\n".join(different) or f"{len(levels)} levels, or a text too many")
    print(f"{len(levels)} levels: the messages expected")


main()
