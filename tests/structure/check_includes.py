#!/usr/bin/env python3
"""Includes go one way (docs/architecture.md): between layers, between the modules of src/app, and
nobody but the engine sees its private headers. No file of src/app is too long. The modules and what they may use are read from the
app_module() calls of src/app/CMakeLists.txt. The rules are tried on examples before they are used.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent

# The folders of src/, lowest first. A layer may use those before it. Those of one line do not know
# each other.
LAYERS = (
    ("json",),
    ("carom",),
    ("games", "files", "licences"),
    ("replay",),
    ("soak", "search", "cli"),
    ("app",),
    ("platform", "tool"),
)
RANK = {name: rank for rank, names in enumerate(LAYERS) for name in names}

# Folders whose sources may use every layer.
ABOVE = ("tests", "fuzz", "bench", "examples")
PRIVATE = "carom/internal/"
# The folders of include/.
PUBLIC = ("carom", "games")
# The tests that reach inside the engine.
INSIDE = ("tests/threads/threads_test.cpp",)

MOST_LINES = 400  # of a file of src/app

INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)
MODULE = re.compile(r"^app_module\((\w+)([^)]*)\)", re.MULTILINE)


def read_modules(cmake):
    """name → the modules that it may use, its own included. Wrong when one uses a later one."""
    reach = {}
    for name, libraries in MODULE.findall(cmake):
        reach[name] = {name}
        for library in libraries.split():
            if library.startswith("app_"):
                used = library.removeprefix("app_")
                if used not in reach:
                    raise ValueError(f"app_module({name}) uses {library}, which is not above it")
                reach[name] |= reach[used]
    return reach


def problem(path, include, modules):
    """Returns the fault of `include` in the file `path` (from the root); none if it is fine."""
    parts = pathlib.PurePosixPath(path).parts
    target = pathlib.PurePosixPath(include).parts
    public = parts[0] == "include"
    layer = parts[1] if public or parts[0] == "src" else None

    if include.startswith(PRIVATE) and (layer != "carom" or public) and path not in INSIDE:
        return "a private header of the engine"
    if layer is None or target[0] not in RANK:
        return None
    if public and target[0] not in PUBLIC:
        return f"the public interface does not use {target[0]}"
    if layer not in RANK:
        return f"src/{layer} is in no layer"
    if target[0] != layer and RANK[target[0]] >= RANK[layer]:
        return f"{layer} does not use {target[0]}"
    if layer == target[0] == "app":
        # App itself, in the folder's own files, is above all modules.
        user = parts[2] if len(parts) > 3 else None
        used = target[1] if len(target) > 2 else None
        if user is None:
            return None
        if user not in modules:
            return f"src/app/{user} is no module"
        if used is None or used not in modules[user]:
            return f"the module {user} does not use {used or 'App'}"
    return None


def too_long(path, text):
    """A file of src/app does one thing. The texts are a table of all words."""
    return (path.startswith("src/app/") and not path.startswith("src/app/text/") and
            text.count("\n") > MOST_LINES)


EXAMPLE = """
app_module(base)
app_module(text)
app_module(input app_base carom)
app_module(screens app_input app_text)
"""
GOOD = (
    ("src/app/screens/a.cpp", "app/base/b.hpp"),
    ("src/app/screens/a.cpp", "app/screens/b.hpp"),
    ("src/app/app.cpp", "app/screens/b.hpp"),
    ("src/app/input/a.hpp", "carom/world.hpp"),
    ("src/app/input/a.hpp", "replay/replay.hpp"),
    ("src/platform/a.cpp", "app/app.hpp"),
    ("src/carom/a.cpp", "carom/internal/b.hpp"),
    ("src/carom/a.cpp", "json/b.hpp"),
    ("src/tool/a.cpp", "tool/b.hpp"),
    ("tests/app/a.cpp", "app/screens/b.hpp"),
    ("include/carom/a.hpp", "carom/b.hpp"),
    ("include/games/a.hpp", "carom/b.hpp"),
)
BAD = (
    ("src/app/base/a.cpp", "app/input/b.hpp"),
    ("src/app/input/a.cpp", "app/text/b.hpp"),
    ("src/app/input/a.cpp", "app/app.hpp"),
    ("src/app/other/a.cpp", "app/base/b.hpp"),
    ("src/app/input/a.cpp", "platform/b.hpp"),
    ("src/app/input/a.cpp", "carom/internal/b.hpp"),
    ("src/replay/a.cpp", "app/base/b.hpp"),
    ("src/replay/a.cpp", "carom/internal/b.hpp"),
    ("src/games/a.cpp", "replay/b.hpp"),
    ("src/games/a.cpp", "files/b.hpp"),
    ("src/carom/a.cpp", "games/b.hpp"),
    ("src/tool/a.cpp", "platform/b.hpp"),
    ("src/tool/a.cpp", "carom/internal/b.hpp"),
    ("src/new/a.cpp", "carom/b.hpp"),
    ("include/carom/a.hpp", "carom/internal/b.hpp"),
    ("include/carom/a.hpp", "json/b.hpp"),
    ("tests/carom/a.cpp", "carom/internal/b.hpp"),
)


def try_rules():
    modules = read_modules(EXAMPLE)
    for path, include in GOOD:
        if problem(path, include, modules):
            sys.exit(f"{path} may include {include}, but: {problem(path, include, modules)}")
    for path, include in BAD:
        if not problem(path, include, modules):
            sys.exit(f"{path} must not include {include}, and no rule says so")
    lines = "\n" * MOST_LINES
    if too_long("src/app/a/b.cpp", lines) or too_long("src/carom/b.cpp", lines + "\n"):
        sys.exit("a file is too long, and is not")
    if not too_long("src/app/a/b.cpp", lines + "\n"):
        sys.exit("a file that is too long is not found")
    try:
        read_modules("app_module(a app_b)\napp_module(b)\n")
        sys.exit("a module that uses a later one is not found")
    except ValueError:
        pass


def main():
    try_rules()
    modules = read_modules((ROOT / "src/app/CMakeLists.txt").read_text())
    folders = {path.name for path in (ROOT / "src/app").iterdir() if path.is_dir()}
    if folders != set(modules):
        sys.exit(f"src/app: folders {sorted(folders)}, modules {sorted(modules)}")
    picture = (ROOT / "docs/images/modules.svg").read_text()
    for box in list(modules) + [name for name in RANK if (ROOT / "src" / name).is_dir()]:
        if f">{box}<" not in picture:
            sys.exit(f"docs/images/modules.svg has no box {box}")
    wrong = 0
    includes = 0
    for top in ("include", "src") + ABOVE:
        for path in sorted((ROOT / top).rglob("*.?pp")):
            name = path.relative_to(ROOT).as_posix()
            text = path.read_text()
            if too_long(name, text):
                print(f"{name}: more than {MOST_LINES} lines")
                wrong += 1
            for match in INCLUDE.finditer(text):
                includes += 1
                if fault := problem(name, match[1], modules):
                    line = text.count("\n", 0, match.start(1)) + 1
                    print(f"{name}:{line}: #include \"{match[1]}\": {fault}")
                    wrong += 1
    if wrong:
        sys.exit(1)
    print(f"{includes} includes, {len(modules)} modules, nothing found")


main()
