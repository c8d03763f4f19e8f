"""Readers of volumes other than shellmatch, here and in other Debian systems: for scripts/study frames-table."""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy as np
from frame_files import MIDDLE

FRAMES = pathlib.Path(__file__).resolve().parent
BUILD = "cmake -S {0}/frames -B {0}/build && cmake --build {0}/build"
BY_NIBABEL = """
import json, nibabel, sys
def middle(points): return (points.min(0) + points.max(0)) / 2
def answer(name, *where):
    if name == "--version": return [nibabel.__version__]
    if name.endswith(".gii"): return middle(nibabel.load(name).agg_data("pointset").reshape(-1, 3))
    if name.endswith(".white"): return middle(nibabel.freesurfer.read_geometry(name)[0])
    return nibabel.affines.apply_affine(nibabel.load(name).affine, [float(a) for a in where])
for line in sys.stdin:
    try: print(*answer(*json.loads(line)), flush=True)
    except Exception: print("not read", flush=True)
"""


class System:
    """This machine, or a Debian in a folder; `folder` is one of its own for files that its programs see."""

    def __init__(self, root=None):
        self.root, self.nibabel = root, None
        self.folder = pathlib.Path(tempfile.mkdtemp(dir=root / "tmp" if root else None))
        shutil.copytree(FRAMES, self.folder / "frames")

    def path(self, path):
        """As its programs name it."""
        return "/" / path.relative_to(self.root) if self.root else path

    def command(self, *words):
        command = [str(self.path(word)) if isinstance(word, pathlib.Path) else word for word in words]
        return ["chroot", str(self.root), *command] if self.root else command

    def run(self, *words):
        return subprocess.run(self.command(*words), capture_output=True, text=True, check=False)

    def ask_nibabel(self, *words):
        """One Python answers all questions: it takes longer to start than to read a file."""
        if self.nibabel is None:
            python = "/usr/bin/python3" if self.root else sys.executable
            self.nibabel = subprocess.Popen(self.command(python, "-c", BY_NIBABEL), stdin=subprocess.PIPE,
                                            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        question = json.dumps([str(self.path(word)) if isinstance(word, pathlib.Path) else word for word in words])
        try:
            self.nibabel.stdin.write(question + "\n")
            self.nibabel.stdin.flush()
        except BrokenPipeError:  # it is not installed
            pass
        answer = self.nibabel.stdout.readline()
        failed = not answer or answer.startswith("not read")
        return subprocess.CompletedProcess(words, int(failed), answer)

    def readers(self):
        """Name with version, and reader, of those that it has."""
        self.run("sh", "-c", BUILD.format(self.path(self.folder)))
        itk = lambda *words: self.run(self.folder / "build/itk_place", *words)
        if (done := self.ask_nibabel("--version")).returncode == 0:
            endings = [".nii", ".gii", ".white"]
            yield f"nibabel {done.stdout.strip()}", lambda path: self.place(self.ask_nibabel, path, endings, 1)
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
        if self.nibabel is not None:
            self.nibabel.communicate()
        shutil.rmtree(self.folder)
