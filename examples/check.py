#!/usr/bin/env python3
"""Runs an example: it has less than 60 lines, prints what is in expected/NAME.txt (all of it, or as
many lines as are there), and an argument OUTPUT.… becomes a file. --write writes what is expected."""

import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent


def main():
    write = "--write" in sys.argv
    name, program, *arguments = [word for word in sys.argv[1:] if word != "--write"]
    lines = (HERE / f"{name}.cpp").read_text().count("\n")
    if lines >= 60:
        sys.exit(f"{name}.cpp has {lines} lines")
    with tempfile.TemporaryDirectory() as folder:
        outputs = [pathlib.Path(folder) / word for word in arguments if word.startswith("OUTPUT.")]
        words = [str(pathlib.Path(folder) / word) if word.startswith("OUTPUT.") else word
                 for word in arguments]
        printed = subprocess.run([program, *words], check=True, capture_output=True, text=True).stdout
        for output in outputs:
            data = output.read_bytes()
            if output.suffix == ".png" and not data.startswith(b"\x89PNG\r\n\x1a\n"):
                sys.exit("no PNG")
            print(f"{output.name}: {len(data)} bytes")
    print(printed)
    expected = HERE / f"expected/{name}.txt"
    if write:
        expected.parent.mkdir(exist_ok=True)
        expected.write_text("".join(printed.splitlines(True)[:12]))
    if not printed.startswith(expected.read_text()) or not printed:
        sys.exit(f"expected:\n{expected.read_text()}")


main()
