"""The build backend of pyproject.toml (PEP 517): CMake builds the module, this puts it into a wheel.

It needs nothing but Python, CMake and what the library is built with. Settings, as in
`pip install --config-settings build-dir=build/release .`: build-dir, a build tree to use or to make (build/wheel without
it; one that is there is built as it was configured); cmake-args, further arguments of a new one.
"""

import base64
import hashlib
import importlib.util
import os
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import zipfile
from pathlib import Path

# Whoever imports a backend out of a source tree leaves its byte code there: that goes again.
_BYTE_CODE = Path(importlib.util.cache_from_source(__file__))
if _BYTE_CODE.is_file():
    _BYTE_CODE.unlink()
    if not any(_BYTE_CODE.parent.iterdir()):
        _BYTE_CODE.parent.rmdir()

SOURCE = Path(__file__).resolve().parents[2]
SUMMARY = "Multiple-scales models that compile into parameter estimators for nonlinear vibration tests"


def _version():
    text = (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(secular VERSION ([\d.]+)", text)[1]


def _metadata():
    return (f"Metadata-Version: 2.1\nName: secular\nVersion: {_version()}\nSummary: {SUMMARY}\n"
            "Requires-Python: >=3.9\nRequires-Dist: numpy\n")


def _tag():
    python = "cp{}{}".format(*sys.version_info[:2])
    return f"{python}-{python}-" + re.sub(r"[-.]", "_", sysconfig.get_platform())


def _run(*command):
    subprocess.run([str(part) for part in command], check=True, stdout=sys.stderr)


def _build(settings):
    """Builds the module; the build tree."""
    tree = Path(settings.get("build-dir", SOURCE / "build/wheel")).absolute()
    if not (tree / "CMakeCache.txt").exists():
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []
        _run("cmake", "-S", SOURCE, "-B", tree, *generator, "-DCMAKE_BUILD_TYPE=Release", "-DSECULAR_BUILD_PYTHON=ON",
             "-DSECULAR_BUILD_TESTS=OFF", f"-DPython_EXECUTABLE={sys.executable}",
             *shlex.split(settings.get("cmake-args", "")))
    _run("cmake", "--build", tree, "--target", "secular_python", "--parallel", os.cpu_count() or 1)
    return tree


def _stage(tree, folder):
    """The package as it stands in a wheel: with models and headers of generated code, which it finds beside itself."""
    _run("cmake", "--install", tree, "--component", "python", "--prefix", folder / "python")
    package = folder / "wheel/secular"
    module, = (folder / "python").rglob("_core.*.so")
    if not module.name.endswith(sysconfig.get_config_var("EXT_SUFFIX")):
        raise SystemExit(f"{tree}: builds for another Python than {sys.executable}; give another build-dir")
    shutil.copytree(module.parent, package)
    _run("cmake", "--install", tree, "--component", "wheel", "--prefix", package)
    return folder / "wheel"


def _describe(info):
    info.mkdir(parents=True)
    (info / "METADATA").write_text(_metadata(), encoding="utf-8")
    (info / "WHEEL").write_text(f"Wheel-Version: 1.0\nGenerator: secular_wheel\nRoot-Is-Purelib: false\nTag: {_tag()}\n",
                                encoding="utf-8")
    shutil.copy(SOURCE / "LICENSE", info)


def _pack(folder, info, file):
    record = []
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as wheel:
        for path in sorted(path for path in folder.rglob("*") if path.is_file()):
            name = path.relative_to(folder).as_posix()
            digest = base64.urlsafe_b64encode(hashlib.sha256(path.read_bytes()).digest()).rstrip(b"=").decode()
            record.append(f"{name},sha256={digest},{path.stat().st_size}")
            wheel.write(path, name)
        name = f"{info}/RECORD"
        wheel.writestr(name, "\n".join([*record, f"{name},,", ""]))


def get_requires_for_build_wheel(config_settings=None):
    return []


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    info = f"secular-{_version()}.dist-info"
    _describe(Path(metadata_directory) / info)
    return info


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    name, info = f"secular-{_version()}-{_tag()}.whl", f"secular-{_version()}.dist-info"
    with tempfile.TemporaryDirectory() as place:
        folder = _stage(_build(config_settings or {}), Path(place))
        _describe(folder / info)
        _pack(folder, info, Path(wheel_directory) / name)
    return name
