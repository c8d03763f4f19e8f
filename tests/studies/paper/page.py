"""Writes docs/paper.md from the summaries."""

import shutil
import subprocess

from paper.claims import judged
from paper.experiments import experiments, papers_table, root
from paper.numbers import level_of, seconds, table, text
from paper.plots import write_oscillations, write_penalty_plots


def papers_level(name):
    return int((root / "configs/paper" / f"{name}.yaml").read_text().split("max_level:")[1].split()[0])


class Page:
    """docs/paper.md from the summaries."""

    def __init__(self, results, path, plots):
        self.results = results
        self.plots = plots  # the program that draws
        self.path = path
        self.pictures = path.parent / "pictures/paper"
        self.parts = []
        self.drawn = set()  # names of the page's pictures
        self.failed = []  # claims of the paper that do not hold

    def add(self, *lines):
        self.parts += [*lines, ""]

    def picture(self, name, picture, alt, profile="paper"):
        source = self.results.output / f"{name}-{profile}" / "pictures" / picture
        if not source.exists():
            return
        copy = self.own_picture(f"{name}_{picture}")
        # A third of the bytes, and no difference to the eye.
        smaller = ["convert", source, "-resize", "1500x1500>", "-colors", "160", "-strip", "-define", "png:exclude-chunks=date,time",
                   f"PNG8:{copy}"]
        if not shutil.which("convert") or subprocess.run(smaller).returncode != 0:
            shutil.copyfile(source, copy)
        self.add(f"![{alt}]({copy.relative_to(self.path.parent)})")

    def own_picture(self, name):
        self.pictures.mkdir(parents=True, exist_ok=True)
        self.drawn.add(name)
        return self.pictures / name

    def write(self):
        self.introduction()
        self.claims()
        self.papers_table()
        self.figures()
        self.oscillations()
        self.penalty()
        self.path.parent.mkdir(parents=True, exist_ok=True)
        partial = self.path.with_name(self.path.name + ".partial")
        partial.write_text("\n".join(self.parts).rstrip() + "\n")
        partial.replace(self.path)
        for picture in self.pictures.glob("*"):
            if picture.name not in self.drawn:
                picture.unlink()

    def introduction(self):
        self.add("# The paper's experiments", "Made by `scripts/study paper-results`; do not edit.")
        threads = sorted({summary["run"]["threads"] for summary in self.results.summaries.values()})
        builds = f", by {len(self.results.programs)} builds of the program" if len(self.results.programs) > 1 else ""
        self.add("The scans of the paper are not public. Built-in shapes stand in their place, with the weights,",
                 "levels and schedule of the paper (`configs/paper/*.yaml`) and `profile: paper`; beside them is",
                 "the default profile without coverage. Distances are means over the diagonal of the bounding box",
                 "of the template. *Correspondence* is the mean distance of vertices from where they are known to",
                 "belong. Times are those of the minimisation on one busy machine: ratios say more than seconds.",
                 "`scripts/study paper-results` runs all experiments; those on this page took",
                 f"{self.results.seconds / 3600:.1f} hours with {' or '.join(map(str, threads))} thread{'' if threads == [1] else 's'}{builds}.")
        lower = [f"{name} ({summary['levels'][-1]['level']})" for name, _, _ in experiments for summary in [self.results.get(name)]
                 if summary and summary["levels"][-1]["level"] < papers_level(name)]
        if lower:
            self.add(f"**Not to the paper's finest level on this page:** {', '.join(lower)}.")
        missing = [name for name, _, _ in experiments if not self.results.get(name)]
        missing += [] if self.results.get("penalty") else ["penalty"]
        if missing:
            self.add(f"**Not run for this page:** {', '.join(missing)}.")

    def claims(self):
        found = judged(self.results)
        self.failed = [claim.words for claim in found if claim.papers and not claim.holds]
        if not found:
            return
        self.add("## What the paper says, and what is found here")
        self.add(table(["claim", "reproduced", "by"],
                       [[claim.words, "yes" if claim.holds else "**no**", claim.numbers] for claim in found]))
        self.add("An energy *oscillates* here if the normals that the map carries are further off than with the",
                 "model on the same grid, and ten times as much of the band folds. *P2 left out* is W(Dphi P1 + n2",
                 "n1^T). With n2 held fixed it is convex along rank-one lines and need not oscillate",
                 "(`tests/energies/terms/comparison_test.cpp`); section 4.1 proves that W of the Cauchy-Green",
                 "tensor oscillates. The curves [eq:varphik] close exactly only for a start radius that is smaller",
                 "than r0 of the paper by a share of order 1/k (`tests/energies/terms/oscillation_test.cpp`).")

    def papers_table(self):
        rows = []
        for name, (below, finest, dofs) in papers_table.items():
            if not self.results.get(name):
                continue
            rows.append([f"**{name}**, the paper's", "8", dofs, "", below, finest, "", ""])
            for profile in ("paper", "default"):
                summary = self.results.get(name, profile)
                if not summary:
                    continue
                last, times = summary["levels"][-1], summary["run"]["level_seconds"]
                rows.append([f"{name}, profile {profile}", f"{last['level']}", f"{last['nodes']}", f"{last['free_nodes']}",
                             seconds(sum(times[:-1])), seconds(times[-1]), text(last["distance"]["template_to_deformed"]["mean"]),
                             f"{last['folds']['folded_cells']}"])
        if rows:
            self.add("## Table tab:parstimes",
                     "The DOFs of the paper are nodes. Its times are those of six cores of a Xeon E5-1650, on its own",
                     "scans.")
            self.add(table(["", "finest level", "nodes", "free nodes", "below the finest level", "at the finest", "distance from template",
                            "folded cells"], rows))
            self.add("The paper names no limit of iterations. Here 1000 on each level are the most with its profile,",
                     "and most runs use them up: they do not end at a minimum, to which the rows of the default",
                     "profile are nearer.")

    def figures(self):
        self.add("## Figures",
                 "Each row: reference, template and deformed reference with a pattern that the deformation carries",
                 "along, deformed reference and template one over the other, and the distance between them.")
        for name, dimension, levels in experiments:
            summary = self.results.get(name)
            if not summary or not levels:
                continue
            heading = (root / "configs/paper" / f"{name}.yaml").read_text().splitlines()[0].lstrip("# ")
            self.add(f"### {name}", heading)
            shown = sorted({level_of(summary, wanted)["level"] for wanted in levels})
            for level in shown if len(levels) > 1 else ():
                self.picture(name, f"level_{level:02d}.png", f"{name}, level {level}")
            if len(levels) == 1:
                self.picture(name, "result.png", f"{name}, level {summary['levels'][-1]['level']}")
            if name == "leaves":
                self.add("Grid (fig:grids) and deformed grid (fig:leaves): cells of less than three pixels, which are",
                         "those along the contour, are not drawn.")
            if name == "dolphin":
                self.add("Slices of the finest grid (fig:grids); reference orange, template blue:")
                self.picture(name, "grid.png", "slices of the dolphin's grid")

    def oscillations(self):
        self.add("### fig:oscillation", "The curves [eq:varphik] for R = 0.95 and k = 6, 20, 50, each with the start radius for which it closes, and the",
                 "circle that they tend to. What the two membranes charge for them is in",
                 "`tests/energies/terms/oscillation_test.cpp`.")
        write_oscillations(self.own_picture("oscillation.png"), self.plots)
        self.add("![oscillating curves of unit speed](pictures/paper/oscillation.png)")

    def penalty(self):
        rows = self.results.penalty_rows()
        if not rows:
            return
        self.add("## The limit of small nu",
                 "A circle onto an ellipse in the plane, one grid and one band, phi = id on the boundary, the full",
                 "volume term W_hat. nu is lowered in steps of 1/2.15, each minimisation starting from the end of",
                 "the one before. Every third step:")
        self.add(table(["nu", "mismatch: integral of eta (d2(phi) - d1)^2", "mismatch / nu", "membrane + bending + volume", "total"],
                       [[f"{nu:.2g}", text(a, 3), text(a / nu, 3), f"{b:.4f}", f"{c:.4f}"] for nu, a, b, c in rows[::3]]))
        self.add("mismatch / nu, the match term, goes to zero, and the rest settles. No map on the grid matches",
                 "exactly: where mismatch / nu begins to rise again, nu is too small for this grid.")
        write_penalty_plots(rows, self.own_picture("penalty_mismatch.png"), self.own_picture("penalty_energies.png"), self.plots)
        self.add("![mismatch over nu](pictures/paper/penalty_mismatch.png)", "![energies over nu](pictures/paper/penalty_energies.png)")
