"""Points and polygons that are turned, moved, mirrored, scaled or joined before they are matched."""
import math


def middle(points):
    return [(min(c) + max(c)) / 2 for c in zip(*points)]


def diagonal(points):
    """The length of the diagonal of the bounding box."""
    return math.dist(*[[f(c) for c in zip(*points)] for f in (min, max)])


def turned(points, degrees, axis):
    """About the middle of the bounding box."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    i, j = [(1, 2), (2, 0), (0, 1)]["xyz".index(axis)]
    centre, result = middle(points), []
    for p in points:
        q = [p[k] - centre[k] for k in range(3)]
        q[i], q[j] = c * q[i] - s * q[j], s * q[i] + c * q[j]
        result.append(tuple(q[k] + centre[k] for k in range(3)))
    return result


def mirrored(points, faces, axis):
    k, centre = "xyz".index(axis), middle(points)
    flip = lambda p: tuple(2 * centre[k] - x if i == k else x for i, x in enumerate(p))  # noqa: E731
    return [flip(p) for p in points], [f[::-1] for f in faces]


def scaled(points, factor):
    return [tuple(factor * x for x in p) for p in points]


def moved(points, diagonals, axis):
    k, step = "xyz".index(axis), diagonals * diagonal(points)
    return [tuple(x + step if i == k else x for i, x in enumerate(p)) for p in points]


def joined(first, second):
    points, faces = first
    more_points, more_faces = second
    return points + more_points, faces + [[v + len(points) for v in f] for f in more_faces]


def random_rotation(random):
    """A matrix with determinant 1, uniform among all, from a unit quaternion."""
    w, x, y, z = (random.gauss(0, 1) for _ in range(4))
    s = 2 / (w * w + x * x + y * y + z * z)
    return [[1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)],
            [s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w)],
            [s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y)]]


def rotated(points, matrix):
    """About the middle of the bounding box."""
    centre = middle(points)
    offsets = [[p[k] - centre[k] for k in range(3)] for p in points]
    return [tuple(centre[i] + sum(matrix[i][k] * q[k] for k in range(3)) for i in range(3)) for q in offsets]
