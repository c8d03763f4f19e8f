"""Combines the records of several rounds, and tabulates the ratios of two sides of a comparison."""

import statistics

import machine
import paired
from measure import median_and_spread

# The measures by which kernels and ceilings are compared. For the last three, more is better.
measures_of_kernels = (("cpu_ns_per_point", "ns/point"), ("cpu_ns_per_free_node", "ns/node"), ("gflops", "Gflop/s"),
                       ("gbytes", "GB/s"), ("gigahertz", "GHz"))
measures_of_cascades = (("cpu_seconds", "CPU s"), ("peak_memory_bytes", "MB"))


def condense(rounds):
    """The median and spread of every measured number; all other entries are those of the last round."""
    result = {"kernels": {}, "cascades": {}}
    for kernel in rounds[-1]["kernels"]:
        for key, _ in measures_of_kernels:
            values = [r["kernels"][kernel][key] for r in rounds if key in r["kernels"].get(kernel, {})]
            if values:
                middle, spread = median_and_spread(values)
                result["kernels"].setdefault(kernel, {}).update({key: round(middle, 3), "spread": round(spread, 3)})
    for name, last in rounds[-1]["cascades"].items():
        entry = dict(last)
        for key in ("cpu_seconds", "wall_seconds", "peak_memory_bytes"):
            middle, spread = median_and_spread([r["cascades"][name][key] for r in rounds])
            entry[key] = middle
            if key == "cpu_seconds":
                entry["spread"] = round(spread, 3)
        result["cascades"][name] = entry
    return result


def markdown(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows]) + "\n"


def number(x):
    return f"{x:.0f}" if abs(x) >= 100 else f"{x:.3g}"


def table_of_records(records):
    """The history as rows: one for each number of each record, with the machine that it was measured on."""
    rows = []
    for r in records:
        who = [r["date"][:16].replace("T", " "), r["commit"][:10] + ("+" if r["changed_since"] else "")]
        for kernel, values in r["kernels"].items():
            for key, unit in measures_of_kernels:
                if key in values:
                    place = "" if kernel.startswith("ceiling") else f" {r['kernel_pair']} level {r['kernel_level']}"
                    rows.append([*who, kernel + place, f"{number(values[key])} {unit}", f"{100 * values['spread']:.0f} %", ""])
        for name, c in r["cascades"].items():
            shares = ", ".join(f"{phase} {100 * share:.0f} %" for phase, share in
                               sorted(c["phase_shares"].items(), key=lambda item: -item[1])[:3])
            rows.append([*who, f"{name} {c['levels']}", f"{number(c['cpu_seconds'])} CPU s", f"{100 * c['spread']:.0f} %",
                         f"{c['peak_memory_bytes'] / 1e6:.0f} MB; {shares}; {c['distance']['deformed_to_template']['mean']:.2g}"
                         f" to template; {c['folded_cells']} folded"])
    machines = dict.fromkeys(f"{machine.label(r['machine'])}; {r['compiler']}; load before {r['load_before']}" for r in records)
    return "\n".join([markdown(["date (UTC)", "commit", "what", "median", "spread", "and"], rows),
                      *(f"Machine: {words}" for words in machines)])


def verdict(before, after):
    """Ratios after/before round by round: median, smallest, largest, and whether the difference is significant.

    A difference is significant if all rounds show it in the same direction and it exceeds the differences between
    the rounds of either side.
    """
    ratios = sorted(b / a for a, b in zip(before, after))
    middle = statistics.median(ratios)
    noise = max(median_and_spread(before)[1], median_and_spread(after)[1])
    same_side = ratios[0] > 1 or ratios[-1] < 1
    differs = len(ratios) > 1 and same_side and abs(middle - 1) > noise
    return middle, ratios[0], ratios[-1], differs


def words_of(middle, differs, more_is_better):
    if not differs:
        return "within the noise"
    better = middle > 1 if more_is_better else middle < 1
    return "**better**" if better else "**worse**"


def report(before, after, names, in_turn=None):
    """Markdown: ratios of the kernels called in turn and of all other measures of both sides, and whether the results of
    the runs are equal."""
    rows, missing = [], []

    def add(what, unit, a, b, scale=1.0, more_is_better=False):
        middle, low, high, differs = verdict(a, b)
        rows.append([what, unit, number(statistics.median(a) * scale), number(statistics.median(b) * scale), f"{middle:.3f}",
                     f"{low:.3f} to {high:.3f}", words_of(middle, differs, more_is_better)])

    for kernel in after[-1]["kernels"]:
        for key, unit in measures_of_kernels:
            a, b = ([r["kernels"].get(kernel, {}).get(key) for r in side] for side in (before, after))
            if all(a) and all(b):
                add(kernel, unit, a, b, 1.0, kernel.startswith("ceiling"))
            elif all(b):
                missing.append(kernel)
    quality = []
    for name, last in after[-1]["cascades"].items():
        for key, unit in measures_of_cascades:
            a, b = ([r["cascades"][name][key] for r in side] for side in (before, after))
            add(f"{name} {last['levels']}", unit, a, b, 1e-6 if unit == "MB" else 1.0)
        first = before[-1]["cascades"][name]
        same = all(first[key] == last[key] for key in ("energy", "distance", "nodes"))
        told = [[f"{x['energy']:.6g}", f"{x['distance']['deformed_to_template']['mean']:.3g}", f"{x['iterations']}",
                 f"{x['folded_cells']}"] for x in (first, last)]
        quality.append([name, "the same to the bit" if same else "**another**"] + [f"{a} / {b}" for a, b in zip(*told)])
    text = ""
    if in_turn:
        text += markdown(["least / median of calls in turn", "unit", names[0], names[1], "median of ratios", "95 % interval", ""],
                         paired.rows(in_turn)) + "\n"
    text += markdown(["what", "unit", names[0], names[1], "ratio", "from round to round", ""], rows)
    text += "\nRatios above 1 are slower or larger, with the ceilings of the machine the other way round: those tell whether it was\n"
    text += "the same machine for both.\n"
    if missing:
        text += f"\nMeasured at {names[1]} only: {', '.join(dict.fromkeys(missing))}.\n"
    if quality:
        text += "\n" + markdown(["run", "result", "energy", "mean distance to template", "iterations", "folded cells"], quality)
    return text
