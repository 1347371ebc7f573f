#!/usr/bin/env python3
"""Runs every fuzzer of a build tree for some seconds, one after the other.

Each starts from its folders (fuzz/CMakeLists.txt), from fuzz/corpus/NAME and from what it found
before, which is kept in BUILD/fuzz/found/NAME. An input that breaks something is left in
BUILD/fuzz/broken/NAME-…: run fuzz-NAME with it as the argument to see it again. --minimize writes
fuzz/corpus/NAME anew: the fewest inputs that reach all branches reached so far, without the seeds.
"""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=pathlib.Path, help="build tree")
    parser.add_argument("--seconds", type=int, default=30, help="for each fuzzer [30]")
    parser.add_argument("--only", metavar="NAME", help="run this fuzzer only")
    parser.add_argument("--minimize", action="store_true", help="write the corpora anew, do not fuzz")
    options = parser.parse_args()

    build = options.build.resolve()
    failed = []
    for line in (build / "fuzz/fuzzers.txt").read_text().splitlines():
        name, *seeds = line.split()
        if options.only not in (None, name):
            continue
        program = build / f"fuzz-{name}"
        corpus = ROOT / "fuzz/corpus" / name
        found = build / "fuzz/found" / name
        broken = build / "fuzz/broken"
        found.mkdir(parents=True, exist_ok=True)
        broken.mkdir(parents=True, exist_ok=True)
        seeds = [ROOT / seed for seed in seeds]
        if options.minimize:
            minimize(program, corpus, found, seeds)
            continue
        folders = [folder for folder in [found, corpus, *seeds] if folder.is_dir()]
        run = subprocess.run(
            # Long inputs from the start: half a minute of short ones plays no game.
            [program, "-len_control=0", f"-max_total_time={options.seconds}", "-timeout=10",
             "-rss_limit_mb=2048", "-print_final_stats=1", f"-artifact_prefix={broken}/{name}-", *folders],
            capture_output=True, encoding="utf-8", errors="replace",
            env=dict(os.environ, UBSAN_OPTIONS="print_stacktrace=1"))
        if run.returncode != 0:
            failed.append(name)
            print(f"{name}: FAILED\n{run.stderr[-6000:]}")
            continue
        count = re.search(r"number_of_executed_units: (\d+)", run.stderr).group(1)
        covered = re.findall(r"cov: (\d+)", run.stderr)[-1]
        print(f"{name}: {options.seconds} s, {count} inputs, {covered} branches, nothing found",
              flush=True)
    if failed:
        sys.exit("broken: " + ", ".join(failed))


def minimize(program, corpus, found, seeds):
    """Merges into a folder that begins with the seeds and takes away these again."""
    merged = found.parent / f"{found.name}.merged"
    shutil.rmtree(merged, ignore_errors=True)
    merged.mkdir()
    known = set()
    for seed in seeds:
        for path in sorted(seed.iterdir()):
            if path.is_file():
                shutil.copy(path, merged)
                known.add(path.name)
    folders = [folder for folder in (corpus, found) if folder.is_dir()]
    subprocess.run([program, "-set_cover_merge=1", "-use_counters=0", merged, *folders],
                   check=True, capture_output=True)
    shutil.rmtree(corpus, ignore_errors=True)
    corpus.mkdir(parents=True)
    for path in sorted(merged.iterdir()):
        if path.name not in known and path.stat().st_size <= 1024:
            shutil.copy(path, corpus)
    shutil.rmtree(merged)
    print(f"{corpus.name}: {len(list(corpus.iterdir()))} inputs")


main()
