#!/usr/bin/env python3
"""Draws cost against number of balls in GAS, both logarithmic, of what carom-bench wrote: an SVG."""

import argparse
import json
import math
import pathlib

WIDTH, HEIGHT = 760, 460
LEFT, RIGHT, TOP, BOTTOM = 70, 120, 56, 56
FONT = "font-family='Lato, DejaVu Sans, sans-serif'"
# by whom (the fastest of them counts), label, colour, dashes
SERIES = [
    (("box2d",), "Box2D", "#7a5195", ""),
    (("chipmunk-tree", "chipmunk-hash"), "Chipmunk", "#c2571a", ""),
    (("carom",), "ours", "#00695c", ""),
    (("streaming",), "streaming", "#6b6b6b", "6 4"),
]


def points(rows, names):
    best = {}
    for row in rows:
        if row["scene"] == "GAS" and row["by"] in names and "ns_per_ball_step" in row:
            balls = row["balls"]
            best[balls] = min(best.get(balls, math.inf), row["ns_per_ball_step"])
    return sorted(best.items())


def decades(figures):
    """The powers of ten around them, at least one decade."""
    low = math.floor(math.log10(min(figures)))
    return low, max(math.ceil(math.log10(max(figures))), low + 1)


def power(exponent):
    return f"{10 ** exponent:,}".replace(",", " ") if exponent >= 0 else f"{10 ** exponent:g}"


def draw(rows):
    series = [(points(rows, names), label, colour, dashes) for names, label, colour, dashes in SERIES]
    series = [entry for entry in series if entry[0]]
    everything = [point for entry in series for point in entry[0]]
    x_low, x_high = decades([balls for balls, _ in everything])
    y_low, y_high = decades([cost for _, cost in everything])

    def x(balls):
        share = (math.log10(balls) - x_low) / (x_high - x_low)
        return LEFT + share * (WIDTH - LEFT - RIGHT)

    def y(cost):
        share = (math.log10(cost) - y_low) / (y_high - y_low)
        return HEIGHT - BOTTOM - share * (HEIGHT - TOP - BOTTOM)

    out = [f"<svg xmlns='http://www.w3.org/2000/svg' width='{WIDTH}' height='{HEIGHT}' "
           f"viewBox='0 0 {WIDTH} {HEIGHT}' {FONT} font-size='14' fill='#333'>",
           f"<rect width='{WIDTH}' height='{HEIGHT}' fill='#ffffff'/>",
           f"<text x='{LEFT}' y='28' font-size='17' font-weight='bold'>"
           "GAS: nanoseconds per ball and step, one thread</text>"]
    for exponent in range(x_low, x_high + 1):
        at = x(10 ** exponent)
        out.append(f"<line x1='{at:.1f}' x2='{at:.1f}' y1='{TOP}' y2='{HEIGHT - BOTTOM}' "
                   "stroke='#e3e3e3'/>")
        out.append(f"<text x='{at:.1f}' y='{HEIGHT - BOTTOM + 22}' text-anchor='middle'>"
                   f"{power(exponent)}</text>")
    for exponent in range(y_low, y_high + 1):
        at = y(10 ** exponent)
        out.append(f"<line x1='{LEFT}' x2='{WIDTH - RIGHT}' y1='{at:.1f}' y2='{at:.1f}' "
                   "stroke='#e3e3e3'/>")
        out.append(f"<text x='{LEFT - 10}' y='{at + 5:.1f}' text-anchor='end'>{power(exponent)}</text>")
    out.append(f"<text x='{(LEFT + WIDTH - RIGHT) / 2}' y='{HEIGHT - 12}' text-anchor='middle'>"
               "balls</text>")

    labels = []
    for line, label, colour, dashes in series:
        path = " ".join(f"{x(balls):.1f},{y(cost):.1f}" for balls, cost in line)
        out.append(f"<polyline points='{path}' fill='none' stroke='{colour}' stroke-width='2.5' "
                   f"stroke-dasharray='{dashes}'/>")
        for balls, cost in line:
            out.append(f"<circle cx='{x(balls):.1f}' cy='{y(cost):.1f}' r='4' fill='{colour}'/>")
        labels.append([y(line[-1][1]) + 5, x(line[-1][0]) + 12, label, colour])
    # Labels at the ends of their lines, pushed apart.
    labels.sort()
    for above, below in zip(labels, labels[1:]):
        below[0] = max(below[0], above[0] + 18)
    for at_y, at_x, label, colour in labels:
        out.append(f"<text x='{at_x:.1f}' y='{at_y:.1f}' fill='{colour}' font-weight='bold'>"
                   f"{label}</text>")
    out.append("</svg>")
    return "\n".join(out) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("figures", type=pathlib.Path, help="what carom-bench --json wrote")
    parser.add_argument("picture", type=pathlib.Path)
    options = parser.parse_args()
    rows = json.loads(options.figures.read_text(encoding="utf-8"))["rows"]
    options.picture.write_text(draw(rows), encoding="utf-8")


main()
