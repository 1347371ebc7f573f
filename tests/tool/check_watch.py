#!/usr/bin/env python3
"""carom check --watch says what is wrong each time a level's file changes, also when it is gone and when
it comes back."""

import pathlib
import queue
import subprocess
import sys
import tempfile
import threading

PATIENCE = 30  # s


def main():
    carom = str(pathlib.Path(sys.argv[1]).resolve())
    root = pathlib.Path(__file__).resolve().parent.parent.parent
    sound = (root / "levels/01-first-steps.json").read_text()
    with tempfile.TemporaryDirectory() as name:
        level = pathlib.Path(name) / "level.json"
        level.write_text(sound)
        watching = subprocess.Popen([carom, "check", "--watch", str(level)], text=True,
                                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        lines = queue.Queue()
        threading.Thread(target=lambda: [lines.put(line) for line in watching.stdout], daemon=True).start()

        def save(text):  # at once: half a file would be reported, too
            aside = level.with_suffix(".new")
            aside.write_text(text)
            aside.replace(level)

        def expect(part):
            line = lines.get(timeout=PATIENCE)
            if part not in line:
                sys.exit(f"expected {part!r}, got {line!r}")

        try:
            expect("level.json: ok")
            expect("level.json: won by")
            save("{")
            expect("level.json:1:2:")
            level.unlink()
            expect("No such file")
            save(sound)
            expect("level.json: ok")
            expect("level.json: won by")
        except queue.Empty:
            sys.exit("said nothing after a change")
        finally:
            watching.terminate()
        if (status := watching.wait(PATIENCE)) != -15:
            sys.exit(f"exit status {status} after SIGTERM")
        if not lines.empty():
            sys.exit(f"said more: {lines.get()!r}")


main()
