#!/usr/bin/env python3
"""Makes docs/levels.md of the proofs that `carom prove` wrote beside the levels.

table.py               prints it
table.py --check PAGE  compares the page with the proofs
"""

import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent

HEAD = """# Levels

How hard the levels are that we ship, measured. `./run levels` proves them anew (`carom prove`) and makes this
page of the proofs, which lie beside the levels (docs/formats.md, docs/search.md).

- **Difficulty**: 1 − the part of 200 games that the reference player wins, who has a hand of 4 px, looks at
  200 throws before each of his own, and has the throws of the level; with the interval that holds the true
  value in 95 of 100 cases. A flame for each fifth.
- **Hands**: won by such players with other hands, in per cent; **random**: by one whose drags are uniform.
- **Margin**: what every throw of the proof may be off alone, 0.1° going with 2 px/s.
- **Stars**: the first is for winning, the second for winning within *par*, the fewest throws in which the
  hand of 2 px wins half its games, the third for *gold*, the score that the best tenth of its games reaches.
"""
COLUMNS = ("level", "difficulty", "", "0 px", "1 px", "2 px", "4 px", "8 px", "random", "throws", "margin",
           "par", "gold")


def packs():
    """The folders with levels, ours first; the levels of each in their order."""
    for folder in sorted({path.parent for path in (ROOT / "levels").rglob("*.proof.json")}):
        yield folder, sorted(folder.glob("*.proof.json"))


def row(number, path):
    proof = json.loads(path.read_text())
    level = json.loads(path.with_name(path.name.replace(".proof.json", ".json")).read_text())
    difficulty = proof["difficulty"]
    flames = min(5, 1 + int(5 * difficulty["rate"]))
    margin = min(throw["margin"]["degrees"] for throw in proof["throws"])
    return [f"{number} {level['name']}", f"{difficulty['rate']:.2f} [{difficulty['low']:.2f}, "
            f"{difficulty['high']:.2f}]", "🔥" * flames,
            *(f"{100 * hand['rate']:.0f}" for hand in proof["hands"]), f"{100 * proof['random']['rate']:.1f}",
            str(len(proof["throws"])), f"± {margin:.1f}°", str(proof["stars"]["par"]),
            str(proof["stars"]["gold"])]


def page():
    lines = [HEAD]
    for folder, proofs in packs():
        lines += [f"## {folder.relative_to(ROOT).as_posix()}", "", "| " + " | ".join(COLUMNS) + " |",
                  "|---|---|---" + "|--:" * (len(COLUMNS) - 3) + "|"]
        lines += ["| " + " | ".join(row(number, path)) + " |" for number, path in enumerate(proofs, 1)]
        lines.append("")
    return "\n".join(lines)


def main():
    if sys.argv[1:2] != ["--check"]:
        print(page(), end="")
    elif pathlib.Path(sys.argv[2]).read_text(encoding="utf-8") != page():
        sys.exit("docs/levels.md is not what the proofs say: python3 bench/levels/table.py >docs/levels.md")


main()
