"""Results within a document, between two marks."""

import shlex

from correspondence.pairs import BenchmarkError
from correspondence.tables import write_whole


def marks(name):
    return f"<!-- results of {name}: made by scripts/study benchmark-correspondence -->", f"<!-- end of {name} -->"


def check_page(path, name):
    """Raises BenchmarkError where there is no place for the results."""
    first, last = marks(name)
    try:
        text = path.read_text()
    except OSError as error:
        raise BenchmarkError(f"{path} cannot be read: {error.strerror}") from error
    if text.count(first) != 1 or text.count(last) != 1 or text.index(first) > text.index(last):
        raise BenchmarkError(f"{path} needs the lines '{first}' and '{last}', once each: the results go between them")
    return text


def write_page(path, name, command, table, pictures):
    """`pictures`: paths relative to the document."""
    first, last = marks(name)
    text = check_page(path, name)
    body = f"    {shlex.join(command)}\n\n{table}" + "".join(f"\n![Share of points below an error]({picture})\n" for picture in pictures)
    before, after = text[:text.index(first)], text[text.index(last):]
    write_whole(path, f"{before}{first}\n\n{body}\n{after}")
