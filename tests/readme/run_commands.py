#!/usr/bin/env python3
"""Runs every command that README.md shows in a ```sh block and compares what it prints with the
```text block that follows, if one does. Left out are only the first-time commands (git clone, cd) and
`./run test`, which is what runs this."""

import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
LEFT_OUT = re.compile(r"git clone .*|cd angry-balls|\./run test.*")


def cells(text, *begin):
    """The cells of the first row of a table that begins with these."""
    for line in text.splitlines():
        row = [cell.strip() for cell in line.strip("| ").split("|")]
        if row[:len(begin)] == list(begin):
            return row
    sys.exit(f"no table has a row {begin}")


def check_figures(readme):
    """The comparison's figures are those of docs/performance.md."""
    text = (ROOT / "docs/performance.md").read_text(encoding="utf-8")
    cost = cells(text, "GAS", "1 000")[2:5]
    shots = cells(text[text.index("### Shots a second"):], "BREAK", "37")[2:5]
    for who, nanoseconds, per_second in zip(("carom", "Chipmunk 7.0.3", "Box2D 2.4.1"), cost, shots):
        row = cells(readme, who)
        if not row[1].startswith(f"{nanoseconds} ns") or row[2] != f"{per_second} shots/s":
            sys.exit(f"README.md says {row[1:3]} of {who}, docs/performance.md {nanoseconds} and {per_second}")


def main():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    check_figures(readme)
    blocks = re.findall(r"```sh\n(.*?)```(?:\s*```text\n(.*?)```)?", readme, re.DOTALL)
    environment = {key: value for key, value in os.environ.items()
                   if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
    environment["PATH"] = f"{ROOT}/build/release:{environment['PATH']}"
    environment["LC_ALL"] = "C.UTF-8"
    ran = 0
    for commands, expected in blocks:
        printed = ""
        for command in commands.splitlines():
            command = command.split("  #")[0].strip()
            if not command or command.startswith("#") or LEFT_OUT.fullmatch(command):
                continue
            print(f"$ {command}")
            run = subprocess.run(["sh", "-c", command], cwd=ROOT, env=environment, timeout=300,
                                 stdin=subprocess.DEVNULL, capture_output=True, encoding="utf-8")
            print(run.stdout + run.stderr)
            if run.returncode != 0:
                sys.exit(f"'{command}' ended with {run.returncode}")
            printed += run.stdout
            ran += 1
        if expected and printed != expected:
            sys.exit(f"expected:\n{expected}\nprinted:\n{printed}")
    for example in re.findall(r"```cpp\n(.*?)```", readme, re.DOTALL):
        if example != (ROOT / "examples/simulate_break.cpp").read_text(encoding="utf-8"):
            sys.exit("the C++ in README.md is not examples/simulate_break.cpp, which is built and run")
    subprocess.run(["build/release/simulate-break"], cwd=ROOT, check=True, timeout=60)
    print(f"{ran} commands ran")
    if ran < 5:
        sys.exit("hardly any command found in README.md")


main()
