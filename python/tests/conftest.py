import os
import subprocess

import pytest
import secular


@pytest.fixture(scope="session")
def program():
    """Runs the program with arguments; its standard output."""
    def run(*arguments):
        done = subprocess.run([os.environ["SECULAR_PROGRAM"], *map(str, arguments)], capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        return done.stdout
    return run


@pytest.fixture(scope="session")
def campaign():
    """The virtual test of docs/python.md: 19 dwells near twice the natural frequency."""
    return secular.simulate("experiments/principal_parametric")


@pytest.fixture(scope="session")
def identification(campaign):
    return secular.identify(campaign, "two_mass_mode1")


@pytest.fixture(scope="session")
def folder(campaign, tmp_path_factory):
    return campaign.save(tmp_path_factory.mktemp("saved") / "principal_parametric")
