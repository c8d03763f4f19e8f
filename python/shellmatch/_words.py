"""Messages of the library speak the words of the command line; here they get those of the Python package."""

from __future__ import annotations

import re

_words = [
    (re.compile(pattern), words)
    for pattern, words in (
        (r" with -o\b", ""),
        (r"--force\b", "force=True"),
        (r"--levels (\d+):(\d+)", r"levels=(\1, \2)"),
        (r"--levels\b", "levels=(coarsest, finest)"),
        (r"--threads (\d+)", r"threads=\1"),
        (r"--align (\w+)", r'align="\1"'),
        (r"--set ([\w.]+)=([\w.-]+)", r'**{"\1": "\2"}'),
        (r"--strict\b", 'input={"close": "never"}'),
        (r"--template-landmarks\b", "landmarks=(file of the reference, file of the template)"),
    )
]


def in_python(text: str) -> str:
    """The same message for somebody who calls the package."""
    for pattern, words in _words:
        text = pattern.sub(words, text)
    return text
