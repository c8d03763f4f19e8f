"""Shapes for the tests, files of them, and the command line program."""

import os
import pathlib
import struct
import subprocess

import numpy as np

source_folder = pathlib.Path(__file__).resolve().parents[2]


def sphere(n=12, stretch=(1.0, 1.0, 1.0), shift=(0.0, 0.0, 0.0)):
    """Vertices and triangles of a sphere of n rings, stretched."""
    angles = np.pi * np.arange(1, n) / n
    vertices = [(0.0, 0.0, -1.0)]
    for a in angles:
        for b in 2 * np.pi * np.arange(2 * n) / (2 * n):
            vertices.append((np.sin(a) * np.cos(b), np.sin(a) * np.sin(b), -np.cos(a)))
    vertices.append((0.0, 0.0, 1.0))
    top, m, faces = len(vertices) - 1, 2 * n, []
    for k in range(m):
        faces.append((0, 1 + (k + 1) % m, 1 + k))
        for ring in range(n - 2):
            a, b = 1 + ring * m + k, 1 + ring * m + (k + 1) % m
            faces += [(a, b, b + m), (a, b + m, a + m)]
        faces.append((top, top - m + k, top - m + (k + 1) % m))
    return np.array(vertices) * stretch + shift, np.array(faces)


def ellipse(n=100, a=1.0, b=1.0, turn=0.0):
    """Points along an ellipse, counter-clockwise."""
    t = 2 * np.pi * np.arange(n) / n
    x, y = a * np.cos(t), b * np.sin(t)
    return np.stack([np.cos(turn) * x - np.sin(turn) * y, np.sin(turn) * x + np.cos(turn) * y], axis=1)


def write_ply(path, vertices, faces):
    """Text whose numbers read back as they are."""
    with open(path, "w") as file:
        file.write(f"ply\nformat ascii 1.0\nelement vertex {len(vertices)}\n")
        file.write("property double x\nproperty double y\nproperty double z\n")
        file.write(f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
        for v in vertices:
            file.write(" ".join(map(repr, v.tolist())) + "\n")
        for f in faces:
            file.write(f"{len(f)} " + " ".join(map(str, f)) + "\n")


def write_outline(path, points):
    with open(path, "w") as file:
        file.writelines(f"{x!r},{y!r}\n" for x, y in points.tolist())


def write_nifti(path, values, affine):
    """Single-file NIfTI-1 of small whole numbers with this affine (of single precision) as its sform."""
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, *values.shape, 1, 1, 1, 1)
    struct.pack_into("<2h", header, 70, 2, 8)  # unsigned bytes
    struct.pack_into("<8f", header, 76, 1, *np.linalg.norm(affine[:3, :3], axis=0), 0, 0, 0, 0)
    struct.pack_into("<3f", header, 108, 352, 1, 0)
    struct.pack_into("<2h", header, 252, 0, 1)
    struct.pack_into("<12f", header, 280, *affine[:3].ravel())
    header[344:348] = b"n+1\0"
    pathlib.Path(path).write_bytes(bytes(header) + values.astype(np.uint8).tobytes(order="F"))


def read_deformed_ply(path):
    """Vertices of the binary PLY that a run writes: doubles first."""
    contents = pathlib.Path(path).read_bytes()
    head, _, body = contents.partition(b"end_header\n")
    lines = head.decode().splitlines()
    assert "format binary_little_endian 1.0" in lines, lines
    sizes = {"double": 8, "float": 4, "int": 4, "uint": 4, "short": 2, "ushort": 2, "uchar": 1, "char": 1}
    n, size = 0, 0
    for line in lines:
        words = line.split()
        if words[:2] == ["element", "vertex"]:
            n = int(words[2])
        elif words[0] == "element":
            break
        elif words[0] == "property" and n:
            size += sizes[words[1]]
    rows = np.frombuffer(body, dtype=np.uint8, count=n * size).reshape(n, size)
    return rows[:, :24].copy().view("<f8")


def run_program(*arguments):
    """The command line program; its failure is one of the test."""
    result = subprocess.run([os.environ["SHELLMATCH_PROGRAM"], *map(str, arguments)], capture_output=True, text=True)
    if result.returncode != 0:
        raise AssertionError(f"{arguments}: exit code {result.returncode}\n{result.stderr}")
    return result.stdout
