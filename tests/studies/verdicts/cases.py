"""The pairs: what is matched, how one shape is changed before, and whether a right map exists near the start."""
import dataclasses
import pathlib
from collections.abc import Callable

from lib import transforms


@dataclasses.dataclass(frozen=True)
class Case:
    name: str
    kind: str         # "right", or in which way it is wrong
    reference: str    # NAME/VARIANT of a built-in shape, or a file
    template: str
    change: Callable | None = None  # of the template's points and faces
    options: tuple = ()
    needs_data: bool = False
    has_same_vertices: bool = False  # vertices of the same number correspond in the files

    @property
    def has_known_errors(self):
        is_one_mesh = self.change is not None and self.reference == self.template and self.kind in ("turned", "mirrored", "far apart")
        return self.has_same_vertices or is_one_mesh


def turn(degrees, axis):
    return lambda points, faces: (transforms.turned(points, degrees, axis), faces)


def mirror(axis):
    return lambda points, faces: transforms.mirrored(points, faces, axis)


def scale(factor):
    return lambda points, faces: (transforms.scaled(points, factor), faces)


def move(diagonals, axis):
    return lambda points, faces: (transforms.moved(points, diagonals, axis), faces)


def double(points, faces):
    return transforms.joined((points, faces), (transforms.moved(points, 0.8, "x"), faces))


def generated():
    plane = ("--levels", "3:8")
    right = [("sphere/large", "ellipsoid/long"), ("torus/thick", "torus/thin"), ("box/cube", "box/compressed"), ("beet/first", "beet/second"),
             ("hand/rest", "hand/bent"), ("dolphin/straight", "dolphin/bent"), ("dolphin/straight", "dolphin/turned"),
             ("face/neutral", "face/smiling"), ("face/neutral", "face/other")]
    found = [Case(f"{a.replace('/', '-')} {b.replace('/', '-')}", "right", a, b) for a, b in right]
    found += [Case(f"{a.replace('/', '-')} {b.replace('/', '-')}", "right", a, b, options=plane)
              for a, b in [("leaf/deep", "leaf/shallow"), ("circle/large", "ellipse/long"), ("star/mild", "star/sharp")]]
    found += [Case(f"{a} turned by {angle} about {axis}", "turned", f"{a}/{variant}", f"{a}/{variant}", turn(angle, axis))
              for a, variant in [("dolphin", "straight"), ("hand", "rest")] for angle, axis in [(90, "x"), (90, "z"), (180, "y"), (180, "z")]]
    found += [Case("hand mirrored", "mirrored", "hand/rest", "hand/rest", mirror("x")),
              Case("beet turned by 180 about x", "turned", "beet/first", "beet/first", turn(180, "x")),
              Case("face turned by 180 about z", "turned", "face/neutral", "face/neutral", turn(180, "z")),
              Case("star and leaf", "kinds", "star/mild", "leaf/deep", options=plane)]
    found += [Case(f"{a} and {b}", "kinds", f"{a}/{v}", f"{b}/{w}")
              for a, v, b, w in [("hand", "rest", "dolphin", "straight"), ("dolphin", "straight", "hand", "rest"), ("sphere", "large", "hand", "rest"),
                                 ("hand", "rest", "sphere", "large"), ("torus", "thick", "sphere", "large"), ("face", "neutral", "hand", "rest"),
                                 ("box", "cube", "dolphin", "straight")]]
    found += [Case("hand and two hands", "parts", "hand/rest", "hand/rest", double),
              Case("sphere, 20 diagonals away", "far apart", "sphere/large", "sphere/large", move(20, "x")),
              Case("hand in other units", "units", "hand/rest", "hand/rest", scale(25.4))]
    return found


SAME_VERTICES = ("bodies_makehuman", "hands_makehuman", "humans_smpl", "heads_ict", "femur_basel")


def real(data):
    d = lambda name: str(pathlib.Path(data) / name)  # noqa: E731
    auto = ("--align", "auto")
    right = [("bodies woman man", "bodies_makehuman/woman_young.off", "bodies_makehuman/man_old_heavy.off", ()),
             ("bodies man boy", "bodies_makehuman/man_old_heavy.off", "bodies_makehuman/boy_child.off", ()),
             ("hands young long", "hands_makehuman/hand_woman_young.off", "hands_makehuman/hand_woman_long_close.off", ()),
             ("humans", "humans_smpl/human_woman.obj", "humans_smpl/human_man.obj", ()),
             ("heads neutral smile", "heads_ict/head_neutral.off", "heads_ict/head_smile.off", ()),
             ("heads neutral sample", "heads_ict/head_neutral.off", "heads_ict/head_sample.off", ()),
             ("hippocampus 001 006", "hippocampus_msd/hippocampus_001_mc.off", "hippocampus_msd/hippocampus_006_mc.off", ()),
             ("hippocampus 006 014", "hippocampus_msd/hippocampus_006_mc.off", "hippocampus_msd/hippocampus_014_mc.off", ()),
             ("vertebrae 018 016", "vertebra_L1_verse/verse018_aligned_to_016.ply", "vertebra_L1_verse/sub-verse016_segment_20.ply", ()),
             ("vertebrae 030 016", "vertebra_L1_verse/verse030_aligned_to_016.ply", "vertebra_L1_verse/sub-verse016_segment_20.ply", ()),
             ("femurs", "femur_basel/femur_reference.off", "femur_basel/femur_target_aligned.off", ()),
             ("spleens 10 13", "spleen_point2ssm/spleen_10.ply", "spleen_point2ssm/spleen_13.ply", auto),
             ("femurs as scanned", "femur_basel/femur_reference.off", "femur_basel/femur_target.stl", ()),
             ("tori", "tori_scalismo/torus_0_aligned.off", "tori_scalismo/torus_1_aligned.off", ()),
             ("hands in the plane 00 03", "hands2d_basel/hand00_aligned.csv", "hands2d_basel/hand03_aligned.csv", ("--levels", "3:8")),
             ("hands in the plane 05 10", "hands2d_basel/hand05_aligned.csv", "hands2d_basel/hand10_aligned.csv", ("--levels", "3:8")),
             ("cat0 cat1", "tosca_5k/isometric/cat0.off", "tosca_5k/isometric/cat1.off", auto),
             ("dog0 dog2", "tosca_5k/isometric/dog0.off", "tosca_5k/isometric/dog2.off", auto),
             ("michael0 michael4", "tosca_5k/isometric/michael0.off", "tosca_5k/isometric/michael4.off", auto)]
    found = [Case(name, "right", d(a), d(b), options=options, needs_data=True, has_same_vertices=a.split("/")[0] in SAME_VERTICES and not b.endswith(".stl"))
             for name, a, b, options in right]
    cat, dog, man = (d(f"tosca_5k/isometric/{n}.off") for n in ("cat0", "dog0", "michael0"))
    body, hand = d("bodies_makehuman/woman_young.off"), d("hands_makehuman/hand_woman_young.off")
    hippocampus, femur = d("hippocampus_msd/hippocampus_001_mc.off"), d("femur_basel/femur_reference.off")
    wrong = [("cat0 cat2 as they lie", "poses", cat, d("tosca_5k/isometric/cat2.off"), None),
             ("cat turned by 180 about z", "turned", cat, cat, turn(180, "z")),
             ("man turned by 90 about x", "turned", man, man, turn(90, "x")),
             ("body upside down", "turned", body, body, turn(180, "x")),
             ("real hand turned by 180 about y", "turned", hand, hand, turn(180, "y")),
             ("femur turned by 180 about x", "turned", femur, femur, turn(180, "x")),
             ("hand and body", "kinds", hand, body, None),
             ("cat and femur", "kinds", cat, femur, None),
             ("dog and man", "kinds", dog, man, None),
             ("hippocampus and cat", "kinds", hippocampus, cat, None),
             ("femurs three diagonals apart", "far apart", femur, d("femur_basel/femur_target_aligned.off"), move(3, "x")),
             ("hippocampus in micrometres", "units", hippocampus, d("hippocampus_msd/hippocampus_006_mc.off"), scale(1000))]
    found += [Case(name, kind, a, b, change, needs_data=True, has_same_vertices=kind == "far apart") for name, kind, a, b, change in wrong]
    return found


def cases(data):
    return generated() + real(data)
