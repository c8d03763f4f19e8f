"""Runs the experiments, keeps what is finished, and reads the summaries."""

import csv
import hashlib
import json
import os
import pathlib
import subprocess
import sys
import time

from paper.experiments import bending_levels, bending_pairs, experiments, first_order, root


class Results:
    """Runs experiments, keeps what is finished, and reads the summaries."""

    def __init__(self, arguments):
        self.arguments = arguments
        self.output = pathlib.Path(arguments.output)
        self.data = os.environ.get("SHELLMATCH_DATA", "")
        self.summaries = {}
        self.failed = []  # experiments that did not end well
        self.seconds = 0  # of this machine, for all that is on the page
        self.programs = set()  # the builds that made it

    def levels(self, name, config, dimension):
        """The configuration's levels, the finest one not above what was asked for."""
        text = (root / "configs/paper" / f"{config}.yaml").read_text()
        low, high = (int(text.split(key + ":")[1].split()[0]) for key in ("min_level", "max_level"))
        if config != "penalty":  # that one is about one grid, and quick
            high = max(low, min(high, self.arguments.max_level[3 - dimension]))
        if name.startswith("bending_"):
            high = min(high, bending_levels[3 - dimension])
        return low, high

    def run(self, name, config, dimension, profile, changes=(), more=()):
        low, high = self.levels(name, config, dimension)
        folder = self.output / f"{name}-{profile}"
        drawn = next((levels for other, _, levels in experiments if other == name), ())
        pictures = "none" if not drawn or profile != "paper" else "all" if len(drawn) > 1 else "result"
        # Coverage is not the paper's: without it both profiles minimise what the claims are about.
        words = ["--levels", f"{low}:{high}", "--profile", profile, "--set", "coverage.levels=0", *more]
        for change in [f"pictures={pictures}", "report=true", *changes]:
            words += ["--set", change]
        made_by = {"configuration": fingerprint(root / "configs/paper" / f"{config}.yaml"),
                   "program": fingerprint(self.arguments.program), "arguments": words}
        if not self.arguments.restart and self.is_kept(folder, made_by):
            print(f"kept: {folder}", flush=True)
            return
        command = [self.arguments.program, "run", str(root / "configs/paper" / f"{config}.yaml"), "-q", "--force",
                   "-o", str(folder), "--threads", str(self.arguments.threads), *words]
        if self.arguments.restart:
            command.append("--restart")
        print(time.strftime("%H:%M:%S ") + " ".join(command), flush=True)
        code = subprocess.run(command).returncode
        if code != 0:
            print(f"paper-results: {name} with profile {profile} ended with {code}; the rest goes on", file=sys.stderr, flush=True)
            self.failed.append(f"{name} ({profile})")
            return
        folder.with_name(folder.name + ".made.json").write_text(json.dumps(made_by, indent=1) + "\n")

    @staticmethod
    def made_by(folder):
        """The record of the configuration and program that made a finished run; {} if unknown."""
        try:
            return json.loads(folder.with_name(folder.name + ".made.json").read_text())
        except (OSError, ValueError):
            return {}

    def is_kept(self, folder, made_by):
        return (folder / "summary.json").exists() and self.made_by(folder) == made_by

    def run_all(self):
        for profile in self.arguments.profile:
            for name, config, dimension, changes, more in self.chosen(profile):
                self.run(name, config, dimension, profile, changes, more)

    def chosen(self, profile):
        """What is to be run with a profile, in the order in which it was named, or else of the page."""
        works = [(name, name, dimension, (), ()) for name, dimension, _ in experiments
                 if profile == "paper" or name not in first_order]
        if profile == "paper":
            works.append(("penalty", "penalty", 2, (), ()))
        for name, config, dimension, reference, template in bending_pairs:
            files = self.data_files(reference, template)
            if files:
                truth = self.correspondence(name, files[1])
                places = (f"input.reference={files[0]}", f"input.template={files[1]}", f"input.correspondence={truth}")
                works.append((f"bending_{name}", config, dimension, places, ("--placement", "fit")))
                places += ("energy.bending_weight=0",)
                works.append((f"bending_{name}_without", config, dimension, places, ("--placement", "fit")))
        only = self.arguments.only
        if not only:
            return works
        return [work for name in only for work in works if work[0] == name or name == "bending" and work[0].startswith("bending_")]

    def correspondence(self, name, template):
        """Writes a correspondence file that maps vertex i to the template's vertex i."""
        lines = template.read_text().splitlines()
        if template.suffix == ".off":
            vertices = [line.split() for line in lines[2:2 + int(lines[1].split()[0])]]
        elif template.suffix == ".obj":
            vertices = [line.split()[1:4] for line in lines if line.startswith("v ")]
        else:
            vertices = [line.replace(",", " ").split() for line in lines if line[:1] in "+-.0123456789"]
        path = (self.output / f"{name}.correspondence").resolve()
        path.write_text("".join(f"{i} {' '.join(v)}\n" for i, v in enumerate(vertices)))
        return path

    def data_files(self, reference, template):
        if not self.data or not self.arguments.data:
            return None
        files = [pathlib.Path(self.data) / name for name in (reference, template)]
        return files if all(file.exists() for file in files) else None

    def read_all(self):
        """All finished runs that were made by the present configuration."""
        configs = {name: name for name, _, _ in experiments}
        configs |= {f"bending_{name}{kind}": config for name, config, _, _, _ in bending_pairs for kind in ("", "_without")}
        for name, config in [*configs.items(), ("penalty", "penalty")]:
            for profile in ("paper", "default"):
                folder = self.output / f"{name}-{profile}"
                made_by = self.made_by(folder)
                if not (folder / "summary.json").exists() or not made_by:
                    continue
                if made_by["configuration"] != fingerprint(root / "configs/paper" / f"{config}.yaml"):
                    print(f"left out, as its configuration has changed: {folder}", file=sys.stderr)
                    continue
                summary = json.loads((folder / "summary.json").read_text())
                if not summary["interrupted"]:
                    self.summaries[name, profile] = summary
                    self.seconds += summary["run"]["seconds"]
                    self.programs.add(made_by["program"])

    def penalty_rows(self):
        """nu, mismatch, other terms and total at the end of every minimisation."""
        if not self.get("penalty"):
            return []
        with open(self.output / "penalty-paper/history.csv", newline="") as file:
            ends = {row["nu"]: row for row in csv.DictReader(file)}  # the last row of each stays
        numbers = [{key: float(row[key]) for key in ("nu", "match", "membrane", "bending", "volume", "value")} for row in ends.values()]
        return [(n["nu"], n["match"] * n["nu"], n["membrane"] + n["bending"] + n["volume"], n["value"]) for n in numbers]

    def get(self, name, profile="paper"):
        return self.summaries.get((name, profile))


def fingerprint(path):
    return hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest()
