"""Puts the shared libraries that programs load beside them, so that they run where none of them is installed.

The copies have names of their own, so that they are not taken for other libraries of a process. Needs ldd, dpkg and patchelf.
"""

import hashlib
import os
import pathlib
import re
import shutil
import subprocess

# What every system with the GNU C library has, and what must be the system's own, as it belongs to the kernel and the dynamic loader.
C_LIBRARY = {"linux-vdso.so.1", "libc.so.6", "libm.so.6", "libmvec.so.1", "libpthread.so.0", "libdl.so.2", "librt.so.1", "libutil.so.1",
             "libresolv.so.2", "ld-linux-x86-64.so.2"}
# What a Python process has once: its other modules may need a newer one than ours.
COMPILER_LIBRARIES = {"libstdc++.so.6", "libgcc_s.so.1"}


def run(*command):
    return subprocess.run([os.fspath(c) for c in command], check=True, capture_output=True, text=True).stdout


def loaded_libraries(file):
    """All libraries that the dynamic loader takes for this file: {name: path}."""
    libraries = {}
    for line in run("ldd", file).splitlines():
        if "not found" in line:
            raise SystemExit(f"bundle: {file} cannot be loaded here: {line.strip()}")
        if match := re.match(r"\s*(\S+) => (\S+) \(", line):
            libraries[match[1]] = pathlib.Path(match[2]).resolve()
    return libraries


def bundle(files, folder, left_out=frozenset()):
    """Copies what these files load into the folder, and points the files and the copies to it. Returns the paths that were copied."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    own = {pathlib.Path(file).name for file in files}
    sources = {}
    for file in files:
        sources.update({name: path for name, path in loaded_libraries(file).items() if name not in own | C_LIBRARY | left_out})
    names = {}
    for name, path in sources.items():
        stem, _, rest = name.partition(".so")
        names[name] = f"{stem}-{hashlib.sha256(path.read_bytes()).hexdigest()[:8]}.so{rest}"
        copy = folder / names[name]
        shutil.copyfile(path, copy)
        copy.chmod(0o755)
        run("patchelf", "--set-soname", names[name], copy)
    for file in [folder / name for name in names.values()] + [pathlib.Path(file) for file in files]:
        needed = run("patchelf", "--print-needed", file).split()
        for name in needed:
            if name in names:
                run("patchelf", "--replace-needed", name, names[name], file)
        to_folder = os.path.relpath(folder, file.parent)
        run("patchelf", "--set-rpath", "$ORIGIN" if to_folder == "." else f"$ORIGIN/{to_folder}", file)
    return sorted(set(sources.values()))


def add_notices(libraries, folder):
    """Copies the copyright files of the Debian packages that these libraries are from."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for library in libraries:
        # Debian has merged /lib into /usr/lib, and its packages name either.
        for path in (library, pathlib.Path(*library.parts[:1], *library.parts[2:])):
            found = subprocess.run(["dpkg", "-S", path], capture_output=True, text=True)
            if found.returncode == 0:
                package = found.stdout.split(":")[0]
                shutil.copyfile(f"/usr/share/doc/{package}/copyright", folder / package)
                break
        else:
            raise SystemExit(f"bundle: no package has {library}, so that its licence is not known")


def add_fonts(folder):
    """The two fonts of our pictures (matching/render/canvas/fontconfig_fonts.h)."""
    pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
    for name in ("DejaVuSans.ttf", "DejaVuSans-Bold.ttf"):
        shutil.copyfile(f"/usr/share/fonts/truetype/dejavu/{name}", pathlib.Path(folder) / name)
