"""Plots drawn by the program's plot writer (matching/render/canvas/plot.h)."""

import json
import pathlib
import shutil
import subprocess

root = pathlib.Path(__file__).resolve().parent.parent.parent
default_program = root / "build/release/tests/studies/plot/plot_series"


def draw(plot, path, program=default_program):
    """Writes .svg or .png, by the extension of `path`; `plot` has the members of Plot. Raises RuntimeError on failure."""
    try:
        result = subprocess.run([str(program), str(path)], input=json.dumps(plot), capture_output=True, text=True)
    except OSError as error:
        raise RuntimeError(f"{program} cannot be run ({error.strerror}); build it with scripts/build release plot_series") from error
    if result.returncode != 0:
        raise RuntimeError(f"{path} cannot be drawn: {result.stderr.strip()}")
    if pathlib.Path(path).suffix == ".png" and shutil.which("convert"):
        # A palette reduces the size to a third without a visible difference.
        subprocess.run(["convert", str(path), "-colors", "48", "-strip", "-define", "png:exclude-chunks=date,time", f"PNG8:{path}"],
                       check=False)
