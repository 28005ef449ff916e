"""Campaigns: what was measured, from NumPy arrays or a folder."""

from __future__ import annotations

import json
import os
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Optional, Sequence, Union

import numpy as np

from . import _core
from ._errors import InputError


@dataclass(frozen=True)
class Channel:
    """One sensor.

    role: "excitation" or "response"; quantity: "acceleration", "velocity", "displacement", "force", "voltage",
    "strain" or "angle"; unit: of the samples ("m/s^2", "g", "mm", ...); frame: of an acceleration of a structure on a
    moving base, "relative" to it or "absolute".
    """

    name: str
    role: str
    quantity: str
    unit: str
    frame: str = "relative"


@dataclass
class Record:
    """One measurement.

    samples: array of channels x samples, in channel units; NaN where nothing was measured.
    kind: "dwell", "sweep", "free_decay", "impact" or "broadband".
    excitation_frequency_hz, excitation_amplitude: of a dwell, nominal (Hz; peak, in the unit of the excitation).
    ensemble_s: how a dwell is cut, s. started_s: when, since the campaign began, s. start_s: of the first sample, s.
    group: records that belong together, such as "frequency sweep, up". file: its name; "records/0001.csv" and so on
    without one.
    """

    samples: np.ndarray
    kind: str
    excitation_frequency_hz: Optional[float] = None
    excitation_amplitude: Optional[float] = None
    ensemble_s: Optional[float] = None
    started_s: Optional[float] = None
    group: str = ""
    start_s: float = 0.0
    file: Optional[str] = None


@dataclass(frozen=True)
class ModalBasis:
    """Mass-normalised mode shapes: array of channels x modes, 1/sqrt(kg) for displacements in m."""

    channels: Sequence[str]
    modes: Sequence[str]
    mass_normalised_shapes: np.ndarray


def _toml(value) -> str:
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_toml(v) for v in value) + "]"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    return repr(float(value))


def _table(head: str, entries: dict) -> str:
    lines = [f"{key} = {_toml(value)}" for key, value in entries.items() if value not in (None, "")]
    return "\n".join(["", head, *lines, ""])


def _campaign_text(name, sample_rate_hz, channels, records, modal_basis) -> str:
    text = f"schema = 1\nname = {_toml(name)}\nsample_rate_hz = {_toml(sample_rate_hz)}\n"
    for channel in channels:
        text += _table("[[channel]]", vars(channel))
    if modal_basis is not None:
        shapes = np.asarray(modal_basis.mass_normalised_shapes, dtype=float).tolist()
        text += _table("[modal_basis]", {"channels": list(modal_basis.channels), "modes": list(modal_basis.modes),
                                         "mass_normalised_shapes": shapes})
    for number, record in enumerate(records, 1):
        entries = {"file": record.file or f"records/{number:04}.csv"}
        entries.update((key, value) for key, value in vars(record).items()
                       if key not in ("samples", "start_s", "file"))
        text += _table("[[record]]", entries)
    return text


def _in_words(error: InputError, text: str) -> InputError:
    """The same error, with the channel or record it is about in place of a line of `text`."""
    at = re.match(r"line (\d+)(, .*)?$", error.place)
    if at is None:
        return error
    heads = [line for line in text.splitlines()[: int(at[1])] if line.startswith("[")]
    if not heads:
        return error
    kind = heads[-1].strip("[]")
    place = kind if kind == "modal_basis" else f"{kind} {heads.count(heads[-1])}"
    message = str(error).replace(error.place, place + (at[2] or ""))
    return InputError(message, error.file, place + (at[2] or ""), error.fault, error.remedy)


class Campaign:
    """Channels and records of a vibration test.

    From arrays, `Campaign(channels, records, time_step_s=...)`: channels a sequence of Channel, records a sequence of
    Record, time_step_s the time between samples (s), modal_basis a ModalBasis where responses are no coordinates of the
    model. From a folder, or the files that `secular import` made one of: `Campaign.read(folder)`.
    """

    def __init__(self, channels: Sequence[Channel], records: Sequence[Record], *, time_step_s: float,
                 name: str = "campaign", modal_basis: Optional[ModalBasis] = None):
        if not time_step_s > 0:
            raise InputError("time_step_s: is not positive", "time_step_s", "", "is not positive", "give seconds")
        text = _campaign_text(name, 1 / time_step_s, channels, records, modal_basis)
        try:
            self._core = _core.Campaign.hold(text, [(record.start_s, record.samples) for record in records])
        except InputError as error:
            raise _in_words(error, text) from None

    @classmethod
    def _of(cls, core) -> "Campaign":
        campaign = cls.__new__(cls)
        campaign._core = core
        return campaign

    @classmethod
    def read(cls, folder: Union[str, os.PathLike]) -> "Campaign":
        """A campaign folder. Its records are read when they are needed."""
        return cls._of(_core.Campaign.read(os.fspath(folder)))

    def save(self, folder: Union[str, os.PathLike], *, replace: bool = False) -> Path:
        """Writes a campaign folder, whole or not at all; reading it gives the same numbers bit by bit.

        replace: what is in the folder goes.
        """
        self._core.save(os.fspath(folder), replace)
        return Path(folder)

    @property
    def name(self) -> str:
        return self._core.name

    @property
    def time_step_s(self) -> float:
        """Between samples, s; infinite where there are tables of lines alone."""
        rate = self._core.sample_rate_hz
        return 1 / rate if rate > 0 else float("inf")

    @property
    def channels(self) -> list[Channel]:
        return [Channel(**channel) for channel in self._core.channels]

    def __len__(self) -> int:
        """How many records."""
        return len(self._core.records)

    def __getitem__(self, index: int) -> Record:
        """A record with its samples: array of channels x samples, NaN where the file holds none."""
        described = self._core.records[index]
        start_s, samples = self._core.samples(index % len(self))
        return Record(samples=samples, start_s=start_s, **described)

    def time(self, index: int) -> np.ndarray:
        """Times of a record's samples, s."""
        record = self[index]
        return record.start_s + np.arange(record.samples.shape[1]) * self.time_step_s

    def __repr__(self) -> str:
        return f"<secular.Campaign {self.name!r}: {len(self)} records of {len(self.channels)} channels>"


def as_campaign(campaign: Union[Campaign, str, os.PathLike]) -> Campaign:
    return campaign if isinstance(campaign, Campaign) else Campaign.read(campaign)
