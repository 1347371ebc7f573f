"""Reads the po files: gettext's format, as far as msgfmt and the usual editors write it."""

import ast
import pathlib
import re

FOLDER = pathlib.Path(__file__).resolve().parent
TEMPLATE = FOLDER / "angry-balls.pot"  # English
LEVELS = "level"  # the context of all level names
PAGE = "page:"  # begins the context of a text that the web page has without the game


class Entry:
    def __init__(self):
        self.context = self.id = ""
        self.plural = None  # the English plural, if the text has forms
        self.forms = {}  # translations by their index; without plural forms 0
        self.fuzzy = False

    @property
    def key(self):
        return self.context, self.id

    def texts(self):
        """The translations in order; [""] if there are none that count."""
        return [""] if self.fuzzy else [self.forms[i] for i in sorted(self.forms)] or [""]

    def english(self):
        return [self.id] if self.plural is None else [self.id, self.plural]


def read(path):
    """The entries of a po file by (context, English text). The header's key is ("", "")."""
    entries = {}
    entry, add = Entry(), None
    for number, line in enumerate(path.read_text(encoding="utf-8").split("\n") + [""], 1):
        line = line.strip()
        where = f"{path.name}:{number}"
        if not line:
            if add is not None:
                if entry.key in entries:
                    raise SystemExit(f"{where}: {entry.key} is there twice")
                entries[entry.key] = entry
            entry, add = Entry(), None
        elif line.startswith("#"):
            entry.fuzzy |= line.startswith("#,") and "fuzzy" in line
        else:
            word, index, text = re.fullmatch(r'(?:(\w+)(?:\[(\d+)\])? )?(".*")', line).groups()
            text = ast.literal_eval(text)
            if word:
                add = {"msgctxt": "context", "msgid": "id", "msgid_plural": "plural"}.get(word)
                add = add or int(index or 0)
                if add == "plural":
                    entry.plural = ""
            if isinstance(add, int):
                entry.forms[add] = entry.forms.get(add, "") + text
            else:
                setattr(entry, add, getattr(entry, add) + text)
    return entries


def header(entries, field):
    match = re.search(rf"^{field}: *(.*)$", entries["", ""].forms[0], re.MULTILINE)
    return match[1] if match else ""


def translations():
    """The translations by their codes, in the order of these."""
    return {path.stem: path for path in sorted(FOLDER.glob("*.po"))}
