"""What records say by themselves, what files hold, files made campaigns."""
import json
import os
import signal
import threading
import time

import numpy as np
import pytest
import secular

RATE = 256.0
POLES = [(9.0, 0.010, (1.0, 0.6)), (23.0, 0.006, (0.7, -1.0))]  # Hz, damping ratio, shape


def ringing():
    """A decay of two modes in two channels: frequencies, damping and shapes are known."""
    t = np.arange(4096) / RATE
    x = np.zeros((2, t.size))
    for hz, ratio, shape in POLES:
        omega = 2 * np.pi * hz
        x += np.outer(shape, np.exp(-ratio * omega * t) * np.cos(omega * np.sqrt(1 - ratio**2) * t))
    x += np.random.default_rng(7).normal(0, 1e-3, x.shape)
    return secular.Campaign([secular.Channel("a", "response", "acceleration", "m/s^2"),
                             secular.Channel("b", "response", "acceleration", "m/s^2")],
                            [secular.Record(x, "free_decay")], time_step_s=1 / RATE, name="ringing")


@pytest.fixture(scope="module")
def decay():
    return ringing()


@pytest.fixture(scope="module")
def decay_folder(decay, tmp_path_factory):
    return decay.save(tmp_path_factory.mktemp("ringing") / "decay")


def test_modal_is_the_program_s_and_the_truth(program, decay, decay_folder, tmp_path):
    printed = json.loads(program("modal", decay_folder, "--json", "-o", tmp_path / "out"))
    found = secular.modal(decay)
    assert found.data == printed == secular.modal(decay_folder).data
    assert len(found.modes) == 2
    for mode, (hz, ratio, shape) in zip(found.modes, POLES):
        assert abs(mode.natural_frequency_hz - hz) < 4 * mode.natural_frequency_sd_hz + 1e-6 * hz
        assert abs(mode.damping_ratio - ratio) < 4 * mode.damping_ratio_sd + 1e-6
        true = np.array(shape) / np.linalg.norm(shape)
        true *= np.sign(true @ mode.shape.real)
        assert np.all(np.abs(mode.shape.real - true) < 4 * mode.shape_sd[0])
        assert mode.motion == "decays" and mode.modal_mass is None
    assert found["v2"] is found.modes[1] and found.mass_normalised_shapes is None
    with pytest.raises(ValueError, match="modal masses"):
        found.modal_basis()
    with_masses = secular.modal(decay, modal_masses=[2.0, 3.0])
    assert with_masses.mass_normalised_shapes.shape == (2, 2)
    assert list(with_masses.modal_basis().modes) == ["v1", "v2"]
    assert "v1" in repr(found) and found.to_html().startswith("<!")
    assert found.figures[:2] == ["stabilisation", "shapes"]


def test_no_mode_is_a_failure_of_the_computation(decay):
    noise = np.random.default_rng(1).normal(0, 1, (2, 2048))
    found = secular.modal(secular.Campaign(decay.channels, [secular.Record(noise, "free_decay")], time_step_s=1 / RATE))
    assert found.status == "failed" and found.reason and found.modes == []
    with pytest.raises(secular.InputError) as raised:
        secular.modal(decay, band_hz=(1, 500))
    assert "--" not in str(raised.value)


def test_spectrum_is_the_program_s_and_the_truth(program, tmp_path):
    t = np.arange(2048) / RATE
    x = 3 * np.cos(2 * np.pi * 20.0 * t + 0.3) + 0.5 * np.cos(2 * np.pi * 47.3 * t)
    x = x[None] + np.random.default_rng(2).normal(0, 0.01, (1, t.size))
    tones = secular.Campaign([secular.Channel("x", "response", "displacement", "m")],
                             [secular.Record(x, "dwell", excitation_frequency_hz=20.0)], time_step_s=1 / RATE)
    folder = tones.save(tmp_path / "tones")
    printed = json.loads(program("spectrum", folder, "--ensemble", "2", "--json", "-o", tmp_path / "out"))
    found = secular.spectrum(tones, ensemble_s=2)
    assert {**found.data, "source": ""} == {**printed, "source": ""}
    largest = sorted(found["x"].terms, key=lambda term: -term.amplitude)[:2]
    for term, (hz, size) in zip(largest, ((20.0, 3.0), (47.3, 0.5))):
        assert abs(term.frequency_hz - hz) < 2e-3 and abs(term.amplitude - size) < 5e-3 and term.family == "circular"
    assert found.conclusions and found.singular_values["temporal"][0] >= found.singular_values["temporal"][-1]
    by_file = secular.spectrum(folder / "records/0001.csv", channels="x", order=2)
    assert by_file["x"].terms[0].frequency_hz == pytest.approx(20.0, abs=1e-3)
    with pytest.raises(secular.InputError) as raised:
        secular.spectrum(tones, channels="y")
    assert "the channels are x" in raised.value.remedy


def test_figures_of_surveys(decay):
    pytest.importorskip("matplotlib").use("agg")
    found = secular.modal(decay)
    drawn = [found.plot(name) for name in found.figures]
    assert all(len(figure.axes) > 0 for figure in drawn) and "Frequency" in drawn[0].axes[-1].get_xlabel()
    spectrum = secular.spectrum(decay, channels="a", order=2)
    assert all(len(spectrum.plot(name).axes) > 0 for name in spectrum.figures)


def test_frames(decay):
    pytest.importorskip("pandas")
    assert secular.modal(decay).to_pandas().loc["v1", "natural_frequency_hz"] == pytest.approx(9.0, rel=1e-3)
    assert set(secular.spectrum(decay, channels="a", order=2).to_pandas()["channel"]) == {"a"}
    assert len(secular.inspect(decay).to_pandas()) == 2


def test_inspect_is_the_program_s_in_memory_and_of_a_folder(program, decay, decay_folder):
    printed = json.loads(program("inspect", decay_folder, "--json"))
    read, held = secular.inspect(decay_folder), secular.inspect(decay)
    assert read.data == printed and {**held.data, "campaign": ""} == {**printed, "campaign": ""}
    assert held.channels == decay.channels and held.records[0].duration_s == 16.0
    assert held.levels[0].rms == pytest.approx(np.std(decay[0].samples[0]), rel=1e-9)
    file = secular.inspect(decay_folder / "records/0001.csv")
    assert file.format == "CSV" and file.time == "t" and [v.name for v in file.variables] == ["t", "a", "b"]
    with pytest.raises(secular.InputError, match="single record"):
        secular.inspect(decay_folder / "records/0001.csv", records="0001*")
    assert file.figures == ["history_1", "spectrum_1"] and len(held.plot("spectrum_1").axes) == len(held.channels)
    for inspection in (read, held):
        assert "Usable for identify: 1 of 1 record." in inspection.to_html()
    assert "secular import" in file.to_html()


def test_faults_are_told_of_samples_in_memory(decay):
    samples = decay[0].samples.copy()
    samples[0, 700:702] = np.nan
    gappy = secular.Campaign(decay.channels, [secular.Record(samples, "free_decay")], time_step_s=1 / RATE)
    found = secular.inspect(gappy)
    assert any(fault.kind == "missing" and fault.channel == "a" for fault in found.faults)
    assert found.levels[0].missing == 2 and "missing" in found._repr_html_()


def test_import_is_the_program_s(program, decay, tmp_path):
    t = np.arange(4096) / RATE
    table = np.column_stack([t, decay[0].samples.T])
    np.savetxt(tmp_path / "swing.csv", table, delimiter=",", header="t,left,right", comments="", fmt="%.17g")
    printed = json.loads(program("import", tmp_path / "swing.csv", "-o", tmp_path / "made", "--kind", "free_decay",
                                 "--channel", "a=left:response:acceleration:m/s^2", "--json"))
    found = secular.import_files(tmp_path / "swing.csv", kind="free_decay",
                                 channels="a=left:response:acceleration:m/s^2")
    assert {**found.data, "campaign": ""} == {**printed, "campaign": ""}
    assert found.left_out == ["right"] and len(found.campaign) == 1
    made = secular.Campaign.read(tmp_path / "made")
    assert np.array_equal(found.campaign[0].samples, made[0].samples)
    assert np.array_equal(found.campaign[0].samples[0], decay[0].samples[0])
    kept = secular.import_files([tmp_path / "swing.csv"], kind="free_decay", folder=tmp_path / "kept",
                                channels=[secular.Channel("left", "response", "acceleration", "m/s^2")])
    assert (tmp_path / "kept/campaign.toml").is_file() and kept.campaign.channels[0].name == "left"
    again = secular.Campaign.read(found.campaign.save(tmp_path / "again"))
    assert np.array_equal(again[0].samples, made[0].samples)


def test_import_replaces_a_campaign_alone_and_never_what_it_reads(decay, tmp_path):
    def imported(file, folder):
        return secular.import_files(file, kind="free_decay", channels="a:response:acceleration:m/s^2", folder=folder,
                                    replace=True)

    thesis = tmp_path / "thesis"
    thesis.mkdir()
    (thesis / "thesis.tex").write_text("all of it")
    file = decay.save(tmp_path / "source") / "records/0001.csv"
    with pytest.raises(secular.InputError, match="is no campaign"):
        imported(file, thesis)
    for folder in (tmp_path / "source", tmp_path / "source/records", tmp_path):
        with pytest.raises(secular.InputError, match="contains the file that is read"):
            imported(file, folder)
    with pytest.raises(secular.InputError, match="no name"):
        imported(file, "")
    assert (thesis / "thesis.tex").read_text() == "all of it" and file.is_file()
    made = decay.save(tmp_path / "made")
    (made / "notes.txt").write_text("mine")
    with pytest.raises(secular.InputError, match="holds notes.txt"):
        imported(file, made)
    (made / "notes.txt").unlink()
    assert [channel.name for channel in imported(file, made).campaign.channels] == ["a"]


def test_a_channel_is_imported_with_its_frame_and_any_name(tmp_path):
    values = np.random.default_rng(0).normal(size=(100, 2))
    np.savetxt(tmp_path / "run.csv", np.column_stack([np.arange(100) / 64, values]), delimiter=",",
               header="t,base,tip:1=a", comments="")
    channels = [secular.Channel("base", "excitation", "acceleration", "m/s^2"),
                secular.Channel("tip:1=a", "response", "acceleration", "m/s^2", frame="absolute")]
    made = secular.import_files(tmp_path / "run.csv", kind="broadband", channels=channels)
    assert made.campaign.channels == channels and "tip:1=a" in made._repr_html_()
    wrong = [secular.Channel("base", "excitation", "acceleration", "m/s^2", frame="absolute"), channels[1]]
    with pytest.raises(secular.InputError, match="channels, frame: is 'absolute' for base"):
        secular.import_files(tmp_path / "run.csv", kind="broadband", channels=wrong)
    unused = secular.import_files(tmp_path / "run.csv", kind="broadband", channels=channels, sample_rate_hz=100)
    assert unused.campaign.time_step_s == 0.01 and any("t is called a time" in notice for notice in unused.notices)


@pytest.mark.parametrize("wrong", [{"channels": None}, {"channels": 3}, {"files": []}, {"files": b"run.csv"},
                                   {"replace": True}])
def test_arguments_of_import_are_judged(wrong):
    with pytest.raises(secular.InputError) as raised:
        secular.import_files(**{**dict(files="run.csv", kind="dwell", channels="u:response:displacement:m"), **wrong})
    assert raised.value.file == next(iter(wrong))


def test_import_asks_for_what_a_file_cannot_say_by_the_argument(tmp_path):
    np.savetxt(tmp_path / "plain.csv", np.random.default_rng(0).normal(size=(100, 2)), delimiter=",", header="u,v",
               comments="")
    with pytest.raises(secular.InputError) as raised:
        secular.import_files(tmp_path / "plain.csv", kind="dwell", channels="u:response:displacement:m")
    assert "sample_rate_hz" in str(raised.value) and "--" not in str(raised.value)


def test_tables_of_lines_come_into_memory(tmp_path):
    rows = "\n".join(f"{hz},2.0,{1e-3 / abs(hz - 12.5):.6g},{-30 - hz}" for hz in (11, 11.5, 12, 13, 13.5, 14))
    (tmp_path / "stepped.csv").write_text("frequency,force,tip,tip.phase\n" + rows + "\n")
    found = secular.import_files(tmp_path / "stepped.csv", kind="lines", phases="deg",
                                 channels=["force:excitation:force:N", "tip:response:displacement:m"])
    inspection = secular.inspect(found.campaign)
    assert inspection.tables[0]["rows"] == 6 and inspection.tables[0]["lowest_hz"] == 11
    assert len(secular.inspect(found.campaign.save(tmp_path / "kept")).tables) == 1


@pytest.mark.parametrize("job", [
    lambda: secular.predict("two_mass_mode1", "predictions/table_5_4", case="principal_parametric", at={"F": 22.5},
                            vary=("Omega", 24.4, 25.1), hz=True, threads=1),
    lambda: secular.plan("two_mass_mode1", "predictions/table_5_4", "mu1", case="principal_parametric",
                         frequency_hz=(24.4, 25.1), amplitude=(10, 30), budget_s=3600),
    lambda: secular.predict("two_mass_mode1", "predictions/table_5_4", case="principal_parametric", at={"F": 22.5},
                            vary=("Omega", 24.4, 25.1), hz=True, sweep="up", sweep_steps=3000),
    lambda: secular.modal(ringing()),
    lambda: secular.spectrum(ringing(), order=8)])
def test_ctrl_c_ends_the_others_too(job):
    stopped_at = []

    def stop():
        stopped_at.append(time.process_time())
        os.kill(os.getpid(), signal.SIGINT)

    threading.Timer(0.15, stop).start()
    with pytest.raises(KeyboardInterrupt):
        while True:
            job()
    assert time.process_time() - stopped_at[0] < 1
