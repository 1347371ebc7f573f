#!/usr/bin/env python3
"""Runs a command-line case: a text file with a command and all that must come back.

    $ carom simulate scenes/hole.json --hash
    exit 0
    --- stdout
    ...
    --- stderr
    ...

The command is run by sh in the project's root, our programs first in PATH. Sections that are
empty are left out. UPDATE_GOLDEN=1 writes the file anew from what came back: read it afterwards.
"""

import argparse
import os
import pathlib
import subprocess
import sys


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bin", required=True, help="folder of the programs")
    parser.add_argument("case", type=pathlib.Path)
    options = parser.parse_args()

    expected = options.case.read_text(encoding="utf-8")
    command = expected.splitlines()[0]
    if not command.startswith("$ "):
        sys.exit(f"{options.case}: the first line must be '$ COMMAND'")
    environment = dict(os.environ, PATH=f"{options.bin}:{os.environ['PATH']}", LC_ALL="C.UTF-8",
                       COLUMNS="80")
    run = subprocess.run(["sh", "-c", command[2:]], env=environment, capture_output=True,
                         encoding="utf-8", stdin=subprocess.DEVNULL, timeout=300)
    actual = f"{command}\nexit {run.returncode}\n"
    for name, text in (("stdout", run.stdout), ("stderr", run.stderr)):
        if text:
            actual += f"--- {name}\n{text}"
            if not text.endswith("\n"):
                actual += "\n(no newline at the end)\n"
    if actual == expected:
        return
    if os.environ.get("UPDATE_GOLDEN"):
        options.case.write_text(actual, encoding="utf-8")
        return
    sys.exit(f"expected:\n{expected}\nactual:\n{actual}")


main()
