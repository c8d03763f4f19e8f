"""Landmarks drawn at random among known correspondences, exact, with noise, and with some that are wrong."""
import math
import random

from lib import meshes, transforms

from .cases import ISOMETRIC
from .runs import known_points

PAIRS = [(f"{ISOMETRIC}cat0.off", f"{ISOMETRIC}cat1.off"), (f"{ISOMETRIC}centaur0.off", f"{ISOMETRIC}centaur1.off")]
N_LANDMARKS = 50


def moved_onto(points, p, distance, source):
    """The vertex nearest to p after a step whose components have this standard deviation."""
    q = [x + source.gauss(0, distance) for x in p]
    return min(range(len(points)), key=lambda j: math.dist(points[j], q))


def far_from(points, p, distance):
    """The vertex whose distance from p is nearest to the one asked for."""
    return min(range(len(points)), key=lambda j: abs(math.dist(points[j], p) - distance))


def variants(points, truth, source):
    """Name of each and lines of its landmarks: the reference's vertex and the template's."""
    size = transforms.diagonal(points)
    chosen = source.sample(truth, N_LANDMARKS)
    wrong = set(source.sample(range(N_LANDMARKS), N_LANDMARKS // 10))
    yield "exact", [(i, points.index(y)) for i, y in chosen]
    for percent in (2, 5):
        yield f"noise {percent} %", [(i, moved_onto(points, y, percent / 100 * size, source)) for i, y in chosen]
    yield "one in ten wrong", [(i, far_from(points, y, size / 2) if k in wrong else points.index(y)) for k, (i, y) in enumerate(chosen)]


def pair_errors(study, pair, levels):
    """Name of each variant to the mean error, in diagonals of the template."""
    reference, template = map(study.file, pair)
    truth, points = known_points(reference, template), meshes.read(template)[0]
    folder = study.output / "landmarks" / f"{reference.stem}-{template.stem}"
    folder.mkdir(parents=True, exist_ok=True)

    def error_of(variant):
        name, lines = variant
        path = folder / f"{name.replace(' ', '-').replace('%', 'percent')}.csv"
        path.write_text("vertex1,vertex2\n" + "".join(f"{i},{j}\n" for i, j in lines))
        summary = study.summary(reference, template, levels, path.with_suffix(""), truth, ("--landmarks", path))
        return name, summary["correspondence_error"]

    source = random.Random(f"landmarks of {reference.stem} and {template.stem}")
    return dict(study.map(error_of, list(variants(points, truth, source))))
