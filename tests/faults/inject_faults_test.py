#!/usr/bin/env python3
"""Tests that tests/faults/inject_faults notices a program that misbehaves.

usage: inject_faults_test.py --program SHELLMATCH
"""

import argparse
import pathlib
import subprocess
import sys
import unittest

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(here.parent / "support"))

from script_test import ScriptTest  # noqa: E402

program = None  # under test


class Misbehaviour(ScriptTest):
    def inject(self, command, after):
        """The output for a program that runs the real one and then these lines of a shell, which know its exit code."""
        fake = self.folder / "shellmatch"
        fake.write_text(f"#!/bin/sh\n'{program}' \"$@\"\ncode=$?\n{after}\n"
                        "[ $code = 137 ] && kill -KILL $$  # dies as the real one was killed\nexit $code\n")
        fake.chmod(0o755)
        done = subprocess.run([here / "inject_faults", "--program", fake, "--only", command, "--random-kills", "0", "--kills", "4", "--faults",
                               "40", "--memory", "0"], capture_output=True, text=True)
        if done.returncode == 77:
            sys.exit(77)
        return done

    def test_nothing_to_complain_of(self):
        done = self.inject("generate-force", "")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn(": 0 with violations", done.stdout)

    def test_what_is_noticed(self):
        for after, told in [("[ $code = 3 ] || [ $code = 6 ] && code=70", "exit code 70"),
                            ("[ $code = 0 ] || rm -f thesis.txt", "files of the user have changed: thesis.txt"),
                            ("[ $code = 0 ] || : > o.csv", "neither the earlier nor the new result"),
                            ("[ $code = 0 ] || echo part > .o.csv.partial-1", "left behind: .o.csv.partial-1"),
                            ("[ $code = 0 ] || echo part > remains", "the repetition made something else: remains in excess"),
                            ("[ $code = 0 ] || echo 'shellmatch: error: and a second one, which is not necessary' >&2", "not one clear message"),
                            ("code=0", "an error, but exit code 0")]:
            with self.subTest(after):
                done = self.inject("generate-force", after)
                self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
                self.assertIn(told, done.stdout)
                self.assertIn("again: tests/faults/inject_faults --case generate-force ", done.stdout)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("--program", required=True)
    arguments, rest = parser.parse_known_args()
    program = arguments.program
    unittest.main(argv=[sys.argv[0], *rest])
