"""What the pages show runs as it stands there."""
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def blocks(page):
    return re.findall(r"```python\n(.*?)```", (ROOT / page).read_text(encoding="utf-8"), re.DOTALL)


def run(text, page, names):
    exec(compile(text, page, "exec"), names)


def test_the_readme_runs_and_then_what_the_page_has_beyond_it(tmp_path, monkeypatch, capsys):
    pytest.importorskip("matplotlib").use("agg")
    monkeypatch.chdir(tmp_path)
    (short,) = blocks("README.md")
    assert len(short.splitlines()) <= 10
    names = {}
    run(short, "README.md", names)
    assert "mu1" in capsys.readouterr().out and Path("response.png").stat().st_size > 1000
    first, *others = blocks("docs/python.md")
    run("\n".join(line for line in first.splitlines() if line not in short), "docs/python.md", names)
    for block in others:
        run(block, "docs/python.md", names)
    assert names["result"]["mu1"].value == pytest.approx(0.222, rel=0.02)
    assert Path("measured/campaign.toml").is_file() and "no_gap" in capsys.readouterr().out
    assert Path("prediction.png").stat().st_size > 1000 and Path("plan.toml").is_file()


def test_the_readme_shows_lines_of_the_page():
    (short,) = blocks("README.md")
    page = blocks("docs/python.md")[0].splitlines()
    assert [line for line in short.splitlines() if line] == [line for line in page if line in short and line]
