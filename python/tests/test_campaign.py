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


def test_a_sample_that_was_not_measured_stays_so():
    given = np.random.default_rng(3).normal(size=(2, 400))
    given[1, 77] = np.nan
    record = small(samples=given)[0]
    assert np.array_equal(record.samples, given, equal_nan=True)


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
