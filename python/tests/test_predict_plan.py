"""Predictions, plans and evaluations: the program's numbers, and those of textbooks."""
import json
import math

import numpy as np
import pytest
import secular

DUFFING = """schema = 1
name = "plain_duffing"
[[mode]]
coordinate = "x"
frequency = "omega0"
equation = "D2(x) + omega0^2*x = -2*mu*D(x) - alpha*x^3 + eta*F*cos(Omega*t)"
[[case]]
name = "primary"
relations = ["Omega = omega0 + eps*sigma"]
order = { mu = 1, alpha = 1, eta = 1 }
expand_to = 1
[[case]]
name = "free"
relations = []
order = { mu = 1, alpha = 1 }
expand_to = 1
excitation = false
"""


def test_predict_is_the_program_s_bit_by_bit(program, folder, campaign, tmp_path):
    printed = json.loads(program("predict", "two_mass_mode1", "--case", "principal_parametric", "--parameters",
                                 "predictions/table_5_4", "--at", "F=22.5", "--vary", "Omega", "24.4", "25.1", "--hz",
                                 "--measured", folder, "--json", "-o", tmp_path / "out"))
    found = secular.predict("two_mass_mode1", "predictions/table_5_4", case="principal_parametric", at={"F": 22.5},
                            vary=("Omega", 24.4, 25.1), hz=True, measured=campaign)
    # Warnings name the campaign as it was named.
    assert {**found.data, "warnings": []} == {**printed, "warnings": []} and found.notices == found.data["warnings"]
    assert found.complete and found.modes == ["v"]
    assert found.to_csv() == (tmp_path / "out/prediction.csv").read_text()
    points = [point for branch in printed["branches"] for point in branch["points"]]
    assert np.array_equal(np.concatenate([branch.parameter for branch in found.branches]),
                          [point["Omega"] for point in points])
    assert len(found.measured) == sum(record.excitation_amplitude == 22.5 for record in campaign) > 5
    assert found.figures == ["response", "phases"]
    kinds = {special.kind for branch in found.branches for special in branch.special_points}
    assert "threshold" in kinds and "threshold" in found._repr_html_()
    assert found.to_html().startswith("<!")


def test_a_duffing_response_is_the_textbook_s():
    mu, alpha, omega0, force = 0.02, 3.0, 10.0, 0.5
    numbers = {"omega0": omega0, "mu": mu, "alpha": alpha, "eta": 1}
    found = secular.predict(DUFFING, numbers, case="primary", at={"F": force},
                            vary=("Omega", 9.95, 10.1))
    checked = 0
    for branch in found.branches:
        for frequency, (amplitude,) in zip(branch.parameter, branch.amplitude):
            # Nayfeh and Mook (1979), (4.1.19): (mu^2 + (sigma - 3 alpha a^2 / (8 omega0))^2) a^2 = F^2 / (4 omega0^2)
            left = (mu**2 + (frequency - omega0 - 3 * alpha * amplitude**2 / (8 * omega0))**2) * amplitude**2
            assert math.isclose(left, force**2 / (4 * omega0**2), rel_tol=1e-6)
            checked += 1
    assert checked > 20
    cut, = found.largest
    assert cut.kind == "range_end" and math.isclose(cut.parameter, 10.1)
    found = secular.predict(DUFFING, numbers, case="primary", at={"F": force}, vary=("Omega", 9.95, 10.3))
    top, = found.largest
    assert top.kind == "peak" and top.mode == "x" and top.amplitude_sd is None
    assert math.isclose(top.amplitude, force / (2 * mu * omega0), rel_tol=1e-12)
    assert math.isclose(top.parameter, omega0 + 3 * alpha * top.amplitude**2 / (8 * omega0), rel_tol=1e-10)
    assert "largest of x" in repr(found) and "largest of x" in found._repr_html_()
    backbone, = secular.predict(DUFFING, numbers, case="free", largest=0.5).backbones
    assert np.allclose(backbone.frequency, omega0 + 3 * alpha * backbone.amplitude**2 / (8 * omega0), rtol=1e-12)
    assert np.allclose(backbone.growth, -mu, rtol=1e-12) and backbone.amplitude[-1] == pytest.approx(0.5)


def test_parameters_of_an_identification_are_predicted_with(identification):
    found = secular.predict("two_mass_mode1", identification, case="principal_parametric", at={"F": 22.5},
                            vary=("Omega", 24.5, 25.0), hz=True)
    assert found.parameters["mu1"] == identification["mu1"].value
    assert any("does not identify" in notice for notice in found.notices)


def test_errors_of_predict_name_arguments():
    with pytest.raises(secular.InputError) as raised:
        secular.predict("two_mass_mode1", "predictions/table_5_4", case="principal_parametric")
    assert raised.value.file == "vary" and "--" not in str(raised.value)
    for wrong in ({"vary": ("Omega", 1)}, {"curve": "magic"}, {"sweep": "left"}, {"sweep_steps": 1}, {"largest": -1},
                  {"at": 3}):
        with pytest.raises(secular.InputError) as raised:
            secular.predict("two_mass_mode1", "predictions/table_5_4", **wrong)
        assert raised.value.file == next(iter(wrong))


def test_examples_in_errors_are_python(identification):
    def refusal(call, *arguments, **named):
        with pytest.raises(secular.InputError) as raised:
            call(*arguments, **named)
        assert not any(word in str(raised.value) for word in ("--", "NAME=VALUE", "LOW:HIGH", "FILE")), raised.value
        return raised.value

    numbers = ("two_mass_mode1", "predictions/table_5_4")
    sweep = dict(case="principal_parametric", vary=("Omega", 153.0, 157.0))
    assert 'vary=("Omega", 150, 160), against=("F", 5, 30), curve="saddle_node"' in \
        str(refusal(secular.predict, *numbers, curve="hopf", **sweep))
    assert "at={name: value}" in \
        str(refusal(secular.predict, *numbers, **sweep))
    assert "is missing" in str(refusal(secular.predict, *numbers, vary=("Omega", 153.0, 157.0)))
    assert "band_hz" in refusal(secular.predict, *numbers, at={"F": 22.5}, band_hz=(1, 2), **sweep).file
    assert refusal(planned, records="x*").file == "records"
    error = refusal(planned, frequency_hz=(-1, 25))
    assert error.fault == "is not positive" and error.remedy == "(low, high) in Hz, for example (24.4, 25.1)"
    for wrong in ({"wanted": []}, {"ensembles": []}, {"ensembles": 2.5}, {"ensembles": None},
                  {"criterion": np.array(["D", "A"])}):
        assert refusal(planned, **wrong).file == next(iter(wrong))
    assert planned(ensembles=np.int64(5)).status == "done"
    assert "mu" in refusal(secular.evaluate, DUFFING, "primary", {"mu": 10**400}).file


def test_every_special_point_is_listed_once_as_the_command_prints_them(program, tmp_path):
    printed = program("predict", "two_mass_mode1", "--case", "principal_parametric", "--parameters",
                      "predictions/table_5_4", "--at", "F=22.5", "--vary", "Omega", "24.4", "25.1", "--hz", "-o",
                      tmp_path / "out")
    found = secular.predict("two_mass_mode1", "predictions/table_5_4", case="principal_parametric", at={"F": 22.5},
                            vary=("Omega", 24.4, 25.1), hz=True)
    points = [point for branch in found.branches for point in branch.special_points]
    assert [line.split()[0] for line in printed.splitlines() if line.startswith("  ") and " Omega = " in line] == [
        point.fields.get("old_kind", point.kind) for point in points]  # people read "saddle-node"
    assert len(points) == sum(len(branch["special_points"]) for branch in found.data["branches"])
    assert [point.kind for point in points].count("saddle_node") == 1  # of two solutions that differ in phase alone
    outside = "(outside of the expansion's range)"
    assert repr(found).count(outside) == printed.count(outside) == sum(point.outside_expansion for point in points)


def test_figures_of_a_prediction(tmp_path):
    pytest.importorskip("matplotlib").use("agg")
    found = secular.predict(DUFFING, {"omega0": 10, "mu": 0.02, "alpha": 3, "eta": 1}, case="primary", at={"F": 0.5},
                            vary=("Omega", 9.95, 10.25))
    axes = found.plot().axes[0]
    peak = max(np.nanmax(line.get_ydata()) for line in axes.lines)
    assert peak == pytest.approx(0.5 / (2 * 10 * 0.02), rel=0.01)  # F / (2 omega0 mu)
    assert "Phase" in found.plot("phases").axes[0].get_ylabel()
    with pytest.raises(secular.InputError, match="response, phases"):
        found.plot("backbone")


def planned(**changed):
    arguments = dict(model="two_mass_mode1", parameters="predictions/table_5_4", wanted=["mu1", "mu3"],
                     case="principal_parametric", frequency_hz=(24.4, 25.1), amplitude=(10, 30), budget_s=600, least=4,
                     frequencies=5, levels=2)
    return secular.plan(**{**arguments, **changed})


def test_plan_is_the_program_s_bit_by_bit(program, tmp_path):
    out = tmp_path / "out"
    printed = json.loads(program("plan", "two_mass_mode1", "--case", "principal_parametric", "--parameters",
                                 "predictions/table_5_4", "--for", "mu1,mu3", "--range-frequency", "24.4:25.1",
                                 "--range-amplitude", "10:30", "--budget-s", "600", "--frequencies", "5", "--levels",
                                 "2", "--least", "4", "--json", "-o", out))
    found = planned()
    assert found.data == printed and found.to_toml() == (out / "plan.toml").read_text()
    assert [wanted.name for wanted in found.wanted] == ["mu1", "mu3"] and found.time_s <= 600
    assert found.time_s == sum(dwell.settle_s + 4 * dwell.ensembles for dwell in found.dwells)
    test = secular.simulate(found.save_experiment(tmp_path / "plan.toml"))
    assert len(test) == len(found.dwells)
    assert found.figures == ["dwells"] and "mu3" in repr(found)


def test_a_plan_from_an_estimate_has_its_units(identification):
    for wanted in planned(parameters=identification).wanted:
        assert wanted.unit == identification[wanted.name].unit


def test_a_plan_against_a_campaign_in_memory(campaign):
    few = secular.Campaign(campaign.channels, [campaign[r] for r in (3, 8)], time_step_s=campaign.time_step_s)
    held = planned(against=few)
    assert [(dwell.frequency_hz, dwell.amplitude) for dwell in held.in_use.dwells] == \
        [(record.excitation_frequency_hz, record.excitation_amplitude) for record in few]
    assert held.wanted[0].sd_in_use == held.in_use.sd["mu1"]


def test_errors_of_plan_name_arguments():
    with pytest.raises(secular.InputError) as raised:
        planned(frequency_hz=(25, 24))
    assert raised.value.file == "frequency_hz"
    with pytest.raises(secular.InputError) as raised:
        planned(budget_s=None)
    assert raised.value.file == "budget_s, against"
    stalled = planned(limit_s=1e-6)
    assert stalled.status == "failed" and stalled.programme is None
    assert "fewer frequencies, levels or ensembles" in stalled.reason and "with limit_s" in stalled.reason
    with pytest.raises(secular.NumericalFailure):
        stalled.to_json()


def test_evaluate_is_the_program_s_and_the_textbook_s(program, tmp_path):
    values = {"omega0": 10.0, "mu": 0.02, "alpha": 3.0, "eta": 1.0, "sigma": 0.1, "F": 0.5}
    (tmp_path / "duffing.toml").write_text(DUFFING)
    (tmp_path / "values.json").write_text(json.dumps(values))
    printed = program("evaluate", tmp_path / "duffing.toml", "--case", "primary", "--at", tmp_path / "values.json")
    found = secular.evaluate(DUFFING, "primary", values)
    assert found.to_json() == printed == secular.evaluate(DUFFING, "primary", tmp_path / "values.json").to_json()
    terms = {tuple(sorted(term.powers.items())): term.value for term in found.modulation["x"]}
    # dA/dt = -mu A + 3 i alpha A^2 conj(A) / (2 omega0) - i F exp(i sigma t) / (4 omega0)
    assert terms[(("A_x", 1),)] == pytest.approx(-0.02)
    assert terms[(("A_x", 2), ("conj_A_x", 1))] == pytest.approx(0.45j)
    assert terms[(("F", 1),)] == pytest.approx(-0.025j)
    assert "A_x^2" in found._repr_html_()
    with pytest.raises(secular.InputError, match="no value for symbol 'alpha'"):
        secular.evaluate(DUFFING, "primary", {"omega0": 10.0, "mu": 0.02, "eta": 1.0, "sigma": 0.1})
    assert any("nu" in notice for notice in
               secular.evaluate(DUFFING, "primary", {**values, "nu": 1.0}).notices)
