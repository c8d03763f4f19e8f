#!/usr/bin/env python3
"""What scripts/package is made from agrees with itself; nothing is built here. The package itself is tested by
scripts/package --repeat --check."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

root = pathlib.Path(__file__).resolve().parent.parent.parent
sys.dont_write_bytecode = True
sys.path[:0] = [str(root / "tests/support"), str(root / "scripts/lib")]

from script_test import ScriptTest  # noqa: E402


def text(name):
    return (root / name).read_text()


def licences_of_the_document():
    """Debian package to licence, from the table of docs/licences.md."""
    rows = [line.split("|") for line in text("docs/licences.md").splitlines() if line.startswith("| ")]
    return {package: row[3].strip() for row in rows for package in re.findall(r"`([^`]+)`", row[2])}


def notices():
    """Debian package to licence, of what is compiled into the program, as cmake/package/copyright lists it."""
    return {package: licence for licence, package in re.findall(r"  +(\S+(?:, parts \S+)?) +licences/(\S+)", text("cmake/package/copyright"))}


class Package(ScriptTest):
    def run_script(self, name, *arguments):
        return subprocess.run([next(p for p in (root / "scripts" / name, root / "tests/studies" / name) if p.exists()), *arguments], capture_output=True, text=True, cwd=self.folder)

    def test_shell_scripts_can_be_read(self):
        scripts = [p for p in [*root.glob("scripts/*"), *root.glob("tests/studies/*"), *root.glob("scripts/lib/*.sh")]
                   if p.suffix == ".sh" or p.is_file() and p.read_bytes().startswith(b"#!/bin/sh")]
        self.assertGreaterEqual(len(scripts), 7)
        for script in scripts:
            read = subprocess.run(["sh", "-n", script], capture_output=True, text=True)
            self.assertEqual((read.returncode, read.stderr), (0, ""), script)

    def test_help_and_unknown_arguments(self):
        for name, option in (("package", "--check"), ("debootstrap-check", "--keep"), ("arm-check", "--root")):
            self.assertIn(option, self.run_script(name, "--help").stdout)
            self.assert_refused(self.run_script(name, "--nothing"), name, 3, ["'--nothing'", f"{name} --help"])
            self.assert_refused(self.run_script(name, "--root"), name, 3, ["--root", "folder"])
        self.assert_refused(self.run_script("debootstrap-check", "--suite", "woody"), "debootstrap-check", 3, ["'woody'", "trixie"])
        self.assert_refused(self.run_script("debootstrap-check", "--package", "none.deb"), "debootstrap-check", 3, ["--package", "file"])

    def test_a_system_without_the_packages_is_refused(self):
        # Stand-ins of a system on which nothing is installed and root installs: its sources have no CGAL, or an old Ceres.
        for name, text_of_it in (("dpkg-query", ""), ("id", "echo 0"), ("apt-get", ""),
                                 ("apt-cache", 'case "$2" in libcgal-dev) v="(none)" ;; libceres-dev) v=$CERES ;; *) v=4:99 ;; esac\n'
                                               'echo "  Candidate: $v"')):
            stand_in = pathlib.Path(self.folder, name)
            stand_in.write_text(f"#!/bin/sh\n{text_of_it}\n")
            stand_in.chmod(0o755)
        environment = {**os.environ, "PATH": f"{self.folder}:{os.environ['PATH']}", "SHELLMATCH_SKIP_DEPENDENCIES": "0"}

        def install(ceres):
            return subprocess.run([root / "scripts/install-dependencies"], capture_output=True, text=True, env={**environment, "CERES": ceres})

        self.assert_refused(install("2.2"), "install-dependencies", 3, ["do not have: libcgal-dev.", "--list"])
        cgal = pathlib.Path(self.folder, "apt-cache")
        cgal.write_text(cgal.read_text().replace("(none)", "6.0"))
        self.assert_refused(install("2.0.0"), "install-dependencies", 3, ["libceres-dev 2.0.0 is older than 2.1"])
        self.assertEqual(install("2.2.0+dfsg").returncode, 0)

    def test_libraries_are_put_beside_a_program(self):
        if shutil.which("patchelf") is None:
            self.skipTest("patchelf is not installed (scripts/install-dependencies --package)")
        import bundle
        program, libraries = pathlib.Path(self.folder, "bin/python"), pathlib.Path(self.folder, "lib")
        program.parent.mkdir()
        shutil.copyfile(pathlib.Path("/usr/bin/python3").resolve(), program)
        program.chmod(0o755)
        copied = bundle.bundle([program], libraries)
        self.assertIn("libz.so.1", {name for path in copied for name in (path.name, f"{path.name.split('.so')[0]}.so.1")})
        loaded = bundle.loaded_libraries(program)
        ours = {name for name, path in loaded.items() if path.parent == libraries.resolve()}
        self.assertEqual(ours, set(loaded) - bundle.C_LIBRARY)
        self.assertTrue(all(re.fullmatch(r".+-[0-9a-f]{8}\.so[.0-9]*", name) for name in ours), ours)
        run = subprocess.run([program, "-c", "import zlib; print(zlib.crc32(b'a'))"], capture_output=True, text=True)
        self.assertEqual(run.stdout, "3904355907\n", run.stderr)

    def test_the_licence_is_the_same_everywhere(self):
        self.assertTrue(text("LICENSE").split()[:4] == ["GNU", "GENERAL", "PUBLIC", "LICENSE"] and "Version 3, 29 June 2007" in text("LICENSE"))
        for name in ("CITATION.cff", "CMakeLists.txt", "README.md", "cmake/package/copyright", "docs/licences.md", "pyproject.toml"):
            self.assertIn("GPL-3.0-or-later", text(name), name)
        version = re.search(r"project\(shellmatch VERSION ([0-9.]+)", text("CMakeLists.txt"))[1]
        self.assertIn(f"\nversion: {version}\n", text("CITATION.cff"))

    def test_each_variant_has_a_preset_and_is_packed_once(self):
        presets = {p["name"]: p for p in json.loads(text("CMakePresets.json"))["configurePresets"]}
        variants = re.search(r'^variants="([^"]+)"', text("scripts/package"), re.M).group(1).split()
        self.assertEqual(set(variants), {"x86-64", "x86-64-v3", "x86-64-v4"})
        trees = {}
        for variant in variants:
            preset = presets[f"package-{variant}"]
            self.assertEqual(preset["cacheVariables"]["SHELLMATCH_ARCHITECTURE"], variant)
            trees[variant] = preset["binaryDir"]
        self.assertEqual(len(set(trees.values())), len(variants))
        # The first one holds the program, the others are packed with it; the last one built makes the package.
        first = presets["package-x86-64"]["cacheVariables"]
        self.assertEqual(first["SHELLMATCH_PACKAGE"], "ON")
        self.assertEqual(variants[-1], "x86-64")
        self.assertEqual(sorted(first["SHELLMATCH_PACKAGE_VARIANTS"].split(";")), sorted(trees[v] for v in variants[:-1]))

    def test_tools_are_installed_with_the_dependencies(self):
        listed = re.search(r'^package_packages="([^"]+)"', text("scripts/install-dependencies"), re.M).group(1).split()
        tools = {"dpkg-dev": r"SHLIBDEPS ON", "help2man": r"run\(help2man ", "debootstrap": r"debootstrap --variant"}
        used = text("cmake/Package.cmake") + text("cmake/package/finish.cmake") + text("scripts/lib/minimal-root.sh")
        for package, use in tools.items():
            self.assertIn(package, listed)
            self.assertRegex(used, use)
        self.assertIn("file", listed)  # CPack finds with it what dpkg-shlibdeps is to look at

    def test_notices_are_those_of_the_libraries_whose_code_is_compiled_in(self):
        document = licences_of_the_document()
        # Libraries of headers, by what scripts/install-dependencies installs and the document lists.
        for package, licence in notices().items():
            unversioned = re.sub(r"\d+\.\d+-dev$", "-dev", package)
            self.assertIn(unversioned, document, package)
            self.assertTrue(document[unversioned].startswith(licence.split(",")[0]), f"{package}: {licence}, {document[unversioned]}")
        packed = re.search(r"foreach\(package ([^)]+)\)", text("cmake/Package.cmake")).group(1).split()
        self.assertEqual(sorted(packed), sorted(notices()))
        dependencies = self.run_script("install-dependencies", "--list").stdout.split()
        self.assertLessEqual({re.sub(r"\d+\.\d+-dev$", "-dev", p) for p in packed}, set(dependencies))
        # Fonts are no library, so that dpkg-shlibdeps does not see that pictures need them.
        self.assertIn("CPACK_DEBIAN_PACKAGE_DEPENDS fonts-dejavu-core", text("cmake/Package.cmake"))
        self.assertIn("fonts-dejavu-core", dependencies)


if __name__ == "__main__":
    unittest.main()
