"""Commands that are disturbed, each with the state of the folder in which it begins."""

import os
import shutil
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

PLANE = "--levels 3:4 --align none --set threads=1 --set resume.min_seconds=0"
MATCH = f"match generate:circle generate:ellipse {PLANE}"
STUDY = """version: 1
title: Tiny
set: {threads: 1, pictures: none, report: false, align: {mode: none}, cascade: {min_level: 3, max_level: 3}}
problems: {leaf: {set: {input: {reference: "generate:circle", template: "generate:ellipse"}}}}
solvers: [newton, lbfgs]
"""
LANDMARKS = "name,x1,y1,x2,y2\na,0.8,0.5,0.8,0.5\nb,0.5,0.8,0.5,0.78\n"

# Things of the user in every working folder; names close to those of the program's own hidden files among them.
FOREIGN = {"thesis.txt": "all I have\n", ".o.partial-notes": "mine\n", "o.unfinished.txt": "mine\n", ".o.csv.partial-mine.csv": "1,2\n",
           ".partial-": "mine\n", "o.old": "mine\n", ".hidden/.o.lock": "mine\n", "moved.csv.part": "mine\n"}


@dataclass
class Scenario:
    """A command in a folder of its own."""
    name: str
    words: str                      # of the command line
    result: str = "o"               # the file or folder that it writes
    before: list = field(default_factory=list)    # commands that make the state it begins with
    files: dict = field(default_factory=dict)     # of the user, which it reads
    again: str = ""                 # words added where it is repeated after a fault
    whole: str = "folder"           # what is replaced at once: the "file", the "folder", or each of the "runs" of a study
    in_place: bool = False          # the parent of the output folder may not be written
    tail: bool = False              # `before` ends with a run that is killed before its last rename

    @property
    def command(self):
        return self.words.split()[0]

    def prepare(self, folder, program):
        """Makes the state in an empty folder."""
        for name, text in {**FOREIGN, **self.files}.items():
            (folder / name).parent.mkdir(exist_ok=True)
            (folder / name).write_text(text)
        for i, words in enumerate(self.before):
            kill = ["strace", "-qq", "-o", "/dev/null", "-e", "trace=rename", "-e", "inject=rename:signal=KILL:when=2"]
            is_killed = self.tail and i + 1 == len(self.before)
            done = subprocess.run([*(kill if is_killed else []), program, *words.split()], cwd=folder, capture_output=True, text=True)
            if done.returncode != (-9 if is_killed else 0):
                raise SystemExit(f"{self.name}: {words}: exit code {done.returncode}: {done.stderr}")
        if self.in_place:
            (folder / "locked/o").mkdir(parents=True)
            if os.getuid() == 0:
                shutil.chown(folder / "locked/o", 65534, 65534)
            (folder / "locked").chmod(0o555)

    def user(self):
        """Options of subprocess.Popen: root may write everywhere."""
        return {"user": 65534, "group": 65534, "extra_groups": []} if self.in_place and os.getuid() == 0 else {}


def all_scenarios():
    plain, quick = f"{MATCH} --set pictures=none --set report=false -q", "--edge-length 0.05"
    study = {"study.yaml": STUDY}
    circle, sphere = "generate circle -o c.csv", f"generate sphere {quick} -o c.ply"
    earlier = f"{plain} -o o".replace("3:4", "3:3")
    space = "match generate:sphere generate:ellipsoid --levels 2:2 --align none --set threads=1 --set pictures=none --set report=false -q -o m"
    return [
        Scenario("match", f"{plain} -o o"),
        Scenario("match-force", f"{plain} -o o --force", before=[earlier]),
        Scenario("match-resume", f"{plain} -o o", before=[f"{plain} -o o"], tail=True),
        Scenario("match-pictures", f"{MATCH} --set pictures=result --set report=false -q -o o"),
        Scenario("match-report", f"{MATCH} --set pictures=none -q -o o"),
        Scenario("match-files", f"match c.csv e.csv {PLANE} --set pictures=none --set report=false --set landmarks.file=l.csv -q -o new/deep/o", result="new/deep/o",
                 before=[circle, "generate ellipse -o e.csv"], files={"l.csv": LANDMARKS}),
        Scenario("match-threads", f"{plain} -o o".replace("threads=1", "threads=3")),
        Scenario("match-in-place", f"{plain} -o locked/o", result="locked/o", in_place=True),
        Scenario("study", "study study.yaml -o o -q", files=study, again="--retry", whole="runs"),
        Scenario("study-changed", "study study.yaml -o o -q --set cascade.max_level=4", files=study, again="--retry", whole="runs",
                 before=["study study.yaml -o o -q"]),
        Scenario("apply", "apply m c.csv -o moved.csv", "moved.csv", before=[f"{plain} -o m", circle], whole="file"),
        Scenario("apply-force", "apply m c.csv -o moved.csv --force", "moved.csv",
                 before=[f"{plain} -o m", circle, "generate ellipse -o moved.csv"], whole="file"),
        Scenario("apply-space", "apply m c.ply -o moved.ply", "moved.ply", before=[space, sphere], whole="file"),
        Scenario("generate", "generate ellipse -o o.csv", "o.csv", whole="file"),
        Scenario("generate-force", "generate ellipse -o o.csv --force", "o.csv", before=["generate circle -o o.csv"], whole="file"),
        Scenario("generate-stl", f"generate sphere {quick} -o o.stl", "o.stl", whole="file"),
        Scenario("curvature", "curvature generate:circle --levels 3:4 --set threads=1 -q -o o"),
    ]
