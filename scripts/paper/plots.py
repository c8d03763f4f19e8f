"""Plots of the page, as SVG."""

import math


def write_penalty_plot(rows, path):
    """Mismatch on the left, energies on the right, over nu."""
    width, height, left, top = 300, 200, 70, 30
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {2 * (width + left) + 30} {height + top + 50}" '
             'font-family="sans-serif" font-size="12">', '<rect width="100%" height="100%" fill="white"/>']
    decades = [math.log10(row[0]) for row in rows]
    panels = [("mismatch", [("", "#1f77b4", [math.log10(row[1]) for row in rows])]),
              ("energies", [("total", "#d62728", [row[3] for row in rows]),
                            ("without match", "#1f77b4", [row[2] for row in rows])])]
    for panel, (title, curves) in enumerate(panels):
        x0 = left + panel * (width + left)
        values = [v for _, _, curve in curves for v in curve]
        low, high = (math.floor(min(values)), math.ceil(max(values))) if panel == 0 else (0, math.ceil(10 * max(values)) / 10)

        def place(decade, value, x0=x0, low=low, high=high):
            return (x0 + width * (decades[0] - decade) / (decades[0] - decades[-1]),
                    top + height * (high - value) / (high - low))

        parts.append(f'<text x="{x0 + width / 2}" y="{top - 12}" text-anchor="middle">{title}</text>')
        parts.append(f'<rect x="{x0}" y="{top}" width="{width}" height="{height}" fill="none" stroke="black"/>')
        for decade in range(math.floor(decades[0] + 1e-9), math.ceil(decades[-1] - 1e-9) - 1, -1):
            x, y = place(decade, low)
            parts.append(f'<path d="M{x:.1f},{y:.1f}v5" stroke="black"/>')
            parts.append(f'<text x="{x:.1f}" y="{y + 18:.1f}" text-anchor="middle">1e{decade}</text>')
        parts.append(f'<text x="{x0 + width / 2}" y="{top + height + 38}" text-anchor="middle">nu</text>')
        for k in range(high - low + 1 if panel == 0 else round(10 * high) + 1):
            value = low + k if panel == 0 else k / 10
            x, y = place(decades[0], value)
            label = f"1e{value}" if panel == 0 else f"{value:.1f}"
            parts.append(f'<path d="M{x:.1f},{y:.1f}h-5" stroke="black"/>')
            parts.append(f'<text x="{x - 8:.1f}" y="{y + 4:.1f}" text-anchor="end">{label}</text>')
        for k, (name, colour, curve) in enumerate(curves):
            points = [place(decade, value) for decade, value in zip(decades, curve)]
            line = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
            parts.append(f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="1.5"/>')
            parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2" fill="{colour}"/>' for x, y in points]
            if name:
                parts.append(f'<text x="{x0 + width - 8}" y="{top + height - 12 - 18 * k}" text-anchor="end" fill="{colour}">{name}</text>')
    path.write_text("\n".join([*parts, "</svg>"]) + "\n")


def oscillating_curve(k, amplitude, start, n):
    """Points of [eq:varphik] and the angle that they run through: r' = R sin(k xi), r theta' = (1 - R^2 sin^2(k xi))^(1/2)."""
    points, theta = [], 0
    for i in range(n):
        xi = 2 * math.pi * (i + 0.5) / n
        r = start + amplitude / k * (1 - math.cos(k * xi))
        points.append((r * math.cos(theta), r * math.sin(theta)))
        theta += math.sqrt(1 - (amplitude * math.sin(k * xi)) ** 2) / r * 2 * math.pi / n
    return points, theta


def write_oscillations(path):
    amplitude, n, side = 0.95, 4000, 260
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {3 * side} {side + 20}" font-family="sans-serif" font-size="12">',
             '<rect width="100%" height="100%" fill="white"/>']
    limit = sum(math.sqrt(1 - (amplitude * math.sin(2 * math.pi * (i + 0.5) / n)) ** 2) for i in range(n)) / n
    for panel, k in enumerate((6, 20, 50)):
        low, high = 0.05, 1
        for _ in range(40):  # the angle falls with the start
            middle = 0.5 * (low + high)
            low, high = (middle, high) if oscillating_curve(k, amplitude, middle, n)[1] > 2 * math.pi else (low, middle)
        x0, y0, scale = (panel + 0.5) * side, side / 2, 0.45 * side
        points = oscillating_curve(k, amplitude, low, n)[0]
        line = " ".join(f"{x0 + scale * x:.1f},{y0 - scale * y:.1f}" for x, y in points[::2])
        parts.append(f'<circle cx="{x0}" cy="{y0}" r="{scale * limit:.1f}" fill="none" stroke="#bbbbbb"/>')
        parts.append(f'<polygon points="{line}" fill="none" stroke="#1f77b4"/>')
        parts.append(f'<text x="{x0}" y="{side + 10}" text-anchor="middle">k = {k}</text>')
    path.write_text("\n".join([*parts, "</svg>"]) + "\n")
