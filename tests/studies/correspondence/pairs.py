"""The pairs of shapes of a benchmark: those of a list file, or of a folder of meshes."""

import dataclasses
import pathlib
import random
import re
import shlex

endings = (".off", ".ply", ".obj")


class BenchmarkError(Exception):
    """What the user can mend; the message is one line."""


@dataclasses.dataclass(frozen=True)
class Pair:
    """Where two shapes lie, and how their vertices correspond."""
    reference: pathlib.Path
    template: pathlib.Path
    vts: tuple = ()  # files of the known correspondence, reference first; empty: vertex i belongs to vertex i

    @property
    def name(self):
        return f"{self.reference.stem}-{self.template.stem}"

    @property
    def metric(self):
        """Where vertices correspond one by one, distances in space are exact to any small size; paths along edges are not."""
        return "geodesic" if self.vts else "euclidean"


def make_pair(reference, template, vts, place):
    if not vts:
        beside = [path.with_suffix(".vts") for path in (reference, template)]
        there = [path.exists() for path in beside]
        if there[0] != there[1]:
            raise BenchmarkError(f"{place}{beside[there[0]]} is not there, but {beside[not there[0]]} is")
        vts = tuple(beside) if all(there) else ()
    return Pair(reference, template, vts)


def read_list(path, data):
    """Lines `REFERENCE TEMPLATE [REFERENCE.vts TEMPLATE.vts [words]]`, relative to the list or to the folder of the data; # comments."""
    def find(word, number):
        for folder in filter(None, (path.parent, data)):
            if (pathlib.Path(folder) / word).is_file():
                return pathlib.Path(folder) / word
        where = f"{data} (SHELLMATCH_DATA)" if data else "a folder of data (SHELLMATCH_DATA is not set)"
        raise BenchmarkError(f"{path}, line {number}: {word} is neither in {path.parent} nor in {where}")

    pairs = []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        try:
            words = shlex.split(line, comments=True)
        except ValueError as error:
            raise BenchmarkError(f"{path}, line {number}: {error}") from error
        if len(words) in (1, 3):
            raise BenchmarkError(f"{path}, line {number}: {len(words)} words; expected REFERENCE TEMPLATE [REFERENCE.vts TEMPLATE.vts [words]]")
        if words:
            files = [find(word, number) for word in words[:4]]
            pairs.append(make_pair(files[0], files[1], tuple(files[2:]), f"{path}, line {number}: "))
    return pairs


def kind_of(path):
    return re.sub(r"\d+$", "", path.stem)


def read_folder(path, all_pairs):
    """Both directions of all pairs of one kind: names that differ in their last digits alone."""
    meshes = sorted(file for file in path.iterdir() if file.suffix in endings)
    return [make_pair(a, b, (), "") for a in meshes for b in meshes if a != b and (all_pairs or kind_of(a) == kind_of(b))]


def draw(pairs, n, seed):
    """Names of n of the pairs. The same for the same seed and names, whatever their order."""
    if n > len(pairs):
        raise BenchmarkError(f"--draw {n}: there are {len(pairs)} pairs")
    return set(random.Random(seed).sample(sorted(pair.name for pair in pairs), n))


def read_pairs(path, data="", all_pairs=False, only=()):
    """Raises BenchmarkError where there is nothing to match, and where two pairs have one name."""
    path = pathlib.Path(path)
    if not path.exists():
        raise BenchmarkError(f"{path} is not there; expected a folder of meshes or a list of pairs")
    pairs = read_folder(path, all_pairs) if path.is_dir() else read_list(path, data)
    if not pairs:
        raise BenchmarkError(f"{path} has no pairs" + ("; --all-pairs takes meshes of unlike names, too" if path.is_dir() else ""))
    names = [pair.name for pair in pairs]
    for name in names:
        if names.count(name) > 1:
            raise BenchmarkError(f"{path}: two pairs are called {name}")
    for name in only or ():
        if name not in names:
            raise BenchmarkError(f"{path} has no pair {name}; it has {', '.join(names)}")
    return [pair for pair in pairs if not only or pair.name in only]
