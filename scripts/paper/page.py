"""docs/paper.md from the summaries."""

import shutil
import subprocess

from paper.claims import judged
from paper.experiments import data_pairs, experiments, papers_table, root
from paper.numbers import level_of, seconds, table, text
from paper.plots import write_penalty_plot


class Page:
    """docs/paper.md from the summaries."""

    def __init__(self, results, path):
        self.results = results
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
        if not shutil.which("convert") or subprocess.run(["convert", source, "-resize", "1500x1500>", "-colors", "160", f"PNG8:{copy}"]).returncode:
            shutil.copyfile(source, copy)
        self.add(f"![{alt}]({copy.relative_to(self.path.parent)})")

    def own_picture(self, name):
        self.pictures.mkdir(parents=True, exist_ok=True)
        self.drawn.add(name)
        return self.pictures / name

    def write(self):
        self.introduction()
        self.claims()
        self.cost()
        self.figures()
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
        space, plane = self.results.arguments.max_level
        self.add("# The paper's experiments", "Made by `scripts/paper-results`; do not edit.")
        self.add("The paper's scans are not public. Here the built-in shapes stand in their place, with the paper's",
                 "weights, levels and schedule (`configs/paper/*.yaml`) and with `profile: paper`; where the default",
                 "profile ran on the same pair its numbers stand beside. Distances are relative to the diagonal of the",
                 "template's bounding box, both ways, means; *correspondence* is the mean distance of vertices from where",
                 "the generator knows that they belong, before and after. Times are those of the minimisation on this",
                 "machine, which others may use as well: ratios say more than seconds.")
        if space < 8 or plane < 10:
            self.add(f"**This page was made with at most level {space} in space and {plane} in the plane**, where the paper",
                     "goes to 8 and 10. `scripts/paper-results` without options runs them all, unattended.")

        missing = [name for name, _, _ in experiments if not self.results.get(name)]
        missing += [] if self.results.penalty_rows() else ["penalty"]
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
                 "(`tests/energies/comparison_test.cpp`) and need not oscillate; what section 4.1 proves to oscillate is W of",
                 "the Cauchy-Green tensor. The curves [eq:varphik] close exactly only for a start radius that is smaller than",
                 "the paper's r0 by a share of order 1/k (`tests/energies/oscillation_test.cpp`).")

    def cost(self):
        rows = []
        for name, dimension, _ in experiments:
            for profile in ("paper", "default"):
                summary = self.results.get(name, profile)
                if not summary:
                    continue
                last, times = summary["levels"][-1], summary["run"]["level_seconds"]
                known = summary.get("correspondence_error")
                papers = papers_table.get(name, ("", "", "")) if profile == "paper" else ("", "", "")
                distance = last["distance"]
                rows.append([
                    name, profile, f"{summary['levels'][0]['level']}:{last['level']}", f"{last['nodes']}",
                    f"{last['free_nodes']}", papers[2], seconds(sum(times[:-1])), papers[0], seconds(times[-1]), papers[1],
                    text(distance["deformed_to_template"]["mean"]) + " / " + text(distance["template_to_deformed"]["mean"]),
                    f"{text(summary['correspondence_error_before'])}, {text(known)}" if known is not None else "",
                    f"{last['band']['normal_angle']:.1f}", f"{100 * last['band']['folded_share']:.2g} %",
                    f"{last['folds']['folded_cells']}"])
        if rows:
            self.add("## Size, time and quality")
            self.add("Columns in italics are the paper's own, on six cores of a Xeon E5-1650 for its own shapes at level 8.")
            self.add(table(["experiment", "profile", "levels", "nodes", "free nodes", "*DOFs*", "below the finest level",
                            "*paper*", "at the finest", "*paper*", "distance to / from template", "correspondence",
                            "normals off (degrees)", "band folded", "folded cells"], rows))

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
            if name == "dolphin":
                self.add("Slices of the finest grid (fig:grids); reference orange, template blue:")
                self.picture(name, "grid.png", "slices of the dolphin's grid")

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
                 "exactly; its match term goes to zero, and what is left settles.")
        write_penalty_plot(rows, self.own_picture("penalty.svg"))
        self.add("![mismatch and energies as nu is lowered](pictures/paper/penalty.svg)")

    def data(self):
        rows = []
        for name, config, dimension, _, _ in data_pairs:
            for profile in ("paper", "default"):
                summary = self.results.get(name, profile)
                if not summary:
                    continue
                last, times = summary["levels"][-1], summary["run"]["level_seconds"]
                rows.append([name, config, profile, f"{last['level']}", f"{last['free_nodes']}",
                             seconds(sum(times[:-1])), seconds(times[-1]),
                             text(last["distance"]["deformed_to_template"]["mean"]),
                             text(last["distance"]["template_to_deformed"]["mean"]), f"{last['band']['normal_angle']:.1f}"])
        if rows:
            self.add("## Real shapes", "The nearest public ones (`SHELLMATCH_DATA`), with the weights of the experiment named.")
            self.add(table(["pair", "as", "profile", "level", "free nodes", "below", "at the finest", "to template",
                            "from template", "normals off (degrees)"], rows))
