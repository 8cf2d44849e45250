"""A folder that installs day6-tui without internet. pip is played by a stand-in here; `try_offline.py` asks the real one."""

from __future__ import annotations

import hashlib
import subprocess
import sys
import zipfile
from collections.abc import Sequence
from pathlib import Path

import pytest

from day6_tui.tui.wheelhouse import closure, command, folder, own_wheel
from day6_tui.tui.wheelhouse.targets import PLATFORMS, Target, this_platform


def wheel_of(place: Path, name: str, version: str, *requires: str) -> Path:
    place.mkdir(parents=True, exist_ok=True)
    path = place / f"{name}-{version}-py3-none-any.whl"
    with zipfile.ZipFile(path, "w") as packed:
        lines = [
            f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}",
            *(f"Requires-Dist: {each}" for each in requires),
        ]
        packed.writestr(f"{name}-{version}.dist-info/METADATA", "\n".join(lines) + "\n")
    return path


class Index:
    """Stands in for pip and its index: the newest wheel that the specifier allows."""

    def __init__(self, place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.place, self.asked = place, list[str]()
        monkeypatch.setattr(closure.subprocess, "run", self.run)

    def run(self, words: Sequence[str], **_: object) -> subprocess.CompletedProcess[str]:
        from packaging.requirements import Requirement
        from packaging.utils import parse_wheel_filename

        wanted = Requirement(words[-1])
        self.asked.append(words[-1])
        fitting = [
            (parse_wheel_filename(path.name)[1], path)
            for path in self.place.glob(f"{wanted.name.replace('-', '_')}-*.whl")
            if wanted.specifier.contains(parse_wheel_filename(path.name)[1])
        ]
        if not fitting:
            return subprocess.CompletedProcess(words, 1, "", f"ERROR: No matching distribution found for {words[-1]}\n")
        path = max(fitting)[1]
        (Path(words[words.index("--dest") + 1]) / path.name).write_bytes(path.read_bytes())
        return subprocess.CompletedProcess(words, 0, "", "")


@pytest.fixture
def index(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Index:
    return Index(tmp_path / "index", monkeypatch)


def needed(index: Index, tmp_path: Path, wheel: Path, platform: str, python: str = "3.12", *extras: str) -> set[str]:
    place = tmp_path / f"for-{platform}-{python}"
    place.mkdir(exist_ok=True)
    target = Target(PLATFORMS[platform], python)
    found = closure.fetch(wheel, extras, target, place, lambda line: None)
    assert found <= {path.name for path in place.iterdir()}
    return {name.split("-")[0] for name in found}


def test_markers_are_judged_for_the_other_machine(index: Index, tmp_path: Path) -> None:
    wheel_of(index.place, "colours", "1.0", "wincon; sys_platform == 'win32'", "old; python_version < '3.11'")
    for name in ("wincon", "old", "web", "cable"):
        wheel_of(index.place, name, "1.0")
    own = wheel_of(tmp_path, "own", "1.0", "Colours>=1", "web; extra == 'serve'", "cable[fast]; extra == 'serve'")
    assert needed(index, tmp_path, own, "linux-x86_64") == {"colours"}
    assert needed(index, tmp_path, own, "windows-x86_64") == {"colours", "wincon"}
    assert needed(index, tmp_path, own, "macos-arm64", "3.10") == {"colours", "old"}
    assert needed(index, tmp_path, own, "linux-aarch64", "3.12", "serve") == {"colours", "web", "cable"}


def test_a_version_that_somebody_else_forbids_is_replaced(index: Index, tmp_path: Path) -> None:
    wheel_of(index.place, "base", "1.0")
    wheel_of(index.place, "base", "2.0", "strange")
    wheel_of(index.place, "picky", "1.0", "base<2")
    wheel_of(index.place, "strange", "1.0")
    own = wheel_of(tmp_path, "own", "1.0", "base", "picky")
    assert needed(index, tmp_path, own, "linux-x86_64") >= {"base", "picky"}
    assert any(each.startswith("base<2") for each in index.asked)


def test_circles_end_and_what_is_missing_is_named(index: Index, tmp_path: Path) -> None:
    wheel_of(index.place, "one", "1.0", "two")
    wheel_of(index.place, "two", "1.0", "one[more]")
    assert needed(index, tmp_path, wheel_of(tmp_path, "own", "1.0", "one"), "linux-x86_64") == {"one", "two"}
    with pytest.raises(closure.FetchError, match="No matching distribution found for nowhere"):
        needed(index, tmp_path, wheel_of(tmp_path, "own", "2.0", "nowhere"), "linux-x86_64")


def test_a_folder_is_filled_again_and_nothing_foreign_is_touched(tmp_path: Path) -> None:
    stick, place = tmp_path / "stick", tmp_path / "place"
    first, second = wheel_of(place, "a", "1.0"), wheel_of(place, "a", "2.0")
    folder.fill(stick, [first], {folder.GUIDE: "read me", folder.CHECK: folder.CHECKER})
    folder.fill(stick, [second], {folder.GUIDE: "read me too", folder.CHECK: folder.CHECKER})
    assert {path.name for path in stick.iterdir()} == {second.name, folder.GUIDE, folder.CHECK, folder.SUMS}
    lines = (stick / folder.SUMS).read_text(encoding="utf-8").splitlines()
    assert f"{hashlib.sha256(second.read_bytes()).hexdigest()}  {second.name}" in lines and len(lines) == 3

    (stick / "holiday.jpg").write_bytes(b"x")
    with pytest.raises(folder.NotOurs, match=r"holiday\.jpg"):
        folder.fill(stick, [first], {})
    (stick / "holiday.jpg").unlink()
    (stick / folder.GUIDE).write_text("my own notes", encoding="utf-8")
    with pytest.raises(folder.NotOurs, match=folder.GUIDE):
        folder.fill(stick, [first], {})
    assert (stick / folder.GUIDE).read_text(encoding="utf-8") == "my own notes" and (stick / second.name).exists()


def test_the_check_on_the_stick_finds_what_was_damaged_on_the_way(tmp_path: Path) -> None:
    stick = tmp_path / "stick"
    folder.fill(stick, [wheel_of(tmp_path, "a", "1.0")], {folder.CHECK: folder.CHECKER})

    def check() -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [sys.executable, str(stick / folder.CHECK)], capture_output=True, encoding="utf-8", cwd="/"
        )

    assert check().returncode == 0
    with open(next(stick.glob("*.whl")), "r+b") as file:
        file.write(b"?")
    assert check().returncode == 1 and "a-1.0" in check().stdout


def test_the_wheel_of_an_installed_day6_holds_what_was_installed(tmp_path: Path) -> None:
    from importlib.metadata import distribution

    site = tmp_path / "site"
    info = site / "day6_tui-7.0.dist-info"
    (site / "day6_tui" / "tui").mkdir(parents=True)
    info.mkdir()
    (site / "day6_tui" / "tui" / "a.py").write_text("A = 1\n", encoding="utf-8")
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: day6-tui\nVersion: 7.0\n", encoding="utf-8")
    (info / "WHEEL").write_text("Wheel-Version: 1.0\nTag: py3-none-any\n", encoding="utf-8")
    (info / "INSTALLER").write_text("pip\n", encoding="utf-8")
    (info / "RECORD").write_text(
        "day6_tui/tui/a.py,,\nday6_tui/tui/__pycache__/a.cpython-312.pyc,,\n../../bin/day6-tui,,\n"
        "day6_tui-7.0.dist-info/METADATA,,\nday6_tui-7.0.dist-info/WHEEL,,\nday6_tui-7.0.dist-info/INSTALLER,,\n",
        encoding="utf-8",
    )
    found = distribution("day6-tui").__class__.at(info)
    wheel = own_wheel._rebuilt(found, tmp_path)
    assert wheel.name == "day6_tui-7.0-py3-none-any.whl"
    target = tmp_path / "target"
    done = subprocess.run(
        [sys.executable, "-m", "pip", "install", "-q", "--no-deps", "--no-index", "--target", str(target), str(wheel)],
        capture_output=True,
        encoding="utf-8",
    )
    assert done.returncode == 0, done.stderr
    assert (target / "day6_tui" / "tui" / "a.py").read_text(encoding="utf-8") == "A = 1\n"


@pytest.mark.parametrize("lang", ["zh", "en"])
def test_the_command_says_what_is_wrong_in_one_line(
    tmp_path: Path, lang: str, index: Index, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "mine").write_text("mine", encoding="utf-8")
    assert command.main([str(tmp_path), "--lang", lang, "--platform", "linux-x86_64"]) == 1
    said = capsys.readouterr().err
    assert said.count("\n") == 1 and str(tmp_path) in said


def test_this_machine_is_one_of_those_known() -> None:
    assert this_platform() in {*PLATFORMS, ""}
