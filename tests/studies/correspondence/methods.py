"""What finds a correspondence: the program itself, or any other that a command starts."""

import dataclasses
import pathlib
import re
import shlex
import shutil
import string

from correspondence.pairs import BenchmarkError

placeholders = ("reference", "template", "out")


@dataclasses.dataclass(frozen=True)
class Method:
    """`words` hold {reference}, {template} and {out}; `resources`, which do not change the result, follow them."""
    name: str
    words: tuple
    resources: tuple = ()

    def command(self, pair, out):
        values = {"reference": pair.reference.resolve(), "template": pair.template.resolve(), "out": out}
        return [word.format(**values) for word in self.words] + list(self.resources)

    def programs(self):
        """The files among the words: the executable, and a script that it reads."""
        found = [shutil.which(self.words[0])] + [word for word in self.words[1:] if pathlib.Path(word).is_file()]
        return [path for path in found if path]


def own_method(name, program, arguments, threads):
    words = (program, "match", "{reference}", "{template}", "-o", "{out}", "--quiet", "--set", "pictures=none", "--set", "report=false")
    # Braces of the user's are no placeholders.
    escaped = tuple(word.replace("{", "{{").replace("}", "}}") for word in arguments)
    check(name, words)
    return Method(name, words + escaped, () if "--threads" in arguments else ("--threads", str(threads)))


def other_method(text):
    """`NAME: command`, or a command that gets the name of its program."""
    named = re.match(r"([A-Za-z0-9][\w.-]*):\s+(.*)", text, re.S)
    try:
        words = tuple(shlex.split(named[2] if named else text))
    except ValueError as error:
        raise BenchmarkError(f"--command '{text}': {error}") from error
    if not words:
        raise BenchmarkError("--command '': a command is missing")
    try:
        used = {field for word in words for _, field, _, _ in string.Formatter().parse(word) if field is not None}
    except ValueError as error:
        raise BenchmarkError(f"--command '{text}': {error}") from error
    if used != set(placeholders):
        wrong = used - set(placeholders)
        raise BenchmarkError(f"--command '{text}': " + (f"there is no placeholder {{{min(wrong)}}}; there are " if wrong else "expected ")
                             + ", ".join(f"{{{name}}}" for name in placeholders))
    name = named[1] if named else pathlib.Path(words[0]).stem
    check(name, words)
    return Method(name, words)


def check(name, words):
    if not re.fullmatch(r"[A-Za-z0-9][\w.-]*", name):
        raise BenchmarkError(f"'{name}' names no method; expected letters, digits, '.', '_' and '-'")
    if not shutil.which(words[0]):
        raise BenchmarkError(f"{words[0]} cannot be run" + ("; build it with scripts/build" if words[1:2] == ("match",) else ""))
