"""Readers of volumes other than shellmatch, here and in other Debian systems: for scripts/study frames-table."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy as np
from frame_files import MIDDLE

FRAMES = pathlib.Path(__file__).resolve().parent
BUILD = "cmake -S {0}/frames -B {0}/build -DCMAKE_BUILD_TYPE=Release && cmake --build {0}/build"
BY_NIBABEL = """
import nibabel, sys
def middle(points): return (points.min(0) + points.max(0)) / 2
name = sys.argv[1]
if name == "--version": print(nibabel.__version__)
elif name.endswith(".gii"): print(*middle(nibabel.load(name).agg_data("pointset").reshape(-1, 3)))
elif name.endswith(".white"): print(*middle(nibabel.freesurfer.read_geometry(name)[0]))
else: print(*nibabel.affines.apply_affine(nibabel.load(name).affine, [float(a) for a in sys.argv[2:]]))
"""


class System:
    """This machine, or a Debian in a folder; `folder` is one of its own for files that its programs see."""

    def __init__(self, root=None):
        self.root = root
        self.folder = pathlib.Path(tempfile.mkdtemp(dir=root / "tmp" if root else None))
        shutil.copytree(FRAMES, self.folder / "frames")

    def path(self, path):
        """As its programs name it."""
        return "/" / path.relative_to(self.root) if self.root else path

    def run(self, *words):
        command = [str(self.path(word)) if isinstance(word, pathlib.Path) else word for word in words]
        return subprocess.run(["chroot", self.root, *command] if self.root else command, capture_output=True, text=True,
                              check=False)

    def readers(self):
        """Name with version, and reader, of those that it has."""
        python = "/usr/bin/python3" if self.root else sys.executable
        nibabel = lambda *words: self.run(python, "-c", BY_NIBABEL, *words)
        self.run("sh", "-c", BUILD.format(self.path(self.folder)))
        itk = lambda *words: self.run(self.folder / "build/itk_place", *words)
        if (done := nibabel("--version")).returncode == 0:
            endings = [".nii", ".gii", ".white"]
            yield f"nibabel {done.stdout.strip()}", lambda path: self.place(nibabel, path, endings, 1)
        if (self.folder / "build/itk_place").is_file():
            version = itk("--version").stdout.strip()
            yield f"ITK {version}", lambda path: self.place(itk, path, [".nii", ".nrrd", ".mha"], -1)

    def place(self, reader, path, endings, sign):
        """Of the middle of the block or the surface's box in RAS; None for a format that the reader does not know, or
        "not read"."""
        if path.suffix not in endings:
            return None
        here = pathlib.Path(shutil.copy(path, self.folder))
        done = reader(here, *map(str, MIDDLE))
        here.unlink()
        if done.returncode != 0:
            return "not read"
        return np.array([sign, sign, 1]) * [float(a) for a in done.stdout.split()]

    def remove(self):
        shutil.rmtree(self.folder)
