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
            parts.append(f'<text x="{x0 + width - 8}" y="{top + height - 12 - 18 * k}" text-anchor="end" fill="{colour}">{name}</text>')
    path.write_text("\n".join([*parts, "</svg>"]) + "\n")
