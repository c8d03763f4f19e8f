"""What fuzzing has done: the sources of each target, executions and seconds, the kept corpus as text, and what each target has reached."""
import json
import os
import shutil
import subprocess
import sys
import threading
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
# The sources of each target, whose coverage is reported.
IO, OUTLINE = "geometry/io/read_", "geometry/outline/"
READERS = {
    "obj": [IO + "obj.cpp", "geometry/mesh_text/read_mesh_formats.cpp", "geometry/mesh_text/read_text.cpp"], "off": [IO + "off.cpp"],
    "ply": [IO + "ply.cpp", IO + "ply_header.cpp"], "stl": [IO + "stl.cpp"],
    "gifti": ["geometry/scene/pugixml_gifti.cpp", "geometry/scene/pugixml_node.cpp", "geometry/bytes/zlib_stream.cpp"],
    "freesurfer": ["geometry/scene/read_freesurfer.cpp"], "gltf": ["geometry/scene/tinygltf_gltf.cpp", "geometry/scene/scene_shape.cpp"],
    "collada": ["geometry/scene/pugixml_collada.cpp"], "three_mf": ["geometry/scene/pugixml_three_mf.cpp", "geometry/scene/zip_file.cpp"],
    "tps": [OUTLINE + "tps_file.cpp", OUTLINE + "tps_outline.cpp"], "roi": [OUTLINE + "imagej_roi.cpp"],
    "geojson": [OUTLINE + "json_geojson.cpp", OUTLINE + "drawing.cpp"],
    "svg": [OUTLINE + "pugixml_svg.cpp", OUTLINE + "svg_text.cpp", OUTLINE + "drawn_path.cpp"],
    "vti": ["geometry/volume/vti_file.cpp"],
    "vtk": ["geometry/polydata/legacy_file.cpp", "geometry/polydata/legacy_scanner.cpp", "geometry/polydata/polydata.cpp"],
    "vtp": ["geometry/polydata/vtp_file.cpp", "geometry/vtk_xml/xml_file.cpp", "geometry/vtk_xml/xml_array.cpp", "geometry/bytes/value_type.cpp"],
    "points2": [IO + "points.cpp"],
    "points3": [IO + "points.cpp"], "png": ["geometry/picture/png_picture.cpp", "geometry/picture/picture.cpp"], "pgm": [IO + "pgm.cpp", "geometry/picture/read_mask.cpp", "geometry/picture/picture_shape.cpp"],
    "tiff": ["geometry/picture/tiff_picture.cpp"], "jpeg": ["geometry/picture/jpeg_picture.cpp", "geometry/picture/picture.cpp"], "bmp": ["geometry/picture/read_bmp.cpp"],
    "nifti": ["geometry/volume/nifti_header.cpp", "geometry/volume/nifti_placement.cpp", "geometry/volume/volume.cpp", "geometry/volume/read_volume.cpp", "geometry/volume/volume_header.cpp"],
    "nifti_gz": ["geometry/volume/zlib_volume.cpp"], "nrrd": ["geometry/volume/nrrd_header.cpp", "geometry/volume/header_fields.cpp"],
    "meta_image": ["geometry/volume/meta_image_header.cpp"],
    "close3": ["geometry/repair/close_surface.cpp", "geometry/repair/cgal_fill_holes.cpp", "geometry/repair/cgal_wrap.cpp"],
    "repair3": ["geometry/repair/repair.cpp", "geometry/repair/repair_steps.cpp", "geometry/repair/repair_triangulate.cpp",
                "geometry/repair/make_shape.cpp", "geometry/repair/cgal_repair.cpp", "geometry/repair/cgal_stitch_cracks.cpp",
                "geometry/repair/flat_triangles.cpp", "geometry/repair/take_apart.cpp"],
    "repair2": ["geometry/repair/repair_outline.cpp", "geometry/repair/cgal_repair_crossings.cpp"],
    "yaml": ["matching/experiment/yaml_document.cpp", "matching/experiment/yaml_syntax.cpp", "matching/experiment/option_text.cpp"],
    "experiment": ["matching/experiment/yaml_options.cpp", "matching/experiment/level_overrides.cpp"],
    "study": ["apps/studies/description/study_file.cpp", "apps/studies/description/option_file.cpp"],
    "subjects": ["apps/cohorts/subjects/subject_table.cpp"], "cohort": ["apps/cohorts/cohort_file.cpp"],
    "map": ["geometry/vtk_xml/xml_file.cpp", "geometry/vtk_xml/xml_head.cpp", "matching/map_file/read_deformation.cpp",
            "matching/output/checksum.cpp"],
    "history": ["matching/output/history_file.cpp"], "summary": ["matching/output/json_summary.cpp"],
    "manifest": ["matching/checkpoint/json_checkpoint_manifest.cpp"], "levels": ["matching/checkpoint/level_vertices.cpp"],
    "alignment": ["matching/checkpoint/json_alignment_file.cpp"], "files": ["matching/output/json_written_files.cpp"],
    "run_result": ["apps/studies/execution/json_run_result.cpp"], "landmarks": ["matching/pairs/landmark_file.cpp", "matching/pairs/landmark_rows.cpp"],
    "fcsv": ["matching/pairs/fcsv_points.cpp"], "markups": ["matching/pairs/json_markups.cpp"],
    "correspondence": ["matching/result/correspondence.cpp"],
}
ESCAPES = {10: "\\n", 13: "\\r", 9: "\\t", 0: "\\z", 92: "\\\\"}
lock = threading.Lock()


def line_of(data):
    """As kept_inputs.h describes it."""
    text = "".join(ESCAPES.get(b) or (chr(b) if 32 <= b < 127 else f"\\x{b:02x}") for b in data)
    return "\\x23" + text[1:] if text.startswith("#") else text


def kept_inputs(path):
    letters = {"n": 10, "r": 13, "t": 9, "z": 0, "\\": 92}
    inputs = []
    for line in path.read_text().split("\n")[:-1] if path.exists() else []:
        data, rest = bytearray(), iter(line)
        if line.startswith("#"):
            continue
        for c in rest:
            if c == "\\":
                letter = next(rest)
                data.append(int(next(rest) + next(rest), 16) if letter == "x" else letters[letter])
            else:
                data.append(ord(c))
        inputs.append(bytes(data))
    return inputs


def load(build):
    path = build / "record.json"
    return json.loads(path.read_text()) if path.exists() else {}


def add(build, target, executions, seconds):
    with lock:
        record = load(build)
        entry = record.setdefault(target, {"executions": 0, "seconds": 0})
        entry["executions"] += executions
        entry["seconds"] += seconds
        (build / "record.json").write_text(json.dumps(record, indent=1))


def tool(name):
    for candidate in (name, f"/usr/lib/llvm-14/bin/{name}", f"{name}-14"):
        if shutil.which(candidate):
            return candidate
    sys.exit(f"fuzz: {name} is missing (Debian: llvm)")


def coverage(build, kept):
    """Of each source of the targets: lines covered, lines, branches covered, branches, by the kept corpus of all targets. Needs a build
    with SHELLMATCH_COVERAGE."""
    raw, merged = build / "kept.profraw", build / "kept.profdata"
    program = build / "fuzz_replay"
    subprocess.run([program, kept], check=True, stdout=subprocess.DEVNULL, cwd=build, env={**os.environ, "LLVM_PROFILE_FILE": str(raw)})
    subprocess.run([tool("llvm-profdata"), "merge", "-sparse", raw, "-o", merged], check=True)
    report = subprocess.run([tool("llvm-cov"), "export", "-summary-only", f"-instr-profile={merged}", program],
                            check=True, capture_output=True, text=True).stdout
    found = {}
    for file in json.loads(report)["data"][0]["files"]:
        name = os.path.relpath(os.path.realpath(file["filename"]), ROOT)
        found[name] = [file["summary"][kind][part] for kind in ("lines", "branches") for part in ("covered", "count")]
    return found


def found_by_target():
    """tests/fuzz/found.txt: TARGET: what was found and mended."""
    found = {target: [] for target in READERS}
    for line in (ROOT / "tests/fuzz/found.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            target, what = line.split(": ", 1)
            found[target].append(what)
    return found


def print_table(build, coverage_build, kept):
    record, found, all_files = load(build), found_by_target(), coverage(coverage_build, kept)
    share = lambda covered, n: f"{100 * covered / n:.1f}" if n else "-"
    rows, n_executions, n_seconds = [], 0, 0
    for target, sources in READERS.items():
        entry = record.get(target, {"executions": 0, "seconds": 0})
        n_executions += entry["executions"]
        n_seconds += entry["seconds"]
        files = {name: all_files[name] for name in sources}
        sums = [sum(values[k] for values in files.values()) for k in range(4)]
        least = min(files, key=lambda name: files[name][0] / files[name][1])
        crashes = build / "crashes" / target
        open_crashes = len(list(crashes.iterdir())) if crashes.exists() else 0
        rows.append(f"| `{target}` | {entry['executions']:,} | {entry['seconds'] / 60:.1f} | {share(*sums[:2])} of {sums[1]} | "
                    f"{share(*sums[2:])} | {Path(least).name}: {share(*files[least][:2])} | {len(found[target])} | {open_crashes} |")
    head = ["| target | executions | minutes | lines of its sources, % | branches, % | least covered source, % of lines | found and mended | open |",
            "|---|---:|---:|---:|---:|---|---:|---:|"]
    total = f"| all | {n_executions:,} | {n_seconds / 60:.1f} | | | | {sum(map(len, found.values()))} | |"
    print("\n".join([*head, *rows, total]))
