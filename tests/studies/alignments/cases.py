"""What is turned, and pairs of which it is known whether their parts correspond.

A shape is KIND/VARIANT of a built-in one or a file in the folder SHELLMATCH_DATA.
"""
import itertools

ISOMETRIC, UNLIKE = "tosca_5k/isometric/", "tosca_5k/nonisometric/"

# Reference and template; the reference is turned.
TURNED = {"dolphin": ("dolphin/straight", "dolphin/bent"),
          "hand of capsules": ("hand/rest", "hand/bent"),
          "vertebra": ("vertebra_L1_verse/verse018_aligned_to_016.ply", "vertebra_L1_verse/sub-verse016_segment_20.ply"),
          "fish": ("fish_two_poses/fish.obj", "fish_two_poses/fish_aligned_to_low_resolution.off"),
          "cat2": (f"{ISOMETRIC}cat2.off", f"{ISOMETRIC}cat0.off")}

MIRRORED = ("dolphin", "hand of capsules")


def both_ways(folder, *pairs):
    return [pair for a, b in pairs for pair in ((folder + a, folder + b), (folder + b, folder + a))]


def poses():
    """Of one kind each: vertices with the same number, or with the same line of their .vts files, correspond."""
    found = both_ways(ISOMETRIC, ("cat0.off", "cat1.off"), ("cat0.off", "cat2.off"), ("dog0.off", "dog2.off"),
                      ("centaur0.off", "centaur1.off"), ("michael0.off", "michael4.off"))
    found += both_ways(UNLIKE, *itertools.product(("8_gorilla_01.off", "8_gorilla_02.off"), ("8_man_01.off", "8_man_03.off")))
    found += both_ways("bodies_makehuman/", *itertools.combinations(("woman_young.off", "man_old_heavy.off", "boy_child.off"), 2))
    hands = ("hand_woman_young.off", "hand_man_old_spread.off", "hand_woman_long_close.off")
    found += both_ways("hands_makehuman/", *itertools.combinations(hands, 2))[:4]
    found += both_ways("humans_smpl/", ("human_man.obj", "human_woman.obj"))
    found += [("fox_poses/fox_rest.off", f"fox_poses/fox_{pose}.off") for pose in ("run", "walk", "survey")]
    return found + [("heads_ict/head_neutral.off", f"heads_ict/head_{name}.off") for name in ("smile", "sample")]


def kinds():
    """Of two kinds: no map of one on the other is right."""
    cat, dog, centaur, man = (f"{ISOMETRIC}{name}0.off" for name in ("cat", "dog", "centaur", "michael"))
    hand, body, head = "hands_makehuman/hand_woman_young.off", "bodies_makehuman/woman_young.off", "heads_ict/head_neutral.off"
    femur, spleen, hippocampus = "femur_basel/femur_reference.off", "spleen_point2ssm/spleen_10.ply", "hippocampus_msd/hippocampus_001_mc.off"
    vertebra, fox, fish = TURNED["vertebra"][1], "fox_poses/fox_rest.off", TURNED["fish"][0]
    return [*both_ways("", (cat, dog), (cat, man), (dog, centaur), (hand, body), (hand, femur), (vertebra, "torus/thick"), ("dolphin/straight", "hand/rest")),
            (centaur, man), (cat, centaur), (spleen, vertebra), (hippocampus, cat), (fish, dog), (cat, fish), (head, hand), (head, cat),
            (spleen, femur), (hippocampus, spleen), (fox, man)]
