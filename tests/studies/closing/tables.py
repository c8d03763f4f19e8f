"""The two tables of docs/closing.md: files with gaps, and pairs of which a third is cut away."""
import json
import math
import re
import subprocess
import time

from closing import cuts
from lib import meshes, transforms

LEVELS = ["--levels", "3:6", "--align", "none", "--set", "pictures=none", "--force"]


def run(program, *arguments):
    begin = time.time()
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, check=False)
    return done, time.time() - begin


def words_of(done, path):
    """The one message of a refusal, without the file's name."""
    lines = [line for line in done.stderr.splitlines() if "error:" in line]
    return re.sub(r"^.*?error: ", "", lines[0]).replace(f"{path}: ", "").split("; close its holes")[0].split(", one from")[0] if lines else "ended without a message"


def result_of(folder):
    return json.loads((folder / "summary.json").read_text()), meshes.read(folder / "deformed.ply")[0]


def mean_error(ends, truth, numbers):
    return sum(math.dist(ends[i], truth[v]) for i, v in numbers) / len(numbers) / transforms.diagonal(truth)


def dirty_row(program, path, folder):
    folder.mkdir(parents=True, exist_ok=True)
    strict, _ = run(program, "match", path, path, "-o", folder / "strict", "--levels", "3:3", "--strict", *LEVELS[2:])
    before = "read" if strict.returncode == 0 else words_of(strict, path)
    end = ["", "", "", ""]
    try:
        points, faces = meshes.read(path)
        truth = cuts.bent(points)
        meshes.write_off(folder / "bent.off", truth, faces)
        done, seconds = run(program, "match", path, folder / "bent.off", "-o", folder / "run", *LEVELS)
        if done.returncode == 0:
            summary, ends = result_of(folder / "run")
            used = sorted({v for f in faces for v in f})
            invented = [summary[s].get("invented") for s in ("reference", "template")]
            end = ["-" if invented == [None, None] else f"{100 * max(x or 0 for x in invented):.2g} %", summary["verdict"]["outcome"],
                   f"{mean_error(ends, truth, [(v, v) for v in used]):.1e}", f"{seconds:.1f}"]
        else:
            end = ["", words_of(done, path), "", f"{seconds:.1f}"]
    except (ValueError, IndexError, KeyError, StopIteration):  # a file that nobody reads: the program's words
        done, seconds = run(program, "inspect", path)
        end = ["", words_of(done, path), "", f"{seconds:.1f}"]
    return [path.name, before, *end]


def dirty_table(program, data, folder):
    rows = ["| file | strictly | made up | now | mean error | s |", "| --- | --- | --- | --- | --- | --- |"]
    paths = sorted(path for path in (data / "dirty").iterdir() if path.name != "SOURCES.md")
    return rows + ["| " + " | ".join(dirty_row(program, path, folder / path.name)) + " |" for path in paths]


def dirty_counts(rows):
    cells = [[cell.strip() for cell in row.split("|")[1:-1]] for row in rows[2:]]
    read = sum(row[1] == "read" for row in cells)
    closed = sum(row[1] != "read" and row[4] != "" for row in cells)
    refused = len(cells) - read - closed
    return f"Of {len(cells)} files {read} are read strictly, {closed} are matched after closing, and {refused} are refused."


# Reference, template with the same numbers of vertices, and the direction whose farthest third is cut away.
PAIRS = [("heads, back and neck", "heads_ict/head_neutral.off", "heads_ict/head_sample.off", (0, -0.3, -1)),
         ("heads, face", "heads_ict/head_neutral.off", "heads_ict/head_sample.off", (0, 0, 1)),
         ("bodies, legs", "bodies_makehuman/woman_young.off", "bodies_makehuman/man_old_heavy.off", (0, -1, 0)),
         ("hands, fingers", "hands_makehuman/hand_woman_young.off", "hands_makehuman/hand_man_old_spread.off", (0, 0, 1)),
         ("hands, wrist", "hands_makehuman/hand_woman_young.off", "hands_makehuman/hand_man_old_spread.off", (0, 0, -1))]


def pair_row(program, pair, data, folder):
    name, reference, template, direction = pair
    folder.mkdir(parents=True, exist_ok=True)
    shapes = [meshes.read(data / p) for p in (reference, template)]
    truth = shapes[1][0]
    parts, kept = [], []
    for k, (points, faces) in enumerate(shapes):
        points, faces, before = cuts.cut(points, faces, direction, 1 / 3)
        parts.append(folder / f"part-{k}.off")
        meshes.write_off(parts[k], points, faces)
        kept.append(before)
    there, gone = set(kept[1]), set(range(len(truth))) - set(kept[1])

    def ends_of(a, b, what):
        done, _ = run(program, "match", a, b, "-o", folder / what, *LEVELS)
        if done.returncode != 0:
            raise SystemExit(f"{name}, {what}: {words_of(done, a)}")
        return result_of(folder / what)

    whole, fitted = ends_of(data / reference, data / template, "whole"), ends_of(data / reference, parts[1], "template-cut")
    part, both = ends_of(parts[0], data / template, "reference-cut"), ends_of(*parts, "both-cut")
    of_part = list(enumerate(kept[0]))
    both_there = [(i, v) for i, v in of_part if v in there]

    def ratio(ends, numbers):
        error, error_whole = mean_error(ends[1], truth, numbers), mean_error(whole[1], truth, [(v, v) for _, v in numbers])
        return f"{error:.4f} / {error_whole:.4f} = {error / error_whole:.2f}"

    return [name, ratio(fitted, [(v, v) for v in there]), ratio(part, of_part), ratio(both, both_there),
            f"{mean_error(shapes[0][0], truth, [(v, v) for v in gone]):.3f} to {mean_error(fitted[1], truth, [(v, v) for v in gone]):.3f}",
            ", ".join(r[0]["verdict"]["outcome"] for r in (fitted, part, both))]


def pair_table(program, data, folder):
    rows = ["| pair, cut away | template cut: error / whole | reference cut | both cut | template cut, what it lacks: error before to after | verdicts |",
            "| --- | --- | --- | --- | --- | --- |"]
    return rows + ["| " + " | ".join(pair_row(program, p, data, folder / f"pair-{i}")) + " |" for i, p in enumerate(PAIRS)]
