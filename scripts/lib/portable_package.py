#!/usr/bin/env python3
"""What runs without any package installed, from the build trees of scripts/package: an archive of the program, and a wheel.

    portable_package.py archive|wheel OUTPUT VERSION TREE...

The first tree is that for all processors; the others' libraries go to folders of which the dynamic loader takes the right one
(cmake/Package.cmake). Everything that is written has the time SOURCE_DATE_EPOCH.
"""

import gzip
import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import tempfile

root = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path[:0] = [str(root / "scripts/lib"), str(root / "python/backend")]

import bundle  # noqa: E402
import shellmatch_backend  # noqa: E402


def folder_of(tree, first):
    return "" if tree == first else f"glibc-hwcaps/{tree.name}"


def archive(output, version, trees):
    name = f"shellmatch-{version}-linux-x86_64"
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch) / name
        for tree in trees:
            for component in ["vector_code"] + ["program"] * (tree == trees[0]):
                bundle.run("cmake", "--install", tree, "--component", component, "--prefix", folder)
        (libraries,) = (folder / "lib").glob("*/shellmatch")
        copied = bundle.bundle([folder / "bin/shellmatch", *libraries.rglob("libshellmatch.so*")], libraries)
        bundle.add_fonts(libraries / "fonts")
        bundle.add_notices(copied, folder / "share/doc/shellmatch/licences")
        path = pathlib.Path(output) / f"{name}.tar.gz"
        write_archive(folder, path)
    return path


def write_archive(folder, path):
    when = int(os.environ["SOURCE_DATE_EPOCH"])

    def plain(entry):
        entry.uid = entry.gid = 0
        entry.uname = entry.gname = "root"
        entry.mtime = when
        entry.mode = 0o755 if entry.isdir() or entry.mode & 0o100 else 0o644
        return entry

    with open(path, "wb") as file, gzip.GzipFile("", "wb", 9, file, when) as packed, tarfile.open(fileobj=packed, mode="w") as tar:
        for entry in [folder, *sorted(folder.rglob("*"))]:
            tar.add(entry, entry.relative_to(folder.parent), recursive=False, filter=plain)


def wheel(output, version, trees):
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        package = folder / "shellmatch"
        # Links to the sources are followed: a wheel has none.
        shutil.copytree(trees[0] / "python/shellmatch", package, ignore=shutil.ignore_patterns("__pycache__"))
        libraries = folder / "shellmatch.libs"
        ours = [package / next(package.glob("_core*.so")).name]
        for tree in trees:
            ours.append(libraries / folder_of(tree, trees[0]) / "libshellmatch_core.so")
            ours[-1].parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(tree / "python/libshellmatch_core.so", ours[-1])
        copied = bundle.bundle(ours, libraries, left_out=bundle.COMPILER_LIBRARIES)
        bundle.add_fonts(libraries / "fonts")
        bundle.add_notices(copied, libraries / "licences")
        files = [(str(path.relative_to(folder)), path.read_bytes()) for path in sorted(folder.rglob("*")) if path.is_file()]
        c_library = os.confstr("CS_GNU_LIBC_VERSION").split()[1].replace(".", "_")
        return pathlib.Path(output) / shellmatch_backend.write_wheel(output, files, f"manylinux_{c_library}_x86_64")


def main():
    kind, output, version, *trees = sys.argv[1:]
    for tool in ("patchelf", "ldd", "dpkg", "cmake"):
        if shutil.which(tool) is None:
            raise SystemExit(f"portable_package: {tool} is missing; scripts/install-dependencies --package installs it")
    try:
        path = {"archive": archive, "wheel": wheel}[kind](output, version, [pathlib.Path(tree).resolve() for tree in trees])
    except subprocess.CalledProcessError as error:
        raise SystemExit(f"portable_package: {' '.join(error.cmd)} failed: {error.stderr}") from None
    print(f"{path}: {path.stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
