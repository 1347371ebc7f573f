#!/usr/bin/env python3
"""The picture of a quadtree is XML with finite numbers, at the bounds of what a scene may be: the
smallest and largest sizes, coordinates next to nothing and far outside, no balls."""

import argparse
import itertools
import json
import math
import re
import subprocess
import sys
import xml.etree.ElementTree

SIZES = (0.001, 1.0000000000000002, 1e9)
COORDINATES = (5e-324, 2.2250738585072014e-308, 0.001, 1e9, -1e9)
NUMBERS = re.compile(r"^-?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$", re.IGNORECASE)
NUMERIC = {"x", "y", "width", "height", "cx", "cy", "r", "stroke-width", "fill-opacity"}


def fault(carom, scene):
    run = subprocess.run([carom, "quadtree", "-", "--svg", "-"], input=json.dumps(scene),
                         capture_output=True, text=True, timeout=60)
    if run.returncode != 0:
        return f"exit {run.returncode}: {run.stderr}"
    try:
        root = xml.etree.ElementTree.fromstring(run.stdout)
    except xml.etree.ElementTree.ParseError as error:
        return f"is no XML: {error}"
    for element in root.iter():
        for name, value in element.attrib.items():
            if name in NUMERIC and not (NUMBERS.match(value) and math.isfinite(float(value))):
                return f"{element.tag} has {name}='{value}'"
            if name in ("width", "height", "r") and float(value) < 0:
                return f"{element.tag} has {name}='{value}'"
    if len(root.findall(".//{*}circle")) != len(scene["balls"]):
        return "not every ball is drawn"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("carom")
    carom = parser.parse_args().carom
    faults = []
    count = 0
    for width, height, radius in itertools.product(SIZES, repeat=3):
        for places in ([], *([(x, y)] for x, y in itertools.product(COORDINATES, repeat=2)),
                       [(x, x) for x in COORDINATES]):
            scene = {"carom": 1, "width": width, "height": height,
                     "edges": {side: "open" for side in ("left", "right", "bottom", "top")},
                     "balls": [{"x": x, "y": y, "radius": radius} for x, y in places]}
            # Some of each kind are enough: each is a start of the program.
            count += 1
            if count % 7 != 1:
                continue
            if found := fault(carom, scene):
                faults.append(f"{json.dumps(scene)}: {found}")
    if faults:
        sys.exit("\n".join(faults[:10]))
    print(f"{count // 7 + 1} pictures are sound")


main()
