#!/usr/bin/env python3
"""Kills the game with SIGKILL at random moments, many times over, while it plays and saves after
every launch and turn. Each time the save must be whole, prove itself, and hold every turn that was over when
the game said so; now and then it is continued."""

import argparse
import json
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

LEVEL = {"carom": 1, "name": "Many throws", "width": 1000, "height": 500, "gravity": 600,
         "edges": {"left": "open", "right": "open", "top": "open"}, "throws": 40,
         "balls": [{"x": 110, "y": 120, "radius": 12, "role": "projectile"},
                   {"x": 500, "y": 20, "radius": 20, "role": "enemy"},
                   {"x": 700, "y": 20, "radius": 20, "role": "enemy"}]}
SIZE = "1000x720"  # shows the level pixel by pixel
LAUNCH = [110, 496]
SAVES = {"level": "continue-level-0001.json", "billiards": "continue-billiards-0001.json"}


def lines(*actions):
    return "".join(json.dumps(action) + "\n" for action in actions)


def level_script(throws, rng):
    actions = [{"at": 0.1, "key": key} for key in
               ("Tab", "Tab", "Tab", "Tab", "Return", "Shift+Tab", "Shift+Tab", "Shift+Tab", "Return")]
    at = 1.0
    for throw in range(throws):
        drag = [LAUNCH[0] + rng.randint(-90, 60), LAUNCH[1] - rng.randint(1, 60)]
        # Every throw is over after 30 s at the latest.
        actions += [{"at": at, "click": LAUNCH}, {"at": at, "click": drag},
                    {"at": at + 31, "print": True}, {"at": at + 31, "key": "N"}]
        if throw == 2:  # the game offers to go on by itself: no
            actions.append({"at": at + 31.5, "key": "Escape"})
        at += 32
    return lines(*actions)


def billiards_script(root):
    """The demonstration, with a word after each of its turns."""
    actions = [json.loads(line) for line in (root / "demos/billiards.jsonl").read_text().split("\n")
               if line]
    clicks = [action["at"] for action in actions if "click" in action][1:]  # but the title's
    ends = clicks[2::2] + [actions[-1]["at"] + 60]
    words = [{"at": at, "print": True} for at in ends]
    return lines(*sorted(actions + words, key=lambda action: action["at"]))


class Game:
    def __init__(self, options, folder):
        self.options = options
        self.folder = folder
        (folder / "level.json").write_text(json.dumps(LEVEL))

    def command(self, script, data, size):
        return [self.options.angry_balls, "--lang", "en", "--size", size, "--data", data,
                "--script", script, self.folder / "level.json"]

    def verified_turns(self, save):
        """How many turns the save holds; it must prove itself."""
        proof = subprocess.run([self.options.carom, "replay", "--verify", save],
                               capture_output=True, text=True)
        if proof.returncode != 0 or not proof.stdout.startswith("verified, "):
            sys.exit(f"{save}: {proof.stdout}{proof.stderr}")
        return int(proof.stdout.split()[1])

    def kill_once(self, script, size, save_name, data, delay, turns):
        """Returns how many of the turns were told and how many are kept."""
        told_file = self.folder / "told.txt"
        with open(told_file, "w") as told:
            game = subprocess.Popen(self.command(script, data, size), stdout=told,
                                    stderr=subprocess.PIPE)
            time.sleep(delay)
            game.send_signal(signal.SIGKILL)
            game.wait()
        game.stderr.close()
        # At its end, even when it is killed after that, it says one line more, of no new turn.
        words = min(turns, told_file.read_text().count("\n"))
        save = data / save_name
        return words, self.verified_turns(save) if save.exists() else 0, game.returncode != 0


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("angry_balls", type=pathlib.Path)
    parser.add_argument("carom", type=pathlib.Path)
    parser.add_argument("--kills", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    rng = random.Random(options.seed)
    root = pathlib.Path(__file__).parents[2]
    began = time.monotonic()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        game = Game(options, folder)
        plays = []
        for kind, script, size in (("level", level_script(12, rng), SIZE),
                                   ("billiards", billiards_script(root), "1280x720")):
            path = folder / f"{kind}.jsonl"
            path.write_text(script)
            # Once to the end: how long it takes, and that the script does what it should.
            data = folder / f"{kind}-whole"
            start = time.monotonic()
            told = subprocess.run(game.command(path, data, size), check=True,
                                  capture_output=True, text=True).stdout.count("\n") - 1
            seconds = time.monotonic() - start
            turns = game.verified_turns(data / SAVES[kind])
            if not told or turns != told:
                sys.exit(f"{kind}: {told} turns were told, {turns} are kept")
            print(f"{kind}: {turns} turns in {seconds:.3f} s")
            plays.append((kind, path, size, seconds, turns))

        kept_turns = {}
        killed = 0
        left_aside = 0
        nothing = folder / "nothing.jsonl"
        nothing.write_text("")
        for run in range(options.kills * 3):
            if killed == options.kills:
                break
            kind, script, size, seconds, turns = plays[0 if run % 4 else 1]
            data = folder / f"run-{run}"
            data.mkdir()
            told, kept, was_killed = game.kill_once(script, size, SAVES[kind], data,
                                                    rng.uniform(0, seconds), turns)
            killed += was_killed
            if not told <= kept <= turns:
                sys.exit(f"run {run}: {told} turns were told, {kept} are kept")
            kept_turns[kept] = kept_turns.get(kept, 0) + 1
            # A file half written when the kill came goes at the next start.
            if any(data.glob("*.part-*")):
                left_aside += 1
                subprocess.run(game.command(nothing, data, size), check=True, capture_output=True)
                if left := list(data.glob("*.part-*")):
                    sys.exit(f"run {run}: still there after the next start: {left}")
            if kept and run % 10 == 0:
                go_on = folder / "go-on.jsonl"
                go_on.write_text(lines({"at": 0.1, "key": "Return"}, {"at": 2, "print": True}))
                said = subprocess.run(game.command(go_on, data, size), check=True,
                                      capture_output=True, text=True).stdout
                if "title screen" in said or "not continued" in said:
                    sys.exit(f"run {run} cannot be continued: {said}")
        if killed < options.kills:
            sys.exit(f"only {killed} runs were killed in time")
        if len(kept_turns) < 3:
            sys.exit(f"the kills came at too few different moments: {kept_turns}")
        print(f"{killed} kills, {left_aside} in the middle of a save, none lost or broken; turns kept: "
              + ", ".join(f"{turns} ({count}×)" for turns, count in sorted(kept_turns.items())))
        print(f"{time.monotonic() - began:.1f} s")


if __name__ == "__main__":
    main()
