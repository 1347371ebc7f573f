#!/usr/bin/env python3
"""Plays in the real window as a person would: an X server of its own (xvfb-run), mouse and keys by
xdotool. What the game shows is read from the window's title; a picture of the screen is kept."""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

WIDTH, HEIGHT = 1280, 720


class Window:
    def __init__(self, program, data, size, *arguments, title="title screen"):
        self.arguments = (program, data, size, *arguments)
        self.game = subprocess.Popen([program, "--size", size, "--lang", "en", *arguments],
                                     env={**os.environ, "XDG_DATA_HOME": str(data),
                                          "XDG_CONFIG_HOME": str(data)})
        self.id = None
        self.wait_for(title)

    def xdotool(self, *arguments):
        return subprocess.run(["xdotool", *map(str, arguments)], capture_output=True, text=True,
                              timeout=60)

    def title(self):
        if self.game.poll() is not None:
            sys.exit(f"the game has ended with {self.game.returncode}")
        # The window may be made anew at the start, when SDL turns to its renderer.
        name = self.xdotool("getwindowname", self.id).stdout.strip() if self.id else ""
        if not name:
            found = self.xdotool("search", "--pid", self.game.pid, "--name", "Angry Balls")
            self.id = found.stdout.split()[-1] if found.stdout.split() else None
        return name

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


def leave(window):
    """By the last button of the pause menu: the first Tab is on the first one, either way."""
    for key in ("Escape", "shift+Tab", "shift+Tab", "Return"):
        window.key(key)
    window.wait_for("title screen")


def billiards(window, pictures):
    window.click(120, 402)
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
    # Back to the title: the game is saved, with no question; "Continue" stands above the others.
    leave(window)


def practice(window, pictures):
    """A shot, taken back and repeated, edited by keys and wheel; a pull; practice leaves without a
    question."""
    window.click(330, 431)
    window.wait_for("practice: Player 1 aims")
    window.click(460, 357)
    window.click(820, 361)
    window.wait_for("practice: Player 1 watches")
    window.key("BackSpace")
    window.wait_for("practice: Player 1 aims")
    window.key("r")
    window.wait_for("practice: Player 1 watches")
    window.key("BackSpace")
    window.wait_for("practice: Player 1 aims")
    # A shot taken back is aimed again: edited by keys, wheel and numbers, and shot by Enter.
    window.key("shift+Left")
    window.xdotool("click", 4)
    for key in ("1", "7", "8", "period", "5", "Tab", "6", "0", "Return"):
        window.key(key)
    time.sleep(0.3)
    window.colours_on_screen(pictures / "window-aim.png")
    window.wait_for("practice: Player 1 aims")
    window.key("Return")
    window.wait_for("practice: Player 1 watches")
    window.key("BackSpace")
    window.wait_for("practice: Player 1 aims")
    # A pull that comes back to the ball is none; one that is let go shoots.
    for x, state in ((462, "aims"), (300, "watches")):
        window.move(460, 357)
        window.xdotool("mousedown", 1)
        window.move(380, 357)
        window.move(x, 357)
        time.sleep(0.1)
        window.xdotool("mouseup", 1)
        time.sleep(0.3)
        window.wait_for(f"practice: Player 1 {state}")
    leave(window)


def continue_and_replay(window, data):
    """A saved game is gone on with by a window that knows nothing else; a replay is copied, pasted,
    and saved."""
    window.click(120, 431)
    window.wait_for("Player 1 aims")
    window.click(418, 379)
    window.click(300, 350)
    window.wait_for("Player 2 aims", "Player 2 places")
    window.game.kill()
    window.game.wait()
    window.__init__(*window.arguments)
    window.key("Return")
    window.wait_for("Player 2 aims", "Player 2 places")
    window.game.kill()
    window.game.wait()

    replay = pathlib.Path(__file__).parents[1] / "replays" / "level-01-won.json"
    window.__init__(*window.arguments[:3], "--replay", replay, title="replay · First steps")
    window.key("space")
    window.wait_for("paused")
    window.key("plus")
    window.key("space")
    window.wait_for("playing ×2")
    window.wait_for("paused · Score 300 · Verified")
    window.key("ctrl+c")
    window.key("Escape")
    window.wait_for("title screen")
    window.key("ctrl+v")
    window.wait_for("replay · First steps · Turn 1 of 1")
    window.wait_for("Verified")
    window.click(926, 38)  # Save
    end = time.monotonic() + 20
    saved = data / "angry-balls" / "replays" / "replay-0001.angry-replay"
    while not saved.exists() and time.monotonic() < end:
        time.sleep(0.05)
    check(saved.exists() and saved.read_bytes() == replay.read_bytes(),
          "the replay saved is not the one shown")
    window.key("Escape")
    window.wait_for("title screen")
    window.key("Escape")
    window.wait_for_end()
    for kept in (data / "angry-balls").glob("continue-*.json"):
        kept.unlink()


def angry_balls(window, pictures, data):
    """The window is one in which a level of 1000 × 500 px is shown pixel by pixel."""
    window.click(220, 481)
    window.wait_for("level menu · 12 levels")
    window.click(134, 163)
    window.wait_for("Level 1: First steps")
    # A click beside the projectile, and a first click taken back, change nothing.
    window.click(500, 250)
    window.click(110, 496)
    window.click(400, 300, button=3)
    window.wait_for("click the angry ball")
    # A throw out of the level, by two clicks; the next one is offered and taken by a click.
    window.click(110, 496)
    window.click(10, 480)
    window.wait_for("click for the next throw · score: 0 · throws left: 2 · enemies left: 2")
    window.click(500, 300)
    window.wait_for("click the angry ball")
    # The recorded throw.
    throw = pathlib.Path(__file__).parents[2] / "tests/levels/original/01-first-steps.throws"
    x, y = map(int, throw.read_text().split())
    window.click(110, 496)
    window.move(200, 500)
    window.click(110 + x, 496 - y)
    window.wait_for("watching the throw · score: 100")
    check(window.colours_on_screen(pictures / "window-angry-balls.png") > 2000,
          "the window shows next to nothing")
    window.wait_for("Level won! · score: 300 · throws left: 1 · enemies left: 0")
    scores = json.loads((data / "angry-balls" / "scores.json").read_text())
    check(scores["angry-balls-scores"] == 1 and list(scores["best"].values()) == [300],
          f"wrong scores: {scores}")
    time.sleep(2.5)
    window.colours_on_screen(pictures / "window-end.png")
    window.click(640, 510)  # Menu
    window.wait_for("level menu")
    window.colours_on_screen(pictures / "window-menu.png")
    window.click(908, 36)  # Title
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
        # -noreset: or the server would start anew whenever the game has ended.
        os.execvpe("xvfb-run", ["xvfb-run", "-a", "-s", f"-screen 0 {WIDTH}x{HEIGHT}x24 -noreset",
                                sys.executable, *sys.argv, "--in-display"], environment)
    with tempfile.TemporaryDirectory() as folder:
        data = pathlib.Path(folder)
        window = Window(options.program, data, f"{WIDTH}x{HEIGHT}")
        billiards(window, options.pictures)
        practice(window, options.pictures)
        window.click(340, 562)  # Quit
        window.wait_for_end()

        window = Window(options.program, data, f"{WIDTH}x{HEIGHT}")
        continue_and_replay(window, data)

        (data / "angry-balls" / "levels").mkdir(parents=True)
        (data / "angry-balls" / "levels" / "broken.json").write_text("{")
        window = Window(options.program, data, f"1000x{HEIGHT}", data / "not-there.json")
        angry_balls(window, options.pictures, data)
        window.click(340, 560)
        window.wait_for_end()
    print("played")


main()
