"""Writes docs/paper.md from the summaries."""

import itertools
import shutil
import subprocess

from paper.claims import judged
from paper.experiments import bending_pairs, built_in_pairs, data_pairs, experiments, papers_table, root
from paper.numbers import level_of, seconds, table, text
from paper.plots import write_oscillations, write_penalty_plots


def ended_by(level):
    return f"{level['stop_reason'].replace('_', ' ')}, {level['iterations']}"


def cells_of(summary):
    """The entries of the tables for a run's finest level, by name."""
    last, times, distance = summary["levels"][-1], summary["run"]["level_seconds"], summary["levels"][-1]["distance"]
    known = summary.get("correspondence_error")
    return {
        "nodes": f"{last['nodes']}", "free nodes": f"{last['free_nodes']}",
        "below": seconds(sum(times[:-1])), "finest": seconds(times[-1]),
        "to template": text(distance["deformed_to_template"]["mean"]),
        "from template": text(distance["template_to_deformed"]["mean"]),
        "correspondence": f"{text(summary['correspondence_error_before'])}, {text(known)}" if known is not None else "",
        "normals": f"{last['band']['normal_angle']:.1f}", "folded band": f"{100 * last['band']['folded_share']:.2g} %",
        "folded cells": f"{last['folds']['folded_cells']}", "ended by": ended_by(last)}


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
        self.cost()
        self.bending()
        self.figures()
        self.oscillations()
        self.penalty()
        self.data()
        self.path.parent.mkdir(parents=True, exist_ok=True)
        partial = self.path.with_name(self.path.name + ".partial")
        partial.write_text("\n".join(self.parts).rstrip() + "\n")
        partial.replace(self.path)
        for picture in self.pictures.glob("*"):
            if picture.name not in self.drawn:
                picture.unlink()

    def introduction(self):
        self.add("# The paper's experiments", "Made by `scripts/paper-results`; do not edit.")
        self.add("The paper's scans are not public. Here the built-in shapes stand in their place, with the paper's",
                 "weights, levels and schedule (`configs/paper/*.yaml`) and with `profile: paper`; where the default",
                 "profile ran on the same pair, without coverage, its numbers stand beside. Distances are relative to the diagonal of the",
                 "template's bounding box, both ways, means; *correspondence* is the mean distance of vertices from where",
                 "the generator, or the common connectivity of two meshes, knows that they belong. Times are those of the",
                 "minimisation on one busy machine: ratios say more than seconds.")
        threads = sorted({summary["run"]["threads"] for summary in self.results.summaries.values()})
        self.add(f"One command, `scripts/paper-results`, runs them all, unattended. Those on this page took {self.results.seconds / 3600:.1f}",
                 f"hours, one after the other, with {' or '.join(map(str, threads))} thread{'' if threads == [1] else 's'} on a machine that others used as well.",
                 "Started again it repeats nothing that is finished.")
        if len(self.results.programs) > 1:
            self.add(f"They were made by {len(self.results.programs)} builds of the program.")
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
        self.add("An energy *oscillates* here if the normals that the map carries along are further off the template's than",
                 "with the model on the same grid, and ten times as much of the band folds over. *P2 left out* is W(Dphi P1 +",
                 "n2 n1^T), the letter of the caption of fig:cubes. With n2 held fixed it is still convex along rank-one lines",
                 "(`tests/energies/terms/comparison_test.cpp`) and need not oscillate; what section 4.1 proves to oscillate is W of",
                 "the Cauchy-Green tensor. The curves [eq:varphik] close exactly only for a start radius that is smaller than",
                 "the paper's r0 by a share of order 1/k (`tests/energies/terms/oscillation_test.cpp`).")

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
                     "The paper's DOFs are nodes: its 178584 of the dolphin are the 1.1 % of the full grid's 257^3 that it names. Its times",
                     "are those of six cores of a Xeon E5-1650, on its own scans.")
            self.add(table(["", "finest level", "nodes", "free nodes", "below the finest level", "at the finest", "distance from template",
                            "folded cells"], rows))

    def bending(self):
        pairs = [(name, prefix + name, f"{prefix}{name}_no_bending") for name in built_in_pairs for prefix in ("coarse_", "")]
        pairs += [(f"{name}, real", f"bending_{name}", f"bending_{name}_without") for name, *_ in bending_pairs]
        rows = []
        for (words, with_term, without), profile in itertools.product(pairs, ("paper", "default")):
            a, b = self.results.get(with_term, profile), self.results.get(without, profile)
            if not a or not b or a["levels"][-1]["level"] != b["levels"][-1]["level"]:
                continue
            ends = [run["levels"][-1] for run in (a, b)]
            rows.append([words, profile, f"{ends[0]['level']}", text(a["correspondence_error_before"]),
                         text(a["correspondence_error"]), text(b["correspondence_error"]),
                         *(text(end["distance"]["template_to_deformed"]["mean"]) for end in ends),
                         *(f"{end['folds']['folded_cells']}" for end in ends)])
        if rows:
            self.add("## With and without the bending term",
                     "The paper calls the influence of the curvature matching indispensable where it matches hand, dolphins and beets",
                     "(section 6), by eye; it gives no number. Here every pair has a known correspondence. The real ones have",
                     "one connectivity for both meshes (hand outlines: registered points) and run with the dolphin's weights.")
            self.add(table(["pair", "profile", "level", "correspondence before", "with", "without", "from template: with", "without",
                            "folded cells: with", "without"], rows))
            self.add("The term pulls edges onto edges, which nothing else does: without it the cube slides along itself. But it asks for equal",
                     "curvatures, and is as good as the curvatures that it is given and the minimiser that follows it. In the paper's profile",
                     "these are crude on coarse grids ([curvature.md](curvature.md)) and the method stops short of a minimum; the default",
                     "profile reads the shapes as smooth splines and converges. Compare the profiles, and one pair on two levels. Where the true",
                     "correspondence changes curvatures, the membrane term, which asks for equal lengths, may do better by itself.")

    def cost(self):
        rows = []
        for name, dimension, _ in experiments:
            for profile in ("paper", "default"):
                summary = self.results.get(name, profile)
                if not summary:
                    continue
                levels, cells = summary["levels"], cells_of(summary)
                rows.append([name, profile, f"{levels[0]['level']}:{levels[-1]['level']}",
                             *(cells[c] for c in ("nodes", "free nodes", "below", "finest")),
                             cells["to template"] + " / " + cells["from template"],
                             *(cells[c] for c in ("correspondence", "normals", "folded band", "folded cells", "ended by"))])
        if rows:
            self.add("## Size, time and quality")
            self.add(table(["experiment", "profile", "levels", "nodes", "free nodes", "below the finest level", "at the finest", "distance to / from template", "correspondence",
                            "normals off (degrees)", "band folded", "folded cells", "finest level ended by"], rows))
            self.add("The paper names no limit of iterations; here 1000 on each level are the most with its profile, and most of its runs",
                     "use them up: its method is slow, and where it ends is not a minimum. What the minimum is, the default profile's",
                     "rows are nearer to.")

    def figures(self):
        self.add("## Figures",
                 "Each row: reference, template and deformed reference with a pattern that the deformation carries along,",
                 "deformed reference and template one over the other, and the distance between them.")
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
                self.add("Grid (fig:grids) and deformed grid (fig:leaves): cells of less than three pixels, which are those along the contour, are",
                         "not drawn.")
            if name == "dolphin":
                self.add("Slices of the finest grid (fig:grids); reference orange, template blue:")
                self.picture(name, "grid.png", "slices of the dolphin's grid")

    def oscillations(self):
        self.add("### fig:oscillation", "The curves [eq:varphik] for R = 0.95 and k = 6, 20, 50, each with the start radius for which it closes, and the",
                 "circle that they tend to. What the two membranes charge for them is in `tests/energies/terms/oscillation_test.cpp`.")
        write_oscillations(self.own_picture("oscillation.png"), self.plots)
        self.add("![oscillating curves of unit speed](pictures/paper/oscillation.png)")
        self.add("### fig:Dtt and fig:detDtt", "Drawings of definitions. The numbers in them, det(Dtg id + n2 n1^T) = 0 and < 0, are in",
                 "`tests/energies/densities/theory_test.cpp`: in the plane that determinant is n1 . n2.")

    def penalty(self):
        rows = self.results.penalty_rows()
        if not rows:
            return
        self.add("## The limit of small nu",
                 "A circle onto an ellipse in the plane, one grid and one band, phi = id on the boundary, the full volume term",
                 "W_hat. nu is lowered in steps of 1/2.15, and each minimisation starts from the end of the one before, so that",
                 "a minimiser is followed; started from the identity, small nu end in other local minima. Every third step:")
        self.add(table(["nu", "mismatch: integral of eta (d2(phi) - d1)^2", "mismatch / nu", "membrane + bending + volume", "total"],
                       [[f"{nu:.2g}", text(a, 3), text(a / nu, 3), f"{b:.4f}", f"{c:.4f}"] for nu, a, b, c in rows[::3]]))
        self.add("The total can only rise as nu falls, and stays below the energy of any map that takes one shape onto the other",
                 "exactly; mismatch / nu, the match term, goes to zero, and what is left settles. No map on the grid matches exactly: where",
                 "mismatch / nu begins to rise again, nu has become too small for this grid.")
        write_penalty_plots(rows, self.own_picture("penalty_mismatch.png"), self.own_picture("penalty_energies.png"), self.plots)
        self.add("![mismatch over nu](pictures/paper/penalty_mismatch.png)", "![energies over nu](pictures/paper/penalty_energies.png)")

    def data(self):
        rows, at_once = [], False
        for name, config, dimension, _, _ in data_pairs:
            for profile in ("paper", "default"):
                summary = self.results.get(name, profile)
                if not summary:
                    continue
                last, cells = summary["levels"][-1], cells_of(summary)
                at_once = at_once or (last["stop_reason"] == "gradient_norm" and last["iterations"] < 5)
                rows.append([name, config, profile, f"{last['level']}",
                             *(cells[c] for c in ("nodes", "free nodes", "below", "finest", "to template", "from template",
                                                  "normals", "correspondence", "folded cells", "ended by"))])
        if rows:
            self.add("## Real shapes", "The nearest public ones (`SHELLMATCH_DATA`), with the weights of the experiment named.")
            self.add(table(["pair", "as", "profile", "level", "nodes", "free nodes", "below", "at the finest", "to template",
                            "from template", "normals off (degrees)", "correspondence", "folded cells", "finest level ended by"], rows))
            if at_once:
                self.add("Where the gradient's norm ended a level after a step or two, the level began with a bending term of an astronomical",
                         "size, exp(1 - det) of an argument that the new grid's curvatures turn inside out; the gradient of the start, against",
                         "which the others are measured, is as large. That level did nothing more.")
