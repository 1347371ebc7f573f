#!/usr/bin/env python3
"""Checks the po files: by msgfmt, and what only this project knows. Says what is not translated."""

import json
import re
import subprocess
import sys

import po_files

SIGNS = "CcOokB|"
faults = 0


def fault(path, entry, what):
    global faults
    faults += 1
    print(f"{path.name}: {entry.context}: {what}\n  {entry.texts()}", file=sys.stderr)


def values(text):
    return set(re.findall(r"\{.*?\}", text))


def check_text(path, entry, english, text):
    for value in values(text) - values(english):
        fault(path, entry, f"{value} is not in the English text")
    # A reason may be told without its details.
    if not entry.context.startswith("fault_"):
        for value in values(english) - values(text):
            fault(path, entry, f"{value} is missing")
    for sign in re.findall(r"\[(.*?)\]", text):
        if sign not in SIGNS or len(sign) != 1:
            fault(path, entry, f"[{sign}] has no meaning; expected one of {' '.join(SIGNS)}")
    for layout in ("[|]", "\t", "\n"):
        if text.count(layout) != english.count(layout):
            fault(path, entry, f"{english.count(layout)} times {layout!r} expected")
    if "  " in text or (text != text.strip(" ") and english == english.strip(" ")):
        fault(path, entry, "has a space too many")


def main():
    template = po_files.read(po_files.TEMPLATE)
    for path in [po_files.TEMPLATE, *po_files.translations().values()]:
        # Its warnings, of headers that nothing here needs, count for nothing.
        command = ["msgfmt", "--check", "--output-file=/dev/null", path]
        if subprocess.run(command, capture_output=True, check=False).returncode != 0:
            sys.exit(subprocess.run(command, check=False).returncode)
        entries = po_files.read(path)
        forms = int(re.search(r"nplurals=(\d+)", po_files.header(entries, "Plural-Forms"))[1])
        missing = 0
        for key, entry in entries.items():
            if key == ("", ""):
                continue
            if key not in template:
                fault(path, entry, "is not in the template: msgmerge --update brings the file up to it")
                continue
            missing += path != po_files.TEMPLATE and "" in entry.texts()
            texts = entry.english() if path == po_files.TEMPLATE else entry.texts()
            if texts == [""]:
                continue
            if entry.plural is not None and len(texts) != forms:
                fault(path, entry, f"{forms} plural forms expected")
            for text in texts:
                check_text(path, entry, entry.english()[-1], text)
        missing += len(template.keys() - entries.keys())
        if missing:
            print(f"{path.name}: {missing} texts are not translated: they are English")
    for level in sorted((po_files.FOLDER.parent / "levels").glob("*.json")):
        if level.name.endswith((".proof.json", "pack.json")):
            continue
        name = json.loads(level.read_text(encoding="utf-8"))["name"]
        if (po_files.LEVELS, name) not in template:
            sys.exit(f"{po_files.TEMPLATE.name}: the level's name {name!r} is missing")
    sys.exit(faults != 0)


main()
