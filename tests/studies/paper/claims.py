"""The paper's claims, and the numbers by which they are judged."""

import collections

from paper.experiments import bending_pairs
from paper.numbers import level_of, text

# holds: whether the numbers support the claim; papers: whether the claim is the paper's or our own.
Claim = collections.namedtuple("Claim", "words holds numbers papers")


def oscillates(ours, other):
    a, b = level_of(ours, 4)["band"], level_of(other, 4)["band"]
    numbers = (f"level {level_of(ours, 4)['level']}: normals {b['normal_angle']:.1f} degrees off against "
               f"{a['normal_angle']:.1f}, {100 * b['folded_share']:.2g} % of the band folded against "
               f"{100 * a['folded_share']:.2g} %")
    return b["normal_angle"] > a["normal_angle"] and b["folded_share"] > 10 * a["folded_share"], numbers


def errors(summary):
    return summary["correspondence_error_before"], summary["correspondence_error"]


def correct(summary):
    before, after = errors(summary)
    return after < 0.25 * before, f"correspondence {text(before)} -> {text(after)}"


def incorrect(summary):
    holds, numbers = correct(summary)
    return not holds, numbers


def better(with_term, without):
    a, b = errors(with_term)[1], errors(without)[1]
    return a < b, f"correspondence {text(a)} with, {text(b)} without, {text(errors(without)[0])} before"


def detail(summary):
    means = [entry["distance"]["template_to_deformed"]["mean"] for entry in summary["levels"]]
    return all(b < a for a, b in zip(means, means[1:])), "template to deformed: " + ", ".join(map(text, means))


def bends(summary):
    energy = summary["levels"][-1]["energy"]
    return energy["bending"] > 0.01 * energy["total"], f"bending {text(energy['bending'])} of {text(energy['total'])} at the end"


def share_of_nodes(summary):
    last = summary["levels"][-1]
    share = last["free_nodes"] / (2 ** last["level"] + 1) ** 3
    return last["level"] < 8 or share < 0.05, \
        f"level {last['level']}: {last['free_nodes']} free nodes, {100 * share:.2g} % (the paper's at level 8: 1.1 %)"


def folds(paper, default):
    a, b = paper["levels"][-1]["folds"], default["levels"][-1]["folds"]
    return b["uncertified_cells"] == 0, f"{a['folded_cells']} folded cells; default profile: {b['uncertified_cells']}"


def penalty_limit(rows):
    nu, mismatch, rest, total = zip(*rows)
    falls = all(b < a for a, b in zip(mismatch, mismatch[1:])) and mismatch[-1] < 1e-4 * mismatch[0]
    first, last = (abs(rest[k] - rest[k + 3]) for k in (0, -4))  # over a decade of nu
    holds = falls and mismatch[-1] / nu[-1] < 0.05 * total[-1] and last < 0.1 * first
    return holds, (f"nu {nu[0]:.2g} -> {nu[-1]:.2g}: mismatch {text(mismatch[0])} -> {text(mismatch[-1])}"
                   f"{', falling at each step' if falls else ''}; other terms {rest[0]:.3f} -> {rest[-1]:.3f}, "
                   f"by {text(first)} in the first decade and {text(last)} in the last")


# Words, required runs (name, or name and profile), function that judges them, and whether the claim is the paper's.
claims = [
    ("The Cauchy-Green membrane oscillates under compression, the model does not (fig:cubes)",
     ["cubes_no_bending", "cubes_cauchy_green"], oscillates, True),
    ("So does W with P2 left out and nothing else changed (the letter of the caption of fig:cubes)", ["cubes", "cubes_no_p2"], oscillates, False),
    ("The quadratic bending energy is no better (section 3.2)", ["cubes", "cubes_quadratic"], oscillates, True),
    ("The intuitively correct deformation under strong compression and rotation (fig:cubes)", ["cubes"], correct, True),
    ("Bending assists: cubes", ["cubes", "cubes_no_bending"], better, True),
    ("Bending is indispensable: hand", ["hand", "hand_no_bending"], better, True),
    ("Bending is indispensable: dolphin", ["dolphin", "dolphin_no_bending"], better, True),
    ("Bending is indispensable: hand, profile default", [("hand", "default"), ("hand_no_bending", "default")], better, False),
    ("Bending is indispensable: dolphin, profile default", [("dolphin", "default"), ("dolphin_no_bending", "default")], better, False),
    ("Bending energy does not vanish at the optimum (section 6)", ["cubes"], bends, True),
    ("Detail is added level by level (fig:faces)", ["faces"], detail, True),
    ("Matching two hands (fig:hand)", ["hand"], correct, True),
    ("Matching two dolphins (fig:dolphin)", ["dolphin"], correct, True),
    ("A turn by pi/6 before is mastered (fig:dolphinRot)", ["dolphin_turned"], correct, True),
    ("A turn by pi is not (fig:dolphinRot)", ["dolphin_reversed"], incorrect, True),
    ("Two leaves in the plane (fig:leaves)", ["leaves"], correct, True),
    ("The grid has the size of a surface's (fig:grids)", ["dolphin"], share_of_nodes, True),
    ("Beyond the paper: no cell folds in the default profile", ["hand", ("hand", "default")], folds, False),
]


def judged(results):
    """The claims whose runs are available, judged."""
    found = []
    for words, needs, judge, papers in claims:
        runs = [results.get(*need) if isinstance(need, tuple) else results.get(need) for need in needs]
        if not all(runs) or judge is better and len({run["levels"][-1]["level"] for run in runs}) > 1:
            continue  # not run, or not on the same grid
        found.append(Claim(words, *judge(*runs), papers))
    for profile in ("paper", "default"):
        pairs = [(name, *(results.get(f"bending_{name}{kind}", profile) for kind in ("", "_without"))) for name, *_ in bending_pairs]
        helped = {name: better(a, b)[0] for name, a, b in pairs if a and b}
        if helped:
            names = ", ".join(name for name, helps in helped.items() if helps)
            found.append(Claim(f"Bending is indispensable: real pairs of known correspondence, profile {profile}", all(helped.values()),
                               f"better with it on {sum(helped.values())} of {len(helped)}{': ' + names if names else ''}",
                               profile == "paper"))
    rows = results.penalty_rows()
    if rows:
        found.append(Claim("The limit of small nu (prop:penalization-limit): mismatch vanishes, energies converge",
                           *penalty_limit(rows), True))
    return found
