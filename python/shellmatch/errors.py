"""The exceptions of shellmatch. All derive from Error, and their text is one line that says what to do."""


from ._words import in_python


class Error(Exception):
    """Whatever shellmatch raises on its own account; Ctrl-C stays a KeyboardInterrupt."""

    def __init__(self, text: str = "") -> None:
        super().__init__(in_python(text))


class InputError(Error, ValueError):
    """The input cannot be used: a shape, an array, an option, a file."""


class ResourceError(Error):
    """The machine lacks disk, memory or rights."""


class OutOfMemoryError(ResourceError, MemoryError):
    """There is not enough memory; a matching with a lower finest level needs less."""


class InternalError(Error, RuntimeError):
    """A broken invariant: an error of shellmatch's own, worth a report."""


class ShellmatchWarning(UserWarning):
    """Something that a result lacks, or a reason to doubt it."""
