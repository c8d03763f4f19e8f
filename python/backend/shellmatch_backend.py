"""Makes a wheel of the Python package by CMake: the build backend of pyproject.toml (PEP 517, PEP 660).

It needs the standard library alone.

The module is built in build/python, which a second call finds again. Settings of pip's:
    --config-settings=preset=release       another preset of CMakePresets.json: what scripts/build has built is not built again
    --config-settings=cmake=-DKEY=VALUE    one argument for CMake
"""

import base64
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tomllib
import zipfile

root = pathlib.Path(__file__).resolve().parents[2]


class UnsupportedOperation(Exception):
    """What PEP 517 asks for where a hook is not offered."""


def _project():
    with open(root / "pyproject.toml", "rb") as file:
        project = tomllib.load(file)["project"]
    project["version"] = re.search(r"project\(shellmatch VERSION ([0-9.]+)", (root / "CMakeLists.txt").read_text())[1]
    return project


def _tag(platform=None):
    version = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{version}-{version}-{platform or sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def _run(*command):
    print("+", *command, flush=True)
    try:
        subprocess.run(command, cwd=root, check=True)
    except subprocess.CalledProcessError as error:
        raise SystemExit(f"shellmatch: {command[0]} failed (exit code {error.returncode}), see above") from None


def _build(settings):
    """The folder with the built package."""
    settings = settings or {}
    for key in settings:
        if key not in ("preset", "cmake"):
            raise SystemExit(f"shellmatch: the setting {key!r} is unknown; there are preset and cmake")
    for tool in ("cmake", "ninja"):
        if shutil.which(tool) is None:
            raise SystemExit(
                f"shellmatch: {tool} is missing; scripts/install-dependencies --python installs what the build needs"
            )
    header = pathlib.Path(sysconfig.get_path("include"), "Python.h")
    if not header.exists():
        raise SystemExit(
            f"shellmatch: {sys.executable} cannot build modules: there is no {header}; make the environment with a Python that can: "
            "/usr/bin/python3 -m venv --system-site-packages my-env, after scripts/install-dependencies --python"
        )
    preset = settings.get("preset", "python")
    arguments = ["-DSHELLMATCH_PYTHON=ON"]
    if preset == "python":  # other presets keep their interpreter, which tests may use
        arguments.append(f"-DPython_EXECUTABLE={getattr(sys, '_base_executable', sys.executable)}")
    if "cmake" in settings:
        given = settings["cmake"]
        arguments += [given] if isinstance(given, str) else given
    _run("cmake", "--preset", preset, *arguments)
    _run("scripts/build", preset, "shellmatch_python")
    package = root / "build" / preset / "python" / "shellmatch"
    module = package / f"_core{sysconfig.get_config_var('EXT_SUFFIX')}"
    if not module.exists():
        raise SystemExit(f"shellmatch: build/{preset} is for another Python than {sys.executable}; leave the setting preset out")
    return package


def _metadata(project):
    lines = [
        "Metadata-Version: 2.1",
        f"Name: {project['name']}",
        f"Version: {project['version']}",
        f"Summary: {project['description']}",
        f"License: {project['license']['text']}",
    ]
    lines += [f"Requires-Python: {project['requires-python']}"]
    lines += [f"Requires-Dist: {name}" for name in project["dependencies"]]
    return "\n".join(lines) + "\n"


def _info(project, tag):
    """The files of the folder .dist-info but RECORD."""
    folder = f"{project['name']}-{project['version']}.dist-info"
    wheel = f"Wheel-Version: 1.0\nGenerator: shellmatch_backend\nRoot-Is-Purelib: false\nTag: {tag}\n"
    return folder, [(f"{folder}/METADATA", _metadata(project).encode()), (f"{folder}/WHEEL", wheel.encode())]


def write_wheel(folder, files, platform=None):
    """Writes a wheel of these files, (name, bytes), for this machine or another platform."""
    project = _project()
    tag = _tag(platform)
    info, own = _info(project, tag)
    files = files + own
    record = ""
    name = f"{project['name']}-{project['version']}-{tag}.whl"
    with zipfile.ZipFile(pathlib.Path(folder) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, contents in files:
            digest = base64.urlsafe_b64encode(hashlib.sha256(contents).digest()).rstrip(b"=").decode()
            record += f"{path},sha256={digest},{len(contents)}\n"
            _add(wheel, path, contents)
        _add(wheel, f"{info}/RECORD", f"{record}{info}/RECORD,,\n".encode())
    return name


def _add(wheel, path, contents):
    entry = zipfile.ZipInfo(path)  # of 1980: the same sources make the same wheel
    entry.compress_type = zipfile.ZIP_DEFLATED
    entry.external_attr = 0o644 << 16
    wheel.writestr(entry, contents)


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    folder, files = _info(_project(), _tag())
    (pathlib.Path(metadata_directory) / folder).mkdir()
    for name, contents in files:
        (pathlib.Path(metadata_directory) / name).write_bytes(contents)
    return folder


prepare_metadata_for_build_editable = prepare_metadata_for_build_wheel


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    package = _build(config_settings)
    module = f"_core{sysconfig.get_config_var('EXT_SUFFIX')}"
    names = sorted(
        path.name
        for path in (root / "python" / "shellmatch").iterdir()
        if path.suffix in (".py", ".pyi") or path.name == "py.typed"
    )
    return write_wheel(wheel_directory, [(f"shellmatch/{name}", (package / name).read_bytes()) for name in names + [module]])


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    folder = os.fspath(_build(config_settings).parent)
    return write_wheel(wheel_directory, [("shellmatch.pth", f"{folder}\n".encode())])


def build_sdist(sdist_directory, config_settings=None):
    raise UnsupportedOperation("shellmatch is built from a checkout; git archive makes an archive of it")
