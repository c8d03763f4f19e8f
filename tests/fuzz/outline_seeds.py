"""Seeds of the readers of drawings."""
import json
import struct

SEPARATOR = b"\x1e"


def roi(kind=0, points=((0, 0), (9, 0), (9, 9)), options=0, subtype=0, floats=(), segments=(), name="", version=227, arc=0, parameter=None):
    head = b"Iout" + struct.pack(">hBBhhhhH", version, kind, 0, 2, 3, 20, 30, len(points)) + struct.pack(f">{len(floats)}f", *floats)
    head = head.ljust(36, b"\0") + struct.pack(">i", len(segments))
    head = head.ljust(48, b"\0") + struct.pack(">hh", subtype, options) + (struct.pack(">hh", 0, arc) if parameter is None else struct.pack(">f", parameter))
    body = struct.pack(f">{len(segments)}f", *segments)
    for k in (0, 1):
        body += struct.pack(f">{len(points)}h", *(p[k] for p in points))
    if options & 128:
        for k in (0, 1):
            body += struct.pack(f">{len(points)}f", *(p[k] + 3.25 for p in points))
    head = head.ljust(60, b"\0") + struct.pack(">i", 64 + len(body) if name else 0)
    tail = bytes(16) + struct.pack(">ii", 128 + len(body), len(name.encode("utf-16-be")) // 2) + bytes(40) + name.encode("utf-16-be") if name else b""
    return head + body + tail


def roi_set(*parts):
    """Stored, not packed: ZIP as in mesh_seeds."""
    files = directory = b""
    for name, data in parts:
        sizes = struct.pack("<IIIHH", 0, len(data), len(data), len(name), 0)
        directory += b"PK\1\2" + struct.pack("<HHHHHH", 20, 20, 0, 0, 0, 0) + sizes + struct.pack("<HHHII", 0, 0, 0, 0, len(files)) + name
        files += b"PK\3\4" + struct.pack("<HHHHH", 20, 0, 0, 0, 0) + sizes + name + data
    return files + directory + b"PK\5\6" + struct.pack("<HHHHIIH", 0, 0, len(parts), len(parts), len(directory), len(files), 0)


def roi_seeds():
    composite = roi(1, (), segments=(0, 0, 0, 1, 9, 0, 2, 9, 9, 0, 9, 4, 0, 20, 0, 3, 20, 9, 30, 9, 30, 0, 4))
    named = roi(name="a\u00e9\u4e2d\U0001f52c")
    return [roi(), roi(7, options=128), roi(8, options=1), roi(1, ()), roi(1, (), arc=4), roi(2, (), options=128, floats=(1.5, 2, 9, 8)), roi(3, ()), roi(10), roi(11),
            roi(7, subtype=3, floats=(0, 0, 6, 8), parameter=0.5), roi(7, subtype=5, floats=(0, 0, 6, 8), parameter=2), composite, named, roi(version=221, options=128),
            composite[:70], roi(points=()), roi(points=((0, 0), (1, 1))), roi_set((b"a.roi", named), (b"b.roi", composite), (b"c.roi", roi(3, ())), (b"d.txt", b"a")),
            roi_set((b"a.ROI", roi(1, ()))), roi_set((b"a.txt", b"")), roi_set((b"a.roi", b"Iout")), roi(1, (), segments=(7,)), roi(1, (), segments=(1, 2)),
            roi(1, (), floats=(0, 0, 0, 0), options=128), roi(points=((0, 0), (-7, 3), (-7000, 2), (9, 9)))]


def tps_seeds():
    square = b"POINTS=4\n0 0\n10 0\n10 10\n0 10\n"
    curves = b"LM=0\nCURVES=3\nPOINTS=2\n0 0\n9 0\nPOINTS=2\n9 9\n9 0\nPOINTS=3\n9 9\n0 9\n0 0\n"
    two = b"LM=2\r\n1 2\r\nNA NA\r\nOUTLINES=1\r\n" + square + b"IMAGE=C:\\a.jpg\r\nID=a\r\nSCALE=0.5\r\nLM3=1\n1 2 3\nID=b\nCOMMENT=SPACE=LPS\nRADII=1\n3\n"
    return [two, b"a" + SEPARATOR + two, b"C:\\a.jpg" + SEPARATOR + two, b"c" + SEPARATOR + two, curves, b"OUTLINES=1\n" + square + b"ID=a\nOUTLINES=1\n" + square + b"ID=a",
            b"a" + SEPARATOR + b"ID=a\nID=a\n", b"IMAGE=a\nIMAGE=b\nSCALE=1\nSCALE=2\nCURVES=0\nCURVES=0", b"LM=1\n", b"LM=x", b"1 2", b"LM=1\n1 2\n3 4", b"LM=1\n1 2 3",
            b"LM=1\n1 NA", b"LM=1\n1 a", b"SCALE=0", square, b"CURVES=2\n" + square, b"OUTLINES=1\nPOINTS=1\nNA NA", b"\n", b"CURVES=1\nPOINTS=0\n", b"b" + SEPARATOR + two,
            b"a" + SEPARATOR + b"LM=0\n", b"CURVES=2\n" + square + square, b"LM=0\nLM=0\n", b"LM=1\n1e300 1\nSCALE=1e300\n", b"LM3=1\n1 2 3\nSCALE=2\n", b"CURVES=3\nPOINTS=2\n9 0\n9 9\nPOINTS=2\n0 0\n9 0\nPOINTS=2\n5 5\n9 9\n"]


def geojson_seeds():
    outer, inner = [[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]], [[3, 3], [3, 6], [6, 6.5], [3, 3]]
    polygon = {"type": "Polygon", "coordinates": [outer, inner]}
    several = {"type": "GeometryCollection", "geometries": [{"type": "MultiPolygon", "coordinates": [[outer, inner], [[[20, 1], [24, 1], [24, 5]]]]},
                                                           {"type": "Point", "coordinates": [0, 0]}, {"type": "LineString", "coordinates": []}]}
    feature = lambda geometry, **more: {"type": "Feature", "geometry": geometry, **more}
    cell = feature(polygon, id="11", nucleusGeometry=polygon, properties={"objectType": "cell", "name": "a", "classification": {"name": "Tumour", "color": [1, 2]}})
    old = feature(several, id="PathAnnotationObject", properties={"classification": {"name": "Tumour"}, "name": 3})
    texts = [polygon, several, cell, {"type": "FeatureCollection", "features": [cell, old, feature(None, properties={"object_type": "tile"})]}, [cell, old], {}, [1],
             {"type": "a"}, {"type": "Polygon"}, {"type": "Polygon", "coordinates": [[[0, 0], [1]]]}, {"type": "Polygon", "coordinates": [3]},
             {"type": "MultiPolygon", "coordinates": [1]}, {"type": "Point"}, {"type": "Polygon", "coordinates": [[[0, 0], [1, 1]]]},
             {"type": "Polygon", "coordinates": [[[0, 0, 5], [1e300, 1], [2, 1e308]]]}, {"type": "Polygon", "coordinates": [[], outer]}, {"type": "FeatureCollection", "features": 1}]
    deep = b"".join([b'{"type":"GeometryCollection","geometries":['] * 120)
    return [json.dumps(t).encode() for t in texts] + [b"{", deep + b"]}" * 120, b"[" * 300, b'{"type":"Polygon","coordinates":[[[0,0],[1e999,1]]]}']


def svg_seeds():
    svg = lambda body, head="": f"<svg xmlns='http://www.w3.org/2000/svg' {head}>{body}</svg>".encode()
    data = ["M1 2L11 2 11 12 1 12Z", "m1,2 10,0 0,10-10,0z", "M1 2H11V12h-10v-9z", "M0 0C0 5 5 5 5 0S10-5 10 0V20z", "m0 0c0 5 5 5 5 0s5-5 5 0v20z", "M0 0Q2 5 5 0T10 0V20z",
            "m0 0q2 5 5 0t5 0v20z", "M5 0A5 5 0 1 1 10 5z", "m5 0a1 2 30 015 5v9zA0 1 0 0 0 1 1", "M0 0h9v9h-9zM3 3h3v3h-3z", "L1 2", "1", "M1 2X", "M0 0h1zz1", "M0 0a1 1 0 2 0 5 5",
            "M.5.5-3+4e1,2E-1", "M0 0h1e999", "M0 0h1e308h1e308v1z", "M1", "M0 0h5v5M9 9M8 8h1"]
    shapes = ("<rect width='50%' height='10' rx='2'/><circle id='c' cx='1cm' r='2'/><ellipse rx='auto' ry='1mm'/><polygon points='0,0 4,0 4,3'/>"
              "<polyline points='0 0 4 0 4 3'/><rect x='9' y='2pt' width='1in' height='1pc' ry='1Q'/><rect/><circle/><polygon/><path/>")
    transforms = ["translate(10)", "translate(10, 20) scale(2)", "scale(2 3)", "rotate(90)", "rotate(90 1 1)", "skewX(45)", "skewY(45)", "matrix(1 2 3 4 5 6)", "turn(3)", "scale", "scale(1;2)",
                  "scale(1 1 1 1 1 1 1 1)"]
    tree = ("<g id='l' label='L' fill-rule='evenodd'><path id='a' style='display:inline; fill-rule:nonzero !important' d='M0 0h9v9h-9zM3 3h3v3h-3z'/>"
            "<g style='display:none'><path d='M0 0h1v1z'/></g></g><svg x='1' y='2' width='5' height='10' viewBox='1 0 10 10'><path id='b' d='M0 0h2v2z'/></svg>"
            "<svg><rect width='1' height='1'/></svg><defs><path d='M0 0h1v1z'/></defs><use/><text/><line/><image/><a><switch><path visibility='hidden' d='M'/></switch></a>")
    heads = ["width='210mm' height='297mm' viewBox='0 0 210 297'", "width='4in'", "width='300' height='200px'", "width='100%' viewBox='0 0 0 0'", "width='2em'", "viewBox='1'",
             "width='1mm' height='9mm' viewBox='0 0 1 1'", "width='auto'"]
    return ([svg(f"<path d='{d}'/>") for d in data] + [svg(f"<g transform='{t}'><path d='M0 0h1v1z'/></g>") for t in transforms] + [svg(shapes), svg(tree)] +
            [svg(shapes, h) for h in heads] + [b"<svg", b"<a/>", svg(""), svg("<g>" * 120 + "<rect width='1' height='1'/>" + "</g>" * 120)])


def outline_seeds():
    return {"tps": tps_seeds(), "roi": roi_seeds(), "geojson": geojson_seeds(), "svg": svg_seeds()}
