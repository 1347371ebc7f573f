#!/usr/bin/env python3
"""Man pages and shell completions, made of what --help says:

  from_help.py BIN FOLDER

writes FOLDER/man/*.1, FOLDER/bash/*, FOLDER/fish/*.fish and FOLDER/zsh/_* for the programs carom and
angry-balls in BIN.
"""

import pathlib
import re
import subprocess
import sys

PROGRAMS = {"carom": 1, "angry-balls": 6}  # the sections of their man pages
SECTIONS = ("Positionals", "Options", "Subcommands", "Examples")


class Help:
    """What `PROGRAM [COMMAND] --help` says."""

    def __init__(self, *words):
        text = subprocess.run([*words, "--help"], check=True, capture_output=True, text=True,
                              env={"PATH": "/usr/bin:/bin", "LC_ALL": "C.UTF-8"}).stdout
        self.name = " ".join([pathlib.Path(words[0]).name, *words[1:]])
        lines = text.splitlines()
        usage = next(i for i, line in enumerate(lines) if line.startswith("Usage:"))
        self.summary = " ".join(lines[:usage]).strip()
        self.usage = lines[usage].removeprefix("Usage:").strip()
        self.entries = {}   # section → [[term, description]]
        self.examples = []
        self.notes = []     # paragraphs
        section = None
        for line in lines[usage + 1:]:
            if line.rstrip(":") in SECTIONS and line.endswith(":"):
                section = line.rstrip(":")
                self.entries.setdefault(section, [])
            elif not line:
                section = None
                self.notes.append("")
            elif section == "Examples":
                self.examples.append(line.strip())
            elif section and re.match(r"  \S", line):
                term, _, description = line.strip().partition("  ")
                self.entries[section].append([term, description.strip()])
            elif section:
                self.entries[section][-1][1] += " " + line.strip()
            else:
                begins = line.startswith("Exit status") or not self.notes or not self.notes[-1]
                if begins:
                    self.notes.append("")
                self.notes[-1] += (" " if self.notes[-1] else "") + line
        self.notes = [note for note in self.notes if note]

    def options(self):
        """[(names, takes an argument, description)]"""
        for term, description in self.entries.get("Options", []):
            names, _, argument = term.partition(" ")
            yield names.split(","), argument, description


def roff(text):
    return re.sub(r"^([.'])", r"\\&\1", text.replace("\\", "\\e").replace("-", "\\-"), flags=re.M)


def man_page(page, section, version):
    title = page.name.replace(" ", "-")
    summary = page.summary.rstrip(".")
    out = [f'.TH {roff(title).upper()} {section} "" "angry-balls {version}"', ".SH NAME",
           f"{roff(title)} \\- {roff(summary[0].lower() + summary[1:])}", ".SH SYNOPSIS",
           f".B {roff(page.usage)}"]
    if page.notes:
        out.append(".SH DESCRIPTION")
        out += [line for note in page.notes for line in (".PP", roff(note))]
    for name in ("Positionals", "Options", "Subcommands"):
        if page.entries.get(name):
            out.append(f".SH {'ARGUMENTS' if name == 'Positionals' else name.upper()}")
            for term, description in page.entries[name]:
                out += [".TP", f".B {roff(term)}", roff(description)]
    if page.examples:
        out += [".SH EXAMPLES", ".nf", *map(roff, page.examples), ".fi"]
    if name := page.name.split(" ")[1:]:
        out += [".SH SEE ALSO", ".BR carom (1)"]
    return "\n".join(out) + "\n"


def bash(program, pages):
    """Completes commands, options, and else files."""
    function = "_" + program.replace("-", "_")
    lines = [f"# Completion of {program} for bash.", f"{function}() {{",
             '  local word=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]} words=',
             "  case $command in"]
    for page in pages[1:]:
        names = " ".join(name for names, _, _ in page.options() for name in names)
        lines.append(f"    {page.name.split()[1]}) words='{names}' ;;")
    top = " ".join([name for names, _, _ in pages[0].options() for name in names] +
                   [page.name.split()[1] for page in pages[1:]])
    lines += [f"    *) words='{top}' ;;", "  esac",
              "  # An option that is begun, or a command; anything else is a file.",
              f"  if [[ $word == -* || ({len(pages)} -gt 1 && $COMP_CWORD -eq 1) ]]; then",
              '    COMPREPLY=($(compgen -W "$words" -- "$word"))', "  else",
              "    compopt -o filenames 2>/dev/null", '    COMPREPLY=($(compgen -f -- "$word"))', "  fi", "}",
              f"complete -F {function} {program}"]
    return "\n".join(lines) + "\n"


def fish(program, pages):
    quote = lambda text: "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"
    lines = [f"# Completion of {program} for fish."]
    for page in pages:
        command = page.name.split()[1:]
        condition = f"-n '__fish_seen_subcommand_from {command[0]}'" if command else "-n __fish_use_subcommand"
        if command:
            lines.append(f"complete -c {program} -n __fish_use_subcommand -a {command[0]} "
                         f"-d {quote(page.summary)}")
        for names, argument, description in page.options():
            flags = " ".join(f"-l {name[2:]}" if name.startswith("--") else f"-s {name[1:]}"
                             for name in names)
            lines.append(f"complete -c {program} {condition} {flags} {'-r ' if argument else ''}"
                         f"-d {quote(description)}")
    return "\n".join(lines) + "\n"


def zsh(program, pages):
    """Completes commands, options, and else files."""
    def quote(text):
        return "'" + text.replace("'", "'\\''") + "'"

    def note(text):
        return re.sub(r"([\[\]:\\])", r"\\\1", text)

    def arguments(page):
        specs = []
        for names, argument, description in page.options():
            choices = f"({argument.replace('|', ' ')})" if "|" in argument else " "
            value = f":{note(argument)}:{'_files' if re.search('FILE|TRACE|FOLDER|SCRIPT|LOG|DIR', argument) else choices}" if argument else ""
            specs += [quote(f"{name}[{note(description.strip())}]{value}") for name in names]
        return specs + [quote("*:file:_files")]

    def call(page, indent):
        return f" \\\n{indent}  ".join([f"{indent}_arguments -s", *arguments(page)])

    lines = [f"#compdef {program}", f"# Completion of {program} for zsh."]
    if len(pages) > 1:
        lines += ["if (( CURRENT == 2 )) && [[ $words[2] != -* ]]; then", "  local -a commands=("]
        lines += [f"    {quote(page.name.split()[1] + ':' + page.summary)}" for page in pages[1:]]
        lines += ["  )", "  _describe command commands", "  return", "fi", "case $words[2] in"]
        for page in pages[1:]:
            lines += [f"  {page.name.split()[1]})", call(page, "    "), "    ;;"]
        lines += ["  *)", call(pages[0], "    "), "    ;;", "esac"]
    else:
        lines.append(call(pages[0], ""))
    return "\n".join(lines) + "\n"


def main():
    binaries, folder = map(pathlib.Path, sys.argv[1:])
    header = (pathlib.Path(__file__).resolve().parent.parent / "include/carom/version.hpp").read_text()
    version = re.search(r'CAROM_VERSION "(.*)"', header)[1]
    for name in ("man", "bash", "fish", "zsh"):
        (folder / name).mkdir(parents=True, exist_ok=True)
    for program, section in PROGRAMS.items():
        path = str((binaries / program).resolve())
        pages = [Help(path)]
        pages += [Help(path, term) for term, _ in pages[0].entries.get("Subcommands", [])]
        for page in pages:
            file = folder / "man" / f"{page.name.replace(' ', '-')}.{section}"
            file.write_text(man_page(page, section, version))
        (folder / "bash" / program).write_text(bash(program, pages))
        (folder / "fish" / f"{program}.fish").write_text(fish(program, pages))
        (folder / "zsh" / f"_{program}").write_text(zsh(program, pages))


main()
