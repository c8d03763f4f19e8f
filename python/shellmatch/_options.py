"""Options as keyword arguments: texts in YAML's notation, which the library checks as those of a file or of --set."""

from __future__ import annotations

import json
import numbers
import os
import re
from typing import Any, Iterator, Mapping, Optional

import numpy as np

from ._inputs import OptionText, file_name, landmark_input
from .errors import InputError

_deepest = 10  # no option lies so deep: the section holds itself

_plain = re.compile(r"[A-Za-z_][A-Za-z0-9_.-]*")


def _text_of(value: Any, key: str, within_list: bool = False) -> str:
    if isinstance(value, np.ndarray):
        value = value.tolist()  # of no axis: the number itself
    elif isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        number = float(value)
        return ".nan" if number != number else repr(number)
    if isinstance(value, str):
        return value if not within_list or _plain.fullmatch(value) else json.dumps(value, ensure_ascii=False)
    if hasattr(value, "__fspath__"):
        return os.fsdecode(value)
    if isinstance(value, (list, tuple)) and not within_list:
        return "[" + ", ".join(_text_of(item, key, True) for item in value) + "]"
    raise InputError(
        f"option {key}: a value of type {type(value).__name__}; expected a number, a text, a truth value or a list of these"
    )


def _flat(values: Mapping[Any, Any], path: str, depth: int = 0) -> Iterator[tuple[str, Any]]:
    if depth > _deepest:
        raise InputError(f"option {path.split('.')[0]}: its sections lie more than {_deepest} deep in each other; does one hold itself?")
    for name, value in values.items():
        if not isinstance(name, str) or not name or not name.isprintable():
            raise InputError(f"option {path or 'at the top'}: the key {name!r} is no word")
        key = f"{path}.{name}" if path else name
        if isinstance(value, Mapping):
            if not value:
                raise InputError(f"option {key}: the section is empty")
            yield from _flat(value, key, depth + 1)
        else:
            yield key, value


def _printable(text: str) -> str:
    """For messages, which are one line."""
    text = text if text.isprintable() else repr(text)
    return text if len(text) <= 100 else text[:100] + "..."


def option_texts(options: Mapping[str, Any]) -> list[OptionText]:
    """Of nested dictionaries or dotted names. A section twice is one section."""
    texts: list[OptionText] = []
    for key, value in _flat(options, ""):
        text = _text_of(value, key)
        origin = f"option {key}={_printable(text)}"
        try:
            texts.append((key, text.encode("utf-8", "surrogateescape"), origin))  # names of files may be no text
        except UnicodeEncodeError:
            raise InputError(f"{origin}: this is no text") from None
    return texts


def level_texts(levels: Any) -> list[OptionText]:
    """Of the argument `levels`, (coarsest, finest); None leaves them to the other options."""
    if levels is None:
        return []
    try:
        if isinstance(levels, (str, bytes)):
            raise TypeError
        coarsest, finest = levels
    except (TypeError, ValueError):
        raise InputError(f"levels={levels!r}: expected the coarsest and the finest level, as (3, 7)") from None
    origin = f"levels=({coarsest}, {finest})"
    return [
        ("cascade.min_level", _text_of(coarsest, "levels"), origin),
        ("cascade.max_level", _text_of(finest, "levels"), origin),
    ]


def matching_arguments(
    landmarks: Any, align: Any, levels: Any, config: Any, options: Mapping[str, Any]
) -> tuple[list[OptionText], bytes, Optional[tuple[Any, Any, Any]]]:
    """Options, file of options and landmarks, as the library takes them, of the arguments that register() and Problem() share.

    Later options win: those of their own over `align` and `levels`.
    """
    of_files, points = landmark_input(landmarks)
    texts = level_texts(levels)
    if align is not None:
        texts += option_texts({"align": align if isinstance(align, Mapping) else {"mode": align}})
    if isinstance(landmarks, Mapping):
        texts += option_texts({"landmarks": landmarks})
    return texts + option_texts(options) + of_files, b"" if config is None else file_name(config, "config"), points
