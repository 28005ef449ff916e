"""Jobs give what the program gives, and say how they end."""
import contextlib
import json
import os
import signal
import threading
import time

import numpy as np
import pytest
import secular


def test_identify_is_the_program_s_bit_by_bit(program, folder, campaign, identification, tmp_path):
    printed = json.loads(program("identify", folder, "--model", "two_mass_mode1", "--json", "-o", tmp_path / "out"))
    assert identification.data == printed
    assert secular.identify(folder, "two_mass_mode1", threads=1).data == printed
    made = program("simulate", "experiments/principal_parametric", "-o", tmp_path / "campaign")
    assert f"{len(campaign)} records" in made
    assert all(np.array_equal(secular.Campaign.read(tmp_path / "campaign")[r].samples, campaign[r].samples)
               for r in (0, len(campaign) - 1))


def test_an_identification_is_typed(identification):
    truth = {"omega0": 77.84866595595507, "mu1": 0.222, "mu3": 36.87, "eta2": 7.64948}
    for name, value in truth.items():
        found = identification[name]
        assert found.ci95[0] < found.value < found.ci95[1]
        assert abs(found.value - value) < 4 * found.sd
    assert "mu1" in identification and "nu1" not in identification
    assert identification["mu1"].unit == "1/s" and identification["mu1"].why == ""
    open_one = identification["alpha2"]
    assert open_one.value is None and not open_one.identifiable and "entangled with alpha3" in open_one.why
    told = [name for name in identification.names if identification[name].value is not None]
    assert identification.covariance_names == told
    sds = [identification[name].sd for name in told]
    assert np.allclose(np.sqrt(np.diag(identification.covariance)), sds, rtol=1e-12)
    assert np.isnan(identification.estimates[identification.names.index("alpha2")])
    assert "mu1" in identification._repr_html_() and "alpha2" in repr(identification)
    assert identification.to_html().startswith("<!")


def test_pandas(identification):
    pandas = pytest.importorskip("pandas")
    frame = identification.to_pandas()
    assert isinstance(frame, pandas.DataFrame)
    assert frame.loc["mu3", "value"] == identification["mu3"].value and frame.loc["mu3", "unit"] == "s/m^2"


def test_the_figure_shows_what_was_measured_and_the_model(campaign, identification):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("agg")
    figure = identification.plot()
    axes = figure.axes[0]
    assert "Hz" in figure.axes[-1].get_xlabel() and axes.get_ylabel()
    drawn = np.concatenate([np.asarray(line.get_xdata()) for line in axes.lines if len(line.get_xdata())])
    asked = [campaign[r].excitation_frequency_hz for r in range(3)]
    assert all(np.min(np.abs(drawn - frequency)) < 2e-3 for frequency in asked)


def test_fixed_numbers_and_selections_reach_the_job(folder):
    result = secular.identify(folder, "two_mass_mode1", fix={"mu2": 0.0}, records="records/000*")
    assert result["mu2"].fixed and result["mu2"].value == 0
    with pytest.raises(secular.InputError) as raised:
        secular.identify(folder, "two_mass_mode1", records="zz*")
    assert "records/0001.csv" in raised.value.remedy
    with pytest.raises(secular.InputError, match="is no band"):
        secular.identify(folder, "two_mass_mode1", band_hz=(30, 20))


@pytest.mark.parametrize("name, value", [
    ("fix", {"mu1": np.nan}), ("fix", {"mu1": np.inf}), ("fix", {"mu1": "a"}), ("fix", 3), ("bootstrap", -1),
    ("bootstrap", 100001), ("bootstrap", 2.5), ("threads", 0), ("threads", 1025), ("threads", -1), ("seed", -1),
    ("seed", 2**64), ("band_hz", 20), ("band_hz", (1, 2, 3)), ("band_hz", ("a", "b")), ("records", ["0001.csv"]),
    ("from_s", "a"), ("to_s", np.nan), ("case", 5), ("by", "magic"), ("refine", "yes"), ("interpret", None)])
def test_arguments_that_are_none_are_refused_by_name(campaign, name, value):
    with pytest.raises(secular.InputError) as raised:
        secular.identify(campaign, "two_mass_mode1", **{name: value})
    assert raised.value.file.split(",")[0] == name and raised.value.remedy.startswith("give ")


def test_arguments_of_the_others_are_refused_by_name(campaign):
    for job, name in ((lambda: secular.identify(5, "two_mass_mode1"), "campaign"),
                      (lambda: secular.identify(campaign, None), "model"),
                      (lambda: secular.diagnose(campaign, "two_mass_mode1", parameters={"mu1": ""}), "parameters, mu1"),
                      (lambda: secular.diagnose(campaign, "two_mass_mode1", without=[1]), "without"),
                      (lambda: secular.simulate("experiments/principal_parametric", seed=1.5), "seed"),
                      (lambda: secular.derive("duffing", 1), "case")):
        with pytest.raises(secular.InputError) as raised:
            job()
        assert raised.value.file == name


def test_a_result_of_the_lesser_part_of_the_records_says_so(campaign):
    heard = [secular.Record(record.samples, record.kind, record.excitation_frequency_hz) for record in campaign]
    shape = heard[0].samples.shape
    noise = [secular.Record(np.random.default_rng(r).normal(0, 1e-3, shape), "dwell", 5 + 0.1 * r) for r in range(25)]
    mixed = secular.Campaign(campaign.channels, heard + noise, time_step_s=campaign.time_step_s)
    result = secular.identify(mixed, "two_mass_mode1")
    assert result.status == "mostly left out" and result.reason == result.notices[-1]
    assert result["mu1"].value is not None


def test_what_was_not_measured_disturbs_the_same_from_a_folder(campaign, tmp_path):
    records = list(campaign)[:6]
    records[2].samples[1, 500] = np.nan
    gappy = secular.Campaign(campaign.channels, records, time_step_s=campaign.time_step_s)
    held = secular.identify(gappy, "two_mass_mode1")
    read = secular.identify(gappy.save(tmp_path / "gappy"), "two_mass_mode1")
    assert read.disturbances == held.disturbances
    assert any("0003" in json.dumps(one) for one in held.disturbances)


def test_diagnose_is_the_program_s(program, folder, campaign, identification, tmp_path):
    printed = json.loads(program("diagnose", folder, "--model", "two_mass_mode1", "--json", "-o", tmp_path / "out"))
    diagnosis = secular.diagnose(campaign, "two_mass_mode1")
    assert diagnosis.data == printed
    assert diagnosis.verdict == "no_gap" and not diagnosis.gap_detected and diagnosis.status == "done"
    given = secular.diagnose(campaign, "two_mass_mode1", parameters=identification)
    assert given.data["gap"]["of"] != printed["gap"]["of"]  # the gap of those numbers


def test_ctrl_c_ends_a_computation_within_a_second(campaign, capfd):
    stopped_at = []

    def stop():
        stopped_at.append(time.process_time())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(0.3, stop)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        while True:  # whatever it is busy with
            secular.diagnose(campaign, "two_mass_mode1", threads=1)
    assert time.process_time() - stopped_at[0] < 1  # of a processor, whatever else it does
    assert secular.derive("duffing").certified  # and nothing is broken
    assert capfd.readouterr() == ("", "")


def test_ctrl_c_ends_a_long_record_within_seconds():
    channels = [secular.Channel("force", "excitation", "force", "N"),
                secular.Channel("x", "response", "displacement", "m")]
    noise = np.random.default_rng(0).normal(size=(2, 500_000))
    long = secular.Campaign(channels, [secular.Record(noise, "broadband")], time_step_s=1e-4)
    stopped_at = []

    def stop():
        stopped_at.append(time.process_time())
        os.kill(os.getpid(), signal.SIGINT)

    threading.Timer(1, stop).start()
    with pytest.raises(KeyboardInterrupt):
        while True:  # noise identifies nothing, which takes less than a second or more
            with contextlib.suppress(secular.InputError):
                secular.identify(long, "duffing", threads=1)
    assert time.process_time() - stopped_at[0] < 6  # the whole pseudo-inverse of a zero's blocks took twenty


def test_other_threads_go_on(campaign):
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(1)
            time.sleep(0.005)

    thread = threading.Thread(target=tick, daemon=True)
    thread.start()
    begun = time.monotonic()
    secular.identify(campaign, "two_mass_mode1", threads=1)
    took = time.monotonic() - begun
    done.set()
    thread.join()
    assert len(ticks) > 0.1 * took / 0.005


def test_models_by_name_and_by_text(program, tmp_path):
    model = secular.Model("two_mass_mode1")
    assert "principal_parametric" in model.cases and "two_mass_mode1" in secular.shipped_models()
    assert model.natural_frequencies == {"omega0": pytest.approx(77.85, rel=1e-3)}
    derivation = model.derive("principal_parametric")
    assert derivation.certified
    assert derivation.text == program("derive", "two_mass_mode1", "--case", "principal_parametric")
    assert derivation._repr_latex_().startswith("\\begin{align*}")
    text = ('schema = 1\nname = "plain"\n[[mode]]\ncoordinate = "x"\nfrequency = "omega0"\n'
            'equation = "D2(x) + omega0^2*x = -2*mu*D(x)"\n[[case]]\nname = "free"\nrelations = []\n'
            'order = { mu = 1 }\nexpand_to = 1\nexcitation = false\n')
    assert secular.Model(text).name == "plain"
    with pytest.raises(secular.InputError) as raised:
        secular.Model(text.replace("expand_to = 1", "expand_to = one"))
    assert raised.value.place.startswith("line 11")
    with pytest.raises(secular.InputError, match="shipped models: "):
        secular.Model("no_such_model")


def test_modulation_in_sympy():
    sympy = pytest.importorskip("sympy")
    rate = secular.derive("two_mass_mode1", "principal_parametric").modulation()["v"]
    mu1, amplitude = sympy.Symbol("mu1", real=True), sympy.Symbol("A_v")
    assert sympy.expand(rate).coeff(mu1) == -amplitude  # linear damping, to first order


def test_what_is_doubtful_is_so_for_a_reason_among_the_notices(campaign):
    found = secular.identify(campaign, "two_mass_mode1", fix={"mu1": 0.1})  # the truth is 0.22
    doubtful = [value for value in found.values if value.doubtful]
    reason, = [notice for notice in found.notices if notice.startswith("doubtful because the model does not fit: ")]
    assert doubtful and doubtful[0].name in reason
    assert all(value.why.startswith("doubtful: the model does not fit") for value in doubtful)
    assert doubtful[0].why in repr(found) and doubtful[0].fields["doubtful_because"][0] in doubtful[0].why


def test_errors_of_identify_name_arguments(campaign):
    for wrong, argument in (({"fix": {"zz": 1}}, "fix zz"), ({"case": "x"}, "case x"),
                            ({"by": "full-equations", "bootstrap": 5}, "bootstrap")):
        with pytest.raises(secular.InputError) as raised:
            secular.identify(campaign, "two_mass_mode1", **wrong)
        assert raised.value.file == argument and "--" not in str(raised.value)
