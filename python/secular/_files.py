"""What files and campaigns hold, and files made campaigns."""

from __future__ import annotations

import os
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from typing import Mapping, Optional, Sequence, Tuple, Union

from . import _checks, _core
from ._campaign import Campaign, Channel
from ._result import Report, Result, html_table, shown


@dataclass(frozen=True)
class Fault:
    """Something to judge: kind, text. record, channel: where; None: of the whole."""

    kind: str
    text: str
    record: Optional[str]
    channel: Optional[str]


@dataclass(frozen=True)
class Levels:
    """A channel of a record, or a variable of a file, in its unit.

    rms is about the mean; noise_rms: of the white noise that the upper half of the spectrum would allow; resolution:
    the step between values; None where they cannot be told. missing: samples that are no numbers.
    """

    record: Optional[str]
    name: str
    unit: str
    samples: int
    missing: int
    mean: float
    rms: float
    peak: float
    noise_rms: Optional[float]
    resolution: Optional[float]


@dataclass(frozen=True)
class InspectedRecord:
    """A record: file, kind, samples, when it begins (s), Hz and s; None where its time is faulty. fields: all of it."""

    file: str
    kind: str
    samples: int
    start_s: Optional[float]
    sample_rate_hz: Optional[float]
    duration_s: Optional[float]
    fields: dict = field(repr=False, compare=False)


@dataclass(frozen=True)
class Variable:
    """A variable of a file: its shape, type and unit (SI; "" where the file says none). fault: why it is no channel."""

    name: str
    shape: Tuple[int, ...]
    type: str
    unit: str
    stated_unit: str
    fault: str


class Inspection(Report):
    """What a campaign or a file holds.

    name: of the campaign or file. channels: list of Channel, records: list of InspectedRecord, tables: of lines, as the
    program tells them (of a campaign); format, variables: list of Variable, time: the variable that holds it or None
    (of a file). levels: list of Levels; faults: list of Fault; disturbances: what there is beside the motion.
    Figures: "history_N" and "spectrum_N" of record N, from 1; what was inspected is read again for them and the report.
    """

    def __init__(self, core):
        super().__init__(core)
        data = self.data
        self.name: str = data.get("name") or data.get("file", "")
        self.channels = [Channel(**entry) for entry in data.get("channels", [])]
        self.records = [InspectedRecord(*(entry[key] for key in ("file", "kind", "samples", "start_s",
                                                                 "sample_rate_hz", "duration_s")), entry)
                        for entry in data.get("records", [])]
        self.tables: list[dict] = data.get("tables", [])
        self.format: Optional[str] = data.get("format")
        self.time: Optional[str] = data.get("time", {}).get("variable")
        self.variables = [Variable(entry["name"], tuple(entry["shape"]), entry["type"], entry.get("unit", ""),
                                   entry.get("stated_unit", ""), entry.get("fault", ""))
                          for entry in data.get("variables", [])]
        self.levels = [_levels(record["file"], entry) for record in data.get("records", [])
                       for entry in record["channels"]]
        self.levels += [_levels(None, entry) for entry in data.get("variables", []) if "rms" in entry]
        self.faults = list(_faults(data))
        self.disturbances: list[dict] = data.get("disturbances", [])

    def to_pandas(self):
        """A data frame with one row for each of `levels`."""
        import pandas

        return pandas.DataFrame([vars(levels) for levels in self.levels])

    def _rows(self) -> list[tuple]:
        return [(levels.record or "", levels.name, levels.unit, *(shown(value) for value in (
            levels.mean, levels.rms, levels.peak, levels.noise_rms, levels.resolution))) for levels in self.levels]

    def _head(self) -> str:
        faults = f"{len(self.faults)} faults, {len(self.disturbances)} disturbances"
        what = f"{len(self.variables)} variables" if self.format else \
            f"{len(self.records)} records of {len(self.channels)} channels"
        return f"{self.name}: {what}, {faults}"

    def _repr_html_(self) -> str:
        table = html_table(self._head(), ("record", "channel", "unit", "mean", "rms", "peak", "noise", "resolution"),
                           self._rows())
        faults = [(fault.record or "", fault.channel or "", fault.kind, fault.text) for fault in self.faults]
        return table + (html_table("Faults", ("record", "channel", "kind", "what"), faults) if faults else "")

    def __repr__(self) -> str:
        lines = ["  " + ": ".join(part for part in (fault.record, fault.channel, fault.kind, fault.text) if part)
                 for fault in self.faults]
        return "\n".join([f"<secular.Inspection of {self._head()}", *lines]) + ">"


def _levels(record: Optional[str], entry: dict) -> Levels:
    return Levels(record, entry["name"], entry.get("unit", ""), *(entry[key] for key in (
        "samples", "missing", "mean", "rms", "peak", "noise_rms", "resolution")))


def _faults(data: dict):
    for fault in data.get("faults", []):
        yield Fault(fault["kind"], fault["text"], None, data.get("time", {}).get("variable"))
    for table in data.get("tables", []):
        for text in table["faults"]:
            yield Fault("table", text, table["file"], None)
    for record in data.get("records", []):
        for fault in record["faults"]:
            yield Fault(fault["kind"], fault["text"], record["file"], None)
        for channel in record["channels"]:
            for fault in channel["faults"]:
                yield Fault(fault["kind"], fault["text"], record["file"], channel["name"])
    for variable in data.get("variables", []):
        for fault in variable.get("faults", []):
            yield Fault(fault["kind"], fault["text"], None, variable["name"])


@_checks.in_keywords({"from": "from_s", "to": "to_s"})
def inspect(source: Union[Campaign, str, os.PathLike], *, records: Optional[str] = None,
            from_s: Optional[float] = None, to_s: Optional[float] = None, whole: bool = False) -> Inspection:
    """What a campaign or a data file holds: channels, units, levels, noise, faults; what `secular inspect` does.

    source: a Campaign, a campaign folder or a file. records: shell pattern of a campaign's files; from_s, to_s: the
    part of every record, s. whole: everything of data larger than 64 MB, of which the first samples are judged else.
    Raises InputError.
    """
    campaign = source._core if isinstance(source, Campaign) else None
    name = source.name if isinstance(source, Campaign) else _checks.path("source", source)
    options = dict(_checks.window(records, None, from_s, to_s), whole=_checks.flag("whole", whole))
    return Inspection(_core.inspect(name, campaign, options))


def _given_channels(channels) -> list[Union[str, Channel]]:
    if isinstance(channels, (str, Channel)):
        return [channels]
    if isinstance(channels, (Mapping, bytes)) or not hasattr(channels, "__iter__"):
        raise _checks.refused("channels", _checks.shown(channels), "give a Channel or a text for each sensor")
    return list(channels)


def _channel_text(channel: Union[Channel, str]) -> str:
    """Without its frame and its delay, which the text has no place for."""
    if not isinstance(channel, Channel):
        return _checks.text("channels", channel)
    for key, value in vars(channel).items():
        check = _checks.optional_real if key == "delay_s" else _checks.text
        check(f"channels, {key}", value)
    _checks.one_of("channels, frame", channel.frame, "relative", "absolute")
    if channel.frame == "absolute" and (channel.role, channel.quantity) != ("response", "acceleration"):
        raise _checks.refused("channels, frame", f"is 'absolute' for {channel.name}",
                              "an absolute frame belongs to accelerations of responses")
    return f"{channel.name}:{channel.role}:{channel.quantity}:{channel.unit}"


def _files(value) -> list[str]:
    if isinstance(value, (str, os.PathLike)):
        return [_checks.path("files", value)]
    if isinstance(value, (Mapping, bytes)) or not hasattr(value, "__iter__"):
        raise _checks.refused("files", _checks.shown(value), "give a path or a sequence of paths")
    return [_checks.path("files", file) for file in _checks.not_empty("files", list(value))]


class Import(Result):
    """A campaign made of files.

    campaign: the Campaign. left_out: variables that no channel names. converted: list of {"name", "from", "to"} of
    units.
    """

    def __init__(self, core, campaign: Campaign):
        super().__init__(core)
        self.campaign = campaign
        self.left_out: list[str] = self.data["left_out"]
        self.converted: list[dict] = self.data["converted"]

    def to_pandas(self):
        """A data frame with one row for each channel."""
        import pandas

        return pandas.DataFrame([vars(channel) for channel in self.campaign.channels])

    def _rows(self) -> list[tuple]:
        return [(channel.name, channel.role, channel.quantity, channel.unit) for channel in self.campaign.channels]

    def _repr_html_(self) -> str:
        left_out = f"; left out: {', '.join(self.left_out)}" if self.left_out else ""
        return html_table(f"{self.campaign.name}: {len(self.campaign)} records{left_out}",
                          ("channel", "role", "quantity", "unit"), self._rows())

    def __repr__(self) -> str:
        left_out = f"; left out: {', '.join(self.left_out)}" if self.left_out else ""
        return f"<secular.Import: {self.campaign!r}{left_out}>"


@_checks.in_keywords({"channel": "channels", "sample-rate": "sample_rate_hz", "frequency": "frequency_hz",
                      "level": "amplitude", "ensemble": "ensemble_s", "column": "columns",
                      "phase-offset": "phase_offset_deg"})
def import_files(files: Union[str, os.PathLike, Sequence[Union[str, os.PathLike]]], *, kind: str,
                 channels: Union[str, Channel, Sequence[Union[str, Channel]]],
                 folder: Union[str, os.PathLike, None] = None, replace: bool = False, time: Optional[str] = None,
                 sample_rate_hz: Optional[float] = None, name: Optional[str] = None, group: Optional[str] = None,
                 geometry: Union[str, os.PathLike, None] = None,
                 frequency_hz: Union[float, Sequence[float], None] = None,
                 amplitude: Union[float, Sequence[float], None] = None, ensemble_s: Optional[float] = None,
                 decimal_mark: Optional[str] = None, columns: Union[str, Sequence[str], None] = None,
                 amplitudes: Optional[str] = None, phases: Optional[str] = None, phase_sign: Optional[str] = None,
                 phase_offset_deg: Optional[float] = None, per_excitation: bool = False,
                 frequency_unit: Optional[str] = None) -> Import:
    """CSV, MAT, HDF5, UFF 58, LVM or WAV files as a campaign, a record each; what `secular import` does.

    kind: of all records ("dwell", "sweep", "free_decay", "impact", "broadband"), or "lines": tables of lines. channels:
    Channel, or "NAME[=VARIABLE]:ROLE[:QUANTITY:UNIT[:FACTOR]]". folder: where the campaign is written (replace: over
    one that stands there); in memory alone without it. time: the variable that holds it; sample_rate_hz: where none
    does. geometry: a universal file with nodes, for drawings of modes. frequency_hz, amplitude: of dwells, nominal,
    one or one a file. columns, amplitudes, phases, phase_sign, phase_offset_deg, per_excitation, frequency_unit: of
    tables of lines, as `secular import --help` has them. Raises InputError, which says what a file cannot tell by the
    name of the argument.
    """
    given = _given_channels(channels)

    def text(argument, value):
        return _checks.optional_text(argument, value) or ""

    options = dict(files=_files(files), kind=_checks.text("kind", kind), channels=[_channel_text(c) for c in given],
                   absolute=[c.name for c in given if isinstance(c, Channel) and c.frame == "absolute"],
                   delays=[f"{c.name}={c.delay_s!r}" for c in given if isinstance(c, Channel) and c.delay_s],
                   time=text("time", time), name=text("name", name), group=text("group", group),
                   geometry="" if geometry is None else _checks.path("geometry", geometry),
                   sample_rate_hz=_checks.optional(_checks.positive, "sample_rate_hz", sample_rate_hz),
                   frequency_hz=_checks.reals("frequency_hz", frequency_hz),
                   amplitude=_checks.reals("amplitude", amplitude),
                   ensemble_s=_checks.optional(_checks.positive, "ensemble_s", ensemble_s),
                   decimal_mark=text("decimal_mark", decimal_mark), columns=_checks.names("columns", columns),
                   amplitudes=text("amplitudes", amplitudes), phases=text("phases", phases),
                   phase_sign=text("phase_sign", phase_sign),
                   phase_offset_deg=_checks.optional_real("phase_offset_deg", phase_offset_deg),
                   per_excitation=_checks.flag("per_excitation", per_excitation),
                   frequency_unit=text("frequency_unit", frequency_unit))
    replaces = _checks.flag("replace", replace)
    if replaces:
        _checks.only_with("folder", folder, dict(replace=replace))
    if folder is not None:
        target = _checks.path("folder", folder)
        return Import(_core.import_files(options, target, replaces), Campaign.read(target))
    with tempfile.TemporaryDirectory() as place:
        target = str(Path(place) / "campaign")
        core = _core.import_files(options, target, False)
        return Import(core, Campaign._of(_core.Campaign.read_into_memory(target)))
