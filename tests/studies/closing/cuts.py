"""Points bent by a smooth map, and surfaces of which a part is cut away."""
import math

from lib import transforms


def bent(points):
    """By a smooth map that moves points by up to 3 % of the diagonal."""
    low = [min(c) for c in zip(*points)]
    size = transforms.diagonal(points) or 1
    return [tuple(p[k] + 0.03 * size * math.sin(4 * (p[(k + 1) % 3] - low[(k + 1) % 3]) / size + k) for k in range(3)) for p in points]


def area(points, face):
    a = points[face[0]]
    total = 0.0
    for b, c in zip(face[1:], face[2:]):
        u, v = [[points[i][k] - a[k] for k in range(3)] for i in (b, c)]
        total += math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2
    return total


def cut(points, faces, direction, share):
    """Without the share of the area that lies farthest along the direction: points, faces, and the numbers of the points before."""
    def height(face):
        return sum(points[v][k] * direction[k] for v in face for k in range(3)) / len(face)

    ordered = sorted(faces, key=height)
    left, kept = (1 - share) * sum(area(points, f) for f in faces), []
    for face in ordered:
        left -= area(points, face)
        if left < 0:
            break
        kept.append(face)
    before = sorted({v for f in kept for v in f})
    number = {v: i for i, v in enumerate(before)}
    return [points[v] for v in before], [[number[v] for v in f] for f in kept], before
