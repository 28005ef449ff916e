"""Arguments of the caller: what they must be, or an InputError that names them."""

from __future__ import annotations

import difflib
import functools
import math
import numbers
import os
import re
from typing import Mapping, Optional, Tuple

import numpy as np

from ._errors import InputError, NumericalFailure


def refused(argument: str, fault: str, remedy: str) -> InputError:
    return InputError(f"{argument}: {fault}; {remedy}", argument, "", fault, remedy)


def shown(value) -> str:
    shown = repr(value)
    return f"is {shown if len(shown) <= 40 else type(value).__name__}"


def real(argument: str, value, *, may_be_infinite: bool = False) -> float:
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, numbers.Real):
        raise refused(argument, shown(value), "give a number")
    try:
        number = float(value)
    except OverflowError:
        raise refused(argument, "is beyond what a double holds", "give a number up to 1.8e308") from None
    if math.isnan(number) or (math.isinf(number) and not may_be_infinite):
        raise refused(argument, shown(value), "give a finite number")
    return number


def optional_real(argument: str, value, **allowed) -> Optional[float]:
    return None if value is None else real(argument, value, **allowed)


def whole(argument: str, value, low: int, high: int) -> int:
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, numbers.Integral) or not low <= value <= high:
        raise refused(argument, shown(value), f"give a whole number from {low} to {high}")
    return int(value)


def flag(argument: str, value) -> bool:
    if not isinstance(value, (bool, np.bool_)):
        raise refused(argument, shown(value), "give True or False")
    return bool(value)


def text(argument: str, value) -> str:
    if not isinstance(value, str):
        raise refused(argument, shown(value), "give a text (str)")
    if any("\ud800" <= character <= "\udfff" for character in value):
        raise refused(argument, "has halves of characters (surrogates)", "give a text that UTF-8 can hold")
    return value


def optional_text(argument: str, value) -> Optional[str]:
    return None if value is None else text(argument, value)


def names(argument: str, value) -> list[str]:
    """One name, or several."""
    if isinstance(value, str):
        return [value]
    if value is None:
        return []
    if isinstance(value, (Mapping, bytes)) or not np.iterable(value):
        raise refused(argument, shown(value), "give a name or a sequence of names")
    return [text(argument, name) for name in value]


def path(argument: str, value) -> str:
    if not isinstance(value, (str, os.PathLike)):
        raise refused(argument, shown(value), "give a path or a name")
    return os.fsdecode(value)


def new_file(argument: str, value) -> str:
    """A path where no file stands, in a folder that does."""
    name = path(argument, value)
    if not os.path.basename(name):
        raise refused(argument, f"{name!r} names no file", "name a new file")
    if os.path.lexists(name):
        raise refused(argument, f"{name} exists", "name a new file")
    if not os.path.isdir(os.path.dirname(name) or "."):
        raise refused(argument, f"the folder of {name} does not exist", "make it, or name another file")
    return name


def numbers_by_symbol(argument: str, value) -> dict[str, float]:
    if value is None:
        return {}
    if not isinstance(value, Mapping):
        raise refused(argument, shown(value), "give a dictionary of symbol to number")
    return {text(argument, name): real(f"{argument}, {name}", number) for name, number in value.items()}


def band(value) -> Optional[Tuple[float, float]]:
    if value is None:
        return None
    if isinstance(value, (str, Mapping)) or not np.iterable(value) or len(pair := list(value)) != 2:
        raise refused("band_hz", shown(value), "give (low, high), for example (20, 300)")
    return real("band_hz", pair[0]), real("band_hz", pair[1])


def threads(value) -> int:
    return min(os.cpu_count() or 1, 1024) if value is None else whole("threads", value, 1, 1024)


def seed(value) -> int:
    return whole("seed", value, 0, 2**64 - 1)


def _measured(where: str, given) -> np.ndarray:
    """An array of any real numbers as doubles, what is masked as NaN."""
    if isinstance(given, (list, tuple)) and given:
        rows = [_measured(where, row) for row in given if isinstance(row, (np.ndarray, list, tuple))]
        if len(rows) == len(given):
            if len({row.shape for row in rows}) != 1:
                raise refused(where, "have channels of several lengths", "one length is needed")
            return np.stack(rows)
    array = given if isinstance(given, np.ndarray) else np.asarray(given)
    if array.dtype.kind not in "fiu":
        raise refused(where, f"are no real numbers: dtype {array.dtype}", "give floats or integers")
    return np.ma.filled(array.astype(float), np.nan)


def samples(where: str, given, channels: int) -> np.ndarray:
    array = _measured(where, given)
    if array.ndim != 2:
        raise refused(where, f"have {array.ndim} dimensions", "give an array of channels x samples")
    if array.shape[0] != channels and array.shape[1] == channels:
        raise refused(where, f"are samples x channels: an array of {array.shape[0]} x {channels}",
                      "give channels x samples, the transposed array")
    if array.shape[0] != channels:
        raise refused(where, f"have {array.shape[0]} channels", f"the campaign has {channels}")
    if array.shape[1] < 2:
        raise refused(where, f"hold {array.shape[1]} of every channel", "give two samples or more")
    return array


def selection(records, band_hz, from_s, to_s, threads_, interpret) -> dict:
    return dict(window(records, band_hz, from_s, to_s), threads=threads(threads_),
                interpret=flag("interpret", interpret))


def window(records, band_hz=None, from_s=None, to_s=None) -> dict:
    """Which part of which records."""
    return {"records": optional_text("records", records), "band_hz": band(band_hz),
            "from_s": optional_real("from_s", from_s, may_be_infinite=True),
            "to_s": optional_real("to_s", to_s, may_be_infinite=True)}


def positive(argument: str, value) -> float:
    number = real(argument, value)
    if not number > 0:
        raise refused(argument, shown(value), "give a positive number")
    return number


def not_negative(argument: str, value) -> float:
    number = real(argument, value)
    if number < 0:
        raise refused(argument, shown(value), "give no negative number")
    return number


def within(argument: str, value, low: float, high: float) -> float:
    number = real(argument, value)
    if not low <= number <= high:
        raise refused(argument, shown(value), f"give a number from {low:g} to {high:g}")
    return number


def optional(check, argument: str, value, *limits):
    return None if value is None else check(argument, value, *limits)


def reals(argument: str, value) -> list[float]:
    """One number, or several; None: none."""
    if value is None:
        return []
    if isinstance(value, (str, Mapping)) or not np.iterable(value):
        return [real(argument, value)]
    return [real(argument, number) for number in value]


def pair(argument: str, value) -> Tuple[float, float]:
    numbers_ = reals(argument, value)
    if len(numbers_) != 2:
        raise refused(argument, shown(value), "give (low, high)")
    return numbers_[0], numbers_[1]


def one_of(argument: str, value, *words: str) -> str:
    if not isinstance(value, str) or value not in words:
        near = difflib.get_close_matches(value.lower(), words, 1) if isinstance(value, str) else []
        raise refused(argument, shown(value), "give " + " or ".join(repr(word) for word in words)
                      + (f"; did you mean {near[0]!r}?" if near else ""))
    return value


def whole_numbers(argument: str, value, low: int, high: int) -> list[int]:
    """One, or several."""
    if isinstance(value, (str, Mapping)) or not np.iterable(value):
        return [whole(argument, value, low, high)]
    return [whole(argument, number, low, high) for number in not_empty(argument, list(value))]


def not_empty(argument: str, values: list) -> list:
    if not values:
        raise refused(argument, "is empty", "give one or more")
    return values


def only_with(argument: str, other, options: Mapping) -> None:
    """Refuses what belongs to `argument`, which is not given."""
    given = [name for name, value in options.items() if value is not None]
    if other is None and given:
        raise refused(", ".join(given), f"belongs to {argument}, which is not given", f"give {argument}, too")


# How the program's examples are written in Python, before options are renamed.
_EXAMPLES = ((r"--(\w+) NAME=VALUE", r"--\1={name: value}"), (r"--(\w+) (\w+)=([\d.]+)", r'--\1={"\2": \3}'),
             (r"--(vary|against) (\w+) (\S+) (\d[\d.]*)", r'--\1=("\2", \3, \4)'), (r"--curve (\w+)$", r'--curve="\1"'),
             (r"(=\([^()]*\)) --", r"\1, --"), (r"LOW:HIGH", "(low, high)"),
             (r"for example ([\d.]+):([\d.]+)", r"for example (\1, \2)"), (r"another (--channel)\b", r"other \1"))


def in_keywords(keywords: Mapping[str, str]):
    """Errors of a job, and the reason of a failed result, name arguments in place of the program's options.

    keywords: option, without its hyphens, to argument, where that is not the same word with underscores.
    """
    def renamed(text_: str) -> str:
        def argument(match):
            option = match[1]
            return keywords.get(option, option.replace("-", "_"))
        for example, written in _EXAMPLES:
            text_ = re.sub(example, written, text_)
        return re.sub(r"(?<![\w-])--([a-z][a-z-]*[a-z])", argument, text_)

    def decorate(job):
        @functools.wraps(job)
        def call(*arguments, **named):
            try:
                result = job(*arguments, **named)
                if getattr(result, "reason", ""):
                    result.reason = renamed(result.reason)
                return result
            except NumericalFailure as failure:
                raise NumericalFailure(renamed(str(failure))) from None
            except InputError as error:
                parts = [renamed(part) for part in (str(error), error.file, error.place, error.fault, error.remedy)]
                if parts[0] == str(error):
                    raise
                raise InputError(*parts) from None
        return call
    return decorate
