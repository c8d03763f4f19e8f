"""Matchings on few levels, how far their vertices end from where they belong, and what was said of their alignment."""
import concurrent.futures
import dataclasses
import hashlib
import json
import pathlib
import random
import subprocess

from lib import meshes, transforms

from .cases import MIRRORED, TURNED


def fingerprint(words, files):
    value = hashlib.sha256("\0".join(map(str, words)).encode())
    for path in files:
        value.update(pathlib.Path(path).read_bytes())
    return value.hexdigest() + "\n"


@dataclasses.dataclass(frozen=True)
class Study:
    program: str
    data: pathlib.Path
    output: pathlib.Path
    jobs: int

    def call(self, *words):
        done = subprocess.run([self.program, *map(str, words)], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise RuntimeError(f"{' '.join(map(str, words))}: exit code {done.returncode}: {done.stderr.strip()}")

    def file(self, shape):
        """Built-in shapes become files of the output folder."""
        if pathlib.Path(shape).suffix:
            return self.data / shape
        path = self.output / f"{shape.replace('/', '-')}.off"
        if not path.exists():
            self.call("generate", shape, "-o", path)
        return path

    def summary(self, reference, template, levels, folder, truth=None, options=()):
        """`truth`: pairs of the number of a reference's vertex and the point where it belongs. A run is kept while its words, its files and
        the program are the same."""
        folder.parent.mkdir(parents=True, exist_ok=True)
        known, made_by = folder.with_suffix(".txt"), folder.with_suffix(".made-by")
        if truth is not None:
            known.write_text("".join(f"{i} {x!r} {y!r} {z!r}\n" for i, (x, y, z) in truth))
            options = (*options, "--set", f"input.correspondence={known}")
        words = ["match", reference, template, "-o", folder, "--levels", levels, "--align", "auto", "--threads", 1, "-q", "--force",
                 "--set", "pictures=none", "--set", "report=false", *options]
        made = fingerprint(words, [self.program, *(w for w in (reference, template, known, *options) if pathlib.Path(w).is_file())])
        if not (folder / "summary.json").exists() or not made_by.exists() or made_by.read_text() != made:
            self.call(*words)
            made_by.write_text(made)
        return json.loads((folder / "summary.json").read_text())

    def map(self, function, items):
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            return list(pool.map(function, items))


def known_points(reference, template):
    """Numbers of the reference's vertices and their points of the template."""
    points = meshes.read(template)[0]
    vts = [path.with_suffix(".vts") for path in (reference, template)]
    if all(path.exists() for path in vts):
        numbers = [[int(float(word)) - 1 for word in path.read_text().split()] for path in vts]
        return [(i, points[j]) for i, j in dict(zip(*numbers)).items()]
    return list(enumerate(points))


def turned_errors(study, name, turns, levels):
    """Mean distances, in diagonals of the template, of turned and then of mirrored references from where the one that is not turned ends."""
    reference, template = map(study.file, TURNED[name])
    folder = study.output / name.replace(" ", "-")
    study.summary(reference, template, levels, folder / "unturned")
    ends = list(enumerate(meshes.read(folder / "unturned/deformed.ply")[0]))
    points, faces = meshes.read(reference)
    source = random.Random(f"{name}: a rotation for each")

    def error_of(turn):
        what, placed, sides, options = turn
        path = folder / f"{what}.off"
        meshes.write_off(path, placed, sides)
        return study.summary(path, template, levels, folder / what, ends, options)["correspondence_error"]

    rotations = [transforms.random_rotation(source) for _ in range(turns)]
    cases = [(f"turned-{k}", transforms.rotated(points, r), faces, ()) for k, r in enumerate(rotations)]
    if name in MIRRORED:
        flipped, inside_out = transforms.mirrored(points, faces, "x")
        cases += [(f"mirrored-{k}", transforms.rotated(flipped, r), inside_out, ("--set", "align.search.mirror=true"))
                  for k, r in enumerate(rotations[:4])]
    errors = study.map(error_of, cases)
    return errors[:turns], errors[turns:]


def pair_result(study, number, pair, is_one_kind, levels):
    """The mean error in diagonals, None where no map is right, and `alignment` of the summary."""
    reference, template = map(study.file, pair)
    folder = study.output / "pairs" / f"{number}-{reference.stem}-{template.stem}"
    truth = known_points(reference, template) if is_one_kind else None
    summary = study.summary(reference, template, levels, folder, truth)
    return summary.get("correspondence_error"), summary["alignment"]
