"""Meshes as points and polygons: OBJ, OFF, PLY and STL are read, OFF is written."""
import pathlib
import re
import struct

SIZES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d",
         "int8": "b", "uint8": "B", "int16": "h", "uint16": "H", "int32": "i", "uint32": "I", "float32": "f", "float64": "d"}


def read_stl(data):
    if len(data) >= 84 and len(data) == 84 + 50 * struct.unpack_from("<I", data, 80)[0]:
        corners = [struct.unpack_from("<3f", data, 84 + 50 * t + 12 + 12 * k) for t in range((len(data) - 84) // 50) for k in range(3)]
    else:
        corners = [tuple(map(float, words)) for words in re.findall(r"vertex\s+(\S+)\s+(\S+)\s+(\S+)", data.decode("latin-1"))]
    number = {}
    for x in corners:
        number.setdefault(x, len(number))
    return list(number), [[number[x] for x in corners[t:t + 3]] for t in range(0, len(corners), 3)]


def read_ply(data):
    head, body = data.split(b"end_header", 1)
    body = body[body.index(b"\n") + 1:]
    elements, order = [], None
    for words in (line.split() for line in head.decode("latin-1").splitlines()):
        if words[:1] == ["format"]:
            order = {"ascii": None, "binary_little_endian": "<", "binary_big_endian": ">"}[words[1]]
        elif words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:1] == ["property"]:
            elements[-1][2].append(words[1:])
    text, at = body.split() if order is None else None, 0

    def number(kind):
        nonlocal at
        if order is None:
            at += 1
            return float(text[at - 1])
        at += struct.calcsize(SIZES[kind])
        return struct.unpack_from(order + SIZES[kind], body, at - struct.calcsize(SIZES[kind]))[0]

    points, faces = [], []
    for name, count, properties in elements:
        for _ in range(count):
            row = {}
            for p in properties:
                row[p[-1]] = [number(p[2]) for _ in range(int(number(p[1])))] if p[0] == "list" else number(p[0])
            if name == "vertex":
                points.append((row["x"], row["y"], row["z"]))
            elif name == "face":
                faces.append([int(v) for v in next(v for k, v in row.items() if k.startswith("vertex_ind"))])
    return points, faces


def read_off(data):
    """Line by line: colours may follow, comments and blank lines may stand between."""
    lines = [line.split("#")[0].replace("OFF", " ").split() for line in data.decode("latin-1").splitlines()]
    lines = [words for words in lines if words]
    n_points, n_faces = int(lines[0][0]), int(lines[0][1])
    points = [tuple(map(float, words[:3])) for words in lines[1:1 + n_points]]
    return points, [[int(v) for v in words[1:1 + int(words[0])]] for words in lines[1 + n_points:1 + n_points + n_faces]]


def read_obj(data):
    """Numbers from 1, or backward from the last vertex."""
    points, faces = [], []
    for words in (line.split("#")[0].split() for line in data.decode("latin-1").splitlines()):
        if words[:1] == ["v"]:
            points.append(tuple(map(float, words[1:4])))
        elif words[:1] == ["f"]:
            numbers = [int(word.split("/")[0]) for word in words[1:]]
            faces.append([v - 1 if v > 0 else len(points) + v for v in numbers])
    return points, faces


def read(path):
    readers = {".stl": read_stl, ".ply": read_ply, ".obj": read_obj, ".off": read_off}
    return readers[pathlib.Path(path).suffix.lower()](pathlib.Path(path).read_bytes())


def write_off(path, points, faces):
    text = [f"OFF\n{len(points)} {len(faces)} 0"]
    text += [" ".join(map(repr, p)) for p in points]
    text += [f"{len(f)} " + " ".join(map(str, f)) for f in faces]
    pathlib.Path(path).write_text("\n".join(text) + "\n")
