"""What a folder holds, without what differs from one undisturbed run to the next."""

import csv
import io
import json
import os
import re
from pathlib import Path

# Columns of a study's tables that are measured (docs/studies.md).
TIMINGS = re.compile(r"seconds|memory|load|machine|jobs|limit|program|time")


def snapshot(folder):
    """All files, folders and links below `folder`, by relative name, with their lasting contents."""
    found = {}
    for place, folders, files in os.walk(folder):
        for name in folders + files:
            path = Path(place, name)
            relative = str(path.relative_to(folder))
            if path.is_symlink():
                found[relative] = "link to " + os.readlink(path)
            elif path.is_dir():
                found[relative] = "folder"
            elif path.is_file():
                found[relative] = lasting(path, folder)
            else:
                found[relative] = "no file"
    return found


def below(found, place):
    """The part of a snapshot that lies in or is `place`."""
    return {name: value for name, value in found.items() if name == place or name.startswith(place + "/")}


def differences(one, other, most=4):
    """Names in which the second snapshot differs from the first, in words; empty where they agree."""
    names = [f"{n} {'in excess' if n not in one else 'missing' if n not in other else 'differs'}"
             for n in sorted(one.keys() | other.keys()) if one.get(n) != other.get(n)]
    return ", ".join(names[:most]) + (f" and {len(names) - most} more" if len(names) > most else "")


def lasting(path, folder):
    """The contents without times, memory and the name of the working folder. A damaged file is its bytes."""
    data = path.read_bytes().replace(str(folder).encode(), b"@")
    try:
        if path.name == "summary.json":
            return without(json.loads(data), "run", "seconds", "distance_seconds", "coefficient_seconds")
        if path.name == "history.csv":
            return table(data, lambda column: column != "seconds")
        if path.name == "files.json":
            return listed(json.loads(data))
        if path.name == "result.json":
            return {key: value for key, value in json.loads(data).items() if key in ("status", "message", "exit_code", "signal")}
        if path.name in ("table.csv", "convergence.csv"):
            return table(data, lambda column: not TIMINGS.search(column))
    except (ValueError, KeyError, IndexError, UnicodeDecodeError):
        return data
    if path.name == "report.html":  # it holds times; whole, or bytes that agree with nothing
        return "page" if data.startswith(b"<!DOCTYPE html>") and data.endswith(b"</html>\n") else data
    measured = path.name in ("log.txt", "summary.md") or "seconds" in path.name
    return "text" if measured and data else data


def without(value, *keys):
    if isinstance(value, dict):
        return {key: without(part, *keys) for key, part in value.items() if key not in keys}
    return [without(part, *keys) for part in value] if isinstance(value, list) else value


def table(data, is_kept):
    rows = list(csv.reader(io.StringIO(data.decode())))
    kept = [i for i, column in enumerate(rows[0]) if is_kept(column)]
    return [[row[i] for i in kept] for row in rows]


def listed(files):
    """Names, and the checksums of those whose bytes last."""
    measured = ("history.csv", "summary.json", "log.txt", "result.json", "files.json", "config.yaml", "report.html")
    return [(file["name"], "" if file["name"].rpartition("/")[2] in measured else file["checksum"]) for file in files["files"]]
