#!/usr/bin/env python3
"""Plays in the real window as a person would: an X server of its own (xvfb-run), mouse and keys by
xdotool. What the game shows is read from the window's title; a picture of the screen is kept."""

import argparse
import os
import pathlib
import subprocess
import sys
import time

WIDTH, HEIGHT = 1280, 720


class Window:
    def __init__(self, program, arguments):
        self.game = subprocess.Popen([program, "--size", f"{WIDTH}x{HEIGHT}", "--lang", "en",
                                      *arguments])
        self.id = None
        self.wait_for("title screen")

    def xdotool(self, *arguments):
        return subprocess.run(["xdotool", *map(str, arguments)], capture_output=True, text=True,
                              timeout=60)

    def title(self):
        if self.game.poll() is not None:
            sys.exit(f"the game has ended with {self.game.returncode}")
        if self.id is None:
            found = self.xdotool("search", "--pid", self.game.pid, "--name", "Angry Balls")
            if not found.stdout.split():
                return ""
            self.id = found.stdout.split()[-1]
        return self.xdotool("getwindowname", self.id).stdout.strip()

    def wait_for(self, *texts, seconds=60):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            title = self.title()
            if any(text in title for text in texts):
                print(f"  {title}")
                return title
            time.sleep(0.05)
        sys.exit(f"waited {seconds} s for {' or '.join(texts)}; the title is '{self.title()}'")

    def move(self, x, y):
        self.xdotool("mousemove", "--window", self.id, x, y)

    def click(self, x, y, button=1):
        self.move(x, y)
        time.sleep(0.1)
        self.xdotool("click", button)

    def key(self, name):
        self.xdotool("key", "--window", self.id, name)

    def colours_on_screen(self, picture):
        """Takes a picture of the screen; returns how many colours it has."""
        subprocess.run(["import", "-window", "root", picture], check=True, timeout=60)
        counted = subprocess.run(["identify", "-format", "%k", picture], check=True, timeout=60,
                                 capture_output=True, text=True)
        return int(counted.stdout)

    def wait_for_end(self):
        status = self.game.wait(timeout=20)
        if status != 0:
            sys.exit(f"the game ended with {status}")


def check(condition, message):
    if not condition:
        sys.exit(message)


def billiards(window, pictures):
    window.click(220, 383)
    window.wait_for("Player 1 aims")
    # A click that is not on the cue ball, and a first click taken back, change nothing.
    window.click(640, 300)
    window.click(418, 379)
    window.move(900, 379)
    window.key("Escape")
    window.click(418, 379)
    window.click(900, 400, button=3)
    window.wait_for("Player 1 aims")
    # The break, by two clicks.
    window.click(418, 379)
    window.move(700, 385)
    window.click(1000, 386)
    window.wait_for("Player 1 watches")
    check(window.colours_on_screen(pictures / "window-billiards.png") > 2000,
          "the window shows next to nothing")
    title = window.wait_for("Player 2 aims", "Player 2 places")
    check("balls left: 36" in title or "Player 1: 0" not in title, "balls fell, yet no score")
    # Another size: the game goes on.
    window.xdotool("windowsize", window.id, 800, 600)
    time.sleep(0.5)
    check(window.colours_on_screen(pictures / "window-resized.png") > 2000,
          "the resized window shows next to nothing")
    window.xdotool("windowsize", window.id, WIDTH, HEIGHT)
    time.sleep(0.5)
    # Back to the title: the game asks, and Enter says yes.
    window.key("Escape")
    window.wait_for("Leave the table?")
    window.key("Return")
    window.wait_for("title screen")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--pictures", type=pathlib.Path, default=pathlib.Path("."))
    parser.add_argument("--in-display", action="store_true", help="a display is there already")
    options = parser.parse_args()
    if not options.in_display:
        environment = {key: value for key, value in os.environ.items()
                       if key not in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER")}
        os.execvpe("xvfb-run", ["xvfb-run", "-a", "-s", f"-screen 0 {WIDTH}x{HEIGHT}x24",
                                sys.executable, *sys.argv, "--in-display"], environment)
    window = Window(options.program, [])
    billiards(window, options.pictures)
    window.click(220, 455)  # Quit
    window.wait_for_end()
    print("played")


main()
