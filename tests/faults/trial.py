"""One disturbed run of a command, and what must hold during and after it."""

import os
import shutil
import signal
import subprocess
import time
from dataclasses import dataclass, field
from pathlib import Path

from disturbances import LOOKING, REMOVING, calls_of, want_of_memory
from scenarios import FOREIGN
from snapshots import below, differences, snapshot

LONGEST = 120  # seconds of a command before it counts as hanging


@dataclass
class Outcome:
    violations: list = field(default_factory=list)
    was_disturbed: bool = True
    code: int = 0
    what: str = ""  # the disturbed call


class Stage:
    """A scenario in a folder of its own: the state before, and that after an undisturbed run."""

    def __init__(self, scenario, program, place):
        self.scenario, self.program = scenario, str(program)
        self.origin, self.work, self.record = place / "origin", place / "work", place / "record"
        place.chmod(0o755)
        self.work.mkdir(parents=True)
        scenario.prepare(self.work, self.program)
        subprocess.run(["cp", "-a", self.work, self.origin], check=True)
        self.before = snapshot(self.work)
        self.run_whole()
        self.after = snapshot(self.work)
        self.restore()
        begin = time.monotonic()
        self.run_whole()
        self.seconds = time.monotonic() - begin
        if difference := differences(self.after, snapshot(self.work)):
            raise SystemExit(f"{scenario.name}: two undisturbed runs differ: {difference}")
        self.restore()
        if os.getuid() == 0 and scenario.in_place:
            self.record.touch()
            self.record.chmod(0o666)
        self.calls = calls_of(self.words(), self.work, self.record, **scenario.user())

    def words(self, extra=""):
        return [self.program, *self.scenario.words.split(), *extra.split()]

    def want_of_memory(self):
        return want_of_memory(self.program, self.words(), self.work, self.restore, **self.scenario.user())

    def run_whole(self):
        done = subprocess.run(self.words(), cwd=self.work, capture_output=True, text=True, **self.scenario.user())
        if done.returncode != 0:
            raise SystemExit(f"{self.scenario.name}: exit code {done.returncode} of an undisturbed run: {done.stderr}")

    def restore(self):
        for folder in (self.work / "locked",):
            if folder.is_dir():
                folder.chmod(0o755)
        shutil.rmtree(self.work)
        subprocess.run(["cp", "-a", self.origin, self.work], check=True)

    def try_out(self, disturbance):
        self.restore()
        outcome = Outcome()
        done = self.disturbed(disturbance, outcome)
        found = snapshot(self.work)
        self.check_end(disturbance, done, outcome)
        self.check_state(disturbance, done, found, outcome)
        self.check_repeated(disturbance, done, outcome)
        return outcome

    def disturbed(self, disturbance, outcome):
        # Each process of a study has a fault of its own: a removal that failed in a run and then in the study would stay.
        with_children = self.scenario.whole != "runs" or disturbance.call not in REMOVING
        words = [*disturbance.around(self.record, with_children), *self.words()]
        # All processes of the command hold the write end, so that its end means that none is left.
        readable, writable = os.pipe()
        process = subprocess.Popen(words, cwd=self.work, stdout=subprocess.PIPE, stderr=subprocess.PIPE, pass_fds=(writable,),
                                   start_new_session=True, **self.scenario.user())
        os.close(writable)
        try:
            if disturbance.kind == "random-kill":
                time.sleep(disturbance.n)
                outcome.was_disturbed = process.poll() is None
                process.kill()
            out, err = process.communicate(timeout=LONGEST)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            out, err = process.communicate()
            outcome.violations.append(f"did not end within {LONGEST} s")
        os.read(readable, 1)
        os.close(readable)
        outcome.code = process.returncode
        if disturbance.call and disturbance.kind != "memory":
            lines = self.record.read_text(errors="replace").splitlines()
            # A call in which a process is killed has no result.
            hit = [line for line in lines if "INJECTED" in line or disturbance.kills and (line.endswith("= ?") or "unfinished" in line)]
            outcome.was_disturbed = bool(hit) if not disturbance.kills else any("killed by SIGKILL" in line for line in lines)
            outcome.what = hit[-1].partition(" ")[2].strip() if hit else ""
        return process.returncode, out.decode(errors="replace"), err.decode(errors="replace")

    def check_end(self, disturbance, done, outcome):
        code, out, err = done
        bad = outcome.violations.append
        if disturbance.kills and outcome.was_disturbed:
            if code not in (-signal.SIGKILL, 0):
                bad(f"exit code {code} after a kill")
            return
        # 127 and what the loader says come before the program begins.
        if code not in (0, 2, 3, 5, 6):
            bad(f"exit code {code}")
        if "terminate called" in err or "Traceback" in err:
            bad("it was terminated")
        # A message is not complete where the fault hits its own output.
        if outcome.what.startswith(("write(2<", "writev(2<")):
            return
        errors = [line for line in err.splitlines() if line.startswith("shellmatch: error: ")]
        if code == 0 and errors:
            bad("an error, but exit code 0")
        if code != 0 and (len(errors) != 1 or len(errors[0]) < 40 or err.splitlines()[-1] != errors[0]):
            bad("not one clear message")

    def check_state(self, disturbance, done, found, outcome):
        bad = outcome.violations.append
        result = self.scenario.result
        foreign = [name for name in (*FOREIGN, *self.scenario.files) if found.get(name) != self.before.get(name)]
        if foreign:
            bad(f"files of the user have changed: {', '.join(foreign)}")
        now, earlier, whole = below(found, result), below(self.before, result), below(self.after, result)
        if self.scenario.whole == "runs":
            self.check_runs(disturbance, now, earlier, whole, bad)
        elif self.scenario.in_place:
            pass  # moved file by file: only what a repetition makes of it counts
        elif now != whole and (now != earlier or done[0] == 0 and not disturbance.kills):
            if not self.lacks_pictures_only(now, whole, done[2]) and not self.has_other_fonts(now, whole, outcome.what):
                bad(f"neither the earlier nor the new result, nor none: {differences(whole, now)}")
        # A run that has succeeded may not have come by what it was to remove; the next one must. A folder whose list of files cannot be read
        # may be anybody's, and stays.
        if not disturbance.kills and done[0] != 0 and disturbance.call not in REMOVING | LOOKING and "O_DIRECTORY" not in outcome.what:
            left = [name for name in found if name not in self.before and name not in self.after
                    and Path(name).name.startswith(".") and Path(name).name not in outcome.what and "/" not in name.removeprefix(result).strip("/")]
            if left:
                bad(f"left behind: {', '.join(left)}")

    @staticmethod
    def lacks_pictures_only(now, whole, err):
        """A picture or report that cannot be made is missing from the result, with a message."""
        missing = [name for name in whole if name not in now]
        return bool(missing) and all(name.endswith((".png", ".html", "/pictures")) for name in missing) and err.count("is missing") == sum(name.endswith((".png", ".html")) for name in missing) and not [
            n for n in now if now[n] != whole.get(n) and not n.endswith("files.json")]

    @staticmethod
    def has_other_fonts(now, whole, what):
        """Where the system's fonts or their settings cannot be read, pictures have others."""
        return "font" in what and now.keys() == whole.keys() and all(name.endswith((".png", "files.json")) for name in now if now[name] != whole[name])

    def check_runs(self, disturbance, now, earlier, whole, bad):
        """Each run of a study is that of before or after, or a failure that says why."""
        place = f"{self.scenario.result}/runs"
        for run in {name.split("/")[2] for name in now if name.startswith(place + "/")}:
            if run.startswith("."):
                continue
            here = below(now, f"{place}/{run}")
            if here in (below(earlier, f"{place}/{run}"), below(whole, f"{place}/{run}")):
                continue
            told = here.get(f"{place}/{run}/result.json")
            if not isinstance(told, dict) or told.get("status") not in ("failed", "out_of_memory", "diverged") or not told.get("message"):
                if not (isinstance(told, dict) and told.get("status") == "crashed" and disturbance.kills):
                    bad(f"the run {run} is neither whole nor a failure that says why: {told}")
            elif told.get("exit_code") not in (0, 2, 3, 5, 6):
                bad(f"the run {run} ended with exit code {told['exit_code']}: {told['message']}")

    def check_repeated(self, disturbance, done, outcome):
        """The same command without a fault ends in what an undisturbed one makes, and clears up."""
        bad = outcome.violations.append
        for extra in (self.scenario.again, f"{self.scenario.again} --force"):
            again = subprocess.run(self.words(extra), cwd=self.work, capture_output=True, text=True, timeout=LONGEST, **self.scenario.user())
            # Where the disturbed one had brought its result to its place, --force replaces it.
            is_there = again.returncode == 2 and "exist" in again.stderr and self.scenario.result in snapshot(self.work)
            if not is_there:
                break
        if again.returncode != 0:
            bad(f"the repetition ended with exit code {again.returncode}: {again.stderr.strip()[-300:]}")
        elif difference := differences(self.after, snapshot(self.work)):
            bad(f"the repetition made something else: {difference}")
