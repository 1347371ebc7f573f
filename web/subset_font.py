#!/usr/bin/python3
"""Makes the page's font of a face of Lato: subset_font.py INPUT OUTPUT [--kerning] [TEXT...]

The whole faces would be half of the page. Kept are the signs of western Europe, for names that
players give, and every sign of the files TEXT. "Lato" is a Reserved Font Name (SIL Open Font License
1.1, section 3), so that what is made of it has another name; copyright and licence stay in it.
"""

import argparse
import pathlib

from fontTools import subset, ttLib

NAME = "Angry Balls Sans"
SIGNS = [*range(0x20, 0x7f), 0xa0, 0xa7, 0xab, 0xb0, 0xb7, *range(0xbb, 0xbf), *range(0xc0, 0x100),
         0x152, 0x153, 0x160, 0x161, 0x178, 0x17d, 0x17e, 0x2013, 0x2014, 0x2018, 0x2019, 0x201a,
         0x201c, 0x201d, 0x201e, 0x2022, 0x2026, 0x202f, 0x2039, 0x203a, 0x20ac,
         0x2190, 0x2191, 0x2192, 0x2193, 0x2212]
COPYRIGHT, FAMILY, STYLE, UNIQUE, FULL, POSTSCRIPT, LICENCE, LICENCE_URL = 0, 1, 2, 3, 4, 6, 13, 14


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("input")
    parser.add_argument("output")
    parser.add_argument("--kerning", action="store_true")
    parser.add_argument("texts", nargs="*", type=pathlib.Path)
    options = parser.parse_intermixed_args()

    signs = set(SIGNS)
    for text in options.texts:
        signs.update(map(ord, text.read_text(encoding="utf-8")))
    choice = subset.Options(hinting=False, layout_features=["kern"] if options.kerning else [])
    choice.name_IDs = [COPYRIGHT, FAMILY, STYLE, UNIQUE, FULL, POSTSCRIPT, LICENCE, LICENCE_URL]
    font = subset.load_font(options.input, choice)
    subsetter = subset.Subsetter(choice)
    subsetter.populate(unicodes=signs)
    subsetter.subset(font)

    style = font["name"].getDebugName(FULL).removeprefix("Lato").strip()
    for record in font["name"].names:
        names = {FAMILY: NAME, UNIQUE: f"{NAME} {style}", FULL: f"{NAME} {style}",
                 POSTSCRIPT: f"{NAME} {style}".replace(" ", "")}
        if record.nameID in names:
            record.string = names[record.nameID]
    subset.save_font(font, options.output, choice)


main()
