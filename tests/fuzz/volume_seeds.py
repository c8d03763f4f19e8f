"""Small volumes of every format, from which fuzzing begins (scripts/fuzz)."""
import base64
import struct
import zlib


def volume_seeds():
    """A label of 4 x 4 x 3 voxels in each format, its bytes plain and compressed."""
    size, n = (6, 5, 5), 150
    voxels = bytes(1 if 0 < i % 6 < 5 and 0 < i // 6 % 5 < 4 and 0 < i // 30 < 4 else 0 for i in range(n))

    def nifti(kind, bits, data, order="<", frame=(1.0, 0, 0, -3, 0, -1.0, 0, 4, 0, 0, 2.0, 5)):
        header = struct.pack(order + "i36x8h14xhh2x8f4f", 348, 3, *size, 1, 1, 1, 1, kind, bits, 1, 1, 1, 2, 1, 1, 1, 1, 352, 1, 0, 0)
        header = header.ljust(252, b"\0") + struct.pack(order + "2h6f12f", 0, 1, 0, 0, 0, 0, 0, 0, *frame)
        return header.ljust(344, b"\0") + b"n+1\0\0\0\0\0" + data
    plain = nifti(2, 8, voxels)
    gzip = lambda data: (lambda c: c.compress(data) + c.flush())(zlib.compressobj(9, zlib.DEFLATED, 31))
    def vti(section, kind, form, values, last):
        extent = " ".join(f"0 {i}" for i in last)
        return (f'<VTKFile type="ImageData" byte_order="LittleEndian"><ImageData WholeExtent="{extent}" Origin="1 2 3" Spacing="1 1 2" '
                f'Direction="0 1 0 -1 0 0 0 0 1"><Piece Extent="{extent}"><{section}><DataArray type="{kind}" Name="a" format="{form}">{values}'
                f"</DataArray></{section}></Piece></ImageData></VTKFile>")

    text = " ".join(map(str, voxels))
    image = vti("PointData", "UInt8", "ascii", text, (5, 4, 4)).encode()
    array = image[image.index(b"<DataArray"):image.index(b"</PointData>")]
    more_vti = [vti("PointData", kind, "ascii", text, (5, 4, 4)).encode()
                for kind in ("Int8", "UInt16", "Int16", "UInt32", "Int32", "UInt64", "Int64", "Float64", "Bit")] + \
        [image.replace(array, array * 2), image.replace(array, array.replace(b'"a"', b'"vtkGhostType"') + array),
         image.replace(b'Name="a"', b'Name="a" NumberOfComponents="3"'), image.replace(b"PointData", b"FieldData"),
         image.replace(b'Spacing="1 1 2" ', b"").replace(b'Origin="1 2 3" ', b""), image.replace(b'Spacing="1 1 2"', b'Spacing="1 1"'),
         image.replace(b' Extent="0 5', b' Extent="0 4'), image.replace(b' Extent="0 5', b' Size="0 5'), image.replace(b'"0 5 0 4', b'"0 5e9 0 4')]

    nrrd = ("NRRD0004\ntype: {}\ndimension: 3\nspace: {}\nsizes: 6 5 5\nspace directions: (1,0,0) (0,1,0) (0,0,2)\nkinds: domain domain domain\n"
            "endian: little\nencoding: {}\nspace origin: (1,2,3)\n\n")
    meta = ("ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData = {}\n{}TransformMatrix = 1 0 0 0 1 0 0 0 1\n"
            "Offset = 1 2 3\nCenterOfRotation = 0 0 0\nElementSpacing = 1 1 2\nDimSize = 6 5 5\nElementType = {}\nElementDataFile = LOCAL\n")
    kinds = [(nrrd.format(name, "scanner-xyz", "raw") + "").encode() + struct.pack(f"<150{form}", *voxels)
             for name, form in (("int8", "b"), ("uint16", "H"), ("uint", "I"), ("int", "i"), ("uint64", "Q"), ("int64", "q"), ("double", "d"))]

    def layered(sizes, axes, directions, second="b"):
        return (f"NRRD0004\ntype: uchar\ndimension: 4\nspace: left-posterior-superior\nsizes: {sizes}\nspace directions: {directions}\nkinds: {axes}\n"
                "encoding: raw\nspace units: \"um\" \"um\" \"um\"\nSegment0_Name:=a\nSegment0_LabelValue:=1\nSegment0_Layer:=1\nSegment7_Name:={second}\n\n").encode()
    floats = struct.pack("<150f", *voxels)
    packed = zlib.compress(voxels)
    # Headers that contradict themselves, or lack something.
    straight = nrrd.format("uchar", "left-anterior-superior", "raw")
    bare = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 6 5 5\nencoding: raw\n{}\n\n"
    odd = [straight, straight.replace("kinds:", "spacings: 1 2 2\nkinds:"), straight.replace("kinds:", "spacings: 1 nan 2\nkinds:"),
           straight.replace("encoding", "byte skip: 1\nencoding"), straight.replace("dimension: 3", "dimension: 2").replace("sizes: 6 5 5", "sizes: 6 25"),
           "NRRD0004\n" + 100 * ("#" + 49 * "-" + "\n") + straight[9:]] + [bare.format(line) for line in (
               "axis mins: 1 2 3\naxis maxs: 7 7 7", "axis maxs: 7 7 7", "spacings: 1 -1 1", "spacings: 1 1", "axis mins: 1 2 3\naxis maxs: 7 7 7\ncenters: node cell ???",
               "centers: cell", "spacings: 1 nan 1")]
    other_meta = meta.format("False", "", "MET_UCHAR")
    odd_meta = [other_meta.replace("Offset", line + "Offset") for line in ("HeaderSize = 0\n", "HeaderSize = -1\n", "HeaderSize = -5\n", "ElementNumberOfChannels = 3\n",
                                                                            100 * ("Comment = " + 40 * "-" + "\n"))]
    return {"nifti": [plain, nifti(16, 32, floats), nifti(4, 16, struct.pack(">150h", *voxels), ">"), plain[:400], plain[:200],
                      nifti(2, 8, voxels, frame=(1.0, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 2, 0))],
            "nifti_gz": [gzip(plain), gzip(plain)[:-30], plain],
            "vti": [image, vti("CellData", "Float32", "ascii", text, (6, 5, 5)).encode(),
                    vti("PointData", "UInt8", "binary", base64.b64encode(struct.pack("<I", n) + voxels).decode(), (5, 4, 4)).encode(), *more_vti],
            "nrrd": [nrrd.format("uchar", "left-posterior-superior", "raw").encode() + voxels,
                     nrrd.format("float", "right-anterior-superior", "gzip").encode() + gzip(floats),
                     nrrd.format("uchar", "scanner-xyz", "ascii").encode() + " ".join(map(str, voxels)).encode(),
                     b"NRRD0001\ntype: short\ndimension: 3\nsizes: 6 5 5\nspacings: 1 1 2\nendian: big\nencoding: raw\n\n" + struct.pack(">150h", *voxels),
                     layered("2 6 5 5", "list domain domain domain", "none (1,0,0) (0,1,0) (0,0,2)") + bytes(v for voxel in voxels for v in (voxel, 2 * voxel)),
                     layered("6 5 5 2", "domain domain domain list", "(1,0,0) (0,1,0) (0,0,2) none") + voxels + voxels,
                     layered("6 5 5 2", "domain domain domain list", "(1,0,0) (0,1,0) (0,0,2) none", "a") + voxels + voxels, *kinds, *(text.encode() + voxels for text in odd)],
            "meta_image": [meta.format("False", "", "MET_UCHAR").encode() + voxels, meta.format("False", "", "MET_FLOAT").encode() + floats,
                           meta.format("True", f"CompressedDataSize = {len(packed)}\n", "MET_UCHAR").encode() + packed,
                           meta.format("False", "", "MET_UCHAR").replace("LOCAL", "none.raw").encode(),
                           *(text.encode() + voxels for text in odd_meta)]}
