#!/usr/bin/env python3
"""Prints the signs that the texts use, for pyftsubset --unicodes: U+20,U+21,…"""

import po_files

signs = {ord(sign) for sign in "0123456789"}
for path in [po_files.TEMPLATE, *po_files.translations().values()]:
    for entry in po_files.read(path).values():
        for text in entry.english() + entry.texts():
            signs |= {ord(sign) for sign in text if sign >= " "}
print(",".join(f"U+{sign:X}" for sign in sorted(signs)))
