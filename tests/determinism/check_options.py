#!/usr/bin/env python3
"""Options that change arithmetic are refused: by the headers when a source is compiled, or by
carom::arithmetic_is_exact() when the program runs. Options that do not are not.
"""

import pathlib
import platform
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent

PROGRAM = """
#include "carom/internal/arithmetic_check.hpp"
#include "carom/vec2.hpp"
int main() { return carom::arithmetic_is_exact() ? 0 : 42; }
"""

COMPILERS = ("g++", "clang++")
LEVELS = ("-O0", "-O1", "-O2", "-O3", "-Os", "-Og")

# (options, compilers). Each is used with -O2.
REFUSED = (
    ("-ffast-math", COMPILERS),
    ("-Ofast", COMPILERS),
    ("-funsafe-math-optimizations", COMPILERS),
    ("-fassociative-math -fno-signed-zeros -fno-trapping-math", COMPILERS),
    ("-freciprocal-math", COMPILERS),
    ("-fno-signed-zeros", COMPILERS),
    ("-ffinite-math-only", COMPILERS),
    ("-fsingle-precision-constant", ("g++",)),
)
REFUSED_ON_X86 = (("-mfma -ffp-contract=fast", COMPILERS), ("-mfpmath=387", ("g++",)))
FINE = ("", "-frounding-math", "-fno-math-errno", "-fno-trapping-math", "-ftrapping-math")


def verdict(folder, compiler, options):
    """"exact", "inexact", or what the compiler said."""
    source = folder / "program.cpp"
    program = folder / "program"
    source.write_text(PROGRAM)
    command = [compiler, "-std=c++20", f"-I{ROOT}/include", f"-I{ROOT}/src", *options.split()]
    built = subprocess.run([*command, str(source), "-o", str(program)], capture_output=True, text=True)
    if built.returncode != 0:
        return built.stderr
    return {0: "exact", 42: "inexact"}.get(subprocess.run([str(program)]).returncode, "crashed")


def main():
    wrong = 0
    refused = REFUSED
    if platform.machine() in ("x86_64", "AMD64"):
        refused += REFUSED_ON_X86
        if " fma " not in pathlib.Path("/proc/cpuinfo").read_text():
            refused = [row for row in refused if "-mfma" not in row[0]]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for options, compilers in refused:
            for compiler in compilers:
                contract = "" if "contract" in options else "-ffp-contract=off "
                said = verdict(folder, compiler, f"-O2 {contract}{options}")
                if said != "inexact" and "carom must not be compiled" not in said and (
                        "without excess precision" not in said):
                    print(f"{compiler} {options}: {said}")
                    wrong += 1
        for compiler in COMPILERS:
            for options in [*FINE, *LEVELS]:
                said = verdict(folder, compiler, f"-O2 -ffp-contract=off {options}")
                if said != "exact":
                    print(f"{compiler} {options}: {said}")
                    wrong += 1
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
