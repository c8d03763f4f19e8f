"""Describes the machine of the measurements, without its name, and its load."""

import os
import pathlib
import re
import subprocess

# The widest comes first: -march=native uses it for packs of eight doubles.
vector_extensions = [("avx512f", "AVX-512"), ("avx2", "AVX2"), ("avx", "AVX"), ("sse4_2", "SSE4.2"), ("asimd", "NEON")]


def vector_extension(flags):
    return next((name for flag, name in vector_extensions if flag in flags), "none known")


def describe():
    """Processor, vector extension, cores, caches and memory; unknown entries are omitted."""
    fields = {}
    for line in first_text("/proc/cpuinfo").split("\n\n")[0].splitlines():
        key, _, value = line.partition(":")
        fields[key.strip()] = value.strip()
    for line in output_of(["lscpu"]).splitlines():
        key, _, value = line.partition(":")
        fields.setdefault(key.strip(), value.strip())
    flags = set((fields.get("flags") or fields.get("Flags") or fields.get("Features") or "").split())
    memory = re.search(r"MemTotal:\s+(\d+) kB", first_text("/proc/meminfo"))
    machine = {
        "processor": fields.get("model name") or fields.get("Model name"),
        "family_and_model": " ".join(fields[key] for key in ("cpu family", "model") if key in fields),
        "vector_extension": vector_extension(flags),
        "cores": len(os.sched_getaffinity(0)),
        "caches": {key.removesuffix(" cache"): fields[key] for key in ("L1d cache", "L2 cache", "L3 cache") if key in fields},
        "memory_gb": round(int(memory[1]) / 2**20) if memory else None,
        "virtual": fields.get("Hypervisor vendor"),
    }
    return {key: value for key, value in machine.items() if value}


def label(machine):
    """The description on one line, for tables."""
    parts = [machine.get("processor", "unknown processor"), machine.get("vector_extension", "")]
    parts += [f"{machine['cores']} cores"] + [f"{name} {size}" for name, size in machine.get("caches", {}).items()]
    parts += [f"{machine['memory_gb']} GB"] if "memory_gb" in machine else []
    return ", ".join(filter(None, parts + (["virtual"] if "virtual" in machine else [])))


def load():
    """Load average of the last minute."""
    return round(os.getloadavg()[0], 2)


def busy_warning(load_before):
    """A warning if other processes load the machine, else ""."""
    if load_before < 0.5:
        return ""
    return (f"the machine is busy (load {load_before} before the first measurement): seconds are too long, and only ratios "
            "of measurements that alternate mean anything")


def first_text(path):
    try:
        return pathlib.Path(path).read_text()
    except OSError:
        return ""


def output_of(command):
    try:
        return subprocess.run(command, capture_output=True, text=True, env={**os.environ, "LC_ALL": "C"}).stdout
    except OSError:
        return ""
