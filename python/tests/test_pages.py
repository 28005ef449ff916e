"""What the pages show runs as it stands there."""
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def blocks(page):
    return re.findall(r"```python\n(.*?)```", (ROOT / page).read_text(encoding="utf-8"), re.DOTALL)


def test_the_page_runs(tmp_path, monkeypatch, capsys):
    pytest.importorskip("matplotlib").use("agg")
    monkeypatch.chdir(tmp_path)
    names = {}
    for block in blocks("docs/python.md"):
        exec(compile(block, "docs/python.md", "exec"), names)
    assert names["result"]["mu1"].value == pytest.approx(0.222, rel=0.02)
    assert Path("response.png").stat().st_size > 1000 and Path("measured/campaign.toml").is_file()
    assert "no_gap" in capsys.readouterr().out
    assert Path("prediction.png").stat().st_size > 1000 and Path("plan.toml").is_file()


def test_the_readme_runs(tmp_path, monkeypatch, capsys):
    pytest.importorskip("matplotlib").use("agg")
    monkeypatch.chdir(tmp_path)
    (short,) = blocks("README.md")
    assert len(short.splitlines()) <= 10
    exec(compile(short, "README.md", "exec"), {})
    assert "mu1" in capsys.readouterr().out and Path("response.png").stat().st_size > 1000


def test_the_readme_shows_lines_of_the_page():
    (short,) = blocks("README.md")
    page = blocks("docs/python.md")[0].splitlines()
    assert [line for line in short.splitlines() if line] == [line for line in page if line in short and line]
