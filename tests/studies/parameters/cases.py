"""What scripts/study parameter-pictures runs and draws: for each parameter the runs, and pictures of some of them."""

import dataclasses
import math
import random


@dataclasses.dataclass
class Run:
    name: str  # folder of the run
    words: str  # of the table
    shapes: tuple  # reference and template
    options: str  # of `shellmatch match`


@dataclasses.dataclass
class Picture:
    run: str
    words: str
    view: str = "--show overlay --color plain"  # of `shellmatch render`
    part: tuple = None  # left, upper, width and height of what is kept, in sides of the panel; None: all but the caption


def plane(name, words, shapes, options):
    return Run(name, words, shapes, "--levels 3:7 --align none " + options)


def space(name, words, shapes, options):
    return Run(name, words, shapes, "--levels 3:5 --align none " + options)


noisy_leaf = ("generate:leaf", "noisy_leaf.csv")
teeth = ("smooth_leaf.csv", "toothed_leaf.csv")
stars = ("star.csv", "turned_star.csv --landmarks inexact_tips.csv")
fist = ("generate:hand", "fingers_bent.ply")
boxes = ("generate:box", "compressed_box.ply")
dolphins = ("generate:dolphin", "generate:dolphin/reversed")
sharp_star = ("generate:circle", "generate:star/sharp")

bay = (0.70, 0.24, 0.16, 0.16)
tooth = (0.0, 0.47, 0.34, 0.34)
bent = "--show overlay --color plain --azimuth 60 --elevation 10"
stretch = "--color distortion"

parameters = {
    "levels": (
        [Run(f"leaf-{level}", f"`--levels 3:{level}`", noisy_leaf, f"--levels 3:{level} --align none") for level in (5, 7, 10)],
        [Picture("leaf-5", "5, too coarse: teeth are missed", part=bay), Picture("leaf-7", "7: the shape without its noise", part=bay),
         Picture("leaf-10", "10, too fine: the noise, too", part=bay)]),
    "bending": (
        [space(f"box-{weight}", f"`energy.bending_weight={weight}`", boxes, f"--set energy.bending_weight={weight}") for weight in (0, 1, 1000)],
        [Picture("box-0", "0, too little: the edge has slid off its checks", ""), Picture("box-1", "1: edge on edge", ""),
         Picture("box-1000", "1000, too much: old edges stay", "")]),
    "nu": (
        [space(f"hand-{nu}", f"hand, `cascade.nu={nu}`", fist, f"--set cascade.nu={nu}") for nu in ("2e-7", "2e-4", "0.2")] +
        [plane(f"star-{nu}", f"star, `cascade.nu={nu}`", sharp_star, f"--set cascade.nu={nu}") for nu in ("2e-7", "2e-4", "0.2")],
        [Picture("hand-2e-7", "hand, 2e-7, too small: areas change by factors of 2", stretch), Picture("hand-2e-4", "hand, 2e-4: by a fifth", stretch),
         Picture("star-2e-4", "star, 2e-4: on the template"), Picture("star-0.2", "star, 0.2, too large: arms are not reached")]),
    "landmarks": (
        [plane(f"landmarks-{weight}", f"`landmarks.weight={weight}`", stars, f"--set landmarks.weight={weight}") for weight in ("0.01", "1", "100")],
        [Picture("landmarks-1", "the reference", "--show reference"), Picture("landmarks-0.01", "0.01, too little: the nearest arm is taken", ""),
         Picture("landmarks-1", "1: the right arms", ""), Picture("landmarks-100", "100, too much: their errors are drawn", "")]),
    "coverage": (
        [plane(f"teeth-{levels}", f"leaf, `coverage.levels={levels}`", teeth, f"--set coverage.levels={levels}") for levels in (0, 1, 2)] +
        [space(f"dolphin-{levels}", f"dolphin, `coverage.levels={levels}`", dolphins, f"--set coverage.levels={levels}") for levels in (0, 2)],
        [Picture("teeth-0", "leaf, 0, too little: a tooth is left out", part=tooth), Picture("teeth-2", "leaf, 2: it is reached", part=tooth),
         Picture("dolphin-0", "the dolphin that lies the wrong way, 0: it shows"),
         Picture("dolphin-2", "2, too much: a tail is drawn out of the snout")]),
    "volume": (
        [space(f"volume-{weight}", f"`cascade.volume={weight}`", fist, f"--set cascade.volume={weight}") for weight in ("0", "0.2", "200", "2000")],
        [Picture("volume-0", "0: looks the same, for forty times the steps", bent), Picture("volume-0.2", "0.2: on the template", bent),
         Picture("volume-2000", "2000, too much: fingers stay straight", bent)]),
}

generated = {
    "smooth_leaf.csv": "leaf --set serration=0", "toothed_leaf.csv": "leaf --set serration=0.06 --set teeth=25", "leaf.csv": "leaf/shallow",
    "star.csv": "star", "turned_star.csv": "star --set turn=45", "compressed_box.ply": "box --set compression=0.64 --set turn=40",
    "fingers_bent.ply": "hand " + " ".join(f"--set bend_{finger}=45" for finger in ("index", "middle", "ring", "little"))}


def outline(path):
    return [tuple(map(float, line.split(",")[:2])) for line in path.read_text().splitlines() if line[0] in "-0123456789"]


def tips(points, n):
    """The points farthest from the middle of the domain, one for each of n arms, counter-clockwise from the right."""
    def polar(p):
        return math.hypot(p[0] - 0.5, p[1] - 0.5), math.atan2(p[1] - 0.5, p[0] - 0.5) % (2 * math.pi)
    first = max(polar(p) for p in points)[1] % (2 * math.pi / n)
    arms = [[] for _ in range(n)]
    for p in points:
        arms[round((polar(p)[1] - first) / (2 * math.pi / n)) % n].append(polar(p))
    return [(*max(arm), first) for arm in arms]


def write_noisy(source, target, most=0.0018):
    """Moves each vertex by at most so much along either axis."""
    chance = random.Random(1)
    target.write_text("x,y\n" + "".join(f"{x + most * chance.uniform(-1, 1):.6f},{y + most * chance.uniform(-1, 1):.6f}\n" for x, y in outline(source)))


def write_tips(reference, template, target, beyond=0.025):
    """Landmarks at the tips of two stars, the second of which is turned by 45 degrees; those on it lie too far out."""
    rows = ["name,x1,y1,x2,y2"]
    on_template = {round(math.degrees(angle)): radius for radius, angle, _ in tips(outline(template), 5)}
    for k, (radius, angle, _) in enumerate(tips(outline(reference), 5)):
        turned = math.degrees(angle) + 45
        far = on_template[round(turned) % 360] + beyond
        rows.append(f"tip{k}," + ",".join(f"{0.5 + r * f(a):.5f}" for r, a in ((radius, angle), (far, math.radians(turned))) for f in (math.cos, math.sin)))
    target.write_text("\n".join(rows) + "\n")
