"""Small volumes and surfaces whose headers say in every way where they lie: for scripts/study frames-table."""
import struct

import numpy as np

SIZE, BLOCK = (20, 18, 16), ((5, 13), (4, 10), (6, 12))
MIDDLE = np.array([(a + b - 1) / 2 for a, b in BLOCK])  # of the labelled block, in voxels
SPACING, ORIGIN = (1, 1.5, 2), (3, -7, 11)
SCANNER, ALIGNED = 1, 2  # codes of NIfTI's transforms


def values():
    label = np.zeros(SIZE, np.uint8)
    label[tuple(slice(a, b) for a, b in BLOCK)] = 1
    return label.tobytes(order="F")


def quaternion(rotation):
    """b, c and d of a proper rotation that turns by less than half a turn."""
    a = np.sqrt(1 + np.trace(rotation)) / 2
    odd = rotation - rotation.T
    return [odd[2, 1] / (4 * a), odd[0, 2] / (4 * a), odd[1, 0] / (4 * a)]


def nifti(q_code, s_code, axes, q_axes=None, unit=2):
    """The bytes of a NIfTI; the qform has `q_axes`, or `axes` without a shear, and lengths SPACING."""
    turn = np.array(q_axes if q_axes is not None else np.asarray(axes) / np.asarray(SPACING))
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, *SIZE, 1, 1, 1, 1)
    struct.pack_into("<2h", header, 70, 2, 8)
    struct.pack_into("<8f", header, 76, 1, *SPACING, 0, 0, 0, 0)
    struct.pack_into("<f", header, 108, 352)
    header[123] = unit
    struct.pack_into("<2h", header, 252, q_code, s_code)
    struct.pack_into("<6f", header, 256, *quaternion(turn), *ORIGIN)
    struct.pack_into("<12f", header, 280, *np.column_stack([axes, ORIGIN]).ravel())
    header[344:348] = b"n+1\0"
    return bytes(header) + values()


def nrrd(*where):
    """The bytes of an NRRD with these lines about where it lies."""
    lines = ["NRRD0005", "type: uint8", "dimension: 3", "sizes: %d %d %d" % SIZE, *where, "encoding: raw", "", ""]
    return "\n".join(lines).encode() + values()


def vectors(scale=1):
    (a, b, c), origin = (scale * s for s in SPACING), ",".join(str(scale * o) for o in ORIGIN)
    return [f"space directions: ({a},0,0) (0,{b},0) (0,0,{c})", f"space origin: ({origin})"]


def meta_image(*where):
    head = ["ObjectType = Image", "NDims = 3", "BinaryData = True", "BinaryDataByteOrderMSB = False",
            "TransformMatrix = 1 0 0 0 1 0 0 0 1", "Offset = %g %g %g" % ORIGIN, *where,
            "ElementSpacing = %g %g %g" % SPACING, "DimSize = %d %d %d" % SIZE, "ElementType = MET_UCHAR",
            "ElementDataFile = LOCAL", ""]
    return "\n".join(head).encode() + values()


def volumes():
    """Name and bytes of each."""
    straight = np.diag(SPACING)
    c, s = np.cos(0.3), np.sin(0.3)
    turned = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ straight
    sheared = straight.astype(float)
    sheared[0, 1] = 0.5
    plain = np.eye(3)
    yield "qform.nii", nifti(SCANNER, 0, straight)
    yield "sform.nii", nifti(0, SCANNER, straight)
    yield "equal.nii", nifti(SCANNER, SCANNER, turned)
    yield "differ_1.nii", nifti(SCANNER, SCANNER, turned, plain)
    yield "differ_2.nii", nifti(SCANNER, ALIGNED, turned, plain)
    yield "sheared.nii", nifti(0, SCANNER, sheared, plain)
    yield "sheared_qform.nii", nifti(SCANNER, SCANNER, sheared, plain)
    yield "unit.nii", nifti(SCANNER, SCANNER, plain, plain)
    yield "unit_sform.nii", nifti(0, SCANNER, plain, plain)
    yield "no_codes.nii", nifti(0, 0, straight)
    yield "metres.nii", nifti(SCANNER, SCANNER, straight, unit=1)
    yield "micrometres.nii", nifti(SCANNER, SCANNER, straight, unit=3)
    yield "lps.nrrd", nrrd("space: left-posterior-superior", *vectors())
    yield "ras.nrrd", nrrd("space: right-anterior-superior", *vectors())
    yield "las.nrrd", nrrd("space: left-anterior-superior", *vectors())
    yield "scanner.nrrd", nrrd("space: scanner-xyz", *vectors())
    yield "right_handed.nrrd", nrrd("space: 3D-right-handed", *vectors())
    yield "no_space.nrrd", nrrd("space dimension: 3", *vectors())
    yield "spacings.nrrd", nrrd("spacings: %g %g %g" % SPACING, "axis mins: %g %g %g" % ORIGIN)
    yield "spacings_cell.nrrd", nrrd("spacings: %g %g %g" % SPACING, "axis mins: %g %g %g" % ORIGIN,
                                     "centerings: cell cell cell")
    yield "micrometres.nrrd", nrrd("space: left-posterior-superior", *vectors(1000), 'space units: "um" "um" "um"')
    yield "meta.mha", meta_image()
    yield "meta_ras.mha", meta_image("AnatomicalOrientation = LPI")
    yield "meta_centre.mha", meta_image("CenterOfRotation = 5 5 5")
    yield "meta_um.mha", meta_image("DistanceUnits = um")


CORNERS = np.array([[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]])
POINTS = CORNERS * [4, 5, 6] + [11, -3, 8]  # of a box, whose middle is asked for
QUADS = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (2, 3, 7, 6), (1, 2, 6, 5), (0, 4, 7, 3)]
TRIANGLES = [t for a, b, c, d in QUADS for t in ((a, b, c), (a, c, d))]


def gifti(frame, matrix):
    """The bytes of a GIfTI whose points have a transform to `frame`."""
    def array(intent, kind, rows, more=""):
        values = " ".join(str(a) for row in rows for a in row)
        return (f'<DataArray Intent="NIFTI_INTENT_{intent}" DataType="NIFTI_TYPE_{kind}" Dimensionality="2" '
                f'ArrayIndexingOrder="RowMajorOrder" Dim0="{len(rows)}" Dim1="3" Encoding="ASCII" '
                'Endian="LittleEndian" ExternalFileName="" ExternalFileOffset="">'
                f"{more}<Data>{values}</Data></DataArray>")
    numbers = " ".join(str(a) for a in np.ravel(matrix))
    system = ("<CoordinateSystemTransformMatrix><DataSpace>NIFTI_XFORM_UNKNOWN</DataSpace>"
              f"<TransformedSpace>NIFTI_XFORM_{frame}</TransformedSpace>"
              f"<MatrixData>{numbers}</MatrixData></CoordinateSystemTransformMatrix>")
    arrays = array("POINTSET", "FLOAT32", POINTS, system) + array("TRIANGLE", "INT32", TRIANGLES)
    head = '<?xml version="1.0" encoding="UTF-8"?><GIFTI Version="1.0" NumberOfDataArrays="2">'
    return f"{head}{arrays}</GIFTI>".encode()


def freesurfer(c_ras):
    """The bytes of a surface of FreeSurfer, with or without the geometry of its volume."""
    footer = b"" if c_ras is None else b"\0\0\0\2\0\0\0\0\0\0\0\x14" + (
        "valid = 1  # volume info valid\nfilename = t1.mgz\nvolume = 256 256 256\nvoxelsize = 1 1 1\nxras = -1 0 0\n"
        "yras = 0 0 -1\nzras = 0 1 0\ncras = %g %g %g\n" % c_ras).encode()
    return (b"\xff\xff\xfecreated for a study\n\n" + struct.pack(">2i", len(POINTS), len(TRIANGLES))
            + POINTS.astype(">f4").tobytes() + np.array(TRIANGLES, ">i4").tobytes() + footer)


def surfaces():
    """Name and bytes of each."""
    moved = np.eye(4)
    moved[:3, 3] = [1, 2, 3]
    yield "plain.surf.gii", gifti("UNKNOWN", np.eye(4))
    yield "scanner.surf.gii", gifti("SCANNER_ANAT", moved)
    yield "mni.surf.gii", gifti("MNI_152", moved)
    yield "lh.white", freesurfer(None)
    yield "rh.white", freesurfer((5, 6, 7))
