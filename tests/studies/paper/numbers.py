"""Formats numbers and tables for the page."""

import math


def text(value, digits=2):
    """Formats a number for a table."""
    if value is None:
        return ""
    if value == 0:
        return "0"
    if abs(value) >= 1000 or abs(value) < 0.01:
        mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
        return f"{mantissa}e{int(exponent)}"
    return f"{value:.{max(0, digits - 1 - math.floor(math.log10(abs(value))))}f}"


def seconds(value):
    return f"{value:.0f} s" if value >= 10 else f"{value:.1f} s"


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines)


def level_of(summary, level):
    """The summary of a level, or of the finest level below it."""
    return [entry for entry in summary["levels"] if entry["level"] <= level][-1]
