"""What a run keeps of its results: the file of a map, and that of an alignment."""
import struct


def map_seed(dim, posed, bend=None, cell=None, facts_of=()):
    """A grid of two cells along each axis, with stored blocks (geometry/bytes/zlib_inflate.cpp), without the line of its checksum. `bend`
    is one of a triangle with these corners; `cell` changes the type, the first point or the first position of the first cell."""
    side = range(3)
    nodes = [(x, y, z) for z in (side if dim == 3 else [0]) for y in side for x in side]
    corner_nodes = [(x, y, z) for z in (range(2) if dim == 3 else [0]) for y in range(2) for x in range(2)]
    cells = [[nodes.index(tuple(a + b for a, b in zip(c, d))) for d in corner_nodes] for c in corner_nodes]
    data = b""

    def array(kind, name, components, fmt, values):
        nonlocal data
        body = struct.pack(f"<{len(values)}{fmt}", *values)
        tag = f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="appended" offset="{len(data)}"/>\n'
        data += struct.pack("<4Q", 1, len(body), 0, len(body)) + body
        return tag
    positions = [x / 2 for node in nodes for x in node]
    facts = array("Int32", "dimension", 1, "i", [dim]) + array("Float64", "placement_scale", 1, "d", [0.5])
    facts += array("Float64", "placement_offset", dim, "d", [0.1] * dim)
    if posed:
        facts += array("Float64", "pose_scale", 1, "d", [1]) + array("Float64", "pose_offset", dim, "d", [0.1] * dim)
        facts += array("Float64", "pose_rotation", dim * dim, "d", [float(i % (dim + 1) == 0) for i in range(dim * dim)])
    if bend is not None:
        facts += array("Float64", "bend_sizes", 2, "d", [3, 1]) + array("Float64", "bend_vertices", 2 * dim, "d", [i / 9 for i in range(6 * dim)])
        facts += array("Int32", "bend_facets", dim, "i", bend)
    for name, value in facts_of:
        facts += array("Float64", name, 1, "d", [value])
    point_data = array("Float64", "phi", 3, "d", positions)
    types, connectivity = [8 if dim == 2 else 11] * len(cells), [v for c in cells for v in c]
    if cell == "type":
        types[0] = 9
    elif cell == "point":
        connectivity[1] = len(nodes)
    elif cell == "place":
        positions[0] = 0.3
    elif cell == "node":
        positions[-3] = 0.3
    cell_data = array("Int32", "level", 1, "i", [1] * len(cells))
    points = array("Float64", "Points", 3, "d", positions)
    topology = array("Int64", "connectivity", 1, "q", connectivity)
    topology += array("Int64", "offsets", 1, "q", [(i + 1) * len(corner_nodes) for i in range(len(cells))])
    topology += array("UInt8", "types", 1, "B", types)
    head = (f'<?xml version="1.0"?>\n<!-- a -->\n<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64" '
            f'compressor="vtkZLibDataCompressor">\n<UnstructuredGrid><FieldData>{facts}</FieldData>'
            f'<Piece NumberOfPoints="{len(nodes)}" NumberOfCells="{len(cells)}"><PointData>{point_data}</PointData>'
            f'<CellData>{cell_data}</CellData><Points>{points}</Points><Cells>{topology}</Cells></Piece></UnstructuredGrid>\n'
            f'<AppendedData encoding="raw">\n_')
    return head.encode() + data + b"\n</AppendedData>\n</VTKFile>"


def map_seeds():
    whole = [map_seed(d, p) for d in (2, 3) for p in (False, True)]
    whole += [map_seed(3, True, [0, 1, 2]), map_seed(3, False, [0, 1, 3]), map_seed(2, False, [0, 1]), map_seed(3, False, [0, 1, 2], facts_of=[("is_backward", 1)]),
              map_seed(2, True, facts_of=[("is_backward", 1), ("space", 1)]), map_seed(3, False, facts_of=[("is_backward", 2)]),
              map_seed(3, False, facts_of=[("bend_sizes", 1)]), *(map_seed(2, False, cell=change) for change in ("type", "point", "place", "node"))]
    changed = [(b"0.5 0", b""), (b"LittleEndian", b"BigEndian"), (b'header_type="UInt64"', b'header_type = "UInt32"'),
               (b"</FieldData>", b"<FieldData/>"), (b"<Piece ", b"<Piece/><Piece "), (b'Name="phi"', b'Name="Points"'),
               (b'format="appended"', b'format="ascii"'), (b'offset="0"', b'offset="-1"'), (b"<?xml", b"<?xml <!--"),
               (b"NumberOfCells", b"a=\"<\" NumberOfCells"), (b'encoding="raw"', b'encoding="base64"'), (b">\n_", b">\n"),
               (b"</FieldData>", b'<DataArray format="appended" type="Int32" Name="dimension" offset="0"/></FieldData>')]
    return whole + [whole[0].replace(a, b, 1) for a, b in changed] + [
        whole[0] + b"\n<!-- shellmatch checksum 0123456789abcdef -->\n", whole[0] + b"\n<!-- shellmatch xxh3 0123456789abcdef -->\n",
        b" -->\n"]


def cbor(value):
    """A document as RFC 8949 has it."""
    head = lambda kind, n: bytes([kind << 5 | n]) if n < 24 else bytes([kind << 5 | 25]) + struct.pack(">H", n)
    if isinstance(value, bool):
        return b"\xf5" if value else b"\xf4"
    if isinstance(value, int):
        return head(0, value)
    if isinstance(value, float):
        return b"\xfb" + struct.pack(">d", value)
    if isinstance(value, str):
        return head(3, len(value)) + value.encode()
    if isinstance(value, list):
        return head(4, len(value)) + b"".join(map(cbor, value))
    return head(5, len(value)) + b"".join(cbor(part) for item in value.items() for part in item)


def alignments():
    """What an alignment has found in the plane and in space, and what none finds."""
    def of(dim, **changes):
        start = {"pose": [1.0] * (1 + dim + dim * dim), "pairs": [0.5] * (2 * (2 * dim + 1)), "spread": 1.0, "landmark_trust": 0.5, "found": 2,
                 "contradicting": 1, "score": 0.1, "order": 0.2, "landmark_distance": 0.1, "identity": True, "mirrored": False} | changes
        search = {"starts": [start], "margin": float("inf"), "share": 1.0, "landmarks": 0, "landmarks_are_spread": False, "notes": ["a"], "part": False,
                  "ambiguous": False}
        found = lambda *results: {"results": list(results), "seconds": 1.5}
        return {"by_pairs": found(search), "by_poses": found(search), "fits_mirrored": found(True),
                "starts": found({"energy": 1.0, "with_pairs": 2.0, "template_distance": 0.1, "spin_difference": 0.2}), "directions": found({"distance": 1.0, "energy": 2.0, "missed": 0.0})}
    without = of(2)
    without["by_pairs"]["results"][0]["starts"] = []
    return [cbor(d) for d in (of(2), of(3), of(2, contradicting=3), of(3, pairs=[1.0]), of(2, pose=[]), of(3, found=-1 % 24), without)] + [cbor([]), b"\x81" * 300, b"\x9b" + b"\xff" * 8]
