"""Tables and curves of finished runs."""

import bisect
import csv
import io
import math
import os
import statistics

from plotting import draw

columns = ("metric", "part", "pair", "method", "before", "mean", "p95", "max", "beyond", "unreachable", "dt_mean", "dt_max", "td_mean", "td_max",
           "folded_cells", "uncertified_cells", "alignment_score", "alignment_margin", "alignment", "seconds", "cpu_seconds")
units = {"geodesic": "geodesic error, 100 = root of the template's area", "euclidean": "distance from where it belongs, diagonals"}


def row_of(method, pair, record, part=""):
    error = record["error"]
    row = dict.fromkeys(columns, "") | {key: value for key, value in record["summary"].items() if value is not None}
    return row | {"metric": pair.metric, "part": part, "pair": pair.name, "method": method.name, "before": record["before"]["mean"],
                  "seconds": record["seconds"], "cpu_seconds": record["cpu_seconds"]} | {
                      key: error[key] for key in ("mean", "p95", "max", "beyond", "unreachable")}


def csv_text(rows):
    text = io.StringIO()
    writer = csv.DictWriter(text, columns, lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue()


def fixed(value, digits):
    return "" if value == "" else f"{value:.{digits}f}"


def cells(row):
    digits = 2 if row["metric"] == "geodesic" else 4
    folds = row["folded_cells"]
    if row["uncertified_cells"]:
        folds = f"{folds} ({row['uncertified_cells']} uncertified)"
    return [row["pair"], row["method"], fixed(row["before"], digits), fixed(row["mean"], digits), fixed(row["p95"], digits),
            fixed(row["max"], digits), f"{100 * row['beyond']:.1f} %", str(folds), row["alignment"], f"{row['cpu_seconds']:.0f}"]


def mean_row(method, part, rows):
    """Means of what every row has; the greatest of the largest errors."""
    row = dict(rows[0]) | {"pair": f"**mean of {len(rows)}{' ' if part else ''}{part}**", "method": method, "alignment": ""}
    for key in columns[4:]:
        values = [r[key] for r in rows]
        if key.startswith("alignment") or "" in values:
            row[key] = ""
        elif key in ("max", "dt_max", "td_max"):
            row[key] = max(values)
        elif key in ("folded_cells", "uncertified_cells", "unreachable"):
            row[key] = sum(values)
        else:
            row[key] = statistics.fmean(values)
    return row


def markdown(rows, failed):
    """A table for each metric, and a line for each run that failed."""
    parts = []
    for metric, unit in units.items():
        chosen = [row for row in rows if row["metric"] == metric]
        if not chosen:
            continue
        limit = "10" if metric == "geodesic" else "0.1"
        head = ["pair", "method", "before", "mean", "95 %", "max", f"beyond {limit}", "folds", "alignment", "CPU s"]
        methods = list(dict.fromkeys(row["method"] for row in chosen))
        parts_of_list = list(dict.fromkeys(row["part"] for row in chosen))
        lines = []
        for part in sorted(parts_of_list):
            of_part = [row for row in chosen if row["part"] == part]
            means = [mean_row(method, part, of_method) for method in methods if (of_method := [row for row in of_part if row["method"] == method])]
            lines += [cells(row) for row in (of_part + means if len(of_part) > len(means) else of_part)]
        keep = [k for k in range(len(head)) if any(line[k] for line in lines) and (head[k] != "method" or methods != ["shellmatch"])]
        table = [[head[k] for k in keep], ["---"] * len(keep)] + [[line[k] for k in keep] for line in lines]
        parts.append(f"Unit: {unit}.\n\n" + "\n".join("| " + " | ".join(line) + " |" for line in table) + "\n")
    parts += [f"Failed: {method.name}, {pair.name}: {reason}\n" for method, pair, reason in failed]
    return "\n".join(parts)


def read_errors(path):
    """Ascending; what cannot be reached is infinite."""
    return sorted(float(line) for line in path.read_text().split())


def share_below(errors, limit):
    """Of ascending errors, the share of those that are at most `limit`."""
    return bisect.bisect_right(errors, limit) / len(errors)


def curves(errors_by_method, metric):
    """Limits, and for each method the mean over its pairs of the share of points whose error is at most each limit."""
    tails = [errors[min(len(errors) - 1, int(0.98 * len(errors)))] for lists in errors_by_method.values() for errors in lists]
    top = max((tail for tail in tails if math.isfinite(tail)), default=0)
    top = min(top, 25.0 if metric == "geodesic" else 0.25) or (1.0 if metric == "geodesic" else 0.01)
    limits = [top * k / 100 for k in range(101)]
    return limits, {name: [statistics.fmean(share_below(errors, limit) for errors in lists) for limit in limits]
                    for name, lists in errors_by_method.items()}


def draw_curves(limits, shares, metric, path, program):
    draw({"x_label": units[metric], "y_label": "share of points below, mean of all pairs", "width": 700, "height": 420,
          "series": [{"name": name, "x": limits, "y": values} for name, values in shares.items()]}, path, program)


def curves_csv(limits, shares):
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["error", *shares])
    writer.writerows([limit, *(values[k] for values in shares.values())] for k, limit in enumerate(limits))
    return text.getvalue()


def write_whole(path, text):
    """Writes a file or leaves the old one."""
    partial = path.with_name(f".{path.name}.partial")
    partial.write_text(text)
    os.replace(partial, path)
