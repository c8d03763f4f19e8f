"""What was said of each run, as Markdown."""
BEGIN, END = "<!-- table of scripts/study verdict-study -->", "<!-- end of the table of scripts/study verdict-study -->"
OUTCOMES = ("matched", "look-here", "not-matched")


def outcome(result):
    return result.summary["verdict"]["outcome"]


def percent(share):
    return f"{100 * share:.2g}" if share < 0.1 else f"{100 * share:.0f}"


def row(result):
    s = result.summary
    there, back = s["distance"]["deformed_to_template"], s["distance"]["template_to_deformed"]
    angle, area = s.get("angle_distortion"), s["area_distortion"]
    error = s.get("correspondence_error")
    return [
        result.case.name,
        f"{error:.1e}" if error is not None else "",
        "right" if result.is_right else "wrong",
        outcome(result),
        f"{there['mean']:.1e}",
        f"{back['mean']:.1e}, {back['max']:.1e}",
        percent(s["distance"]["uncovered"]),
        percent(s["flipped_share"]),
        f"{angle['p95']:.0f}" if angle else "",
        f"{area['p5']:.2g} to {area['p95']:.2g}",
    ]


def is_wrong(result):
    """What the verdict says is not true; 'look-here' never is."""
    return outcome(result) == ("not-matched" if result.is_right else "matched")


def table_text(results, wrong_only=False):
    head = ["pair", "error", "map", "verdict", "to template", "back: mean, largest", "not reached, %", "flipped, %"]
    head += ["angles, 95 %", "areas, 5 to 95 %"]
    lines = [head, ["---"] * len(head)] + [row(r) for r in results if not r.error and (is_wrong(r) or not wrong_only)]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def counts_text(results):
    done = [r for r in results if not r.error]
    n = {(right, o): sum(r.is_right == right and outcome(r) == o for r in done) for right in (True, False) for o in OUTCOMES}
    lines = [["maps", *OUTCOMES], ["---"] * 4]
    lines += [[f"{sum(n[right, o] for o in OUTCOMES)} {name}", *(str(n[right, o]) for o in OUTCOMES)] for right, name in ((True, "right"), (False, "wrong"))]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)
