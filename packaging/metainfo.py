#!/usr/bin/env python3
"""The AppStream metainfo with the releases of CHANGELOG.md: metainfo.py FILE

A release is a heading "## 1.2.3 (2026-11-29)", this version's one without the date, which is that of
debian/changelog."""

import email.utils
import pathlib
import re
import sys
from xml.sax.saxutils import escape

ROOT = pathlib.Path(__file__).resolve().parent.parent
MOST_POINTS = 8  # of a release


def releases():
    changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    version = re.search(r'CAROM_VERSION "(.*)"', (ROOT / "include/carom/version.hpp").read_text())[1]
    debian = (ROOT / "debian/changelog").read_text(encoding="utf-8")
    today = email.utils.parsedate_to_datetime(re.search(r"^ -- .*>  (.*)$", debian, re.M)[1])
    for part in re.split(r"^## ", changelog, flags=re.M)[1:]:
        heading, _, body = part.partition("\n")
        named = re.match(r"(\d+\.\d+\.\d+)(?: \((\d{4}-\d\d-\d\d)\))?$", heading)
        if not named:
            continue
        if (named[1] == version) != (named[2] is None):
            sys.exit(f"CHANGELOG.md: {heading}: this version has no date, an older one has one")
        points = re.findall(r"^- (.*(?:\n  .*)*)", body, flags=re.M)
        plain = [re.sub(r"\s+", " ", point).replace("`", "") for point in points]
        yield named[1], named[2] or today.date().isoformat(), plain


def main():
    text = ""
    for version, date, points in releases():
        text += f'    <release version="{version}" date="{date}">\n      <description>\n        <ul>\n'
        text += "".join(f"          <li>{escape(point)}</li>\n" for point in points[:MOST_POINTS])
        text += "        </ul>\n      </description>\n    </release>\n"
    template = ROOT / "packaging/io.github.angry_balls.angry_balls.metainfo.xml.in"
    pathlib.Path(sys.argv[1]).write_text(template.read_text().replace("@RELEASES@", text), "utf-8")


main()
