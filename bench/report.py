#!/usr/bin/env python3
"""Makes tables of what carom-bench wrote: on the terminal, or in a document between its markers,
<!-- table NAME --> and <!-- end -->."""

import argparse
import json
import pathlib
import re

OURS = "carom"
CHIPMUNKS = ("chipmunk-tree", "chipmunk-hash")
# Shots a second with that many balls on the table, one core, as its authors published; not measured
# here, and of a model with spin.
FASTFIZ = {2: 75_700, 4: 28_300, 8: 9_100, 16: 2_540}


class Figures:
    def __init__(self, figures):
        self.machine = figures["machine"]
        self.rows = figures["rows"]
        self.cells = {}
        for row in self.rows:
            self.cells.setdefault((row["scene"], row["balls"]), {})[row["by"]] = row

    def scenes(self, shots):
        """((scene, balls), row by contestant) of shots, or of all that has a cost of its own."""
        for key, by in self.cells.items():
            is_shot = any("shots" in row for row in by.values())
            if is_shot if shots else not is_shot or key[0] == "BREAK":
                yield key, by


def value(row, key):
    return row.get(key) if row else None


def chipmunk(by):
    """The faster of its two ways to find pairs."""
    ways = [by[way] for way in CHIPMUNKS if way in by and "wrong" not in by[way]]
    return min(ways, key=lambda row: row["ns_per_ball_step"], default=None)


def number(figure, digits=3):
    if figure is None:
        return "–"
    if figure >= 10 ** digits:
        return f"{figure:,.0f}".replace(",", " ")
    return f"{figure:.{digits}g}" if figure == 0 or figure >= 0.001 else f"{figure:.0e}"


def cost(row):
    if row and "wrong" in row:
        return "wrong"
    return number(value(row, "ns_per_ball_step"))


def times(much, little):
    return "–" if much is None or little is None else f"{number(much / little)} ×"


def slower(row, ours):
    return times(value(row, "ns_per_ball_step"), value(ours, "ns_per_ball_step"))


def noise(by):
    """How much longer than its fastest repetition the slowest took, of whoever it was worst."""
    worst = max((row["nanoseconds"][-1] / row["nanoseconds"][0] for row in by.values()
                 if "nanoseconds" in row), default=1)
    return f"{100 * (worst - 1):.0f} %"


def count(balls):
    return f"{balls:,}".replace(",", " ")


def cost_table(figures):
    """Nanoseconds per ball and step."""
    lines = [["scene", "balls", "ours", "Chipmunk", "Box2D", "streaming", "to Chipmunk", "to Box2D",
              "noise"]]
    for (scene, balls), by in figures.scenes(shots=False):
        ours, box2d = by.get(OURS), by.get("box2d")
        lines.append([scene, count(balls), cost(ours), cost(chipmunk(by)), cost(box2d),
                      cost(by.get("streaming")), slower(chipmunk(by), ours), slower(box2d, ours),
                      noise(by)])
    return lines


def shot_table(figures):
    """Shots a second."""
    lines = [["scene", "balls", "ours", "Chipmunk", "Box2D", "FastFiz (published)", "to Chipmunk",
              "to Box2D", "to FastFiz", "noise"]]
    for (scene, balls), by in figures.scenes(shots=True):
        key = "shots_per_second"
        ours, chip = value(by.get(OURS), key), value(chipmunk(by), key)
        box2d = value(by.get("box2d"), key)
        fastfiz = FASTFIZ.get(balls) if scene == "BILLIARDS" else None
        lines.append([scene, count(balls), number(ours), number(chip), number(box2d),
                      number(fastfiz), times(ours, chip), times(ours, box2d), times(ours, fastfiz),
                      noise(by)])
    return lines


def chipmunk_table(figures):
    """Nanoseconds per ball and step of Chipmunk's two ways to find pairs."""
    lines = [["scene", "balls", "ours", "tree (its default)", "spatial hash", "to the tree",
              "to the hash"]]
    for (scene, balls), by in figures.cells.items():
        tree, hashed = (by.get(way) for way in CHIPMUNKS)
        if tree or hashed:
            ours = by.get(OURS)
            lines.append([scene, count(balls), cost(ours), cost(tree), cost(hashed),
                          slower(tree, ours), slower(hashed, ours)])
    return lines


def motion_table(figures):
    """Results: kinetic energy left, and the deepest overlap, after the last step."""
    lines = [["scene", "balls", "steps", "by", "energy kept", "speed, px/s", "mean height, px",
              "deepest overlap, px"]]
    for row in figures.rows:
        if "rms_speed" not in row or row["by"] == "streaming":
            continue
        before = row["rms_speed_before"]
        kept = number((row["rms_speed"] / before) ** 2) if before else "–"
        lines.append([row["scene"], count(row["balls"]), count(round(row["all_steps"])), row["by"], kept,
                      number(row["rms_speed"]), number(row["mean_height"]),
                      number(row["deepest_overlap"])])
    return lines


def variant_table(figures):
    """Nanoseconds per ball and step of other ways to run our engine; empty when none was run."""
    ways = sorted({row["by"] for row in figures.rows if row["by"].startswith(OURS + "-")})
    lines = [["scene", "balls", "ours"] + [way.removeprefix(OURS + "-") for way in ways]]
    for (scene, balls), by in figures.cells.items():
        if any(way in by for way in ways):
            lines.append([scene, count(balls), cost(by.get(OURS))] +
                         [cost(by.get(way)) for way in ways])
    return lines if ways else []


TABLES = {"cost": cost_table, "shots": shot_table, "chipmunk": chipmunk_table,
          "motion": motion_table, "variants": variant_table}


def text(lines):
    """Markdown, aligned so that it reads well as it is: names to the left, figures to the right."""
    if not lines:
        return "None in this run.\n"
    names = [all(not line[n][:1].isdigit() and line[n] not in ("–", "wrong") for line in lines)
             for n in range(len(lines[0]))]
    widths = [max(len(line[n]) for line in lines) for n in range(len(lines[0]))]
    rule = ["-" * width if name else "-" * (width - 1) + ":" for width, name in zip(widths, names)]
    result = ""
    for line in [lines[0], rule] + lines[1:]:
        cells = [cell.ljust(width) if name else cell.rjust(width)
                 for cell, width, name in zip(line, widths, names)]
        result += f"| {' | '.join(cells)} |\n"
    return result


def machine(figures):
    m = figures.machine
    return (f"{m['processor']}, {m['cores']} cores; {m['compiler']}, {m['flags']}; "
            f"Chipmunk {m['chipmunk']} and Box2D {m['box2d']} of Debian\n")


def update(document, figures):
    old = document.read_text(encoding="utf-8")

    def fill(match):
        name = match.group(1)
        body = machine(figures) if name == "machine" else text(TABLES[name](figures))
        return f"<!-- table {name} -->\n\n{body}\n<!-- end -->"

    document.write_text(re.sub(r"<!-- table (\w+) -->.*?<!-- end -->", fill, old, flags=re.DOTALL),
                        encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("figures", type=pathlib.Path, help="what carom-bench --json wrote")
    parser.add_argument("--update", type=pathlib.Path, metavar="DOCUMENT",
                        help="fill the tables of this document instead of printing them")
    options = parser.parse_args()
    figures = Figures(json.loads(options.figures.read_text(encoding="utf-8")))
    if options.update:
        update(options.update, figures)
        return
    print(machine(figures))
    print("Nanoseconds per ball and step, and how many times as long the others take")
    print(text(cost_table(figures)))
    print("Shots a second, and how many times as many we compute")
    print(text(shot_table(figures)))
    variants = variant_table(figures)
    if variants:
        print("Nanoseconds per ball and step of our engine run otherwise")
        print(text(variants))


main()
