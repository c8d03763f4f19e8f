"""Runs pairs side by side, measures what comes out and keeps what is finished."""

import concurrent.futures
import fcntl
import hashlib
import json
import os
import pathlib
import shutil
import signal
import subprocess
import threading
import time

from correspondence.pairs import BenchmarkError

marker = ".benchmark-correspondence"  # tells a folder of results, and locks it


def fingerprint(path):
    return hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest()


class Stopped(Exception):
    """The benchmark is ending."""


class Failed(Exception):
    """A run that has no result; the message says why in one line."""


class Benchmark:
    """The folder `output` holds METHOD/PAIR/ for every finished run: result, errors, log, and record.json, which says by
    what they were made. It appears as a whole."""

    def __init__(self, output, measure_program, first_index=1, limit=0, keep_maps=False):
        self.output, self.measure_program, self.first_index = pathlib.Path(output), str(measure_program), first_index
        self.limit, self.keep_maps = limit, keep_maps
        self.stopped = threading.Event()
        self.children, self.guard = set(), threading.Lock()

    def __enter__(self):
        if self.output.exists() and (not self.output.is_dir() or any(self.output.iterdir()) and not (self.output / marker).exists()):
            raise BenchmarkError(f"{self.output} holds something else than results of a benchmark; name another folder with -o")
        self.output.mkdir(parents=True, exist_ok=True)
        self.lock = open(self.output / marker, "a")
        try:
            fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            self.lock.close()
            raise BenchmarkError(f"another benchmark is writing to {self.output}") from error
        for left in self.output.glob("*/.*.partial-*"):  # of a benchmark that was killed
            shutil.rmtree(left, ignore_errors=True)
        return self

    def __exit__(self, *_):
        self.lock.close()

    def stop(self):
        """Ends all children: those that are still there after 5 s at once."""
        self.stopped.set()
        self.signal_all(signal.SIGTERM)
        timer = threading.Timer(5, self.signal_all, (signal.SIGKILL,))
        timer.daemon = True
        timer.start()

    def signal_all(self, number):
        with self.guard:
            for child in self.children:
                signal_group(child.pid, number)

    def folder(self, method, pair):
        return self.output / method.name / pair.name

    def run_configuration(self, method, pair):
        return {"words": list(method.words), "programs": [fingerprint(path) for path in method.programs()],
                "shapes": [fingerprint(pair.reference), fingerprint(pair.template)]}

    def measure_configuration(self, pair):
        return {"program": fingerprint(self.measure_program), "metric": pair.metric, "first_index": self.first_index,
                "shapes": [fingerprint(pair.reference), fingerprint(pair.template)], "vts": [fingerprint(path) for path in pair.vts]}

    def record(self, folder):
        try:
            return json.loads((folder / "record.json").read_text())
        except (OSError, ValueError):
            return {}

    def run_all(self, works, jobs, tell):
        """`works`: methods and pairs. Returns the failed ones with their reasons."""
        failed, done = [], 0
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            futures = {pool.submit(self.run, *work): work for work in works}
            try:
                for future in concurrent.futures.as_completed(futures):
                    method, pair = futures[future]
                    done += 1
                    try:
                        tell(f"[{done}/{len(works)}] {method.name} {pair.name}: {future.result()}")
                    except Failed as failure:
                        failed.append((method, pair, str(failure)))
                        tell(f"[{done}/{len(works)}] {method.name} {pair.name}: failed: {failure}")
            except BaseException:
                self.stop()
                pool.shutdown(cancel_futures=True)
                raise
        return failed

    def run(self, method, pair):
        folder = self.folder(method, pair)
        run, measure = self.run_configuration(method, pair), self.measure_configuration(pair)
        old = self.record(folder)
        if old.get("run") == run and old.get("measure") == measure:
            return words_of(old) + " (kept)"
        partial = folder.with_name(f".{folder.name}.partial-{os.getpid()}")
        shutil.rmtree(partial, ignore_errors=True)
        folder.with_name(folder.name + ".failed.txt").unlink(missing_ok=True)
        try:
            if old.get("run") == run:  # only the measurement has changed
                shutil.copytree(folder, partial)
                record = {key: old[key] for key in ("run", "result", "summary", "seconds", "cpu_seconds")}
            else:
                partial.mkdir(parents=True)
                record = {"run": run, **self.find(method, pair, partial)}
            record |= {"measure": measure, "metric": pair.metric, **self.measure(pair, partial, record["result"])}
            (partial / "record.json").write_text(json.dumps(record, indent=1) + "\n")
            shutil.rmtree(folder, ignore_errors=True)
            partial.rename(folder)
        except Failed:
            if (partial / "log.txt").exists():
                (partial / "log.txt").replace(folder.with_name(folder.name + ".failed.txt"))
            raise
        finally:
            shutil.rmtree(partial, ignore_errors=True)
        return words_of(record)

    def find(self, method, pair, partial):
        """Runs the method: the name of its result within the folder, summary, seconds."""
        out = (partial / "out").resolve()
        seconds, cpu_seconds = self.call(method.command(pair, out), partial / "log.txt", self.limit)
        summary = {}
        if out.is_dir():
            result = out / "deformed.ply"
            if (out / "summary.json").exists():
                summary = extract(json.loads((out / "summary.json").read_text()))
            if not self.keep_maps:
                (out / "deformation.vtu").unlink(missing_ok=True)
        else:
            choices = [out.with_name("out" + ending) for ending in ("", ".ply", ".off", ".obj", ".txt")]
            result = next((path for path in choices if path.exists()), out)
        if not result.exists():
            raise Failed("it wrote nothing to {out}, nor with .ply, .off, .obj or .txt behind it" if result == out
                         else f"it wrote no {result.name}")
        return {"result": str(result.relative_to(partial.resolve())), "summary": summary, "seconds": seconds,
                "cpu_seconds": cpu_seconds}

    def measure(self, pair, partial, result):
        words = [self.measure_program, str(pair.reference), str(pair.template)]
        options = ["--vts", *map(str, pair.vts)] if pair.vts else []
        options += ["--euclidean"] if pair.metric == "euclidean" else []
        found = {}
        of_result = ["--first-index", str(self.first_index), "--errors", str(partial / "errors.txt")]
        for name, end, more in (("before", "identity", []), ("error", str(partial / result), of_result)):
            # What cannot be measured is a fault of the result; what can be wrong with the pair shows in the first of the two.
            log = partial / "measure.txt"
            self.call(words + [end] + options + more, log)
            found[name] = json.loads(log.read_text())
            log.unlink()
        return found

    def call(self, command, log, limit=0):
        """Runs a command, its output in `log`. Returns wall and CPU seconds, those of its children included."""
        begin = time.monotonic()
        with open(log, "wb") as file:
            with self.guard:
                if self.stopped.is_set():
                    raise Stopped
                try:
                    child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=file, stderr=subprocess.STDOUT,
                                             start_new_session=True)
                except OSError as error:
                    raise Failed(f"{command[0]} cannot be run: {error.strerror}") from error
                self.children.add(child)
            timer = threading.Timer(limit, signal_group, (child.pid, signal.SIGKILL)) if limit > 0 else None
            try:
                if timer:
                    timer.start()
                _, status, usage = os.wait4(child.pid, 0)
            finally:
                if timer:
                    timer.cancel()
                with self.guard:
                    self.children.discard(child)
            child.returncode = os.waitstatus_to_exitcode(status)
        seconds = time.monotonic() - begin
        if self.stopped.is_set():
            raise Stopped
        if limit > 0 and seconds >= limit:
            raise Failed(f"stopped after {limit:g} s")
        if child.returncode != 0:
            lines = log.read_text(errors="replace").strip().splitlines()
            raise Failed(lines[-1] if lines else f"{pathlib.Path(command[0]).name} ended with {child.returncode}")
        return seconds, usage.ru_utime + usage.ru_stime


def signal_group(pid, number):
    try:
        os.killpg(pid, number)
    except ProcessLookupError:
        pass


def extract(summary):
    """What the tables need of summary.json."""
    distance, folds = summary["distance"], summary["levels"][-1]["folds"]
    found = {f"{short}_{figure}": distance[key][figure] for short, key in (("dt", "deformed_to_template"), ("td", "template_to_deformed"))
             for figure in ("mean", "max")}
    found |= {"folded_cells": folds["folded_cells"], "uncertified_cells": folds["uncertified_cells"]}
    alignment = summary.get("alignment") or {}
    found |= {f"alignment_{key}": alignment.get(key) for key in ("score", "margin")}
    return found | {"alignment": alignment_words(alignment)}


def alignment_words(alignment):
    """What became of what was found; None where nothing was searched."""
    if not alignment:
        return None
    if alignment["pairs"] > 0:
        return "used, doubtful" if alignment["doubtful"] else "used"
    return "doubtful" if alignment["doubtful"] else "as it lies"


def words_of(record):
    error = record["error"]
    scale = "" if record["metric"] == "geodesic" else " diagonals"
    return f"mean {error['mean']:.4g}, 95 % {error['p95']:.4g}, max {error['max']:.4g}{scale}, {record['seconds']:.1f} s"
