#!/usr/bin/env python3
"""docs/commands is what this program says of itself, and scripts/command-pages notices where it is not."""

import pathlib
import shutil
import subprocess
import sys
import unittest

root = pathlib.Path(__file__).resolve().parent.parent.parent
sys.dont_write_bytecode = True
sys.path[:0] = [str(root / "tests/support")]

from script_test import ScriptTest, path_option  # noqa: E402

program = ""

# Another program: this one, with one more command.
extended = """#!/bin/sh
if [ "$1" = cohort ]; then
  printf 'Averages shapes.\\nUsage: shellmatch cohort [OPTIONS] LIST\\n\\nOptions:\\n'
  printf '  -h,--help                       Print this help message and exit\\n'
  printf '  --a-name-that-is-too-long A|B|C ...\\n                                  its *meaning*\\n'
  printf '\\nSee docs/output.md, or --help.\\n\\nExamples:\\n  shellmatch cohort list.csv\\n'
elif [ "$1" = --help ]; then
  "{program}" --help | sed 's/^  config  /  cohort                          Averages shapes.\\n&/'
else
  exec "{program}" "$@"
fi
"""


class CommandPages(ScriptTest):
    def run_script(self, *arguments, of=None):
        return subprocess.run([root / "scripts/command-pages", "--program", of or program, *arguments], capture_output=True, text=True)

    def own_pages(self):
        docs = self.folder / "docs"
        shutil.copytree(root / "docs/commands", docs / "commands")
        shutil.copy(root / "docs/commands.md", docs)
        return docs

    def script_file(self, text):
        file = self.folder / "other"
        file.write_text(text)
        file.chmod(0o755)
        return file

    def test_the_pages_are_those_of_this_program(self):
        result = self.run_script("--check")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        names = {page.stem for page in (root / "docs/commands").iterdir()}
        self.assertLessEqual({"match", "apply", "render"}, names)
        for name in names:
            page = (root / f"docs/commands/{name}.md").read_text()
            self.assertIn(f"    shellmatch {name}", page.split("## Examples")[1], name)
            self.assertIn("| `-h,--help` |", page, name)

    def test_what_is_out_of_date_is_named_and_mended(self):
        docs = self.own_pages()
        for damage in (lambda: (docs / "commands/match.md").write_text((docs / "commands/match.md").read_text() + "by hand\n"), lambda: (docs / "commands/match.md").unlink(),
                       lambda: (docs / "commands/match.md").write_text(""), lambda: (docs / "commands/tidy.md").write_text("a command that is gone\n"),
                       lambda: (docs / "commands.md").unlink()):
            self.assertEqual(self.run_script("--check", "--docs", docs).returncode, 0)
            damage()
            before = sorted(docs.rglob("*"))
            result = self.run_script("--check", "--docs", docs)
            self.assert_refused(result, "command-pages", 1, ["out of date", "run scripts/command-pages"])
            self.assertEqual(sorted(docs.rglob("*")), before, "a check writes nothing")
            self.assertEqual(self.run_script("--docs", docs).returncode, 0)

    def test_a_new_command_gets_its_page(self):
        docs, other = self.own_pages(), self.script_file(extended.format(program=program))
        result = self.run_script("--check", "--docs", docs, of=other)
        self.assert_refused(result, "command-pages", 1, ["commands/cohort.md", "commands.md"])
        self.assertEqual(self.run_script("--docs", docs, of=other).returncode, 0)
        page = (docs / "commands/cohort.md").read_text()
        for part in ("# shellmatch cohort\n\nAverages shapes.\n\n    shellmatch cohort [OPTIONS] LIST\n",
                     "\nSee [output.md](../output.md), or `--help`.\n", "## Examples\n\n    shellmatch cohort list.csv\n",
                     "| `--a-name-that-is-too-long A\\|B\\|C ...` | its \\*meaning\\* |\n"):
            self.assertIn(part, page)
        self.assertIn("| [`cohort`](commands/cohort.md) | Averages shapes. |\n", (docs / "commands.md").read_text())

    def test_programs_without_help_are_refused(self):
        docs = self.own_pages()
        self.assert_refused(self.run_script("--docs", docs, of=self.folder / "none"), "command-pages", 1, ["none is not there"])
        for text in ("exit 3", "echo hello", "echo 'A b'; echo 'Usage: x'"):
            self.assert_refused(self.run_script("--docs", docs, of=self.script_file("#!/bin/sh\n" + text)), "command-pages", 1, ["cannot be used"])
        self.assertEqual(self.run_script("--check", "--docs", docs).returncode, 0)


if __name__ == "__main__":
    program, rest = path_option("--program")
    unittest.main(argv=[sys.argv[0], *rest])
