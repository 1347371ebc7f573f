#!/usr/bin/env python3
"""Measures shots a second of this tree's engine beside those of a commit, one after the other in
short turns, so that what else the machine does disturbs both alike. Every row's hash must be the same
on both sides, with and without skipping, and that of bench/golden.txt. ./run bench --baseline COMMIT
calls it."""

import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FOLDER = ROOT / "build" / "compare"
# Shots a second with that many balls on the table, one core, as its authors published.
FASTFIZ = {"BILLIARDS/2": 75_700, "BILLIARDS/4": 28_300, "BILLIARDS/8": 9_100, "BILLIARDS/16": 2_540}
TABLES = ["BREAK/37", "BILLIARDS/37", "BREAKS/37", "SCATTERED/37", "BILLIARDS/16", "BILLIARDS/8",
          "BILLIARDS/4", "BILLIARDS/2"]
PEERS = ("chipmunk-tree", "chipmunk-hash", "box2d")


class Driver:
    """bench/compare/shots.cpp with one commit of the engine."""

    def __init__(self, name, engine):
        build = FOLDER / f"{name}-build"
        self.program = build / "shots"
        for command in (["cmake", "-S", ROOT / "bench/compare", "-B", build, "-G", "Ninja",
                         "-DCMAKE_BUILD_TYPE=Release", f"-DENGINE={engine}"],
                        ["ninja", "-C", build, "shots"]):
            done = subprocess.run(command, capture_output=True, encoding="utf-8")
            if done.returncode != 0:
                sys.exit(f"{done.stdout}\n{done.stderr}\ncannot build the engine of {name}")

    def command(self, workload, how, seconds, passes=0):
        return [self.program, ROOT / "levels", workload, how, str(seconds), str(passes)]

    def run(self, workload, how, seconds):
        done = subprocess.run(self.command(workload, how, seconds), capture_output=True,
                              encoding="utf-8", check=True)
        return json.loads(done.stdout)

    def instructions(self, workload, how):
        """Of one pass, start-up left out; none where nothing counts them."""
        return None if (one := self.count(workload, how, 1)) is None else (
            self.count(workload, how, 2) - one)

    def count(self, workload, how, passes):
        command = self.command(workload, how, 0, passes)
        if COUNTER == "perf":
            done = subprocess.run(["perf", "stat", "-x,", "-e", "instructions:u", *command],
                                  capture_output=True, encoding="utf-8", check=True)
            return int(done.stderr.split(",")[0])
        if COUNTER == "valgrind":
            with tempfile.NamedTemporaryFile() as out:
                subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={out.name}",
                                *command], capture_output=True, check=True)
                text = pathlib.Path(out.name).read_text(encoding="utf-8")
            return int(re.search(r"^(?:summary|totals): (\d+)", text, re.MULTILINE)[1])
        return None


def counter():
    """Returns the program that counts instructions here."""
    if shutil.which("perf"):
        tried = subprocess.run(["perf", "stat", "-x,", "-e", "instructions:u", "true"],
                               capture_output=True, encoding="utf-8")
        if tried.returncode == 0 and tried.stderr.split(",")[0].isdigit():
            return "perf"
    return "valgrind" if shutil.which("valgrind") else None


COUNTER = counter()


class Side:
    """Result of one way to run a workload, over all turns."""

    def __init__(self, driver, how):
        self.driver, self.how = driver, how
        self.seconds = []
        self.last = None

    def turn(self, workload, seconds):
        self.last = self.driver.run(workload, self.how, seconds)
        self.seconds.append(self.last["seconds"])

    @property
    def best(self):
        return min(self.seconds)

    @property
    def rate(self):
        return self.last["shots"] / self.best

    @property
    def noise(self):
        """How much longer than the best turn's fastest pass that of the worst turn took."""
        return max(self.seconds) / self.best - 1


def measure(workload, sides, golden, turns, seconds):
    for _ in range(turns):
        for side in sides:
            side.turn(workload, seconds)
    hashes = {side.last["hash"] for side in sides}
    if workload in golden and sides[0].how != "copy":
        hashes.add(golden[workload])
    if len(hashes) != 1:
        sys.exit(f"{workload}: not the same hash: {', '.join(sorted(hashes))}")


def number(figure, digits=3):
    if figure is None:
        return "–"
    if figure >= 10 ** digits:
        return f"{figure:,.0f}".replace(",", " ")
    return f"{figure:.{digits}g}"


def times(ratio):
    return "–" if ratio is None else f"{ratio:.3g} ×"


def table(lines):
    widths = [max(len(line[n]) for line in lines) for n in range(len(lines[0]))]
    for at, line in enumerate(lines):
        cells = [cell.ljust(width) if n == 0 else cell.rjust(width)
                 for n, (cell, width) in enumerate(zip(line, widths))]
        print(f"| {' | '.join(cells)} |")
        if at == 0:
            print("|" + "|".join("-" * (width + 2) if n == 0 else "-" * (width + 1) + ":"
                                 for n, width in enumerate(widths)) + "|")
    print(flush=True)


def peers(program):
    """Shots a second of BREAK by the faster Chipmunk, and by Box2D."""
    figures = FOLDER / "peers.json"
    if not program or subprocess.run(
            [program, "--scene", "BREAK", *(f"--by={peer}" for peer in PEERS), "--json", figures],
            capture_output=True).returncode != 0:
        return {}
    rows = json.loads(figures.read_text(encoding="utf-8"))["rows"]
    rates = {row["by"]: row["shots_per_second"] for row in rows}
    return {"Chipmunk": max(rates[peer] for peer in PEERS[:2]), "Box2D": rates["box2d"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("commit", help="the baseline")
    parser.add_argument("--bench", help="carom-bench, for the peers")
    parser.add_argument("--scene", action="append", help="only rows that begin so: BREAK, LEVEL, …")
    parser.add_argument("--turns", type=int, default=5, help="of each side of each row")
    parser.add_argument("--seconds", type=float, default=0.1, help="of a turn")
    parser.add_argument("--json", type=pathlib.Path, default=ROOT / "build/baseline.json")
    options = parser.parse_args()

    def git(*arguments):
        return subprocess.run(["git", "-C", ROOT, *arguments], check=True, capture_output=True).stdout

    commit = git("rev-parse", "--verify", options.commit + "^{commit}").decode().strip()
    sources = FOLDER / commit
    if not sources.exists():
        FOLDER.mkdir(parents=True, exist_ok=True)
        aside = FOLDER / f"{commit}.part"
        shutil.rmtree(aside, ignore_errors=True)
        aside.mkdir()
        subprocess.run(["tar", "-x", "-C", aside], input=git("archive", commit), check=True)
        aside.rename(sources)
    old = Driver(commit, sources)
    new = Driver("this", ROOT)

    golden = dict(line.split() for line in (ROOT / "bench/golden.txt").read_text().splitlines())
    # A level is called by its number alone.
    golden |= {name.split("/")[0]: hash_ for name, hash_ in golden.items() if "LEVEL" in name}
    levels = sorted(f"LEVEL-{path.name[:2]}" for path in (ROOT / "levels").glob("*.json")
                    if not path.name.endswith((".proof.json", "pack.json")))
    wanted = lambda row: not options.scene or any(row.startswith(scene) for scene in options.scene)
    rates = peers(options.bench) if wanted("BREAK") else {}
    rows = []

    print(f"Shots a second, one core, beside {commit[:7]}; instructions by {COUNTER or 'nobody'}\n")
    lines = [["shots", "baseline", "this tree", "ratio", "instructions", "never skip", "to FastFiz",
              "to Chipmunk", "to Box2D", "noise"]]
    old_total = new_total = 0
    for workload in filter(wanted, TABLES + levels):
        sides = [Side(old, "run"), Side(new, "run"), Side(new, "never-skip")]
        measure(workload, sides, golden, options.turns, options.seconds)
        before, now, never = sides[:3]
        counts = [side.driver.instructions(workload, "run") for side in (before, now)]
        fewer = None if None in counts else counts[0] / counts[1]
        row = {"row": workload, "baseline": before.rate, "shots_per_second": now.rate,
               "ratio": now.rate / before.rate, "instructions": counts, "never_skip": never.rate,
               "fastfiz": FASTFIZ.get(workload),
               "noise": max(side.noise for side in sides)}
        rows.append(row)
        if workload.startswith("LEVEL"):
            old_total += before.best
            new_total += now.best
        to = lambda rate: times(now.rate / rate) if rate else "–"
        in_break = workload == "BREAK/37"
        lines.append([workload, number(before.rate), number(now.rate), times(row["ratio"]),
                      times(fewer), times(now.rate / never.rate), to(FASTFIZ.get(workload)),
                      to(in_break and rates.get("Chipmunk")), to(in_break and rates.get("Box2D")),
                      f"{100 * row['noise']:.0f} %"])
    if new_total:
        lines.append(["levels in total", "", "", times(old_total / new_total)] + [""] * 6)
        rows.append({"row": "levels in total", "ratio": old_total / new_total})
    table(lines)

    lines = [["step() singly, shots a second", "baseline", "this tree", "ratio", "noise"]]
    for workload in filter(wanted, ("BILLIARDS/16", "BILLIARDS/2")):
        sides = [Side(old, "step"), Side(new, "step")]
        measure(workload, sides, golden, options.turns, options.seconds)
        before, now = sides
        ratio = now.rate / before.rate
        noise = max(before.noise, now.noise)
        rows.append({"row": f"step {workload}", "baseline": before.rate, "shots_per_second": now.rate,
                     "ratio": ratio, "noise": noise})
        lines.append([workload, number(before.rate), number(now.rate), times(ratio),
                      f"{100 * noise:.0f} %"])
    table(lines)

    lines = [["assignment of a world, ns", "baseline", "this tree", "noise"]]
    for workload in filter(wanted, ("SCATTERED/37", "BILLIARDS/16", "BILLIARDS/2")):
        sides = [Side(old, "copy"), Side(new, "copy")]
        measure(workload, sides, golden, options.turns, options.seconds)
        before, now = (1e9 / side.rate for side in sides)
        noise = max(side.noise for side in sides)
        rows.append({"row": f"copy {workload}", "baseline": before, "nanoseconds": now, "noise": noise})
        lines.append([workload, number(before), number(now), f"{100 * noise:.0f} %"])
    table(lines)
    options.json.write_text(json.dumps({"baseline": commit, "rows": rows}, indent=1) + "\n",
                            encoding="utf-8")


main()
