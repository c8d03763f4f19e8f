#!/bin/sh
# ProDy 2.3.1 (Debian 12): calcTransformation(mobile, target, weights), which 'minimizes the weighted RMSD', does not, nor do superpose() and the
# superpose() of an Ensemble with weights. getTransformation() takes the centres with the weights, but multiplies both sets of centred coordinates by
# the weights before it forms their product, so that the rotation is the best one for the squares of the weights, about the centre for the weights
# themselves. An atom of weight 2 is therefore not the same as one listed twice. Where many atoms of small weight face a few of large weight,
# the many hardly count: of two halves of a molecule bent by 60 degrees against each other, 100 atoms of weight 0.1 and 10 of weight 1, the first are
# left 55 degrees askew and the second 5, where 30 and 30 is best. calcRMSD(), whose weights are plain, says that the RMSD is larger than it
# need be. It does not show for weights of 0 and 1, as AtomMap.getFlags('mapped') gives them, nor where the sets fit exactly. Nothing is said.
set -eu
prody=2.3.1+dfsg-3+deb12u2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "python3-prody=$prody" python3-biopython=1.80+dfsg-4+b1 python3-pyparsing=3.0.9-1 python3-numpy=1:1.24.2-1+deb12u1 \
  python3-scipy=1.10.1-2 python3-pkg-resources python3-packaging python3-decorator libblas3 liblapack3 libgfortran5 libquadmath0 liblbfgsb0 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
cat > weights.py <<'P'
import sys
import numpy as np
import prody

prody.confProDy(verbosity="none")
print("ProDy", prody.__version__)


def about_z(degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def best(mobile, target, w, squared=False):
    """Kabsch's rotation and shift for weights w, or the rotation for their squares about the centres for w."""
    m, t = w @ mobile / w.sum(), w @ target / w.sum()
    u, _, v = np.linalg.svd((mobile - m).T @ ((w ** 2 if squared else w)[:, None] * (target - t)))
    r = v.T @ np.diag([1, 1, np.sign(np.linalg.det(u @ v))]) @ u.T
    return r, t - r @ m


def turned(r):
    return np.degrees(np.arctan2(r[1, 0], r[0, 0]))


rng = np.random.RandomState(5)
many = np.c_[rng.uniform(-10, 10, (100, 2)), rng.uniform(-1, 1, 100)]
few = np.c_[rng.uniform(-10, 10, (10, 2)), rng.uniform(-1, 1, 10)]
# both halves about one centre and with equal weighted spread, so that the best compromise lies in the middle
many -= many.mean(axis=0)
few -= few.mean(axis=0)
few[:, :2] *= np.sqrt((many[:, :2] ** 2).sum() / 10 / (few[:, :2] ** 2).sum())
target = np.r_[many, few]
mobile = np.r_[many @ about_z(60).T, few]  # the many are turned by 60 degrees against the few
as_described = True
for name, w in (("100 atoms of 0.1, 10 of 1", np.r_[np.full(100, 0.1), np.full(10, 1.0)]), ("50 of 0, 50 of 1, 10 of 1", np.r_[np.zeros(50), np.ones(60)]),
                ("all of 1", np.ones(110))):
    t = prody.calcTransformation(mobile, target, w)
    r, shift = best(mobile, target, w)
    q, other = best(mobile, target, w, squared=True)
    got = prody.calcRMSD(t.apply(mobile), target, w)
    right = prody.calcRMSD(mobile @ r.T + shift, target, w)
    same = abs(t.getRotation() - q).max() < 1e-9 and abs(t.getTranslation() - other).max() < 1e-9
    print(f"{name:26s} ProDy turns by {turned(t.getRotation()):6.2f} degrees, calcRMSD {got:.3f}; best {turned(r):6.2f}, {right:.3f}; "
          f"as for squared weights: {same}")
    as_described &= same
    if w.min() == 0.1:
        as_described &= abs(turned(r) + 30) < 0.5 and -8 < turned(t.getRotation()) < -3 and got > 1.05 * right
    else:
        as_described &= abs(got - right) < 1e-9 and abs(t.getRotation() - r).max() < 1e-9

# an atom of weight 2 and the same atom twice
p = rng.normal(size=(6, 3)) * [3, 2, 1]
q = p + rng.normal(size=(6, 3))
w = np.array([2.0, 1, 1, 3, 1, 1])
twice = np.repeat(np.arange(6), w.astype(int))
a = prody.calcTransformation(p, q, w)
b = prody.calcTransformation(p[twice], q[twice])
c = prody.calcTransformation(p[twice], q[twice], np.ones(9))
print(f"6 atoms of weights 2 1 1 3 1 1: RMSD {prody.calcRMSD(a.apply(p), q, w):.4f}; listed 2 1 1 3 1 1 times: {prody.calcRMSD(b.apply(p), q, w):.4f}")
angle = np.degrees(np.arccos((np.trace(a.getRotation().T @ b.getRotation()) - 1) / 2))
print(f"the two rotations are {angle:.2f} degrees apart")
as_described &= angle > 0.5 and prody.calcRMSD(a.apply(p), q, w) > prody.calcRMSD(b.apply(p), q, w) + 1e-4
as_described &= abs(c.getRotation() - b.getRotation()).max() < 1e-9 and abs(best(p, q, w)[0] - b.getRotation()).max() < 1e-9

ensemble = prody.Ensemble("two")
ensemble.setCoords(target)
ensemble.addCoordset(mobile)
w = np.r_[np.full(100, 0.1), np.full(10, 1.0)]
ensemble.setWeights(w[:, None])
ensemble.superpose()
r, shift = best(mobile, target, w)
print(f"Ensemble.superpose(): RMSD {ensemble.getRMSDs()[0]:.3f}, best {prody.calcRMSD(mobile @ r.T + shift, target, w):.3f}")
as_described &= ensemble.getRMSDs()[0] > 1.05 * prody.calcRMSD(mobile @ r.T + shift, target, w)
sys.exit(0 if as_described else 1)
P
export LD_LIBRARY_PATH="$folder/root/usr/lib/x86_64-linux-gnu:$folder/root/usr/lib/x86_64-linux-gnu/blas:$folder/root/usr/lib/x86_64-linux-gnu/lapack"
HOME=$folder OPENBLAS_NUM_THREADS=1 PYTHONPATH=$folder/root/usr/lib/python3/dist-packages /usr/bin/python3 -W ignore weights.py
