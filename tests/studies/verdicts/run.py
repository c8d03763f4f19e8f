"""One run: its shapes, `shellmatch match`, its summary."""
import dataclasses
import json
import pathlib
import re
import subprocess

from lib import meshes

from .cases import Case


RIGHT_BELOW = 0.02  # mean error of known correspondences, in diagonals


@dataclasses.dataclass
class Result:
    case: Case
    summary: dict
    error: str = ""

    @property
    def is_right(self):
        """By known correspondences where there are any: some turned shapes find their way back."""
        if self.case.has_known_errors:
            return self.summary["correspondence_error"] < RIGHT_BELOW
        return self.case.kind == "right"


def as_file(program, shape, folder, name):
    if pathlib.Path(shape).suffix:
        return shape
    path = folder / f"{name}-original.off"
    subprocess.run([program, "generate", shape, "-o", str(path), "--force"], check=True, capture_output=True)
    return str(path)


def write_known_points(points, path):
    path.write_text("".join(f"{i} {p[0]!r} {p[1]!r} {p[2]!r}\n" for i, p in enumerate(points)))
    return ("--set", f"input.correspondence={path}")


def inputs(case, program, folder, name):
    """Words for `shellmatch match`; a shape that is changed before becomes a file."""
    if case.change is None:
        words = [shape if pathlib.Path(shape).suffix else f"generate:{shape}" for shape in (case.reference, case.template)]
        points = meshes.read(case.template)[0] if case.has_known_errors else []
    else:
        template = folder / f"{name}.off"
        points, faces = case.change(*meshes.read(as_file(program, case.template, folder, f"{name}-template")))
        meshes.write_off(template, points, faces)
        words = [as_file(program, case.reference, folder, f"{name}-reference"), str(template)]
    return words + (list(write_known_points(points, folder / f"{name}.txt")) if case.has_known_errors else [])


def run_case(case, program, output):
    name = re.sub(r"[^a-z0-9]+", "-", case.name.lower()).strip("-")
    summary = output / name / "summary.json"
    if not summary.exists():
        try:
            shape_words = inputs(case, program, output, name)
        except (OSError, subprocess.CalledProcessError) as error:
            return Result(case, {}, str(error))
        levels = () if "--levels" in case.options else ("--levels", "3:6")
        align = () if "--align" in case.options else ("--align", "none")
        words = [program, "match", *shape_words, "-o", str(output / name), "-q", "--force", "--set", "pictures=result", "--set", "report=false", "--threads", "1",
                 "--max-seconds", "600", *levels, *align, *case.options]
        run = subprocess.run(words, capture_output=True, text=True, check=False)
        if run.returncode != 0:
            return Result(case, {}, f"exit code {run.returncode}: {run.stderr.strip()}")
    return Result(case, json.loads(summary.read_text()))
