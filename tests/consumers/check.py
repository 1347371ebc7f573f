#!/usr/bin/env python3
"""Builds tests/consumers/consumer, a project that uses the library, in one of these ways, and
compares the hashes it prints with those of the program carom:

  installed    by find_package and by pkg-config, from what the tree BUILD installs, which is moved
               first; also: the headers refuse -ffast-math and its parts
  subproject   by add_subdirectory
  fetched      by FetchContent, from a clone of this repository
  shared       the library alone as a shared one, installed, by find_package and by pkg-config; it
               shows only what the public headers declare
  levels       by add_subdirectory at -O0, -O1, -O3 and -Os with g++ and clang
"""

import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
CONSUMER = ROOT / "tests/consumers/consumer"
SCENE = ROOT / "scenes/break.json"
# The state after the second break of main.cpp, which is played by the rules.
RACK_BREAK = "6bb814b105220fad\n"
FAST_MATH = ("-ffast-math", "-Ofast", "-ffinite-math-only", "-fno-signed-zeros",
             "-freciprocal-math", "-fassociative-math -fno-signed-zeros -fno-trapping-math")


def run(*command, **options):
    ran = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    if ran.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\nended with {ran.returncode}\n{ran.stdout}{ran.stderr}")
    return ran.stdout


def cmake(source, folder, *options, target="all"):
    run("cmake", "-S", source, "-B", folder, "-G", "Ninja", *options)
    run("cmake", "--build", folder, "--target", target)


def same(printed, expected, how):
    if printed != expected:
        sys.exit(f"{how}: expected\n{expected}printed\n{printed}")
    print(f"{how}: {' '.join(printed.split())}")


def consume(folder, expected, way, *options, how=None):
    cmake(CONSUMER, folder, f"-DWAY={way}", *options)
    same(run(folder / "consumer", SCENE), expected, how or way)
    same(run(folder / "plain", SCENE), expected.splitlines(True)[0], f"{how or way}, plain C")


def consume_installed(prefix, folder, expected, *link):
    consume(folder / "consumer", expected, "find_package", f"-DCMAKE_PREFIX_PATH={prefix}",
            "-DCMAKE_BUILD_TYPE=Release")
    (config,) = prefix.rglob("carom.pc")
    environment = {**os.environ, "PKG_CONFIG_PATH": str(config.parent),
                   "LD_LIBRARY_PATH": str(config.parent.parent)}
    flags = run("pkg-config", "--cflags", "--libs", *link, "carom-games", env=environment).split()
    run("c++", "-std=c++20", "-O2", CONSUMER / "main.cpp", *flags, "-o", folder / "by-pkg-config")
    same(run(folder / "by-pkg-config", SCENE, env=environment), expected, "pkg-config")


def refuse_fast_math(prefix):
    headers = (f"-I{prefix}/include", f"-I{prefix}/include/carom-games")
    for options in ("", *FAST_MATH):
        built = subprocess.run(["g++", "-std=c++20", "-fsyntax-only", *headers, *options.split(),
                                str(CONSUMER / "main.cpp")], capture_output=True, text=True)
        refused = "#error \"carom must not be compiled with -ffast-math" in built.stderr
        if refused != bool(options):
            sys.exit(f"g++ {options}: {built.stderr or 'not refused'}")
    print(f"-ffast-math and {len(FAST_MATH) - 1} like it are refused")


def exported(library):
    return [line.split(maxsplit=2)[2] for line in
            run("nm", "--dynamic", "--defined-only", "--demangle", library).splitlines()]


def installed(build, folder, expected):
    for component in ("carom", "carom-games"):
        run("cmake", "--install", build, "--component", component, "--prefix", folder / "first")
    prefix = (folder / "first").rename(folder / "moved")
    consume_installed(prefix, folder, expected)
    refuse_fast_math(prefix)


def shared(_, folder, expected):
    cmake(ROOT, folder / "build", "-DBUILD_SHARED_LIBS=ON", "-DANGRY_BALLS_PROGRAMS=OFF",
          "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG", "-DCMAKE_INSTALL_LIBDIR=lib")
    prefix = folder / "prefix"
    run("cmake", "--install", folder / "build", "--prefix", prefix)
    consume_installed(prefix, folder, expected)
    symbols = exported(prefix / "lib/libcarom.so")
    for wanted, name in ((True, "carom::World::step"), (False, "carom::Forecast"),
                         (False, "nlohmann")):
        if any(symbol.startswith(name) for symbol in symbols) != wanted:
            sys.exit(f"libcarom.so {'hides' if wanted else 'shows'} {name}")
    print(f"libcarom.so shows {len(symbols)} symbols")


def fetched(_, folder, expected):
    run("git", "clone", "--quiet", ROOT, folder / "clone")
    consume(folder / "consumer", expected, "FetchContent", "-DCMAKE_BUILD_TYPE=Release",
            f"-DCAROM_SOURCE=file://{folder}/clone",
            f"-DCAROM_COMMIT={run('git', '-C', ROOT, 'rev-parse', 'HEAD').strip()}")


def subproject(_, folder, expected):
    consume(folder / "consumer", expected, "add_subdirectory", "-DCMAKE_BUILD_TYPE=Release",
            f"-DCAROM_SOURCE={ROOT}")


def levels(_, folder, expected):
    for compiler in ("g++", "clang++"):
        for level in ("-O0", "-O1", "-O3", "-Os"):
            consume(folder / (compiler + level), expected, "add_subdirectory",
                    f"-DCAROM_SOURCE={ROOT}", f"-DCMAKE_CXX_COMPILER={compiler}",
                    f"-DCMAKE_CXX_FLAGS={level}", how=f"{compiler} {level}")


def main():
    way, build = sys.argv[1:]
    build = pathlib.Path(build)
    hashes = run(build / "carom", "simulate", SCENE, "--until-rest", "--hash")
    expected = hashes + RACK_BREAK
    with tempfile.TemporaryDirectory() as folder:
        globals()[way](build, pathlib.Path(folder), expected)


main()
