#!/usr/bin/env python3
"""What a page loads before the game starts, packed as servers pack it: check_size.py FOLDER"""

import gzip
import pathlib
import sys

LIMIT = 400 * 1024  # bytes


def main():
    folder = pathlib.Path(sys.argv[1])
    sizes = {name: len(gzip.compress((folder / name).read_bytes(), 9))
             for name in ("game.wasm", "game.js")}
    total = sum(sizes.values())
    print(", ".join(f"{name} {size} bytes" for name, size in sizes.items()), f"together {total}")
    if total > LIMIT:
        sys.exit(f"more than {LIMIT} bytes")


main()
