#!/usr/bin/env python3
"""Installs the packages that ./run package made in a bare Debian, uses and purges them:
chroot.py FOLDER_OF_PACKAGES. Needs root, debootstrap and a mirror."""

import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def run(*command, **options):
    ran = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    if ran.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: {ran.returncode}\n{ran.stdout[-3000:]}{ran.stderr[-3000:]}")
    return ran.stdout


def main():
    packages = sorted(pathlib.Path(sys.argv[1]).glob("*.deb"))
    if len(packages) < 3:
        sys.exit(f"{sys.argv[1]} has {packages}: ./run package makes them")
    with tempfile.TemporaryDirectory() as name:
        chroot = pathlib.Path(name) / "debian"
        run("debootstrap", "--variant=minbase", "bookworm", chroot)

        def inside(*command):
            return run("chroot", chroot, "env", "DEBIAN_FRONTEND=noninteractive", "LC_ALL=C.UTF-8", *command)

        def files():
            return set(inside("find", "/usr", "/etc", "-xdev", "-path", "*ngry*", "-o", "-path", "*carom*")
                       .splitlines())

        before = files()
        shutil.copytree(ROOT / "demos", chroot / "root/demos")
        shutil.copytree(ROOT / "levels", chroot / "root/levels")
        shutil.copytree(ROOT / "tests/replays", chroot / "root/replays")
        for package in packages:
            if "dbgsym" not in package.name:
                shutil.copy(package, chroot / "root")
        inside("sh", "-c", "apt-get update -q && apt-get install -y -q --no-install-recommends "
               "/root/*.deb shared-mime-info pkgconf xdg-utils g++")
        print(inside("carom", "--version"), end="")
        print(inside("/usr/games/angry-balls", "--script", "/root/demos/billiards.jsonl"), end="")
        inside("carom", "replay", "/root/replays/level-09-won.json", "--verify")
        shutil.copy(chroot / "root/levels/01-first-steps.json", chroot / "root/mine.angry-level")
        kind = inside("sh", "-c", "XDG_UTILS_DEBUG_LEVEL=0 xdg-mime query filetype /root/mine.angry-level").strip()
        opens = inside("xdg-mime", "query", "default", "application/x-angry-balls-level").strip()
        if kind != "application/x-angry-balls-level" or not opens.startswith("io.github.angry_balls"):
            sys.exit(f"a level is {kind}, opened by {opens}")
        shutil.copy(ROOT / "examples/simulate_break.cpp", chroot / "root/user.cpp")
        shutil.copy(ROOT / "scenes/break.json", chroot / "root/break.json")
        inside("sh", "-c", "cd /root && g++ -std=c++20 user.cpp $(pkg-config --cflags --libs carom) -o user "
               "&& ./user break.json")
        inside("apt-get", "purge", "-y", "-q", "angry-balls", "carom", "libcarom-dev")
        if left := files() - before:
            sys.exit(f"left after the purge: {sorted(left)}")
        print("nothing is left after the purge")


main()
