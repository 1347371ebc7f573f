#!/usr/bin/env python3
"""Adds what Emscripten links with to the licence texts: licences.py INPUT OUTPUT"""

import pathlib
import re
import sys

COPYRIGHT = pathlib.Path("/usr/share/doc/emscripten/copyright")
MUSL = pathlib.Path("/usr/share/emscripten/system/lib/libc/musl/COPYRIGHT")
APACHE = pathlib.Path("/usr/share/common-licenses/Apache-2.0")
# The sources that end up in a page; the rest of the package are tests and tools.
LINKED = re.compile(r" (\*|src/\S*|system/include/(emscripten|compat)\S*|system/lib/(html5|libc|libcxx|libcxxabi|compiler-rt|"
                    r"emmalloc|gl)\S*)")
# Its values list files of which none is linked: they are for a processor or a tool.
UNUSED = re.compile(r"/(asan|lsan|ubsan\w*|sanitizer_common|solaris)/")


def main():
    source, target = map(pathlib.Path, sys.argv[1:])
    paragraphs = COPYRIGHT.read_text().split("\n\n")
    kept, names = [], set()
    for paragraph in paragraphs:
        if not paragraph.startswith("Files:"):
            continue
        files = paragraph.split("Copyright:")[0].splitlines()[1:]
        if any(LINKED.fullmatch(file) and not UNUSED.search(file) for file in files):
            kept.append(paragraph)
            names.update(re.split(r" or | and | with ", re.search("^License: *(.*)", paragraph, re.M)[1]))
    for paragraph in paragraphs:
        licence = re.match("License: *(.*)", paragraph)
        if licence and licence[1] in names:
            kept.append(paragraph)
    parts = {"Emscripten and the libraries that it links with": "\n\n".join(kept) + "\n",
             "musl: the C library": MUSL.read_text(),
             "Apache License 2.0, of the C++ library and of compiler-rt": APACHE.read_text()}
    text = source.read_text()
    for title, licence in parts.items():
        text += f"{title}\n{'=' * len(title)}\n\n{licence}\n\n"
    target.write_text(text)


main()
