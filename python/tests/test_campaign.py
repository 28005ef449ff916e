"""Campaigns from arrays and folders, and back."""
import numpy as np
import pytest
import secular

CHANNELS = [secular.Channel("base", "excitation", "acceleration", "m/s^2"),
            secular.Channel("v", "response", "acceleration", "m/s^2")]


def small(channels=CHANNELS, samples=None, **described):
    if samples is None:
        samples = np.random.default_rng(3).normal(size=(2, 400))
    described = dict(dict(kind="dwell", excitation_frequency_hz=12.5), **described)
    return secular.Campaign(channels, [secular.Record(samples, **described)], time_step_s=1 / 128, name="small")


def test_simulate_writes_a_report_to_a_new_file_and_says_so_before_the_work(tmp_path):
    experiment, page = "experiments/pendulum_decay", tmp_path / "page.html"
    campaign = secular.simulate(experiment, seed=3, report=page)
    text = page.read_text(encoding="utf-8")
    assert text.startswith("<!") and "pendulum" in text and "<svg" in text and len(campaign) > 0
    assert "response" in campaign._repr_html_()
    for wrong in (page, tmp_path / "none" / "page.html", "", f"{tmp_path}/none/", 3):
        with pytest.raises(secular.InputError) as raised:
            secular.simulate("no such experiment", report=wrong)
        assert raised.value.file == "report", raised.value
    assert page.read_text(encoding="utf-8") == text


def test_arrays_come_back_bit_by_bit_also_from_a_folder(tmp_path):
    given = np.random.default_rng(3).normal(size=(2, 400))
    campaign = small(samples=given, start_s=2.5, group="one", excitation_amplitude=3.0)
    read = secular.Campaign.read(campaign.save(tmp_path / "small"))
    for same in (campaign, read):
        record = same[0]
        assert np.array_equal(record.samples, given)
        assert (record.kind, record.group, record.excitation_frequency_hz) == ("dwell", "one", 12.5)
        assert record.excitation_amplitude == 3.0
        assert same.time(0)[0] == 2.5 and np.isclose(same.time(0)[-1], 2.5 + 399 / 128)
        assert same.channels == CHANNELS and same.time_step_s == 1 / 128 and len(same) == 1
    with pytest.raises(secular.InputError, match="not an empty folder"):
        campaign.save(tmp_path / "small")
    campaign.save(tmp_path / "small", replace=True)


def test_only_a_campaign_is_replaced_and_never_what_is_read(tmp_path, monkeypatch):
    campaign = small()
    thesis = tmp_path / "thesis"
    thesis.mkdir()
    (thesis / "thesis.tex").write_text("all of it")
    with pytest.raises(secular.InputError, match="is no campaign"):
        campaign.save(thesis, replace=True)
    monkeypatch.chdir(thesis)
    with pytest.raises(secular.InputError, match="is no campaign"):
        campaign.save(".", replace=True)
    assert (thesis / "thesis.tex").read_text() == "all of it"
    saved = campaign.save(tmp_path / "saved")
    (saved / "notes.txt").write_text("mine")
    with pytest.raises(secular.InputError, match="holds notes.txt, which is no part of its campaign"):
        campaign.save(saved, replace=True)
    (saved / "notes.txt").unlink()
    read = secular.Campaign.read(saved)
    for place, how in ((saved, "is"), (saved / "inner", "lies inside"), (tmp_path, "contains")):
        with pytest.raises(secular.InputError, match=how + " the campaign that is read"):
            read.save(place, replace=True)
    assert np.array_equal(read[0].samples, campaign[0].samples)
    campaign.save(saved, replace=True)


def test_a_sample_that_was_not_measured_stays_so(tmp_path):
    given = np.random.default_rng(3).normal(size=(2, 400))
    given[1, 77] = np.nan
    given[:, 201:203] = np.nan
    campaign = small(samples=given)
    again = secular.Campaign.read(campaign.save(tmp_path / "a"))
    once_more = secular.Campaign.read(again.save(tmp_path / "b"))
    for same in (campaign, again, once_more):
        assert np.array_equal(same[0].samples, given, equal_nan=True)
    file = tmp_path / "a" / "records" / "0001.csv"
    lines = file.read_text().splitlines(keepends=True)
    del lines[51]  # a row that the file does not hold
    file.write_text("".join(lines))
    gappy = secular.Campaign.read(tmp_path / "a")
    gappy.save(tmp_path / "c")
    assert (tmp_path / "c" / "records" / "0001.csv").read_text() == file.read_text()
    assert np.isnan(gappy[0].samples[:, 50]).all()


def test_masked_samples_are_not_measured():
    given = np.random.default_rng(3).normal(size=(2, 400))
    masked = np.ma.masked_array(given, mask=np.zeros(given.shape, bool))
    masked[1, 77] = np.ma.masked
    for form in (masked, [masked[0], masked[1]]):
        found = small(samples=form)[0].samples
        assert np.isnan(found[1, 77]) and np.isnan(found).sum() == 1
    counts = np.ma.masked_array((1000 * given).astype(int), mask=masked.mask)
    assert np.isnan(small(samples=counts)[0].samples[1, 77])


@pytest.mark.parametrize("kind", ["complex128", "datetime64[s]", "str", "object", "bool"])
def test_samples_that_are_no_real_numbers_are_refused(kind):
    given = (1000 * np.random.default_rng(3).normal(size=(2, 400))).astype(int).astype(kind)
    with pytest.raises(secular.InputError, match="record 1, samples: are no real numbers: dtype") as raised:
        small(samples=given)
    assert str(given.dtype) in raised.value.fault


def test_a_gap_is_named_by_record_channel_and_sample():
    whole = np.random.default_rng(3).normal(size=(2, 400))
    for number, sample in ((1, 3), (1, 8), (2, 8), (2, 150)):
        gap = whole.copy()
        gap[1, sample:sample + 40] = np.nan
        gap[1, 1] = 0.5
        records = [secular.Record(gap if r == number else whole, "dwell", 12.5 + r) for r in (1, 2)]
        with pytest.raises(secular.InputError) as raised:
            secular.Campaign(CHANNELS, records, time_step_s=1 / 128)
        assert raised.value.place == f"record {number}, channel v, samples[1, {sample}]"
        assert "40 in a row" in str(raised.value)


@pytest.mark.parametrize("given, said", [
    (np.zeros((2, 0)), "hold 0 of every channel"), (np.zeros((400, 2)), "transposed"),
    (np.zeros(400), "1 dimensions"), ([np.zeros(4), np.zeros(5)], "several lengths"), (None, "dtype object")])
def test_arrays_of_a_wrong_shape_are_refused(given, said):
    with pytest.raises(secular.InputError, match="record 1, samples: .*" + said):
        secular.Campaign(CHANNELS, [secular.Record(given, "broadband")], time_step_s=1 / 128)


def test_arguments_of_a_wrong_type_are_named():
    for wrong in ({"start_s": None}, {"excitation_frequency_hz": "12"}, {"excitation_amplitude": np.nan},
                  {"kind": 3}, {"group": None}, {"file": 1}):
        (name,) = wrong
        with pytest.raises(secular.InputError) as raised:
            small(**wrong)
        assert raised.value.file == f"record 1, {name}" and "give a" in raised.value.remedy
    good = secular.Record(np.zeros((2, 400)), "broadband")
    for step in ("a", None, np.nan, 0):
        with pytest.raises(secular.InputError, match="^time_step_s: "):
            secular.Campaign(CHANNELS, [good], time_step_s=step)
    with pytest.raises(secular.InputError, match="^channels: "):
        secular.Campaign(["base", "v"], [good], time_step_s=1)
    with pytest.raises(secular.InputError, match="^records: "):
        secular.Campaign(CHANNELS, good, time_step_s=1)
    with pytest.raises(secular.InputError, match="^channel 2, name: has halves of characters"):
        small(channels=[CHANNELS[0], secular.Channel("v\ud800", "response", "acceleration", "m/s^2")])
    with pytest.raises(secular.InputError, match="^channel 2, unit: "):
        small(channels=[CHANNELS[0], secular.Channel("v", "response", "acceleration", 1)])


def test_what_is_wrong_is_named_with_its_place():
    with pytest.raises(secular.InputError) as raised:
        small(channels=[CHANNELS[0], secular.Channel("v", "response", "acceleration", "parsec")])
    assert raised.value.place == "channel 2, key unit" and "parsec" in raised.value.fault
    with pytest.raises(secular.InputError) as raised:
        small(kind="dwel")
    assert raised.value.place == "record 1, key kind" and "free_decay" in raised.value.remedy
    with pytest.raises(secular.InputError, match="half the sample rate"):
        small(excitation_frequency_hz=64.0)
    with pytest.raises(secular.InputError) as raised:
        small(samples=np.zeros((3, 400)))
    assert "3 channels" in raised.value.fault and "2" in raised.value.remedy
    with pytest.raises(secular.InputError, match="does not exist"):
        secular.Campaign.read("nowhere")
