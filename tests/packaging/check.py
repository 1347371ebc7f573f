#!/usr/bin/env python3
"""What packages are made of, by the linters of the desktop: check.py BUILD

The desktop file, the metainfo, the MIME types, the man pages, the completions, one version everywhere."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
ID = "io.github.angry_balls.angry_balls"


def run(*command, **options):
    ran = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    if ran.returncode != 0 or ran.stderr.strip():
        sys.exit(f"{' '.join(map(str, command))}: {ran.returncode}\n{ran.stdout}{ran.stderr}")
    return ran.stdout


def completed(file, *words):
    """What bash offers for the last of the words."""
    script = (f". {file}; COMP_WORDS=({' '.join(map(repr, words))}); COMP_CWORD={len(words) - 1}; "
              f"_{words[0].replace('-', '_')}; echo ${{COMPREPLY[*]}}")
    return run("bash", "-c", script).split()


def main():
    build = pathlib.Path(sys.argv[1])
    if said := run("desktop-file-validate", ROOT / f"packaging/{ID}.desktop"):
        sys.exit(said)
    version = re.search(r'CAROM_VERSION "(.*)"', (ROOT / "include/carom/version.hpp").read_text())[1]
    debian = re.match(r"angry-balls \((.*)\)", (ROOT / "debian/changelog").read_text())[1]
    numbers = ".".join(re.findall(r"CAROM_VERSION_\w+ (\d+)",
                                  (ROOT / "include/carom/version.hpp").read_text()))
    said = run(build / "carom", "--version").split()[1]
    if not version == debian == numbers == said:
        sys.exit(f"versions: {version}, debian/changelog {debian}, numbers {numbers}, carom {said}")

    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run(sys.executable, ROOT / "packaging/metainfo.py", folder / f"{ID}.metainfo.xml")
        run("appstreamcli", "validate", "--no-net", "--pedantic", folder / f"{ID}.metainfo.xml")
        # The types, as a desktop sees them.
        (folder / "mime/packages").mkdir(parents=True)
        (folder / f"mime/packages/{ID}.xml").write_text((ROOT / f"packaging/{ID}.xml").read_text())
        run("update-mime-database", folder / "mime", env={**os.environ, "XDG_DATA_DIRS": str(folder)})
        globs = (folder / "mime/globs2").read_text()
        for kind in ("level", "replay"):
            if f"application/x-angry-balls-{kind}:*.angry-{kind}" not in globs:
                sys.exit(f"no MIME type of *.angry-{kind}:\n{globs}")

        run(sys.executable, ROOT / "packaging/from_help.py", build, folder)
        pages = sorted((folder / "man").iterdir())
        if len(pages) < 8:
            sys.exit(f"only {pages}")
        for page in pages:
            run("groff", "-man", "-Tutf8", "-ww", "-z", page)
            text = page.read_text()
            for part in (".SH NAME", ".SH SYNOPSIS", ".SH OPTIONS"):
                if part not in text:
                    sys.exit(f"{page.name} has no {part}")
        carom = folder / "bash/carom"
        for words, expected in ((("carom", "sim"), ["simulate"]), (("carom", "simulate", "--ha"), ["--hash"]),
                                (("carom", "--vers"), ["--version"])):
            if completed(carom, *words) != expected:
                sys.exit(f"{words}: {completed(carom, *words)}")
        if "-l hash" not in (folder / "fish/carom.fish").read_text():
            sys.exit("fish does not know --hash")
        for program in ("carom", "angry-balls"):
            run("zsh", "-n", folder / f"zsh/_{program}")
        for part in ("'check:", "'--hash[", "'--broad-phase[", ":(pairs quadtree)'", ":FILE:_files'"):
            if part not in (folder / "zsh/_carom").read_text():
                sys.exit(f"zsh does not know {part}")
    for program, *commands in (("carom", "simulate", "check", "shots"), ("angry-balls",)):
        for words in ([], *([command] for command in commands)):
            for line in run(build / program, *words, "--help").splitlines():
                if len(line) > 80:
                    sys.exit(f"{program} {words} --help: more than 80 columns: {line}")
    print(f"{len(pages)} man pages, version {version}")


main()
