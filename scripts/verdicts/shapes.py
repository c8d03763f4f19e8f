"""Meshes and contours that are turned, moved, mirrored, scaled or joined before they are matched. OFF, OBJ and CSV as text."""
import math
import pathlib


def read_mesh(path):
    """Points and polygons of an OFF or OBJ file."""
    lines = [line.split("#")[0].split() for line in pathlib.Path(path).read_text().splitlines()]
    lines = [words for words in lines if words]
    if lines[0][0] == "OFF":
        numbers = [word for words in lines for word in words][1:]
        n_points, n_faces = int(numbers[0]), int(numbers[1])
        values = numbers[3:]
        points = [tuple(map(float, values[3 * i:3 * i + 3])) for i in range(n_points)]
        faces, at = [], 3 * n_points
        for _ in range(n_faces):
            n = int(values[at])
            faces.append([int(v) for v in values[at + 1:at + 1 + n]])
            at += 1 + n
        return points, faces
    points = [tuple(map(float, words[1:4])) for words in lines if words[0] == "v"]
    faces = [[int(word.split("/")[0]) - 1 for word in words[1:]] for words in lines if words[0] == "f"]
    return points, faces


def write_mesh(path, points, faces):
    text = [f"OFF\n{len(points)} {len(faces)} 0"]
    text += [" ".join(map(repr, p)) for p in points]
    text += [f"{len(f)} " + " ".join(map(str, f)) for f in faces]
    pathlib.Path(path).write_text("\n".join(text) + "\n")


def middle(points):
    return [(min(c) + max(c)) / 2 for c in zip(*points)]


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
    k = "xyz".index(axis)
    box = [(min(c), max(c)) for c in zip(*points)]
    step = diagonals * math.dist([b[0] for b in box], [b[1] for b in box])
    return [tuple(x + step if i == k else x for i, x in enumerate(p)) for p in points]


def joined(first, second):
    points, faces = first
    more_points, more_faces = second
    return points + more_points, faces + [[v + len(points) for v in f] for f in more_faces]
