"""The experiments to repeat: those of the paper, pairs of real shapes, and the numbers that the paper gives."""

import pathlib

root = pathlib.Path(__file__).resolve().parents[3]

# Experiments in the order of the page: name of configs/paper/NAME.yaml, dimension, pictures of which levels.
experiments = [
    ("cubes", 3, (4, 7)), ("cubes_cauchy_green", 3, (4,)), ("cubes_no_p2", 3, ()), ("cubes_quadratic", 3, ()),
    ("cubes_no_bending", 3, (4,)), ("faces", 3, (4, 6, 8)), ("hand", 3, (4, 8)), ("hand_no_bending", 3, ()),
    ("dolphin", 3, (4, 8)), ("dolphin_no_bending", 3, ()), ("dolphin_turned", 3, (8,)),
    ("dolphin_reversed", 3, (8,)), ("beet", 3, (4, 8)), ("leaves", 2, (10,)),
]
# Experiments without a second derivative, which Newton's method of the default profile needs.
first_order = {"cubes_cauchy_green", "cubes_no_p2", "cubes_quadratic"}
# Pairs of SHELLMATCH_DATA of one connectivity, so that every vertex is known to belong to that of its number: the experiment whose
# weights they take (those with a large delta), and two files. They run with and without the bending term.
bending_pairs = [
    ("hands", "dolphin", 3, "hands_makehuman/hand_woman_young.off", "hands_makehuman/hand_man_old_spread.off"),
    ("long_hands", "dolphin", 3, "hands_makehuman/hand_woman_young.off", "hands_makehuman/hand_woman_long_close.off"),
    ("heads", "dolphin", 3, "heads_ict/head_neutral.off", "heads_ict/head_sample.off"),
    ("humans", "dolphin", 3, "humans_smpl/human_man.obj", "humans_smpl/human_woman.obj"),
    ("bodies", "dolphin", 3, "bodies_makehuman/woman_young.off", "bodies_makehuman/man_old_heavy.off"),
    ("foxes", "dolphin", 3, "fox_poses/fox_rest.off", "fox_poses/fox_survey.off"),
    ("hand_outlines", "leaves", 2, "hands2d_basel/hand00_registered.csv", "hands2d_basel/hand03_registered.csv"),
]
bending_levels = 6, 8  # the finest, in space and in the plane
# Claims, by their beginnings, that do not hold on the reduced levels: the page says "no", and --check --reduced accepts
# it.
open_when_reduced = ("Bending is indispensable",)
# Table tab:parstimes: time below the finest level, at it, and DOFs.
papers_table = {"faces": ("1 h 04", "4 h 34", "695 K"), "hand": ("30 min", "1 h 27", "313 K"),
                "dolphin": ("20 min", "51 min", "179 K"), "beet": ("29 min", "1 h 25", "408 K")}
