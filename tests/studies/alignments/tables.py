"""Results of alignment as Markdown."""
import pathlib

RIGHT_BELOW = 0.06  # mean error of known correspondences on two levels, in diagonals


def name_of(shape):
    path = pathlib.Path(shape)
    return path.stem if path.suffix else shape


def turned_table(results):
    """`results`: name to errors of turned and of mirrored references."""
    lines = ["| reference | turned: mean of errors | largest | mirrored and turned: mean | largest |", "| --- | ---: | ---: | ---: | ---: |"]
    for name, sets in results.items():
        cells = [text for errors in sets for text in ((f"{sum(errors) / len(errors):.4f}", f"{max(errors):.4f}") if errors else ("", ""))]
        lines.append("| " + " | ".join([name, *cells]) + " |")
    return "\n".join(lines) + "\n"


def landmark_table(results):
    """`results`: pair to errors of each variant, of which the first is exact."""
    names = list(next(iter(results.values())))
    lines = ["| pair | " + " | ".join(names) + " |", "| --- |" + " ---: |" * len(names)]
    for (reference, template), errors in results.items():
        cells = [f"{error:.4f} ({error / errors[names[0]]:.2f})" for error in errors.values()]
        lines.append(f"| {name_of(reference)} to {name_of(template)} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def called(alignment):
    return "doubtful" if alignment.get("doubtful") else "as it lies" if alignment.get("as_it_lies") else "used"


def is_right(error):
    return error is not None and error < RIGHT_BELOW


def doubt_counts(results):
    """`results`: rows of pair, error and alignment."""
    n = {(right, word): sum(is_right(e) == right and called(a) == word for _, e, a in results)
         for right in (True, False) for word in ("used", "as it lies", "doubtful")}
    lines = ["| maps | used | as it lies | doubtful |", "| --- | ---: | ---: | ---: |"]
    lines += [f"| {sum(v for (r, _), v in n.items() if r == right)} {name} | " + " | ".join(str(n[right, w]) for w in ("used", "as it lies", "doubtful")) + " |"
              for right, name in ((True, "right"), (False, "wrong"))]
    doubtful, wrong = n[True, "doubtful"] + n[False, "doubtful"], sum(v for (r, _), v in n.items() if not r)
    share = lambda part, whole: f"{100 * part / whole:.0f} %" if whole else "-"  # noqa: E731
    return "\n".join(lines) + (f"\n\nOf those called doubtful {share(n[False, 'doubtful'], doubtful)} are wrong (precision), and of the wrong ones "
                               f"{share(n[False, 'doubtful'], wrong)} are called so (recall).\n")


def doubt_table(results, unexpected_only=False):
    if unexpected_only:
        results = [row for row in results if called(row[2]) != ("used" if is_right(row[1]) else "doubtful")]
    lines = ["| reference | template | mean error | map | alignment | score | margin |", "| --- | --- | ---: | --- | --- | ---: | ---: |"]
    for (reference, template), error, alignment in results:
        score, margin = (f"{alignment[key]:.3g}" if alignment.get(key) is not None else "" for key in ("score", "margin"))
        lines.append(f"| {name_of(reference)} | {name_of(template)} | {'other kind' if error is None else f'{error:.3f}'} | "
                     f"{'right' if is_right(error) else 'wrong'} | {called(alignment)} | {score} | {margin} |")
    return "\n".join(lines) + "\n"
