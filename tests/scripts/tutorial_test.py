#!/usr/bin/env python3
"""docs/tutorial.md followed word by word: every command runs, in order, and says what the tutorial shows."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import unittest

root = pathlib.Path(__file__).resolve().parent.parent.parent
sys.dont_write_bytecode = True
sys.path[:0] = [str(root / "tests/support")]

from script_test import path_option  # noqa: E402

build = None
number = re.compile(r"-?\d+(?:\.\d+)?")


def steps(section):
    """Pairs of a command and the lines that it, or one before in this section, is shown to print; what follows python3 in its
    block is python3's input."""
    found = []
    for block in re.findall(r"(?:^    .*\n|^\n(?=    ))+", section, re.M):
        lines = [line[4:] for line in block.splitlines()]
        for i, line in enumerate(lines):
            if line.endswith("/python3"):
                found.append((f"{line} - <<'END'\n" + "\n".join(lines[i + 1 :]) + "\nEND", []))
                break
            if re.match(r"(shellmatch|printf) ", line):
                found.append((line, []))
            elif line:
                found[-1][1].append(line)
    return found


def says(shown, printed):
    """Whether a line that is printed begins as the one that is shown, up to its dots, with numbers within a tenth: digits
    further on are those of one machine."""
    shown = " ".join(shown.split("...")[0].split())
    words = re.compile(f"({number.pattern})".join(map(re.escape, number.split(shown))))
    values = [float(x) for x in number.findall(shown)]
    return any(
        (found := words.match(" ".join(line.split()))) and all(abs(float(a) - b) <= 0.1 * abs(b) for a, b in zip(found.groups(), values))
        for line in printed.splitlines()
    )


class Tutorial(unittest.TestCase):
    def test_every_step(self):
        text = (root / "docs/tutorial.md").read_text()
        sections = [steps(section) for section in text.split("\n## ")]
        self.assertGreaterEqual(sum(map(len, sections)), 16)
        self.assertGreaterEqual(sum(len(shown) for section in sections for _, shown in section), 5)
        has_python = (build / "python/shellmatch").exists()
        begin = time.monotonic()
        with tempfile.TemporaryDirectory() as folder:
            place = pathlib.Path(folder)
            environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER")}
            environment["PATH"] = f"{build}/apps:{environment['PATH']}"
            # The Python package as it was built, in place of an installed one.
            (place / "my-env/bin").mkdir(parents=True)
            (place / "my-env/bin/python3").symlink_to("/usr/bin/python3")
            environment["PYTHONPATH"] = f"{build}/python"
            for section in sections:
                printed = ""
                for command, shown in section:
                    if "python3" in command and not has_python:
                        continue
                    ended = subprocess.run(["bash", "-c", command], cwd=place, env=environment, capture_output=True, text=True)
                    printed += ended.stdout + ended.stderr
                    self.assertEqual(ended.returncode, 0, f"{command}\n{printed}")
                    for line in shown:
                        self.assertTrue(says(line, printed), f"{command}\n--- shown:\n{line}\n--- printed:\n{printed}")
            # What the text says of results.
            moved, back = ([float(x) for x in (place / name).read_text().splitlines()[1].split(",")[1:4]] for name in ("moved.csv", "back.csv"))
            told = re.search(r"`moved.csv` has it at \((.*?)\)", text)[1]
            for x, y in zip(moved, map(float, told.split(", "))):
                self.assertAlmostEqual(x, y, delta=0.002)
            for x, y in zip(back, (0.5, 0.47, 0.78)):
                self.assertAlmostEqual(x, y, delta=1e-6)
            self.assertTrue((place / "hand/report.html").exists())
            outcome = re.compile(r'"outcome": "(.*?)"')
            for name, expected in (("hand", "matched"), ("wrong", "not-matched"), ("right", "matched")):
                self.assertEqual(outcome.search((place / name / "summary.json").read_text())[1], expected, name)
        print(f"{sum(map(len, sections))} steps in {time.monotonic() - begin:.0f} s" + ("" if has_python else ", without Python"))


if __name__ == "__main__":
    build, rest = path_option("--build")
    unittest.main(argv=[sys.argv[0], *rest])
