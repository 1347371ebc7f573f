#!/usr/bin/env python3
"""Puts together the folder that a web server serves: assemble.py FOLDER WORKER FILE..."""

import base64
import hashlib
import json
import pathlib
import shutil
import sys

# The smallest module with an instruction of the 128-bit SIMD: what takes it can run game-simd.wasm.
SIMD_PROBE = bytes([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0,
                    10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11])


def integrity(content):
    """As the attribute of that name has it."""
    return "sha256-" + base64.b64encode(hashlib.sha256(content).digest()).decode()


def main():
    folder, worker, *files = map(pathlib.Path, sys.argv[1:])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    contents = {file.name: file.read_bytes() for file in files}
    texts = contents.pop("page.json").decode()
    probe = json.dumps(list(SIMD_PROBE))

    whole = hashlib.sha256(worker.read_bytes() + texts.encode())
    for name in sorted(contents):
        whole.update(f"{name} {len(contents[name])} ".encode() + contents[name])
    version = whole.hexdigest()[:16]
    parts = {name: {"size": len(content), "hash": integrity(content)}
             for name, content in contents.items() if name.endswith((".wasm", ".texts")) or name in ("game.js", "game-simd.js", "licences.txt")}
    for name in ("index.html", "page.js"):
        text = contents[name].decode()
        for word, value in (("VERSION", version), ("PARTS", json.dumps(parts)),
                            ("SIMD_PROBE", probe), ("TEXTS", texts)):
            text = text.replace(word, value)
        contents[name] = text.encode()

    hashes = {name: integrity(content) for name, content in sorted(contents.items())}
    hashes["./"] = hashes["index.html"]
    script = worker.read_text().replace("FILES", json.dumps(hashes)).replace("SIMD_PROBE", probe)
    for name, content in contents.items():
        (folder / name).write_bytes(content)
    # Last: it is what the build takes for the sign that all is there.
    (folder / worker.name).write_text(script)


main()
