"""The notebooks of python/examples run, and find what was put into their data."""
import runpy
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"


def run(name, tmp_path, monkeypatch):
    pytest.importorskip("matplotlib").use("agg")
    monkeypatch.chdir(tmp_path)
    return runpy.run_path(str(EXAMPLES / name))


def test_own_data(tmp_path, monkeypatch):
    told = run("own_data.py", tmp_path, monkeypatch)
    result = told["result"]
    for symbol, truth in (("omega0", told["omega0"]), ("mu", told["mu"]), ("alpha", told["stiffening"])):
        assert abs(result[symbol].value - truth) < 4 * result[symbol].sd, symbol
    assert told["backbone"].frequency[-1] > told["backbone"].frequency[0]


def test_new_resonance_case(tmp_path, monkeypatch):
    told = run("new_resonance_case.py", tmp_path, monkeypatch)
    # Nayfeh and Mook (1979), (4.1.33): forced part of amplitude F/(omega0^2 - Omega^2), here with 8/9 omega0^2, and of
    # the modulation i (3 alpha/(2 omega0)) 2 Lambda^2 A, Lambda half of it, as a shift of frequency.
    values = told["values"]
    half = values["eta"] / (2 * values["omega0"]**2 * 8 / 9)
    terms = {tuple(sorted(term.powers.items())): term.value for term in told["numbers"].modulation["v"]}
    shift = terms[(("A_v", 1), ("F", 2))]
    assert shift == pytest.approx(1j * 3 * values["alpha"] * half**2 / values["omega0"])
    assert told["response"].complete and told["plan"].time_s <= 1200


def test_diagnosis(tmp_path, monkeypatch):
    told = run("diagnosis.py", tmp_path, monkeypatch)
    assert told["diagnosis"].verdict == "cause" and told["diagnosis"].cause == "cubic_damping"
    assert abs(told["damping"].coefficient - 36.87) < 4 * told["damping"].sd


def test_every_example_is_run_here_and_told_of():
    names = {path.stem for path in EXAMPLES.glob("*.py")}
    assert names == {name[len("test_"):] for name in globals() if name.startswith("test_")} - \
        {"every_example_is_run_here_and_told_of"}
    page = (EXAMPLES.parents[1] / "docs/python.md").read_text(encoding="utf-8")
    assert all(f"{name}.py" in page for name in names)
