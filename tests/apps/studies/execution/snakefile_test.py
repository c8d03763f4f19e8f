#!/usr/bin/env python3
"""The head of the Snakefile, which is plain Python, with names that a shell or Snakemake would misread."""
import os
import pathlib
import stat
import sys
import tempfile
import unittest

SNAKEFILE = pathlib.Path(__file__).resolve().parents[4] / "apps/studies/workflow/Snakefile"


class Head(unittest.TestCase):
    def run_head(self, folder, **config):
        program = os.path.join(folder, "program")
        with open(program, "w") as f:
            f.write('#!/bin/sh\nprintf "%s\\n" "$@" > words\nprintf "a-r1\\t1\\t10\\t0\\n"\n')
        os.chmod(program, os.stat(program).st_mode | stat.S_IXUSR)
        head = SNAKEFILE.read_text().split("localrules:")[0]
        before = os.getcwd()
        os.chdir(folder)
        try:
            names = {"config": {"program": program, **config}}
            exec(compile(head, str(SNAKEFILE), "exec"), names)
            return names, pathlib.Path("words").read_text().split("\n")
        finally:
            os.chdir(before)

    def test_a_study_that_begins_with_a_hyphen_is_no_option(self):
        with tempfile.TemporaryDirectory() as folder:
            names, words = self.run_head(folder, study="-x.yaml")
            self.assertEqual(words[:2], ["study", "./-x.yaml"])
            self.assertIn("study ./-x.yaml -o out/-x", names["command"])
            names, _ = self.run_head(folder, study="x.yaml", out="-o")
            self.assertEqual(names["out"], "./-o")

    def test_braces_in_the_folder_are_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            for out in ("a{b}", "a}", "{run}"):
                with self.assertRaises(SystemExit) as caught:
                    self.run_head(folder, study="x.yaml", out=out)
                self.assertIn("braces", str(caught.exception.code))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
