#!/usr/bin/env python3
"""The texts of the repository: C++ is formatted, documents point to what is there, no file names a machine. Each rule is
also held against a planted fault."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

root = pathlib.Path(__file__).resolve().parent.parent.parent
clang_format = next(filter(None, map(shutil.which, ("clang-format-14", "clang-format"))), None)
left_out = {".git", "build", "install", "out", "__pycache__"}
top_folders = {p.name for p in root.iterdir() if p.is_dir()}
# In two pieces, so that this file does not find itself.
machine = re.compile("(?<![\\w./})-])/(?:wo" "rk|ho" "me|ro" "ot|t" "mp|Us" "ers)/|debian" r"\.org|npm" r"js\.|pypi" r"\.org")


def files(folder, *endings):
    found = []
    for where, folders, names in os.walk(folder):
        folders[:] = [f for f in folders if f not in left_out and not f.startswith("build-")]
        found += [pathlib.Path(where) / n for n in names if n.endswith(endings)]
    return sorted(found)


def unformatted(folder):
    """What clang-format complains of in all sources below `folder`."""
    told = subprocess.run([clang_format, "--dry-run", f"--style=file:{root / '.clang-format'}", *files(folder, ".h", ".cpp")],
                          capture_output=True, text=True)
    return [line for line in told.stderr.splitlines() if "warning:" in line or "error:" in line]


def anchors(text):
    return {re.sub(r"[^\w-]", "", line.lstrip("# ").strip().lower().replace(" ", "-"))
            for line in text.splitlines() if line.startswith("#")}


def dead_links(page, text, root):
    """Links of Markdown, and `folder/file.ext`, that name nothing."""
    dead = []
    text = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        if re.match(r"https?:|mailto:", target):
            continue
        name, _, anchor = target.partition("#")
        path = page.parent / name if name else page
        if not path.exists():
            dead.append(target)
        elif anchor and path.suffix == ".md" and anchor not in anchors(text if path == page else path.read_text()):
            dead.append(target)
    for name in re.findall(r"`([\w.-]+/[^`\s]*\.\w+)`", text):
        if name.partition("/")[0] in top_folders - left_out and not any(root.glob(name)):
            dead.append(name)
    return dead


def too_long(folder, most=400):
    """Python below `folder` of more lines, also without an ending; that of C++ is counted in structure_rules.cpp."""
    scripts = (f for f in files(folder, "")
               if f.suffix == ".py" or not f.suffix and f.read_bytes().partition(b"\n")[0].endswith(b"python3"))
    return [str(f) for f in scripts if f.read_text().count("\n") > most]


@unittest.skipUnless(clang_format, "clang-format is not installed")
class Format(unittest.TestCase):
    def setUp(self):
        version = subprocess.run([clang_format, "--version"], capture_output=True, text=True).stdout
        if not re.search(r"version 14\.", version):
            self.skipTest(f"clang-format 14 lays the tree out, and this is another: {version.strip()}")

    def test_the_tree_has_no_difference(self):
        self.assertEqual(unformatted(root), [])

    def test_a_difference_is_seen(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "near.h").write_text("int x = 1;\n")
            self.assertEqual(unformatted(folder), [])
            (pathlib.Path(folder) / "far.h").write_text("int  x=1 ;\n")
            self.assertIn("far.h", "".join(unformatted(folder)))


class Texts(unittest.TestCase):
    def test_documents_point_to_what_is_there(self):
        dead = {str(page): found for page in files(root, ".md") if (found := dead_links(page, page.read_text(), root))}
        self.assertEqual(dead, {})

    def test_dead_links_are_seen(self):
        page = root / "docs/index.md"
        near = "# A head\n[a](index.md) [b](#a-head) [c](https://example.com/x) `out/x.ply` `base/error.h` `base/err*.h`\n"
        self.assertEqual(dead_links(page, near, root), [])
        far = "# A head\n[a](nowhere.md) [b](#no-head) `base/nothing.h`\n"
        self.assertEqual(dead_links(page, far, root), ["nowhere.md", "#no-head", "base/nothing.h"])

    def test_no_file_names_a_machine(self):
        endings = (".h", ".cpp", ".md", ".py", ".txt", ".cmake", ".yaml", ".yml", ".js", ".json", ".toml")
        named = [str(f) for f in [*files(root, *endings), *(f for f in (root / "scripts").iterdir() if f.is_file())]
                 if machine.search(f.read_text(errors="replace"))]
        self.assertEqual(named, [])

    def test_machines_are_seen(self):
        self.assertIsNone(machine.search("docs/ho" "me/page, ${root}/t" "mp/x and /usr/share/doc"))
        self.assertIsNotNone(machine.search("cd /ho" "me/somebody"))

    def test_scripts_are_short(self):
        self.assertEqual(too_long(root), [])

    def test_long_scripts_are_seen(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "near.py").write_text("pass\n" * 400)
            self.assertEqual(too_long(folder), [])
            (pathlib.Path(folder) / "far.py").write_text("pass\n" * 401)
            (pathlib.Path(folder) / "script").write_text("#!/usr/bin/env python3\n" * 401)
            self.assertEqual(len(too_long(folder)), 2)

    def test_bits_do_not_depend_on_addresses(self):
        """Eigen's stable norms (3.4) have other last bits at other addresses; unit_or_zero() has not."""
        used = [str(f) for f in files(root, ".h", ".cpp") if re.search(r"\.stableNorm", f.read_text())]
        self.assertEqual(used, [])


if __name__ == "__main__":
    unittest.main()
