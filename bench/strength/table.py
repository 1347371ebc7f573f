#!/usr/bin/env python3
"""Makes docs/strength.md of the games that `carom strength` played.

table.py LOG...          prints it; the logs of shards add up
table.py --merge LOG...  prints the games of all logs as one
table.py --check LOG PAGE CAROM   compares the page with the log, and plays ten games of it again
"""

import csv
import math
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
REPLAYED = 10


def read(paths):
    rows = {}
    for path in paths:
        with open(path, newline="") as file:
            for row in csv.DictReader(file):
                if row["versions"] == "versions":
                    continue  # a log appended to another
                key = (row["versions"], int(row["level_a"]), int(row["level_b"]), int(row["game"]))
                rows[key] = row
    return [rows[key] for key in sorted(rows)]


def levels():
    """(name, hand, simulations) from the source: the only place where they stand."""
    source = (ROOT / "src/search/opponent.hpp").read_text()
    found = re.findall(r'\{"(\w+)", \{([\d.]+)\}, (\d+)\}', source)
    if len(found) != 10:
        sys.exit(f"opponent.hpp: {len(found)} levels, not 10")
    return found


def wilson(hits, n, z=1.96):
    rate = hits / n
    scale = 1 + z * z / n
    middle = (rate + z * z / (2 * n)) / scale
    half = z / scale * math.sqrt(rate * (1 - rate) / n + z * z / (4 * n * n))
    return middle - half, middle + half


def elo(score):
    return 400 * math.log10(score / (1 - score)) if 0 < score < 1 else math.inf * (score - 0.5)


def signed(number):
    return "∞" if math.isinf(number) else f"{number:+.0f}"


def pair_row(a, b, games, names):
    n = len(games)
    wins = sum(int(game["points_a"]) > int(game["points_b"]) for game in games)
    losses = sum(int(game["points_a"]) < int(game["points_b"]) for game in games)
    draws = n - wins - losses
    low, high = wilson(wins, n)

    def mean(column, digits):
        return f"{sum(float(game[column]) for game in games) / n:.{digits}f}"

    turns = sum(int(game["turns_a"]) + int(game["turns_b"]) for game in games) / n
    # In game 2k a breaks, in 2k + 1 b.
    broken = sum((int(game["points_a"]) > int(game["points_b"])) == (int(game["game"]) % 2 == 0)
                 for game in games if game["points_a"] != game["points_b"])
    return (f"| {a} {names[a - 1][0]} – {b} {names[b - 1][0]} | {n} | {wins} | {draws} | {losses} "
            f"| {100 * wins / n:.1f} | {100 * low:.1f} – {100 * high:.1f} "
            f"| {signed(elo((wins + draws / 2) / n))} "
            f"| {mean('points_a', 0)} : {mean('points_b', 0)} "
            f"| {mean('fouls_a', 2)} : {mean('fouls_b', 2)} | {turns:.1f} "
            f"| {100 * broken / n:.0f} |")


def page(rows):
    names = levels()
    pairs = {}
    for row in rows:
        pairs.setdefault((int(row["level_a"]), int(row["level_b"])), []).append(row)
    simulations = sum(int(row["simulations_a"]) + int(row["simulations_b"]) for row in rows)
    seconds = sum(float(row["seconds"]) for row in rows)
    versions = sorted({row["versions"] for row in rows})
    lines = ["# Strength of the computer", "",
             "Made by `./run strength` from the games in `bench/strength/log.csv`; a test holds this",
             f"page to them and plays {REPLAYED} of them again.", "",
             "| level | name | hand: error of the drag, px | looks at, shots a turn |",
             "|---|---|---|---|"]
    for number, (name, hand, count) in enumerate(names, 1):
        lines.append(f"| {number} | {name} | {'exact' if hand == '0' else hand} | {count} |")
    head = ["| pair | games | won | drawn | lost | won, % | 95 % | Elo | points a game | fouls a game "
            "| turns a game | breaker won, % |",
            "|---|---|---|---|---|---|---|---|---|---|---|---|"]
    lines += ["", "A pair is two levels, the first of which is to be the stronger; they play the report's game "
              "from the", "rack, in pairs of games with the same random numbers, in which each breaks once. The "
              "interval is", "Wilson's.", "", "## Neighbours", ""] + head
    lines += [pair_row(a, b, games, names) for (a, b), games in sorted(pairs.items()) if a == b + 1]
    lines += ["", "## Others", ""] + head
    lines += [pair_row(a, b, games, names) for (a, b), games in sorted(pairs.items()) if a != b + 1]
    lines += ["", f"{len(rows)} games, {simulations} simulations in {seconds:.0f} s of one processor: "
              f"{simulations / seconds:.0f} a second", "with the choosing and the shots themselves. Versions of "
              f"physics, rules and search: {', '.join(versions)}.", "The seed of a pair's games 2k and 2k + 1 is "
              "(10 k + i) · 10 + j for the levels i and j, counted from 0.", ""]
    return "\n".join(lines)


def check(log, written, carom):
    rows = read([log])
    if page(rows) != pathlib.Path(written).read_text():
        sys.exit(f"{written} is not what {log} says: run bench/strength/table.py {log} > {written}")
    # Those that the log lacks are played: so take some out.
    taken = rows[::len(rows) // REPLAYED][:REPLAYED]
    games = max(int(row["game"]) for row in rows) + 1
    with tempfile.NamedTemporaryFile("w", suffix=".csv", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(row for row in rows if row not in taken)
        file.flush()
        again = subprocess.run([carom, "strength", "--games", str(games), "--played", file.name],
                               check=True, capture_output=True, text=True).stdout.splitlines()[1:]

    def line(row):
        return ",".join(value for column, value in row.items() if column != "seconds")

    expected = sorted(line(row) for row in taken)
    got = sorted(text.rpartition(",")[0] for text in again)
    if expected != got:
        sys.exit("other games than in the log:\n" + "\n".join(expected) + "\nnow:\n" + "\n".join(got))
    print(f"{len(rows)} games; {len(got)} played again, the same")


def merge(paths):
    rows = read(paths)
    writer = csv.DictWriter(sys.stdout, rows[0].keys(), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)


if sys.argv[1] == "--check":
    check(*sys.argv[2:])
elif sys.argv[1] == "--merge":
    merge(sys.argv[2:])
else:
    sys.stdout.write(page(read(sys.argv[1:])))
