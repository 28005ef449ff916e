"""Campaigns: what was measured, from NumPy arrays or a folder."""

from __future__ import annotations

import json
import os
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Optional, Sequence, Union

import numpy as np

from . import _checks, _core
from ._errors import InputError
from ._result import html_table


@dataclass(frozen=True)
class Channel:
    """One sensor.

    role: "excitation" or "response"; quantity: "acceleration", "velocity", "displacement", "force", "voltage",
    "strain" or "angle"; unit: of the samples, SI alone ("m/s^2", "m/s", "m", "N", ...; no "g", no "mm"); frame: of an
    acceleration of a structure on a moving base, "relative" to it or "absolute"; delay_s: by how much its samples are
    late against those of the other channels, by a mere delay.
    """

    name: str
    role: str
    quantity: str
    unit: str
    frame: str = "relative"
    delay_s: float = 0.0


@dataclass
class Record:
    """One measurement.

    samples: array of channels x samples, real numbers in channel units; NaN, or masked, where nothing was measured.
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


def _in_words(error: InputError, text: str, channels, records) -> InputError:
    """The same error, with the channel, record or sample it is about in place of a line of `text` or of a file."""
    files = [record.file or f"records/{number:04}.csv" for number, record in enumerate(records, 1)]
    at = re.match(r"line (\d+)(, .*)?$", error.place)
    if files.count(error.file) == 1:
        place = f"record {files.index(error.file) + 1}"
        sample = re.match(r"line (\d+), column (.*)$", error.place)
        names = [channel.name for channel in channels]
        if sample and sample[2] in names:
            place += f", channel {sample[2]}, samples[{names.index(sample[2])}, {int(sample[1]) - 2}]"
        elif at:
            place += f", sample {int(at[1]) - 2} (from 0){at[2] or ''}"
        elif error.place:
            place += f", {error.place}"
    elif at is None or error.file in files:
        return error
    else:
        heads = [line for line in text.splitlines()[: int(at[1])] if line.startswith("[")]
        if not heads:
            return error
        kind = heads[-1].strip("[]")
        place = (kind if kind == "modal_basis" else f"{kind} {heads.count(heads[-1])}") + (at[2] or "")
    message = f"{error.file}, {place}: {error.fault}" + (f"; {error.remedy}" if error.remedy else "")
    return InputError(message, error.file, place, error.fault, error.remedy)


def _checked_channels(channels) -> list[Channel]:
    if not np.iterable(channels) or not all(isinstance(channel, Channel) for channel in channels):
        raise _checks.refused("channels", "are no sequence of secular.Channel", "give one Channel for each sensor")
    checked = list(channels)
    for number, channel in enumerate(checked, 1):
        for key, value in vars(channel).items():
            check = _checks.optional_real if key == "delay_s" else _checks.text
            check(f"channel {number}, {key}", value)
    return checked


def _checked_records(records, channels: int) -> list[Record]:
    """Copies with arrays of doubles; the arrays of the caller stay as they are."""
    if not np.iterable(records) or not all(isinstance(record, Record) for record in records):
        raise _checks.refused("records", "are no sequence of secular.Record", "give one Record for each measurement")
    checked = []
    for number, record in enumerate(records, 1):
        at = f"record {number}"
        reals = {key: _checks.optional_real(f"{at}, {key}", getattr(record, key)) for key in
                 ("excitation_frequency_hz", "excitation_amplitude", "ensemble_s", "started_s")}
        file = _checks.optional_text(f"{at}, file", record.file)
        samples = _checks.samples(f"{at}, samples", record.samples, channels)
        checked.append(Record(samples, _checks.text(f"{at}, kind", record.kind), **reals, file=file,
                              group=_checks.text(f"{at}, group", record.group),
                              start_s=_checks.real(f"{at}, start_s", record.start_s)))
    return checked


def _checked_basis(basis) -> Optional[ModalBasis]:
    if basis is None:
        return None
    if not isinstance(basis, ModalBasis):
        raise _checks.refused("modal_basis", f"is {type(basis).__name__}", "give a secular.ModalBasis")
    shapes = np.asarray(basis.mass_normalised_shapes)
    if shapes.ndim != 2 or shapes.dtype.kind not in "fiu":
        raise _checks.refused("modal_basis, mass_normalised_shapes", "are no array of real numbers, channels x modes",
                              "give two dimensions")
    return ModalBasis(_checks.names("modal_basis, channels", basis.channels),
                      _checks.names("modal_basis, modes", basis.modes), shapes)


class Campaign:
    """Channels and records of a vibration test.

    From arrays, `Campaign(channels, records, time_step_s=...)`: channels a sequence of Channel, records a sequence of
    Record, time_step_s the time between samples (s), modal_basis a ModalBasis where responses are no coordinates of the
    model. From a folder: `Campaign.read(folder)`; from other files: `secular.import_files`.
    """

    def __init__(self, channels: Sequence[Channel], records: Sequence[Record], *, time_step_s: float,
                 name: str = "campaign", modal_basis: Optional[ModalBasis] = None):
        step = _checks.real("time_step_s", time_step_s)
        if not step > 0:
            raise InputError("time_step_s: is not positive", "time_step_s", "", "is not positive", "give seconds")
        channels = _checked_channels(channels)
        records = _checked_records(records, len(channels))
        text = _campaign_text(_checks.text("name", name), 1 / step, channels, records, _checked_basis(modal_basis))
        try:
            self._core = _core.Campaign.hold(text, [(record.start_s, record.samples) for record in records])
        except InputError as error:
            raise _in_words(error, text, channels, records) from None

    @classmethod
    def _of(cls, core) -> "Campaign":
        campaign = cls.__new__(cls)
        campaign._core = core
        return campaign

    @classmethod
    def read(cls, folder: Union[str, os.PathLike]) -> "Campaign":
        """A campaign folder. Its records are read when they are needed."""
        return cls._of(_core.Campaign.read(_checks.path("folder", folder)))

    def save(self, folder: Union[str, os.PathLike], *, replace: bool = False) -> Path:
        """Writes a campaign folder, whole or not at all; reading it gives the same numbers bit by bit, NaN included.

        replace: a campaign that stands there goes. Anything else is refused: a folder that no command and no `save`
        made or that holds other files too, and the folder that this campaign is read from.
        """
        self._core.save(_checks.path("folder", folder), _checks.flag("replace", replace))
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

    def _repr_html_(self) -> str:
        rows = [(channel.name, channel.role, channel.quantity, channel.unit) for channel in self.channels]
        return html_table(f"{self.name}: {len(self)} records", ("channel", "role", "quantity", "unit"), rows)

    def __repr__(self) -> str:
        return f"<secular.Campaign {self.name!r}: {len(self)} records of {len(self.channels)} channels>"


def as_campaign(campaign: Union[Campaign, str, os.PathLike]) -> Campaign:
    return campaign if isinstance(campaign, Campaign) else Campaign.read(_checks.path("campaign", campaign))
