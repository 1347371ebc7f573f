#!/usr/bin/env python3
"""Prints the project's CMake targets as a Mermaid diagram, links that others imply left out:

    cmake --preset release --graphviz=build/targets.dot && docs/images/targets.py build/targets.dot
"""

import re
import sys


def read(path):
    """Returns target → the targets that it links, the project's own only."""
    with open(path, encoding="utf-8") as file:
        links = re.findall(r"// ([\w:-]+) -> ([\w:-]+)$", file.read(), re.MULTILINE)
    targets = {}
    for user, library in links:
        if re.search(r"-tests$|^fuzz|^example-|^(pictures|golden-hashes|project_warnings|carom_warnings)$", user):
            continue
        targets.setdefault(user, set())
        # A library that links nothing has no line of its own; others' have "::" in their names.
        if "::" not in library and not library.endswith("_warnings"):
            targets[user].add(library)
            targets.setdefault(library, set())
    return targets


def reach(targets, start):
    """Returns all that `start` links, directly or through others."""
    found = set()
    open_ends = list(targets[start])
    while open_ends:
        target = open_ends.pop()
        if target not in found:
            found.add(target)
            open_ends += targets[target]
    return found


def main():
    targets = read(sys.argv[1])
    print("graph TD")
    for user in sorted(targets):
        links = targets[user]
        implied = set().union(*(reach(targets, library) for library in links)) if links else set()
        for library in sorted(links - implied):
            print(f"  {user} --> {library}")


if __name__ == "__main__":
    main()
