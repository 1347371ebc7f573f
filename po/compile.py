#!/usr/bin/env python3
"""Compiles the po files: compile.py FOLDER writes

names.hpp      the texts and languages as enumerations
CODE.texts     the texts of a language: UTF-8, each ended by a zero byte. The first is the version,
               the second the plural forms of 0 to 199, a digit each; then come the texts in the
               order of the enumeration, then the names of levels. A text not translated is empty;
               between plural forms stands U+001F.
page.json      what the web page says itself, by language

Files that would not change are left as they are.
"""

import gettext
import hashlib
import json
import pathlib
import re
import sys

import po_files


def write(path, text):
    data = text.encode()
    if not path.exists() or path.read_bytes() != data:
        path.write_bytes(data)


def plural_forms(entries):
    rule = re.search(r"plural *= *([^;]*);", po_files.header(entries, "Plural-Forms"))[1]
    form = gettext.c2py(rule)
    return "".join(str(form(n)) for n in range(200))


def names_header(names, languages, version):
    lines = lambda values: "".join(f"  {value},\n" for value in values)
    quoted = lambda values: ", ".join(json.dumps(v, ensure_ascii=False) for v in values)
    return f"""// Made by po/compile.py.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace app {{

enum class Text : std::uint16_t {{
{lines(names)}  count,
}};

/// By the codes of the files in po/; English is the first.
enum class Language : std::uint8_t {{ {", ".join(languages)} }};
inline constexpr std::array<std::string_view, {len(languages)}> language_codes{{
    {quoted(languages)}}};
/// As the language itself says it.
inline constexpr std::array<std::string_view, {len(languages)}> language_names{{
    {quoted(languages.values())}}};
/// Differs between tables of texts that do not go together.
inline constexpr std::string_view texts_version = "{version}";

}}  // namespace app
"""


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    template = po_files.read(po_files.TEMPLATE)
    kinds = {"texts": [], "levels": [], "page": []}
    for context, english in list(template):
        if (context, english) != ("", ""):
            kind = "levels" if context == po_files.LEVELS else "texts"
            kinds["page" if context.startswith(po_files.PAGE) else kind].append((context, english))
    in_table = kinds["texts"] + kinds["levels"]
    # Of what a place in the table means; a text may be worded anew.
    meanings = [context for context, _ in kinds["texts"]] + [name for _, name in kinds["levels"]]
    version = hashlib.sha256(repr(meanings).encode()).hexdigest()[:16]

    languages, page = {}, {}
    files = {"en": po_files.TEMPLATE, **po_files.translations()}
    for code, path in files.items():
        entries = template if code == "en" else po_files.read(path)

        def texts(key):
            if code == "en":
                return template[key].english()
            return entries[key].texts() if key in entries else [""]

        table = ["\x1f".join(texts(key)) for key in in_table]
        name = next(key for key in in_table if key[0] == "language_name")
        languages[code] = texts(name)[0] or code
        whole = [version, plural_forms(entries), *table]
        write(folder / f"{code}.texts", "".join(text + "\0" for text in whole))
        page[code] = {
            key[0].removeprefix(po_files.PAGE): texts(key)[0] or key[1] for key in kinds["page"]
        }
    write(folder / "names.hpp", names_header([c for c, _ in kinds["texts"]], languages, version))
    write(folder / "page.json", json.dumps(page, ensure_ascii=False))


main()
