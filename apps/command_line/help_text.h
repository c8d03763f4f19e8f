#pragma once
/// \file
/// The texts that `--help` prints besides the list of options.

namespace shellmatch::help_text {

inline constexpr const char* program =
    "Finds the deformation of the unit square or cube that carries a reference shape onto a template shape "
    "the way a thin elastic shell would go.";

inline constexpr const char* program_footer = R"(Examples:
  shellmatch match reference.ply template.obj -o out
  shellmatch apply out other.ply -o moved.ply
  shellmatch match generate:hand generate:hand/bent -o hand --levels 3:6

`shellmatch COMMAND --help` tells more about each command.

Exit codes: 0 done; 1 a check did not pass; 2 the command line or an input cannot be used; 3 the machine does not give what is
needed (memory, disk, permission); 4 --max-seconds or --max-memory was reached; 70 an error of the program; 130 stopped by Ctrl-C,
143 by SIGTERM, 129 by the end of its terminal.)";

inline constexpr const char* match = "Match two shapes: two files in, an output folder out. No YAML is needed.";

inline constexpr const char* match_footer =
    R"(Shapes are closed surfaces (OBJ, PLY, OFF, STL, VTK, VTP, GIfTI, FreeSurfer, glTF, 3MF, COLLADA), labels of volumes (NIfTI, NRRD, MetaImage, VTI; scan.nii.gz:3 or
"scan.nii.gz:>0.5", otherwise all above 0), closed contours in the plane (CSV) or pictures of them (PNG, PGM, TIFF, JPEG, BMP; cells.png:3 is one label), or built-in ones by name, as generate:hand/bent (`shellmatch generate --list`). Both must be of the same dimension.

Examples:
  shellmatch match reference.ply template.obj -o out
  shellmatch match leaf_a.csv leaf_b.csv -o out --levels 4:10
  shellmatch match a.ply b.ply -o out --placement as-is --set energy.delta=0.5 --set cascade.nu=0.01)";

inline constexpr const char* run = "Run an experiment that a YAML file describes.";

inline constexpr const char* run_footer =
    R"(`shellmatch config` prints a YAML file with every option, ready to be edited. Options given here win over the
file's, and --set over the named ones.

Examples:
  shellmatch run configs/hand.yaml
  shellmatch run configs/hand.yaml -o out/hand5 --levels 3:5
  shellmatch run out/hand/config.yaml -o again        (the config.yaml of an output folder repeats its run))";

inline constexpr const char* output_footer = R"(

The output folder holds the deformed reference (deformed.ply, or deformed.csv for contours) with the nearest points of the
template, the template with its distance to it (template.ply, template.csv), the deformation (deformation.vtu, for ParaView and `shellmatch apply`), history.csv, summary.json, config.yaml, pictures/ and report.html, a page to look at it all.
It is written as a whole at the end. A folder that exists and is not empty is left alone and an error; --force
replaces it if it is the output of an earlier run, and never anything else. While a run works, the
alignment and the last finished level are kept in DIR.unfinished: where it was stopped or killed the same command goes
on from there; --restart begins anew.)";

inline constexpr const char* generate = "Write one of the built-in shapes to a file.";

inline constexpr const char* generate_footer = R"(Examples:
  shellmatch generate --list
  shellmatch generate hand --list
  shellmatch generate hand/bent -o bent.ply
  shellmatch generate hand -o pointing.ply --set bend_middle=50 --set bend_ring=50 --edge-length 0.01
The same names serve as inputs elsewhere, as in `shellmatch match generate:hand generate:hand/bent -o out`.)";

inline constexpr const char* apply =
    "Move something else by a deformation that was found: a mesh, a contour, points or a volume; or write its fields.";

inline constexpr const char* apply_footer =
    R"(The file is in the coordinates of the reference that was matched, the result in those of the template. Points
outside the domain move with the nearest point of the domain. With --inverse the file is in the coordinates of the template, and the result in
those of the reference. With --keep-pose the result stays where the reference lies: it is deformed, but neither turned, moved nor scaled
by the motion that alignment found. Together with --inverse the file lies there.
Control points of 3D Slicer (.mrk.json, .fcsv) keep names, descriptions and frame. Points are written by the ending of OUTPUT: .csv, for Slicer
.mrk.json or .fcsv, for morphometrics .tps or .txt (Morphologika), each of which names the frame (docs/landmarks.md).

A volume (.nii .nii.gz .nrrd .mha .vti) is pulled back: every voxel of the result, on the voxels of --like or its own, gets what lies where it comes from,
0 where the map is not defined. Fields of the map need no FILE, but --like (docs/volumes.md).

Examples:
  shellmatch apply out other.ply -o moved.ply
  shellmatch apply out/deformation.vtu landmarks.csv -o moved.csv
  shellmatch apply out landmarks.mrk.json -o moved.mrk.json
  shellmatch apply out landmarks.csv -o moved.tps
  shellmatch apply out on_template.ply -o on_reference.ply --inverse
  shellmatch apply out reference.ply -o deformed_in_place.ply --keep-pose
  shellmatch apply out labels.nii.gz -o on_template.nii.gz --like template.nii.gz
  shellmatch apply out --displacement field.nii.gz --log-jacobian growth.nii.gz --like reference.nii.gz)";

inline constexpr const char* inspect =
    "Say what the program thinks of a shape: dimension, pieces, size, genus, what was mended, and levels that suit it.";

inline constexpr const char* inspect_footer = R"(Examples:
  shellmatch inspect shape.ply
  shellmatch inspect generate:hand --json)";

inline constexpr const char* curvature =
    "Compare the curvatures that the grids see of a shape with fits to its mesh and, where there is one, a formula.";

inline constexpr const char* curvature_footer =
    R"(One grid for each of the levels, refined at the shape as for a matching. The output folder holds summary.json,
curvature.ply (the finest level; curvature.csv for contours), pictures/ and config.yaml.

Examples:
  shellmatch curvature shape.ply -o curvature --levels 4:7
  shellmatch curvature generate:torus -o torus --set coefficients.tau=2
  shellmatch curvature generate:ellipsoid/long -o marched --set coefficients.distance=fast_marching)";

inline constexpr const char* check_gradient =
    "Check the derivatives of an experiment's energy, term by term: order of the Taylor remainder, element functors "
    "with "
    "dual numbers, differences, Ceres' checker, and symmetry and sign of the Newton model.";

inline constexpr const char* check_gradient_footer =
    R"(The grid and the energy are those of the cascade at the end of the level. The deformation is identity,
random:AMPLITUDE[:SEED] (in sides of the domain), or the output folder of a run. Exit code 1 where a derivative is wrong.

Examples:
  shellmatch check-gradient configs/hand.yaml
  shellmatch check-gradient configs/hand.yaml --level 6 --state out/hand --json check.json
  shellmatch check-gradient configs/leaf.yaml --state random:0.05:7 --set energy.volume=full)";

inline constexpr const char* self_test =
    "Check what this program computes on this machine against what is known: closed forms, gradients, certificates of "
    "folds, small matches.";

inline constexpr const char* self_test_footer =
    R"(A table of figures and bounds; exit code 1 where one exceeds its bound. It writes no files.

Examples:
  shellmatch self-test
  shellmatch self-test --threads 1)";

inline constexpr const char* view = "Open the page of a result in the browser.";

inline constexpr const char* view_footer =
    R"(A run writes report.html into its output folder: shapes to turn, time and level to slide over, colours, the verdict's places,
plots, figures and options in one file that needs no network (docs/report.md). Its name is printed; where there is no display, open it elsewhere.

Examples:
  shellmatch view out/hand
  xdg-open $(shellmatch view out/hand --print))";

inline constexpr const char* render = "Draw a result with a chosen view: a picture or an animation.";

inline constexpr const char* render_footer =
    R"(It reads the output folder, and the reference that its config.yaml names. Pictures of surfaces in SVG and PDF are placed as pixels; text and scales are lines.

Examples:
  shellmatch render out/hand -o hand.png --show all --color distance
  shellmatch render out/hand -o hand.pdf --show overlay --azimuth 30 --elevation 10 --size 1600
  shellmatch render out/hand -o hand.webp --motion morph                   (any browser shows it)
  shellmatch render out/hand -o turn.webp --motion turntable --frames 90 --seconds 6 --size 400
  shellmatch render out/hand -o morph --motion morph; ffmpeg -i morph/frame_%04d.png -pix_fmt yuv420p morph.mp4)";

inline constexpr const char* config =
    "Print every option with its default, range, unit and meaning, as a YAML file that is ready to be edited.";

inline constexpr const char* config_footer = R"(Examples:
  shellmatch config > experiment.yaml
  shellmatch config --profile paper
  shellmatch config --markdown)";

inline constexpr const char* cohort =
    "Match one shape onto many, and compute their mean, modes of variation and differences of groups.";

inline constexpr const char* cohort_footer =
    R"(An atlas is deformed onto every subject, so that all have the same points. It is a shape that is given, or the subjects'
mean: all are matched, the mean becomes the next atlas, until it converges. Each matching is a process of its own: one that fails costs its own row
only. The same command again goes on where it was stopped, and matches only what is new. docs/cohorts.md describes the file and the output folder.

Examples:
  shellmatch cohort scans/*.ply -o out/scans                                 (mean shape, modes, report)
  shellmatch cohort scans/*.ply --atlas atlas.ply -o out/scans --levels 3:6
  shellmatch cohort --table subjects.csv -o out/scans                        (ids, groups, landmarks)
  shellmatch cohort cohort.yaml                                              (out/cohort; --options prints what can be in it)
  shellmatch cohort cohort.yaml --shard 3/16; shellmatch cohort cohort.yaml --collect)";

inline constexpr const char* study =
    "Run a comparison study that a YAML file describes: problems x solvers x metrics x parameters.";

inline constexpr const char* study_footer =
    R"(Each run is a process of its own with limits of time and memory: a run that crashes, hangs or takes too much costs
its own row of the table only. The same command again goes on where it was stopped; runs that have a result of the
same configuration are not run again. docs/studies.md describes the file and the output folder.

Examples:
  shellmatch study configs/studies/small.yaml                 (out/small; takes seconds)
  shellmatch study configs/studies/solvers.yaml --jobs 4      (timings are marked as taken in parallel)
  shellmatch study configs/studies/solvers.yaml --set cascade.max_level=5 --set limits.seconds=600
  shellmatch study STUDY.yaml --list
  shellmatch study STUDY.yaml --only RUN -o DIR; shellmatch study STUDY.yaml --collect -o DIR)";

}  // namespace shellmatch::help_text
