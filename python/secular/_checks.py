"""Arguments of the caller: what they must be, or an InputError that names them."""

from __future__ import annotations

import math
import numbers
import os
from typing import Mapping, Optional, Tuple

import numpy as np

from ._errors import InputError


def refused(argument: str, fault: str, remedy: str) -> InputError:
    return InputError(f"{argument}: {fault}; {remedy}", argument, "", fault, remedy)


def _shown(value) -> str:
    shown = repr(value)
    return f"is {shown if len(shown) <= 40 else type(value).__name__}"


def real(argument: str, value, *, may_be_infinite: bool = False) -> float:
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, numbers.Real):
        raise refused(argument, _shown(value), "give a number")
    if math.isnan(value) or (math.isinf(value) and not may_be_infinite):
        raise refused(argument, _shown(value), "give a finite number")
    return float(value)


def optional_real(argument: str, value, **allowed) -> Optional[float]:
    return None if value is None else real(argument, value, **allowed)


def whole(argument: str, value, low: int, high: int) -> int:
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, numbers.Integral) or not low <= value <= high:
        raise refused(argument, _shown(value), f"give a whole number from {low} to {high}")
    return int(value)


def flag(argument: str, value) -> bool:
    if not isinstance(value, (bool, np.bool_)):
        raise refused(argument, _shown(value), "give True or False")
    return bool(value)


def text(argument: str, value) -> str:
    if not isinstance(value, str):
        raise refused(argument, _shown(value), "give a text (str)")
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
        raise refused(argument, _shown(value), "give a name or a sequence of names")
    return [text(argument, name) for name in value]


def path(argument: str, value) -> str:
    if not isinstance(value, (str, os.PathLike)):
        raise refused(argument, _shown(value), "give a path or a name")
    return os.fsdecode(value)


def numbers_by_symbol(argument: str, value) -> dict[str, float]:
    if value is None:
        return {}
    if not isinstance(value, Mapping):
        raise refused(argument, _shown(value), "give a dictionary of symbol to number")
    return {text(argument, name): real(f"{argument}, {name}", number) for name, number in value.items()}


def band(value) -> Optional[Tuple[float, float]]:
    if value is None:
        return None
    if isinstance(value, (str, Mapping)) or not np.iterable(value) or len(pair := list(value)) != 2:
        raise refused("band_hz", _shown(value), "give (low, high), for example (20, 300)")
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
