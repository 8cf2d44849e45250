"""pip in a home: what it installs is for the programs of that home, and day6-tui's own packages stay as they are."""

from __future__ import annotations

import os
import sys
import zipfile
from pathlib import Path
from typing import Any

import pytest

from day6_core.ros import home_python, pip_of_home
from day6_core.ros.executables import python_words
from day6_core.ros.home_python import BELOW_HOME, interpreter_of, packages_of, python_of, scripts_of

pytestmark = pytest.mark.skipif(os.name != "posix", reason="written for Unix's folders")


def wheel(folder: Path, name: str, version: str, code: str) -> None:
    """Write a package that pip can install offline; its module has `say`, which is a command, too."""
    about = f"{name}-{version}.dist-info"
    files = {
        f"{name}/__init__.py": code,
        f"{about}/METADATA": f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n",
        f"{about}/WHEEL": "Wheel-Version: 1.0\nGenerator: day6\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
        f"{about}/entry_points.txt": f"[console_scripts]\n{name}-say = {name}:say\n",
        f"{about}/RECORD": "",
    }
    with zipfile.ZipFile(folder / f"{name}-{version}-py3-none-any.whl", "w") as archive:
        for path, text in files.items():
            archive.writestr(path, text)


@pytest.fixture
def wheels(tmp_path: Path) -> str:
    """The options with which pip finds `toy`, and a numpy that would break day6-tui."""
    folder = tmp_path / "wheels"
    folder.mkdir()
    wheel(folder, "toy", "1.0", "def say(): print('toy', __file__)\n")
    wheel(folder, "numpy", "0.0.1", "__version__ = '0.0.1'\n")
    return f"-q --disable-pip-version-check --no-index --find-links {folder}"


# -- with the real pip ---------------------------------------------------------------------------------------------------


@pytest.mark.process
def test_what_pip_installs_is_for_the_programs_of_the_home_only(machine: Any, wheels: str) -> None:
    pytest.importorskip("pip")
    import numpy

    own = numpy.__version__
    packages = packages_of(machine.desk.home / BELOW_HOME)
    first = machine.run(f"pip install --user {wheels} toy")
    said = "What pip installs here is kept in ~/.local/lib/day6-tui/{}: for the programs of this home, not for day6-tui itself.\n"
    assert (first.status, first.err) == (0, said.format(BELOW_HOME.name))
    assert machine.run(f"python3 -m pip install {wheels} numpy==0.0.1").status == 0  # and nothing is said again
    look = "python3 -c 'import numpy, toy, rclpy, std_msgs.msg; print(numpy.__version__); toy.say()'"
    told = f"0.0.1\ntoy {packages}/toy/__init__.py\n"
    assert machine.run(look) == (0, told, "")
    assert machine.run(f'/bin/sh -c "{look}"') == (0, told, "")
    assert machine.run("toy-say").out == f"toy {packages}/toy/__init__.py\n"
    listed = machine.run("pip list --disable-pip-version-check").out.split()
    assert listed[listed.index("toy") + 1] == "1.0" and "day6-tui" in listed
    assert machine.run("pip uninstall -q -y numpy toy").status == 0
    assert machine.run("python3 -c 'import numpy; print(numpy.__version__)'").out == f"{own}\n"
    refused = machine.run("pip uninstall -y numpy").out
    assert "outside environment" in refused and "Can't uninstall 'numpy'" in refused
    assert not (Path(packages_of(Path(sys.prefix))) / "toy").exists()


@pytest.mark.process
def test_uninstalling_first_removes_nothing_of_day6_tui(machine: Any) -> None:
    pytest.importorskip("pip")
    refused = machine.run("pip uninstall -y numpy")
    assert "outside environment" in refused.out and "kept in" in refused.err
    assert machine.run("pip install --no-index --disable-pip-version-check nosuch").err.startswith(
        "ERROR: Could not find a version"
    )


@pytest.mark.process
def test_a_venv_that_the_user_has_activated_goes_first(machine: Any, wheels: str) -> None:
    pytest.importorskip("pip")
    home = machine.desk.home
    machine.run("python3 -m venv --without-pip own && source own/bin/activate")
    assert machine.run("which python3").out == f"{home}/own/bin/python3\n"
    lines = "import rclpy, std_msgs.msg, sys; print(sys.prefix)"
    assert machine.run(f'python3 -c "{lines}"') == (0, f"{home}/own\n", "")
    assert machine.run(f"pip install {wheels} toy") == (0, "", "")
    assert machine.run("toy-say").out == f"toy {packages_of(home / 'own')}/toy/__init__.py\n"
    assert not (home / BELOW_HOME).exists()
    assert machine.run("deactivate; python3 -c 'import sys; print(sys.prefix)'").out == f"{sys.prefix}\n"
    assert "No module named 'toy'" in machine.run("python3 -c 'import toy'").err


# -- without a process ---------------------------------------------------------------------------------------------------


def made(environment: Path) -> Path:
    """Make what stands for an environment; its Python is ours."""
    packages_of(environment).mkdir(parents=True)
    scripts_of(environment).mkdir(parents=True, exist_ok=True)
    interpreter_of(environment).symlink_to(sys.executable)
    home_python.add_line(environment)
    return environment


def test_the_python_of_a_program_is_the_venvs_then_the_homes_then_ours(tmp_path: Path) -> None:
    variables = {"HOME": str(tmp_path), "PATH": "/usr/bin"}
    assert python_of(variables) == sys.executable
    home = made(tmp_path / BELOW_HOME)
    assert python_of(variables) == str(interpreter_of(home))
    own = made(tmp_path / "own")
    (packages_of(own) / home_python.LINE_FILE).unlink()
    variables["VIRTUAL_ENV"] = str(own)
    assert python_of(variables) == str(interpreter_of(home))  # `deactivate` took it from PATH
    variables["PATH"] = f"{scripts_of(own)}:/usr/bin"
    assert python_of(variables) == str(interpreter_of(own))
    assert (packages_of(own) / home_python.LINE_FILE).read_text() == home_python.LINE
    variables["VIRTUAL_ENV"] = sys.prefix  # day6-tui's own, from which it was started
    variables["PATH"] = str(scripts_of(Path(sys.prefix)))
    assert python_of(variables) == str(interpreter_of(home))


def test_an_environment_whose_python_is_gone_is_none(tmp_path: Path) -> None:
    home = made(tmp_path / BELOW_HOME)
    interpreter_of(home).unlink()
    interpreter_of(home).symlink_to(tmp_path / "gone")
    assert python_of({"HOME": str(tmp_path)}) == sys.executable


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["-m", "pip", "install", "x"], ["-m", "day6_core.ros.pip_of_home", "install", "x"]),
        (["setup.py", "develop"], ["-m", "day6_core.ros.pip_of_home", "--then", "setup.py", "develop"]),
        (["setup.py", "--version"], ["setup.py", "--version"]),
        (["install.py", "install"], ["install.py", "install"]),
        (["-m", "pipx"], ["-m", "pipx"]),
        ([], []),
    ],
)
def test_pip_and_what_installs_goes_by_the_module_that_keeps_them_apart(
    tmp_path: Path, words: list[str], told: list[str]
) -> None:
    assert python_words(words, {"HOME": str(tmp_path)}) == [sys.executable, *told]


@pytest.mark.parametrize(
    ("line", "changes"),
    [
        ("install x", True), ("-q install -r r.txt", True), ("uninstall -y x", True), ("install --help", False),
        ("list", False), ("download x", False), ("--version", False), ("", False), ("show install", False),
    ],
)  # fmt: skip
def test_only_what_changes_packages_makes_an_environment(line: str, changes: bool) -> None:
    assert pip_of_home.changes(line.split()) is changes


@pytest.mark.parametrize(
    ("missing", "language", "told"),
    [
        ("venv", "en", "has no module venv, which keeps your packages apart"),
        ("venv", "zh", "没有 venv 模块"),
        ("pip", "en", "has no pip. Install it in a real terminal: sudo apt install python3-venv python3-pip"),
        ("pip", "zh", "没有 pip。请在真正的终端里安装：sudo apt install python3-venv python3-pip"),
        ("uv", "en", "has no pip. Install it in a real terminal: uv pip install --python"),
        ("room", "en", "~/.local/lib/day6-tui/{version} cannot be made: Not a directory"),
        ("room", "zh", "没法建立 ~/.local/lib/day6-tui/{version}：Not a directory"),
    ],
)
def test_what_is_missing_is_said_in_one_sentence(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    missing: str,
    language: str,
    told: str,
) -> None:
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("DAY6_LANG", language)
    monkeypatch.delenv("VIRTUAL_ENV", raising=False)
    monkeypatch.setattr(sys, "argv", ["pip", "install", "x"])
    monkeypatch.setattr(pip_of_home, "_has_pip", lambda python: False)
    monkeypatch.setattr(pip_of_home.importlib.util, "find_spec", lambda name: None)
    monkeypatch.setattr(pip_of_home.shutil, "which", lambda name: "/bin/uv" if missing == "uv" else None)
    if missing == "venv":
        monkeypatch.setitem(sys.modules, "venv", None)
    elif missing == "room":
        (tmp_path / ".local").write_text("a file")
    else:
        made(tmp_path / BELOW_HOME)
    assert pip_of_home.main() == 1
    err = capsys.readouterr().err
    assert told.format(version=BELOW_HOME.name) in err and len(err.splitlines()) == 1
