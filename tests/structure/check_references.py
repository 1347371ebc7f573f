#!/usr/bin/env python3
"""Whatever refers to a section of the documents, docs/NAME.md#anchor, finds it; nothing refers to a
document that the repository does not have."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FOLDERS = ("include", "src", "tests", "bench", "fuzz", "examples", "docs", "po", "web")
KINDS = {".hpp", ".cpp", ".py", ".md", ".mjs", ".js", ".txt"}


def anchors(page):
    """As GitHub makes them of headings."""
    headings = re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def main():
    known = {page.name: anchors(page) for page in (ROOT / "docs").glob("*.md")}
    wrong = found = 0
    files = [path for folder in FOLDERS for path in sorted((ROOT / folder).rglob("*"))]
    for path in [*files, *ROOT.glob("*.md")]:
        if path.suffix not in KINDS or path == pathlib.Path(__file__).resolve():
            continue
        text = path.read_text(encoding="utf-8", errors="replace")
        # In a comment a reference may go on in the next line.
        here = re.findall(r"docs/(\w+\.md)(?:#([\w-]+))?", text)
        if path.parent == ROOT / "docs":
            here += re.findall(r"\]\((\w+\.md)?#([\w-]+)\)", text)
        for page, anchor in here:
            page = page or path.name
            found += 1
            if page not in known or (anchor and anchor not in known[page]):
                print(f"{path.relative_to(ROOT)}: docs/{page}#{anchor} is not there")
                wrong += 1
        if re.search(r"\bspec §", text):
            print(f"{path.relative_to(ROOT)}: spec § is no section of these documents")
            wrong += 1
    print(f"{found} references, {wrong} wrong")
    sys.exit(wrong != 0 or found < 20)


main()
