#!/usr/bin/env python3
"""Puts together the folder that a web server serves: assemble.py FOLDER WORKER FILE..."""

import hashlib
import json
import pathlib
import shutil
import sys


def main():
    folder, worker, *files = map(pathlib.Path, sys.argv[1:])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    contents = {file.name: file.read_bytes() for file in files}
    size = str(len(contents["game.wasm"])).encode()
    texts = contents.pop("page.json")
    script = contents["page.js"].replace(b"/*WASM_BYTES*/ 0", size)
    contents["page.js"] = script.replace(b"/*TEXTS*/ { en: {} }", texts)
    version = hashlib.sha256()
    for name in sorted(contents):
        version.update(f"{name} {len(contents[name])} ".encode() + contents[name])
        (folder / name).write_bytes(contents[name])
    script = worker.read_text()
    script = script.replace("VERSION", version.hexdigest()[:16])
    script = script.replace("FILES", json.dumps(["./", *sorted(contents)]))
    # Last: it is what the build takes for the sign that all is there.
    (folder / worker.name).write_text(script)


main()
