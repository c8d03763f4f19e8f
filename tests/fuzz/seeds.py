"""The inputs that fuzzing begins with, one or a few of each form of each format, and words that stand in the formats."""
import base64
import re
import struct
import zlib
from pathlib import Path

from outline_seeds import outline_seeds
from result_seeds import alignments, map_seeds
from volume_seeds import volume_seeds

ROOT = Path(__file__).resolve().parent.parent.parent
SEPARATOR = b"\x1e"  # target.h


def mesh_seeds():
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
    header = ("ply\nformat {} 1.0\ncomment a\nelement vertex 4\nproperty {r} x\nproperty {r} y\nproperty {r} z\nproperty uchar red\n"
              "property float nx\nelement face 4\nproperty list uchar int vertex_indices\nelement edge 1\nproperty short a\nend_header\n")
    text = lambda row: " ".join(map(str, row)) + "\n"
    seeds = {
        "obj": [("o a\nmtllib m\n" + "".join("v " + text(p) for p in points) + "vt 0 0\nvn 0 0 1\ns 1\n" +
                 "".join("f " + " ".join(f"{v + 1}/1/1" for v in f) + "\n" for f in faces)).encode(),
                ("".join("v " + text(p + (0.1, 0.2, 0.3)) for p in points) + "f -1 -2 -3\nf 1//1 2//1 \\\n3//1\nl 1 2\n").encode(),
                b"# SPACE=LPS\no a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nusemtl a\\\nb\nf 1//1 2//1 3//1\n",
                b"f 1 2 3\nf 1 2\nv 0 0 0 1\nv 1 0 0 1 0 0\nv 0 1 0\n"],
        "off": [("OFF\n4 4 0\n" + "".join(map(text, points)) + "".join("3 " + text(f) for f in faces)).encode(),
                ("COFF 4 4 6 # a\n" + "".join(text(p + (1, 2, 3, 4)) for p in points) + "".join("3 " + text(f + (255, 0, 0)) for f in faces)).encode(),
                b"STCNOFF\n3\n1\n0\n0 0 0 0 0 1 .1 .2 .3 0 0\n1 0 0 0 0 1 .1 .2 .3 1 0\n0 1 0 0 0 1 .1 .2 .3 0 1\n3 0 1 2\n",
                b"3 1 0\n0 0 0 9\n1 0 0 9\n0 1 0 9\n3 0 1 2\n", b"OFF BINARY\n", b"4OFF\n1 0 0\n"],
        "stl": [("solid a\n" + "".join("facet normal 0 0 0\nouter loop\n" + "".join("vertex " + text(points[v]) for v in f) +
                                       "endloop\nendfacet\n" for f in faces) + "endsolid a\n").encode(),
                b" " * 80 + struct.pack("<I", 4) + b"".join(
                    struct.pack("<12fH", 0, 0, 0, *points[f[0]], *points[f[1]], *points[f[2]], 0) for f in faces) + b"12"],
        "ply": [(header.format("ascii", r="float") + "".join(text(p + (9, 0.5)) for p in points) +
                 "".join("3 " + text(f) for f in faces) + "1\n").encode(),
                b"ply\nformat ascii 1.0\nelement vertex 1\nproperty list uchar int a\nproperty double x\nproperty int16 y\nproperty uint z\n"
                b"element tristrips 1\nproperty list int int vertex_index\nend_header\n2 1 1 0 0 0\n3 0 0 0\n",
                b"ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty char x\nproperty ushort y\nproperty int z\n"
                b"property uint a\nproperty int8 b\nend_header\n" + bytes(12) + b"!"],
    }
    for order, name in (("<", "little"), (">", "big")):
        seeds["ply"].append(header.format(f"binary_{name}_endian", r="double").encode() +
                            b"".join(struct.pack(order + "3dBf", *p, 9, 0.5) for p in points) +
                            b"".join(struct.pack(order + "B3i", 3, *f) for f in faces) + struct.pack(order + "h", 1))
    return seeds


def surface_seeds():
    """A tetrahedron in the formats of neuroimaging and of scenes."""
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
    flat = lambda rows: [v for row in rows for v in row]
    text = lambda rows: " ".join(map(str, flat(rows)))

    def gifti(encode, order="<", columns=False, matrix="1 0 0 5 0 1 0 6 0 0 1 7 0 0 0 1"):
        def array(intent, kind, letter, rows):
            values = flat(zip(*rows)) if columns else flat(rows)
            data = encode(struct.pack(f"{order}12{letter}", *values), values)
            return (f'<DataArray Intent="NIFTI_INTENT_{intent}" DataType="NIFTI_TYPE_{kind}" ArrayIndexingOrder="{"Column" if columns else "Row"}MajorOrder" '
                    f'Dimensionality="2" Dim0="4" Dim1="3" Encoding="{data[0]}" Endian="{"Little" if order == "<" else "Big"}Endian">'
                    f"<CoordinateSystemTransformMatrix><DataSpace>NIFTI_XFORM_UNKNOWN</DataSpace><TransformedSpace>NIFTI_XFORM_SCANNER_ANAT"
                    f"</TransformedSpace><MatrixData>{matrix}</MatrixData></CoordinateSystemTransformMatrix><Data>{data[1]}</Data></DataArray>")
        return ('<?xml version="1.0"?><!DOCTYPE GIFTI><GIFTI Version="1.0" NumberOfDataArrays="2">' + array("POINTSET", "FLOAT32", "f", points) +
                array("TRIANGLE", "INT32", "i", faces) + "</GIFTI>").encode()
    plain = lambda data, values: ("ASCII", " ".join(map(str, values)))
    packed = lambda data, values: ("GZipBase64Binary", base64.b64encode(zlib.compress(data)).decode())
    binary = lambda data, values: ("Base64Binary", base64.b64encode(data).decode())
    frame = b"\0\0\0\x14valid = 1\nfilename = a\nvolume = 4 4 4\nvoxelsize = 1 1 1\nxras = -1 0 0\nyras = 0 0 -1\nzras = 0 1 0\ncras = 1 2 3\n"
    brain = b"\xff\xff\xfea\n\n" + struct.pack(">2i12f12i", 4, 4, *flat(points), *flat(faces))
    part = ('<mesh><source id="p"><float_array id="a" count="12">' + text(points) + '</float_array><technique_common><accessor source="#a" count="4" stride="3"/>'
            '</technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>{}</mesh>')
    corners = '<input semantic="VERTEX" source="#v" offset="0"/>'
    collada = lambda faces: ('<?xml version="1.0"?><COLLADA><asset><unit meter="0.01"/><up_axis>Z_UP</up_axis></asset><library_geometries><geometry id="g">' +
                             part.format(faces) + '</geometry></library_geometries><library_controllers><controller id="c"><skin source="#g"><bind_shape_matrix>'
                             '1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix></skin></controller></library_controllers><library_visual_scenes>'
                             '<visual_scene id="s"><node id="n"><translate>1 2 3</translate><rotate>0 0 1 30</rotate><scale>1 2 3</scale><instance_geometry url="#g"/>'
                             '<instance_controller url="#c"/></node><node><instance_node url="#n"/></node></visual_scene></library_visual_scenes>'
                             '<scene><instance_visual_scene url="#s"/></scene></COLLADA>').encode()
    mesh = ("<mesh><vertices>" + "".join('<vertex x="%d" y="%d" z="%d"/>' % p for p in points) + "</vertices><triangles>" +
            "".join('<triangle v1="%d" v2="%d" v3="%d"/>' % f for f in faces) + "</triangles></mesh>")
    model = ('<model unit="inch"><resources><object id="1">' + mesh + '</object><object id="2"><components><component objectid="1" '
             'transform="1 0 0 0 1 0 0 0 1 2 0 0"/></components></object></resources><build><item objectid="2"/><item objectid="1"/></build></model>').encode()
    relations = b'<Relationships><Relationship Target="/a" Type="x/3dmodel"/></Relationships>'

    def archive(pack):
        files = directory = b""
        for name, data in ((b"_rels/.rels", relations), (b"a", model)):
            squeezer = zlib.compressobj(9, zlib.DEFLATED, -15)
            stored = squeezer.compress(data) + squeezer.flush() if pack else data
            sizes = struct.pack("<IIHH", len(stored), len(data), len(name), 0)
            method = 8 if pack else 0
            directory += b"PK\1\2" + struct.pack("<HHHHII", 20, 20, 0, method, 0, 0) + sizes + struct.pack("<HHHII", 0, 0, 0, 0, len(files)) + name
            files += b"PK\3\4" + struct.pack("<HHHII", 20, 0, method, 0, 0) + sizes + name + stored
        return files + directory + b"PK\5\6" + struct.pack("<HHHHIIH", 0, 0, 2, 2, len(directory), len(files), 0)
    def wide_archive():
        """All numbers in the records of ZIP64."""
        files = directory = b""
        most = 0xffffffff
        for name, data in ((b"_rels/.rels", relations), (b"a", model)):
            field = struct.pack("<HHQQQ", 1, 24, len(data), len(data), len(files))
            head = struct.pack("<HHHHI", 45, 0, 0, 0, 0) + struct.pack("<II", most, most)
            directory += b"PK\1\2" + struct.pack("<H", 45) + head + struct.pack("<HHHHHII", len(name), len(field), 0, 0, 0, 0, most) + name + field
            files += b"PK\3\4" + head + struct.pack("<HH", len(name), 0) + name + data
        end = struct.pack("<QHHIIQQQQ", 44, 45, 45, 0, 0, 2, 2, len(directory), len(files))
        return (files + directory + b"PK\6\6" + end + b"PK\6\7" + struct.pack("<IQI", 0, len(files) + len(directory), 1) +
                b"PK\5\6" + struct.pack("<HHHHIIH", 0, 0, 2, 2, len(directory), most, 0))
    data = struct.pack("<12f12H", *flat(points), *flat(faces))
    gltf = ('{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"translation":[1,2,3]}],"meshes":[{"primitives":'
            '[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},'
            '{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteLength":48},'
            '{"buffer":0,"byteOffset":48,"byteLength":24}],"buffers":[{"byteLength":72%s}]}')
    with_data = (gltf % (',"uri":"data:application/octet-stream;base64,' + base64.b64encode(data).decode() + '"')).encode()
    sparse = (b'"componentType":5126,"count":4,"type":"VEC3"', b'"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":2,"indices":'
              b'{"bufferView":1,"componentType":5123},"values":{"bufferView":0}}')
    scenes = [with_data.replace(old, new) for old, new in (
        (b'"translation":[1,2,3]', b'"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,5,6,7,1]'),
        (b'"translation":[1,2,3]', b'"rotation":[0,0,0.7,0.7],"scale":[1,2,3]'), sparse, (sparse[0], sparse[1].replace(b'"bufferView":1', b'"bufferView":0')),
        (b'"indices":1}', b'"indices":1,"mode":0},{"attributes":{"POSITION":0},"mode":5}'), (b'"indices":1}', b'"indices":1,"mode":6}'),
        (b'"asset"', b'"extensionsRequired":["KHR_draco_mesh_compression"],"asset"'), (b'"scene":0,"scenes":[{"nodes":[0]}],', b""),
        (b"data:application/octet-stream;base64,", b"beside.bin"), (b'"nodes":[{', b'"nodes":[{"skin":0,'))]
    head = (gltf % "").encode()
    head += b" " * (-len(head) % 4)
    glb = b"glTF" + struct.pack("<III", 2, 28 + len(head) + len(data), len(head)) + b"JSON" + head + struct.pack("<I", len(data)) + b"BIN\0" + data
    quads = lambda mark, form, factor: (mark + bytes([0, 0, len(points), 0, 0, 2]) + b"".join(struct.pack(form, int(factor * c)) for c in flat(points)) +
                                        b"".join(bytes([0, 0, v]) for v in (0, 1, 2, 3, 1, 0, 3, 2)))
    lists = lambda rows: "".join("<p>" + " ".join(map(str, row)) + "</p>" for row in rows)
    return {"gifti": [gifti(plain), gifti(packed), gifti(binary, ">", True), gifti(plain, matrix="0 2 0 5 -1 1 0 6 0 0 1 7 0 0 0 1"), gifti(plain, matrix="1")],
            "freesurfer": [brain + frame, brain, brain + b"\0\0\0\2\0\0\0\1" + frame, brain[:60], quads(b"\xff\xff\xff", ">h", 100), quads(b"\xff\xff\xfd", ">f", 1)],
            "gltf": [glb, with_data, *scenes],
            "collada": [collada("<triangles>" + corners + "<p>" + text(faces) + "</p></triangles>"),
                        collada("<polylist>" + corners + "<vcount>3 3 3 3</vcount><p>" + text(faces) + "</p></polylist>"),
                        collada("<polygons>" + corners + lists(faces) + "</polygons>"), collada("<tristrips>" + corners + "<p>0 1 2 3 0 1</p></tristrips>"),
                        collada("<trifans>" + corners + "<p>0 1 2 3</p></trifans>"),
                        *(collada("<triangles>" + corners + "<p>" + text(faces) + "</p></triangles>").replace(*change) for change in [
                            (b'<scene><instance_visual_scene url="#s"/></scene>', b""), (b'url="#s"', b'url="other.dae#s"'), (b'url="#s"', b'url="#t"'), (b'meter="0.01"', b'meter="0"'),
                            (b"POSITION", b"NORMAL"), (b"</p>", b" 1</p>"), (b"<p>", b"<p>0 "), (b"<p>", b"<ph><p>0</p></ph><p>"),
                            (b'semantic="VERTEX"', b'semantic="TEXCOORD"'), (b'<visual_scene id="s">', b'<visual_scene id="s">' + 300 * b"<node>" + 300 * b"</node>"),
                            (b"<translate>1 2 3</translate>", b"<lookat>1 2 3</lookat>"), (b"<asset>", 300 * b"<a>" + 300 * b"</a>" + b"<asset>")]),
                        collada("<polylist>" + corners + "<vcount>3 3 3 3 3</vcount><p>" + text(faces) + "</p></polylist>"),
                        collada("<polylist>" + corners + "<vcount>3 3 3</vcount><p>" + text(faces) + "</p></polylist>"),
                        collada("<triangles>" + corners + "<p>0 1</p></triangles>")],
            "three_mf": [archive(True), archive(False), wide_archive()]}


def image_seeds():
    grey = bytes(255 if 4 <= x < 12 and 3 <= y < 13 else 0 for y in range(16) for x in range(16))

    def png(depth, colour, row_of):
        def chunk(kind, data):
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        rows = b"".join(b"\0" + row_of(grey[16 * y:16 * y + 16]) for y in range(16))
        return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 16, 16, depth, colour, 0, 0, 0)) +
                chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
    def tiff(bits, data, kind=1, photometric=1, more=()):
        tags = sorted([(256, 4, 1, 16), (257, 4, 1, 16), (258, 3, 1, bits), (259, 3, 1, 1), (262, 3, 1, photometric), (273, 4, 1, 8), (277, 3, 1, 1),
                       (278, 4, 1, 16), (279, 4, 1, len(data)), (339, 3, 1, kind), *more])
        return (b"II*\0" + struct.pack("<I", 8 + len(data)) + data + struct.pack("<H", len(tags)) +
                b"".join(struct.pack("<HHII", *t) for t in tags) + bytes(4))
    tiles = [(322, 4, 1, 16), (323, 4, 1, 16), (324, 4, 1, 8), (325, 4, 1, 256)]

    def bmp(bits, palette, data):
        return b"BM" + struct.pack("<IIIIiiHHIIIIII", 54 + len(palette + data), 0, 54 + len(palette), 40, 16, 16, 1, bits, 0, len(data), 0, 0, len(palette) // 4,
                                   0) + palette + data
    jpeg = base64.b64decode(
             "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAAYEBQYFBAYGBQYHBwYIChAKCgkJChQODwwQFxQYGBcUFhYaHSUfGhsjHBYWICwgIyYnKSopGR8tMC0oMCUoKSj/"
             "wAALCAAQABABAREA/8QAFQABAQAAAAAAAAAAAAAAAAAAAAf/xAAjEAAAAwYHAAAAAAAAAAAAAAACERIEBQcTFBUAAQMIFjJB/9oACAEBAAA/AJ/tthS44m8i"
             "vzU8me3U8qi1AAVMmqUoAj6ZERe4bkYUuOGXHbC1PJouNRNrdQA0y5SUpAEu+ZmfmG22KzjhlyK/MryaLjTyqLTANMuapShhLvkRH7huRis44m8dsLK8me3V"
             "E2t0wAVMlJSkYj6ZmZeY/9k=")
    labels = bytes(v and 1 + (i % 16 > 7) for i, v in enumerate(grey))
    exif = [order.encode() + struct.pack(form + "HIHHHIHHHHIHH", 42, 8, 2, 256, 3, 1, 16, 0, 274, 3, 1, 6, 0) for order, form in (("II", "<"), ("MM", ">"))]
    turned = [jpeg[:2] + b"\xff\xe1" + struct.pack(">H", 8 + len(e)) + b"Exif\0\0" + e + jpeg[2:] for e in exif]
    chunk = struct.pack(">I", len(exif[0])) + b"eXIf" + exif[0] + struct.pack(">I", zlib.crc32(b"eXIf" + exif[0]))
    plain = png(8, 0, lambda r: r)
    return {"tiff": [tiff(8, grey), tiff(8, labels), tiff(16, b"".join(bytes([v, v]) for v in grey)), tiff(32, struct.pack("<256f", *labels), 3), tiff(8, grey, more=[(274, 3, 1, 6)]),
                     tiff(1, b"".join(bytes([15, 240] if 3 <= y < 13 else 2) for y in range(16))), tiff(8, grey, more=tiles)],
            "jpeg": [jpeg, *turned], "bmp": [bmp(8, bytes(v for c in range(256) for v in (c, c, c, 0)), grey), bmp(24, b"", b"".join(bytes([v] * 3) for v in grey)),
                                    bmp(1, bytes([0, 0, 0, 0, 255, 255, 255, 0]), b"".join(bytes([15, 240, 0, 0] if 3 <= y < 13 else 4) for y in range(16)))],
            "png": [plain, plain[:33] + chunk + plain[33:], png(16, 0, lambda r: b"".join(bytes([v, v]) for v in r)),
                    png(8, 6, lambda r: b"".join(bytes([v, v, v, 255]) for v in r)),
                    png(1, 0, lambda r: bytes(sum((r[8 * i + k] > 0) << (7 - k) for k in range(8)) for i in range(2)))],
            "pgm": [b"P5\n# a\n16 16\n255\n" + grey, b"P5 16 16 65535\n" + b"".join(bytes([v, v]) for v in grey),
                    b"P2\n16 16\n255\n" + " ".join(map(str, grey)).encode()]}


def polydata_seeds():
    """Both forms of VTK's legacy format, old and new lists of cells; its XML format with text, base64 and raw values."""
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
    head = "# vtk DataFile Version 3.0\na SPACE=LPS\n{}\nDATASET POLYDATA\n"
    flat = lambda rows: " ".join(str(v) for row in rows for v in row)
    text = (head.format("ASCII") + f"POINTS 4 float\n{flat(points)}\nMETADATA\nINFORMATION 0\n\nVERTICES 1 2\n1 0\nLINES 1 3\n2 0 1\n"
            f"POLYGONS 4 16\n{flat((3,) + f for f in faces)}\nTRIANGLE_STRIPS 1 5\n4 0 1 2 3\nCELL_DATA 7\nSCALARS c int\nLOOKUP_TABLE default\n1 1 1 1 1 1 1\n"
            "POINT_DATA 4\nSCALARS a double 2\nLOOKUP_TABLE t\n1 2 3 4 5 6 7 8\nLOOKUP_TABLE t 1\n0 0 0 1\nCOLOR_SCALARS RGB 3\n1 0 0 1 0 0 1 0 0 1 0 0\n"
            "VECTORS v float\n0 0 0 0 0 0 0 0 0 0 0 0\nNORMALS n float\n0 0 0 0 0 0 0 0 0 0 0 0\nTEXTURE_COORDINATES t 2 float\n0 0 0 0 0 0 0 0\n"
            "FIELD f 3\nNULL_ARRAY\nb 1 4 unsigned_char\n1 2 3 4\ns 1 4 string\na\nb\nc\nd\n").encode()
    new = (head.format("ASCII") + f"FIELD FieldData 1\nx 1 1 bit\n1\nPOINTS 4 double\n{flat(points)}\nPOLYGONS 5 12\nOFFSETS vtktypeint64\n0 3 6 9 12\n"
           f"CONNECTIVITY vtktypeint64\n{flat(faces)}\nPOINT_DATA 4\nGLOBAL_IDS g vtkIdType\n1 2 3 4\n").encode()
    binary = (head.format("BINARY").encode() + b"POINTS 4 float\n" + struct.pack(">12f", *(v for p in points for v in p)) + b"\nPOLYGONS 4 16\n" +
              b"".join(struct.pack(">4i", 3, *f) for f in faces) + b"\nPOINT_DATA 4\nSCALARS a bit 1\nLOOKUP_TABLE default\n\xf0\nFIELD f 1\ns 1 2 string\n\xc1a\xc1b\n")
    grid = (b"# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\nCELLS 5 20\n3 0 1 2\n4 0 1 2 3\n3 1 3 2\n"
            b"1 0\n4 0 1 2 3\nCELL_TYPES 5\n5 8 7 1 6\n")
    array = lambda kind, name, n, values, form="ascii", more="": (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{n}" format="{form}"{more}>' + values + "</DataArray>")

    def vtp(encode, root=""):
        parts = [encode("Float64", "Points", 3, [v for p in points for v in p]), encode("Int32", "connectivity", 1, [v for f in faces for v in f]),
                 encode("Int64", "offsets", 1, [3, 6, 9, 12]), encode("UInt8", "RGB", 3, [7] * 12)]
        return (f'<?xml version="1.0"?>\n<VTKFile type="PolyData" byte_order="LittleEndian"{root}><PolyData><FieldData><Array type="String" Name="SPACE" '
                f'NumberOfTuples="1" format="ascii">76 80 83 0</Array></FieldData><Piece NumberOfPoints="4" NumberOfPolys="4"><PointData>{parts[3]}</PointData>'
                f'<Points>{parts[0]}</Points><Polys>{parts[1]}{parts[2]}</Polys></Piece></PolyData>').encode()
    letters = {"Float64": "d", "Int32": "i", "Int64": "q", "UInt8": "B"}
    packed = lambda kind, values: struct.pack(f"<{len(values)}{letters[kind]}", *values)
    data = b""

    def raw(kind, name, n, values):
        nonlocal data
        body = packed(kind, values)
        tag = array(kind, name, n, "", "appended", f' offset="{len(data)}"')
        data += struct.pack("<I", len(body)) + body
        return tag

    def blocks(kind, name, n, values):
        body = packed(kind, values)
        return array(kind, name, n, base64.b64encode(struct.pack("<4Q", 1, len(body), 0, len(zlib.compress(body)))).decode() +
                     base64.b64encode(zlib.compress(body)).decode(), "binary")
    plain = vtp(lambda kind, name, n, values: array(kind, name, n, " ".join(map(str, values)))) + b"</VTKFile>"
    appended = vtp(raw) + b'<AppendedData encoding="raw">_'
    return {"vtk": [text, new, binary, grid, text.replace(b"POLYDATA", b"STRUCTURED_POINTS"), text.replace(b"POINTS 4", b"POINTS 99999999999"),
                    text.replace(b"3 0 2 1", b"3 0 2 9"), new.replace(b"0 3 6", b"0 9 6"), grid.replace(b"5 8 7", b"5 8 10"), text.replace(b"SPACE", b"A")],
            "vtp": [plain, appended + data + b"</AppendedData></VTKFile>",
                    vtp(blocks, ' header_type="UInt64" compressor="vtkZLibDataCompressor"') + b"</VTKFile>", plain.replace(b"PolyData", b"ImageData"),
                    plain.replace(b'NumberOfPoints="4"', b'NumberOfPoints="5"'), plain.replace(b"3 6 9 12", b"3 6 9 99999999999"),
                    plain.replace(b'byte_order', b'compressor="vtkLZ4DataCompressor" byte_order'), plain.replace(b"<Piece", b"<Piece/><Piece")]}


def repair_seeds():
    """Edits as edited_shape.cpp understands them."""
    n = lambda *values: bytes(int(122 + 4 * v) for v in values)
    two = lambda v: struct.pack("<H", v)
    tetrahedron = lambda x, y, z, side: b"\x00" + n(x, y, z, side)
    square = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0)]
    prism = lambda corners, height: b"\x01" + two(len(corners) - 3) + n(*height) + b"".join(n(*c) for c in corners)
    body = tetrahedron(0, 0, 0, 4)
    return {
        "repair3": [body, body + tetrahedron(.25, .25, .25, 1), prism(square, (0, 0, 2)), prism(square[::-1], (0, 0, 2)),
                    prism([(0, 0, 0), (4, 0, 0), (4, 4, 0), (2, 1, 0), (0, 4, 0)], (0, 0, 1)),
                    body + tetrahedron(8, 0, 0, 0), body + b"\x04" + two(1), body + b"\x05" + two(2) + b"\x06" + two(0),
                    body + b"\x09" + two(0) + two(0), body + b"\x09" + two(1) + two(0) + b"\x0a" + two(0), body + b"\x0a" + two(1),
                    body + tetrahedron(4, 0, 0, 4) + b"\x08" + two(4) + two(1), b"\x02" + n(0, 0, 0), body + b"\x07" + two(0) + n(1, 1, 2),
                    b"", prism(square, (0, 0, 0)), body + b"\x03" + two(2) + two(0) + two(1), body + b"\x02\xff\xff\xff",
                    body + tetrahedron(1, 1, 1, 4), body + b"\x0b" + two(0) + two(1) + b"\x01"],
        # Without one or two of their polygons, with one twice, and with a vertex of its own for one.
        "close3": [body + b"\x06" + two(0), prism(square, (0, 0, 2)) + b"\x06" + two(1), prism(square, (0, 0, 2)) + b"\x06" + two(5) + b"\x06" + two(0),
                   body + tetrahedron(.25, .25, .25, 1) + b"\x06" + two(4), body + b"\x05" + two(2), body + b"\x0a" + two(1) + b"\x07" + two(4) + n(1, 1, 2),
                   body + tetrahedron(4, 0, 0, 4) + b"\x08" + two(4) + two(1) + b"\x06" + two(7), b"", body + b"\x03" + two(3) + two(0) + two(1) + two(2)],
        "repair2": [b"".join(b"\x00" + n(x, y) for x, y in [(0, 0), (4, 0), (4, 4), (0, 4)]), b"\x04" + n(0, 0, 8, 8) + b"\x04" + n(1, 1, 2, 2),
                    b"\x05" + two(2) + two(1) + n(0, 0, 4), b"\x05" + two(3) + two(0) + n(0, 0, 4), b"", b"\x03",
                    b"\x04" + n(0, 0, 4, 4) + b"\x04" + n(4, 4, 4, 4), b"\x04" + n(0, 0, 4, 4) + b"\x00" + n(0, 2) + b"\x06" + two(0),
                    b"\x00" + n(0, 0) + b"\x00" + n(4, 0) + b"\x00" + n(0, 0) + b"\x00" + n(0, 4)]}


HISTORY = (b"level,substep,nu,solver,iteration,value,match,gradient_norm,l2_gradient_norm,step,value_evaluations,gradient_evaluations,"
           b"seconds\n3,0,0.5,newton,0,1.5,1.5,2,nan,0,1,1,0.25\n")
SUMMARY = (b'{"version": "0.1.0", "profile": "default", "dimension": 2, "interrupted": false, "reference": {"file": "a", "vertices": 1, '
           b'"facets": 1, "notes": ["b"], "components": 1, "genus": 0, "invented": 0.1}, "template": {"file": "c", "vertices": 1, "facets": 1, "notes": [], '
           b'"components": 1, "genus": 0}, "unit": "mm", "template_diagonal": 2, "verdict": {"outcome": "look-here", "reasons": [{"what": "a", "advice": '
           b'"b", "shape": "template", "place": [0, 1]}]}, "placement": {"kind": "fit", '
           b'"scale": 1, "offset": [0, null]}, "distance_before": {D}, "distance": {D}, "correspondence_error": 0.5, "area_distortion": {M}, '
           b'"angle_distortion": {M}, "flipped_facets": 0, "flipped_share": 0, "correspondence_error_before": 1, "levels": [{"level": 3, "sigma": 1, "nu": 1, "volume_weight": 1, "substeps": 1, '
           b'"nodes": 1, "free_nodes": 1, "cells": 1, "band_cells": 1, "energy_minimised": {"sum": 1}, "energy": {"sum": 1}, "iterations": 1, '
           b'"value_evaluations": 1, "gradient_evaluations": 1, "gradient_norm": 1, "linear_iterations": 1, "regularised_systems": 0, "l2_gradient_norm": 1, "solver": "newton", "fallbacks": ["a"], "library_reports": [{"brief": "a", "full": "b"}], '
           b'"stop_reason": "a", "stop_message": "b", "folds": {"min_determinant": 1, "determinant_lower_bound": 1, "folded_cells": 0, '
           b'"uncertified_cells": 0, "folded_volume": 0}, "band": {"normal_angle": 1, "folded_share": 0}, "distance": {D}}], "gradient_checks": '
           b'[{"level": 3, "substep": 0, "iteration": 0, "passed": true, "failed_terms": "a", "worst_order": 2, "worst_functor_error": 0}], "run": {"compiler": "a", "threads": 1, "seconds": 1, "phase_seconds": {"a": 1}, "level_seconds": [1], "peak_memory_bytes": 1, '
           b'"resumed_after": [3], "level_memory_estimates": [1], "level_memory_peaks": [1]}, "direction": {"backward": false, '
           b'"forward_distance": 1, "backward_distance": 0.5, "forward_energy": 1, "backward_energy": 2}, "alignment": {"mode": "a", "angle": 1, "scale": 1, "mirrored": false, "score": 1, "margin": 1, "tried": 1, '
           b'"pairs": 1, "doubtful": false, "as_it_lies": false, "fits_mirrored": false, "landmark_distance": 1, "landmark_trust": 1, "predicted_from": 3}, "bent": false, '
           b'"landmarks": {"count": 1, "mean": 0.1, "max": 0.2, "farthest": "a", "place": [0, 1]}, "spin_difference": 0.1}').replace(b"{D}", b'{"deformed_to_template": {"mean": 1, "p95": 1, "max": 1}, "template_to_deformed": '
           b'{"mean": 1, "p95": 1, "max": 1}, "uncovered": 0}').replace(b"{M}", b'{"mean": 1, "min": 1, "max": 1, "p5": 1, "p95": 1}')


def seeds_of_all():
    seeds = {**mesh_seeds(), **outline_seeds(), **surface_seeds(), **image_seeds(), **volume_seeds(), **polydata_seeds(), **repair_seeds(), "map": map_seeds()}
    joined = lambda *parts: SEPARATOR.join(parts)
    seeds["points2"] = [b"x,y,\"a\"\n0,0,1\n1,0,2\n\n0;1;3\n# b\n1,1,4\n", b"\xef\xbb\xbf0 0\n1 0\n0 1\n0 0\n", b"z,x,y\n", b"a,x\n0,1\n"]
    seeds["points3"] = [b"x,y,z\n0,0,0\n1,0,nan\n", b"0 0 0\r\n1 1e5 -2\r\n", b"a y X z\n1 2 3 4\n",
                       b"name,x,y,z,label\n\"a, \"\"b\"\"\",1,2,3,4\nc d,1,2,3,5\n"]
    seeds["yaml"] = [b"version: 1\nsome: {flag: true, number: 3, value: 0.5, text: \"a\", list: [1, 2], colour: green}\n",
                     b"version: &a 1\nsome:\n  number: *a\n  list:\n    - 1\n    - !!float 2\n", b"{version: 1},", b"a: 1\n---\nb: 2\n", b"[a]",
                     b"{}", b"some:\n", b"some: 1\n", b"[]: 1\n", b"some: {[1]: 2}\n", b"some: {list: 1, text: [a]}\n", b"version: {a: 1}\n",
                     b"version:\n", b"version: 1\nversion: 2\n", b"some: &a {text: *a}\n", b"a\n", b"", b"some: {list: [[1]]}\n", b"a: \0\n",
                     joined(b"version: 1", b"[1, 2]", b"true", b"3", b"1, junk", b"red", b"{a: 1}", b"'a", b"yes", b"1e999", b"!!int 3", b"")]
    seeds["experiment"] = [b"profile: paper\ninput: {reference: a.ply, template: generate:circle, placement: as-is}\ncascade: {min_level: 2, "
                           b"max_level: 3}\nsolver: {name: lbfgs, fallback: [newton], levels: {3-5: {name: newton, stop: {max_iterations: 3}}}}\n",
                           b"solver: {levels: {3: {stop.max_iterations: 3}, 4-15: {name: lbfgs}}}\nenergy: {match_weight: 0}\n",
                           joined(b"threads: 1", b"solver.levels.3-5.name=lbfgs", b"profile=paper", b"cascade.nu=0.5", b"input.reference=a"),
                           joined(b"threads: 1", b"cascade=1"), joined(b"threads: 1", b"solver.levels=1"), joined(b"threads: 1", b"a.b=1"),
                           b"solver: {levels: 3}", b"solver: {levels: {3: 4}}", b"solver: {levels: {[]: 4}}", b"solver: {levels: {3: {[]: 4}}}",
                           b"solver: {levels: {3-5: {levels: {}}}}", b"solver: {levels: {3-5: {stop: 4}, 4: {name: lbfgs}}}", b"solver: {levels: {3-5: {name: newton}, 4: {name: lbfgs}}}", b"solver: {name: a}",
                           b"cascade: {min_level: 5, max_level: 4}", b"check_gradient: {every: 2}\npictures: none\nresume: {enabled: no}\n",
                           joined(b"threads: 1", b"solver.levels.3.stop=1"), joined(b"threads: 1", b"solver.levels.3.name=a", b"=1"), b"start: {level: 4}", b"start: {map: a, level: 14}",
                           b"start: {map: a, level: 4, images: [a, b]}", b"solver: {levels: {3: {fallback: [a]}}}", b"solver: {name: newton, fallback: [newton]}"]
    study = b"version: 1\ntitle: a\nproblems: {a: {set: {input: {reference: 'generate:circle', template: b}}}}\nsolvers: [newton]\n"
    seeds["study"] = [study, joined(study, b"repeats=2", b"cascade.nu=1", b"version=1"),
                      study + b"limits: {seconds: 3, memory_mb: 1}\nset: {cascade.nu: 1, energy: {delta: 2}}\nmetrics: [l2, h1]\n"
                      b"parameters: {cascade.nu: [1, 2], input.reference: [a, b]}\n", study + b"set: {start.images: [a, \"b'\"]}\n",
                      b"version: 1\nproblems: {a: {base: ., set: {}}}\nsolvers: {x: {name: newton, stop: {max_iterations: 2}}, lbfgs: , y: {}}\n",
                      b"version: 2", b"version:", b"a: 1", b"version: 1\nproblems:", b"version: 1\nproblems: {a: 1}", b"version: 1\nlimits: 1",
                      b"version: 1\nproblems: {a: {base: []}}", b"version: 1\nproblems: {a: {b: 1}}", b"version: 1\nproblems: {a b: {}}",
                      b"version: 1\nproblems: {a: {base: none}}", b"version: 1\nproblems: {a: {}}\nsolvers: [[]]", study + b"metrics: []",
                      study + b"metrics: 1", study + b"parameters: []", study.replace(b"solvers", b"repeats"), study.replace(b"[newton]", b"1")]
    table = b"id,file,landmarks,group,reflect,age\n a1 ,a.ply,a.fcsv,left,1,40\n,b/c.nii.gz:3,,\"ri, ght\",no,\n"
    seeds["subjects"] = [table, b"file\ngenerate:hand/bent\na.vtp\n", b"FILE;id\na;b\n", table + table, b"file,file\na,b\n", b"id\na\n", b"file\n", b"",
                         table.replace(b"no", b"2"), table.replace(b"a1", b".a"), table.replace(b"b/c.nii.gz:3", b""), b"file,id\na\n",
                         table.replace(b"a1", b"a" * 201), b"file,x\na,b,c\n"]
    cohort = b"version: 1\ntitle: a\nshapes: ['generate:circle', 'generate:blob', 'generate:leaf']\natlas: {kind: given, shape: blob, rounds: 2}\n"
    more = b"statistics: {procrustes: none, modes: 2}\nlimits: {seconds: 3}\nset: {profile: paper, cascade: {max_level: 5}, energy.delta: 2}\n"
    seeds["cohort"] = [cohort, cohort + more, joined(cohort, b"atlas.kind=mean", b"cascade.nu=1", b"atlas.shape=generate:leaf", b"version=1"),
                       cohort.replace(b"blob,", b"blub,"), cohort.replace(b"shape: blob, ", b""), cohort + b"table: a.csv\n", b"version: 1\ntable: a.csv\n",
                       b"version: 1\n", b"version: 1\nshapes: []\n", cohort + b"statistics: {groups: [a, b]}\n", cohort + b"statistics: {groups: [a]}\n",
                       cohort + b"set: {input.reference: a}\n", cohort + b"set: {input: {template: a}}\n", cohort + b"set: {input.correspondence: a}\n",
                       cohort + b"set: {landmarks.file: a}\n", cohort + b"set: {landmarks: {template_file: a}}\n", cohort.replace(b"rounds", b"max_level"),
                       b"version: 1\nshapes: ['*.x']\n", joined(cohort, b"atlas.landmarks=b"), cohort.replace(b"blob, ", b"b.csv, landmarks: a.csv, "),
                       cohort.replace(b"shape: blob, ", b"").replace(b"given", b"mean"), cohort.replace(b"blob,", b"'generate:star',"), cohort.replace(b"'generate:leaf'", b"b.csv"),
                       cohort + b"set: {start.map: a}\n", cohort + b"set: {start.images: [a]}\n", cohort.replace(b"rounds: 2", b"max_level: 14"), cohort + b"table: a.csv\n"]
    seeds["history"] = [HISTORY, HISTORY + b"3,0,0.5,newton,1,1,1,1,nan,1,1,1,0.5\n3,1,0.1,newton,0,2,2,1,nan,0,1,1,0\n", HISTORY.replace(b",match", b"").replace(b"1.5,1.5", b"1.5"), HISTORY + b"1,2\n", HISTORY.replace(b"0.25", b"a"),
                        b"level,substep\n", b""]
    seeds["landmarks"] = [b"name,x1,y1,z1,x2,y2,z2,weight\na,0,0,0,1,1,1,2\n", b"vertex1,vertex2,sd\n0,1,0.5\n2,3,1\n",
                          b'"name", x1,y1,x2,y2\na,0,0,1,1\nb,0,1,1,2\n', joined(b"name,x,y,z,sd\na,0,0,0,1\nb,1,1,1,2\n", b"name,vertex\nb,1\na,2\n"),
                          joined(b"name,vertex,weight\na,0,1\n", b"name,x,y\na,0.5,1e3\n"), joined(b"name,vertex\na,0\n", b"name,vertex\nb,0\n"),
                          joined(b"name,vertex\na,0\nb,1\n", b"name,vertex\na,0\n"), joined(b"name,vertex\na,0\n", b"name,vertex,sd\na,0,1\n"),
                          joined(b"", b"name,vertex\na,0\n", b""), joined(b"vertex\n0\n", b"name,vertex\na,0\n"), b"x1,y1,vertex2\n0,0,9\n",
                          b"vertex1,vertex2,a\n", b"vertex1,vertex1\n", b"vertex1,x2\n", b"vertex1,vertex2,sd,weight\n", b"vertex1,vertex2\n",
                          b"vertex1,vertex2\n1\n", b"name,vertex1,vertex2\n,1,1\n", b"name,vertex1,vertex2\na,1,1\na,1,2\n", b"\n",
                          b"vertex1,vertex2,sd\n1,1,0\n", b"vertex1,vertex2\n1.5,1\n", b"x1,y1,x2,y2\nnan,0,0,0\n"]
    point = b'{"id": "1", "label": "a", "description": "", "position": [1.5, -2, 3], "orientation": [-1.0, 0.0], "positionStatus": "defined"}'
    markups = b'{"@schema": "s", "markups": [{"type": "Fiducial", "coordinateSystem": "LPS", "controlPoints": [' + point + b']}]}'
    seeds["markups"] = [markups, markups.replace(b'"LPS"', b"0"), markups.replace(b"LPS", b"IJK"), markups.replace(b"defined", b"undefined"),
                        markups.replace(b"-2, 3", b"-2"), markups.replace(b"1.5", b"1e999"), markups.replace(b"1.5", b'"1"'), b"{}", b"[", b'{"markups": [1]}',
                        b'{"markups": [{"controlPoints": 1}]}', b'{"markups": [{"controlPoints": [1]}]}', b'{"markups": [{}]}', b"[" * 300]
    fcsv = (b"# Markups fiducial file version = 4.11\n# CoordinateSystem = LPS\n# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n"
            b'1,1.5,-2,3,0,0,0,1,1,1,0,"F, ""1""",,\r\n')
    seeds["fcsv"] = [fcsv, fcsv.replace(b"LPS", b"1"), fcsv.replace(b"LPS", b"IJK"), fcsv.replace(b"id,x,y,z,ow", b"z,y,x"), fcsv.replace(b"label", b"l"),
                     fcsv.replace(b"1.5", b"nan"), b"1,2,3\n", b"# columns = label,x,y,z\na,1,2,3\n", b"1,1,2,3,0,0,0,1,1,1,0,a\n"]
    placed = fcsv.replace(b"4.11", b"5.4").replace(b",,\r\n", b",,,2,0\r\n2,,nan,x,0,0,0,1,1,1,0,b,,,3,0\r\n")
    seeds["fcsv"] += [placed, placed.replace(b",3,0", b",7,0"), placed.replace(b"# CoordinateSystem = LPS\n", b""), fcsv.replace(b"# CoordinateSystem = LPS\n", b""),
                      b"# Markups fiducial file version = 4.x\n# columns = label,positionStatus,x,y,z\na,0,1,2,3\nb,2,1,2,3\n"]
    slicer = joined(fcsv.replace(b'"F, ""1"""', b"a"), markups)
    seeds["landmarks"] += [slicer, joined(markups, markups), joined(markups.replace(b'"a"', b'"b"'), markups), fcsv, joined(slicer, b"", b""),
                           joined(b"name,vertex\na,0\nb,1\n", b"name,vertex\nb,0\nc,1\n", b"", b""), joined(b"name,vertex\na,0\n", b"name,vertex\nb,0\n", b"", b""),
                           joined(markups.replace(b"defined", b"undefined"), markups), joined(markups.replace(b'"a"', b'""'), markups),
                           joined(markups.replace(point, point + b"," + point), markups), joined(b"{}", b"{}"),
                           joined(b"name,x,y,z\na,,NA,nan\nb,1,2,3\n", b"name,vertex\na,0\nb,0\n"), joined(placed, b"name,vertex\nb,0\n"),
                           joined(b"name,x,y\na,,\n", b"name,vertex\na,0\n"),
                           joined(b"LM=2\n1 2\nNA NA\nSCALE=2\n", b"name,vertex\n1,0\n2,0\n"), joined(b"name,vertex\n1,0\n", b"LM3=1\n1 2 3\nCOMMENT=SPACE=LPS"),
                           b"LM=1\n1 2\n", joined(b"LM=1\nNA NA\n", b"LM=0\n"), joined(b"LM=0\n", b"LM=0\nID=a\nLM=0\nID=b\n")]
    seeds["correspondence"] = [b"# a\n0 0.5 0.5 0.5\n8 1 2 3\n", b"0 1 2\n", b"9 1 2 3\n", b"#\n"]
    seeds["files"] = [b'{"format": 1, "files": [{"name": "a/b", "bytes": 3, "checksum": "00"}]}', b'{"format": 2, "files": []}', b"{"]
    two, three = (struct.pack(f"<{2 * n}d", *range(2 * n)) for n in (2, 3))
    seeds["levels"] = [b"dimension 2, 2 vertices, levels [3, 4]\n" + 2 * two, b"dimension 3, 2 vertices, levels [12]\n" + three,
                       b"dimension 2, 0 vertices, levels []\n", b"dimension 2, 2 vertices, levels [4, 3]\n" + 2 * two,
                       b"dimension 3, 3 vertices, levels [3]\n" + three, b"dimension 2, 2 vertices, levels [3]\n" + two[:-1] + b"\xff"]
    seeds["alignment"] = alignments()
    seeds["manifest"] = [b'{"format": 4, "level": 4, "program": "a", "reference": "b", "template": "c", "landmarks": "d"}', b"[1e300]"]
    seeds["run_result"] = [b'{"status": "finished", "message": "", "exit_code": 0, "signal": 0, "fingerprint": "a", "seconds": 1.5, '
                           b'"peak_memory_bytes": 1, "load": 0, "limit_seconds": 0, "limit_memory_mb": 0, "jobs": 1, "machine": "m", "program": "p"}']
    seeds["summary"] = [b"{}", SUMMARY, b"[]"]
    return seeds


def words_of(target, inputs):
    """A dictionary of libFuzzer: the words of the seeds, and for options those of docs/options.md."""
    text = b"\n".join(inputs)
    if target in ("experiment", "study", "cohort"):
        text += b" ".join(re.findall(rb"`([^`]*)`", (ROOT / "docs/options.md").read_bytes()))
    words = set(re.findall(rb"[A-Za-z_][A-Za-z_0-9.-]{1,40}", text)) | {b"1e308", b"-1", b"nan", b"9223372036854775807", b"2147483648"}
    return "".join(f'"{word.decode()}"\n' for word in sorted(words) if not re.search(rb'["\\]', word))
