"""What is done to a command: kills and faults of system calls, by strace, and short reads and writes, by libfiu.

A disturbance is written KIND, KIND:CALL:N or random-kill:SECONDS, as "ENOSPC:write:17": the 17th write of a process fails with
that error. KILL:CALL:N kills before the call. `memory:data:N` limits the data segment to N kB, so that allocations fail.
"""

import random
import re
import subprocess
from collections import defaultdict
from dataclasses import dataclass

# Errors of each system call, as far as file systems and the kernel give them. What is not named is only killed at.
WRITING = ["ENOSPC", "EIO", "EDQUOT"]
ERRORS = {
    "openat": ["ENOSPC", "EACCES", "EIO", "EINTR", "EMFILE"], "open": ["ENOSPC", "EACCES", "EIO"],
    "write": [*WRITING, "EINTR"], "writev": [*WRITING, "EINTR"], "pwrite64": WRITING, "sendfile": WRITING, "copy_file_range": WRITING,
    "read": ["EIO", "EINTR"], "readv": ["EIO"], "pread64": ["EIO"], "lseek": ["EIO"],
    "fsync": ["EIO", "ENOSPC", "EINTR"], "close": ["EIO", "EINTR"], "ftruncate": ["EIO"], "fallocate": ["ENOSPC"],
    "rename": ["EIO", "EACCES", "ENOSPC"], "renameat": ["EIO"], "renameat2": ["EIO", "EACCES", "EINVAL", "ENOSYS"],
    "mkdir": ["ENOSPC", "EACCES", "EIO"], "mkdirat": ["ENOSPC"], "link": ["EPERM", "EIO", "EMLINK"], "linkat": ["EPERM", "EIO"],
    "unlink": ["EIO", "EACCES", "EBUSY"], "unlinkat": ["EIO", "EACCES", "EBUSY"], "rmdir": ["EIO", "EBUSY"],
    "newfstatat": ["EIO", "EACCES"], "fstat": ["EIO"], "statx": ["EIO", "ENOSYS"], "access": ["EACCES", "EIO"], "faccessat2": ["EACCES"],
    "getdents64": ["EIO"], "readlink": ["EIO", "EACCES"], "flock": ["ENOLCK", "EINTR", "EIO"], "fchmod": ["EPERM", "EIO"],
    "getrandom": ["ENOSYS", "EINTR"], "getcwd": ["ENOENT"], "mmap": ["ENOMEM"], "clone3": ["EAGAIN"], "vfork": ["EAGAIN"], "clone": ["EAGAIN"],
    "pipe2": ["EMFILE"], "execve": ["EACCES", "ENOMEM"], "wait4": ["EINTR"], "statfs": ["EIO"], "fstatfs": ["EIO"],
}
# Calls of a removal: where one of them fails, what it was to remove may stay until the next run.
REMOVING = {"unlink", "unlinkat", "rmdir", "getdents64"}
# Calls by which it finds out what is there before.
LOOKING = {"newfstatat", "fstat", "statx"}
SHORT = ["-c", "enable name=posix/io/rw/read/reduce", "-c", "enable name=posix/io/rw/write/reduce",
         "-c", "enable name=posix/io/rw/writev/reduce"]


@dataclass(frozen=True)
class Disturbance:
    kind: str
    call: str = ""
    n: float = 0

    def __str__(self):
        return f"{self.kind}:{self.n:g}" if self.kind == "random-kill" else f"{self.kind}:{self.call}:{self.n}" if self.call else self.kind

    @property
    def kills(self):
        return self.kind in ("KILL", "random-kill")

    @property
    def group(self):
        """Under which it is counted."""
        return self.kind if self.kills or self.kind == "memory" else self.call or self.kind

    def around(self, record, with_children=True):
        """The words that come before the command line; strace writes the calls that were disturbed to `record`."""
        if self.kind == "short":
            return ["fiu-run", "-x", *SHORT]
        if self.kind == "memory":
            return ["prlimit", f"--data={1024 * self.n}"]
        if not self.call:
            return []
        # Signals are not injected where seccomp leaves out what is not traced (strace 6.1).
        follow = ["-f", *(["--seccomp-bpf"] if self.kind != "KILL" else [])]
        trace = ["strace", *(follow if with_children else []), "-q", "-y", "-o", str(record)]
        what = "signal=KILL" if self.kind == "KILL" else f"error={self.kind}"
        return [*trace, "-e", f"trace={self.call}", "-e", f"inject={self.call}:{what}:when={self.n}"]


def parse(text):
    kind, *rest = text.split(":")
    return Disturbance(kind, "", float(rest[0])) if kind == "random-kill" else Disturbance(kind, rest[0], int(rest[1])) if rest else Disturbance(kind)


def calls_of(words, folder, record, **how):
    """(process, name, n) of the system calls of a command after its libraries are loaded, n counted from 1 by process and name."""
    subprocess.run(["strace", "-f", "-y", "-qq", "-o", str(record), *words], cwd=folder, capture_output=True, check=True, **how)
    counts, calls, begun = defaultdict(int), [], set()
    processes = {}
    for line in record.read_text(errors="replace").splitlines():
        found = re.match(r"(\d+) +(\w+)\(", line)
        if not found:
            continue
        process = processes.setdefault(found[1], len(processes))
        counts[process, found[2]] += 1
        # What main() does first (apps/main.cpp).
        if found[2] == "rt_sigaction" and "SIGXFSZ, {sa_handler=SIG_IGN" in line:
            begun.add(process)
        elif process in begun:
            calls.append((process, found[2], counts[process, found[2]]))
    return calls


def faults_of(calls):
    """All disturbances at single calls, each once, however many processes make the call."""
    once = dict.fromkeys((name, n) for _, name, n in calls)
    return [Disturbance(error, name, n) for name, n in once for error in ERRORS.get(name, [])]


def kills_of(calls):
    """Kills before calls that change files."""
    changing = {"openat", "write", "writev", "fsync", "rename", "renameat2", "mkdir", "unlink", "unlinkat", "rmdir", "link", "linkat", "flock",
                "ftruncate", "close", "sendfile", "fchmod", "execve", "wait4"}
    return [Disturbance("KILL", name, n) for name, n in dict.fromkeys((name, n) for _, name, n in calls if name in changing)]


def want_of_memory(program, words, folder, restore, **how):
    """Limits between what the program needs to begin and what the command needs to end, in steps of 8 kB."""
    def least(command):
        low, high = 0, 2 ** 20
        while high - low > 8:
            middle = (low + high) // 2
            restore()
            done = subprocess.run([*Disturbance("memory", "data", middle).around(""), *command], cwd=folder, capture_output=True, check=False, **how)
            low, high = (low, middle) if done.returncode == 0 else (middle, high)
        return high
    return [Disturbance("memory", "data", n) for n in range(least([program, "--version"]), least(words), 8)]


def chosen(random_numbers: random.Random, disturbances, number):
    """So many of them, spread over the system calls: as many of a rare call as of a frequent one, as far as there are."""
    by_call = defaultdict(list)
    for disturbance in disturbances:
        by_call[disturbance.call, disturbance.kind].append(disturbance)
    for group in by_call.values():
        random_numbers.shuffle(group)
    taken = []
    while len(taken) < number and by_call:
        for key in list(by_call):
            taken.append(by_call[key].pop())
            if not by_call[key]:
                del by_call[key]
    return taken[:number] if number < len(disturbances) else taken
