#!/usr/bin/env python3
"""The site, in FOLDER/site: build.py FOLDER

The documents by mkdocs, the API pages by Doxygen (api/), and the game (play/) if build/web is there.
Warnings of both are errors."""

import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HERE = ROOT / "docs/site"


def main():
    folder = pathlib.Path(sys.argv[1]).resolve()
    shutil.rmtree(folder, ignore_errors=True)
    pages = folder / "pages"
    pages.mkdir(parents=True)
    pages_named = [word for word in re.findall(r": (\w+\.md)", (HERE / "mkdocs.yml").read_text())]
    for name in pages_named:
        if name != "index.md":
            shutil.copy(ROOT / "docs" / name, pages)
    shutil.copytree(ROOT / "docs/images", pages / "images")
    game = ROOT / "build/web"
    play = "[Play in the browser](play/index.html) · " if (game / "index.html").exists() else ""
    readme = (ROOT / "README.md").read_text(encoding="utf-8").replace("docs/images/", "images/")
    (pages / "index.md").write_text(f"{play}[API of the library](api/index.html)\n\n{readme}", "utf-8")
    (pages / "api").mkdir()
    (pages / "api/index.html").write_text("the API pages come here")
    if play:
        shutil.copytree(game, pages / "play")
    shutil.copy(HERE / "mkdocs.yml", folder)
    subprocess.run(["mkdocs", "build", "--quiet", "--config-file", "mkdocs.yml"], cwd=folder, check=True)

    version = re.search(r'CAROM_VERSION "(.*)"', (ROOT / "include/carom/version.hpp").read_text())[1]
    settings = (HERE / "Doxyfile").read_text() + (
        f"PROJECT_NUMBER = {version}\nOUTPUT_DIRECTORY = {folder}\nHTML_OUTPUT = site/api\n")
    subprocess.run(["doxygen", "-"], input=settings, text=True, cwd=ROOT, check=True)
    if "api/" not in (folder / "site/index.html").read_text():
        sys.exit("the site does not lead to the API")
    print(f"The site is {folder}/site")


main()
