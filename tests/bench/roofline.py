"""The roofline model: flops and bytes of each kernel, the bound by the machine's ceilings, and the rate reached."""

import json
import subprocess

from comparison import markdown, number
from measure import BenchError, measure_kernels

kernel_names = ("value", "gradient", "band_gradient", "newton_model", "newton_product")


def flops_of(kernel, counts, sizes):
    """Floating-point operations of one evaluation of each kernel."""
    points, cells = sizes["active_points"], sizes["cells"]

    def all_of(by_point, *by_element):
        return points * counts[by_point]["flops"] + cells * sum(counts[name]["flops"] for name in by_element)

    return {
        "value": lambda: all_of("band_value_by_point", "volume_value_by_element", "barrier_by_element"),
        "gradient": lambda: all_of("band_gradient_by_point", "volume_gradient_by_element", "barrier_by_element"),
        "band_gradient": lambda: all_of("band_gradient_by_point"),
        "newton_model": lambda: all_of("newton_band_by_point", "newton_volume_by_element"),
        # A block has 3 x 3 entries with a multiplication and an addition each; off-diagonal blocks are read once and
        # used twice.
        "newton_product": lambda: 18 * (2 * sizes["blocks"] - sizes["free_nodes"]),
    }[kernel]()


def count_flops(program):
    result = subprocess.run([program], capture_output=True, text=True)
    if result.returncode != 0:
        raise BenchError(f"'{program}' ended with code {result.returncode}: {result.stderr.strip()}")
    return json.loads(result.stdout)


def rows_of(kernels, sizes, counts):
    """One entry for each kernel, and the ceilings by name."""
    ceilings = {"peak": max(kernels["ceiling_fma"]["gflops"], kernels["ceiling_fma_and_add"]["gflops"]),
                "fma": kernels["ceiling_fma"]["gflops"], "clock": kernels["ceiling_clock"]["gigahertz"],
                "read": kernels["ceiling_read"]["gbytes"], "triad": kernels["ceiling_triad"]["gbytes"]}
    rows = []
    for kernel in kernel_names:
        product = kernel == "newton_product"
        per = sizes["free_nodes" if product else "active_points"]
        nanoseconds = kernels[kernel]["cpu_ns_per_free_node" if product else "cpu_ns_per_point"]
        flops, moved = flops_of(kernel, counts, sizes) / per, sizes[f"{kernel}_bytes"] / per
        ceiling = min(ceilings["peak"], flops / moved * ceilings["read"])
        rows.append({"kernel": kernel, "per": "free node" if product else "point", "flops": flops, "bytes": moved,
                     "nanoseconds": nanoseconds, "ceiling": ceiling, "memory_bound": ceiling < ceilings["peak"],
                     "reached": flops / nanoseconds})
    return rows, ceilings


def table(rows, ceilings):
    lines = [[row["kernel"], row["per"], number(row["flops"]), number(row["bytes"]), f"{row['flops'] / row['bytes']:.2f}",
              f"{row['ceiling']:.1f} ({'memory' if row['memory_bound'] else 'arithmetic'})", f"{row['nanoseconds']:.0f}",
              f"{row['reached']:.1f}", f"{100 * row['reached'] / row['ceiling']:.0f} %"] for row in rows]
    text = markdown(["kernel", "for each", "flops", "bytes", "flops/byte", "ceiling, Gflop/s", "ns", "Gflop/s", "share"], lines)
    per_cycle = ceilings["peak"] / ceilings["clock"]
    return text + (f"\nCeilings of one core: {ceilings['clock']:.2f} GHz; {ceilings['fma']:.1f} Gflop/s in fused multiplications and "
                   f"additions alone,\n{ceilings['peak']:.1f} with plain additions beside them, {per_cycle:.0f} for each cycle; "
                   f"{ceilings['read']:.1f} GB/s read from memory, {ceilings['triad']:.1f} GB/s by the triad.\n")


def measure(programs, pair, level, seconds):
    names = "^(" + "|".join(kernel_names) + ")/threads:1/|^ceiling"
    kernels, sizes = measure_kernels(programs, pair, level, seconds, names)
    return rows_of(kernels, sizes, count_flops(programs.count_flops))
