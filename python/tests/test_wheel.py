"""`pip install --no-build-isolation .` into a virtual environment that sees the system's packages."""
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import secular

SOURCE = Path(__file__).resolve().parents[2]
SCRIPT = """
from pathlib import Path
import secular
package = Path(secular.__file__).parent
assert str(package).startswith({place!r}), package
assert (package / "share/secular/models/two_mass_mode1.toml").is_file()
assert (package / "include/secular/estimator/model/compiled_model.hpp").is_file()
result = secular.identify(secular.simulate("experiments/principal_parametric"), "two_mass_mode1")
print(result["mu1"].value)
"""


def test_the_backend_leaves_no_byte_code(tmp_path):
    shutil.copy(SOURCE / "python/packaging/secular_wheel.py", tmp_path)
    bare = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    subprocess.run([sys.executable, "-c", "import secular_wheel"], cwd=tmp_path, env=bare, check=True)
    assert [file.name for file in tmp_path.iterdir()] == ["secular_wheel.py"]


def test_a_wheel_is_installed_and_works_by_itself(tmp_path, identification):
    pytest.importorskip("venv")
    pytest.importorskip("pip")  # the system's, which the environment sees
    tree = Path(secular.__file__).absolute().parents[2]
    if not (tree / "CMakeCache.txt").exists():
        pytest.skip("the package under test does not stand in a build tree")
    subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", "--without-pip", tmp_path / "venv"],
                   check=True)
    python = tmp_path / "venv/bin/python"
    bare = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "SECULAR"))}
    subprocess.run([python, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps", "--no-build-isolation",
                    "--config-settings", f"build-dir={tree}", SOURCE], check=True, env=bare)
    done = subprocess.run([python, "-c", SCRIPT.format(place=str(tmp_path))], env=bare, cwd=tmp_path, check=True,
                          capture_output=True, text=True)
    assert float(done.stdout) == identification["mu1"].value
