"""A folder that installs day6-tui without internet. pip is played by a stand-in here; `try_offline.py` asks the real one."""

from __future__ import annotations

import ast
import errno
import hashlib
import os
import re
import subprocess
import sys
import zipfile
from collections.abc import Sequence
from pathlib import Path

import pytest
from packaging.requirements import Requirement

from day6_tui.wheelhouse import closure, command, folder, guide, own_wheel
from day6_tui.wheelhouse.targets import PLATFORMS, Target, this_platform, this_python


def texts_for(targets: list[Target]) -> dict[str, str]:
    return {folder.GUIDE: guide.guide(targets), folder.CHECK: guide.checker(targets)}


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


HERE = [Target(PLATFORMS["linux-x86_64"], "3.12"), Target(PLATFORMS["windows-x86_64"], "3.12")]

NO_NETWORK = """\
WARNING: Retrying (Retry(total=0, connect=None, read=None, redirect=None, status=None)) after connection broken by \
'NewConnectionError('<pip._vendor.urllib3.connection.HTTPSConnection object at 0x7f9864d61910>: Failed to establish a new \
connection: [Errno -3] Temporary failure in name resolution')': /simple/rich/
ERROR: Could not find a version that satisfies the requirement rich>=14 (from versions: none)
ERROR: No matching distribution found for rich>=14
"""
"""What pip 23 says in `unshare -n`."""
NO_NETWORK_26 = re.sub(
    r"'New.*?\[",
    "'NameResolutionError(\"HTTPSConnection(host='pypi.org', port=443): Failed to resolve 'pypi.org' ([",
    NO_NETWORK,
)


class Index:
    """Stands in for pip and its index: the newest wheel that the specifier allows, or `says` for all it is asked for."""

    def __init__(self, place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.place, self.asked = place, list[str]()
        self.says = ""
        monkeypatch.setattr(closure.subprocess, "run", self.run)

    def run(self, words: Sequence[str], **_: object) -> subprocess.CompletedProcess[str]:
        from packaging.utils import parse_wheel_filename

        wanted = Requirement(words[-1])
        self.asked.append(words[-1])
        if self.says:
            return subprocess.CompletedProcess(words, 1, "", self.says)
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


def test_of_what_yourdfpy_brings_only_what_is_used_is_fetched(index: Index, tmp_path: Path) -> None:
    wheel_of(index.place, "trimesh", "5.0", *(f"{name}; extra == 'easy'" for name in ("scipy", "pycollada", "lxml")))
    wheel_of(index.place, "yourdfpy", "1.0", "trimesh[easy]", "lxml")
    for name in ("scipy", "pycollada", "lxml"):
        wheel_of(index.place, name, "1.0")
    own = wheel_of(tmp_path, "own", "1.0", "yourdfpy")
    assert needed(index, tmp_path, own, "linux-x86_64") == {"trimesh", "yourdfpy", "pycollada", "lxml"}
    assert not [each for each in index.asked if "scipy" in each]


def test_the_list_says_which_machine_needs_which_version() -> None:
    linux, windows = HERE
    common = {"rich-15.0.0-py3-none-any.whl", "day6_tui-0.1.0-py3-none-any.whl"}
    text = guide.listed({linux: {*common, "a-1.0-py3-none-any.whl"}, windows: {*common, "a-2.0-py3-none-any.whl"}})
    lines = [Requirement(line) for line in text.splitlines()]
    for target, version in ((linux, "1.0"), (windows, "2.0")):
        wanted = [each for each in lines if each.marker is None or each.marker.evaluate(target.markers())]
        assert [str(each).partition(" ;")[0].partition(";")[0] for each in wanted] == [
            f"a=={version}",
            "day6-tui==0.1.0",
            "rich==15.0.0",
        ]


def test_the_metadata_of_a_package_inside_the_wheel_is_not_the_wheels(index: Index, tmp_path: Path) -> None:
    wheel_of(index.place, "colours", "1.0")
    own = tmp_path / "own-1.0-py3-none-any.whl"
    with zipfile.ZipFile(own, "w") as packed:
        packed.writestr("own/ros/inside-2.0.dist-info/METADATA", "Metadata-Version: 2.1\nName: inside\nVersion: 2.0\n")
        packed.writestr("own-1.0.dist-info/METADATA", "Metadata-Version: 2.1\nName: own\nRequires-Dist: colours\n")
    assert needed(index, tmp_path, own, "linux-x86_64") == {"colours"}


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
    folder.fill(stick, [first], {folder.GUIDE: "read me", folder.CHECK: "pass"})
    folder.fill(stick, [second], {folder.GUIDE: "read me too", folder.CHECK: "pass"})
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


def test_a_damaged_and_a_missing_wheel_are_repaired_by_the_next_run(tmp_path: Path) -> None:
    stick, place = tmp_path / "stick", tmp_path / "place"
    wheels = [wheel_of(place, "a", "1.0"), wheel_of(place, "b", "1.0"), wheel_of(place, "c", "1.0")]
    folder.fill(stick, wheels, {})
    (stick / wheels[0].name).write_bytes(b"?")
    (stick / wheels[1].name).unlink()
    folder.fill(stick, wheels, {})
    assert all((stick / wheel.name).read_bytes() == wheel.read_bytes() for wheel in wheels)


@pytest.mark.parametrize("before", [(), ("a", "1.0")])
def test_a_full_disk_names_the_users_folder_and_the_next_run_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, before: tuple[str, ...]
) -> None:
    stick, place = tmp_path / "stick", tmp_path / "place"
    if before:
        folder.fill(stick, [wheel_of(tmp_path / "before", *before)], {folder.GUIDE: "old"})
    wheels = [wheel_of(place, "a", "2.0"), wheel_of(place, "b", "1.0")]
    copy = folder.shutil.copyfile

    def copy_half(source: Path, target: Path) -> None:
        if source == wheels[1]:
            Path(target).write_bytes(b"half")
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(source))
        copy(source, target)

    monkeypatch.setattr(folder.shutil, "copyfile", copy_half)
    with pytest.raises(OSError) as full:
        folder.fill(stick, wheels, texts_for(HERE))
    assert full.value.filename == str(stick)
    assert not [path for path in stick.iterdir() if "part" in path.name]
    monkeypatch.undo()
    (stick / ".c-1.0-py3-none-any.whl.part").write_bytes(b"pulled out")
    (stick / ".day6-0123456789ab").write_bytes(b"killed")
    folder.fill(stick, wheels, texts_for(HERE))
    names = {*(wheel.name for wheel in wheels), folder.GUIDE, folder.CHECK, folder.SUMS}
    assert {path.name for path in stick.iterdir()} == names


def test_a_folder_nobody_can_write_to_is_told_before_anything_is_fetched(
    tmp_path: Path, index: Index, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("no folder", encoding="utf-8")
    stick = tmp_path / "file" / "stick"
    assert command.main([str(stick), "--lang", "en", "--platform", "linux-x86_64"]) == 1
    said = capsys.readouterr()
    assert said.err.startswith(f"day6-tui wheelhouse: {stick}: ") and not index.asked and not said.out
    folder.try_to_write(tmp_path / "new" / "stick")
    assert not (tmp_path / "new").exists()


def test_no_network_and_no_such_project_are_told_apart(index: Index, tmp_path: Path) -> None:
    own = wheel_of(tmp_path, "own", "1.0", "rich>=14")
    for index.says in (NO_NETWORK, NO_NETWORK_26):
        with pytest.raises(closure.NoInternet, match=r"^Temporary failure in name resolution$"):
            needed(index, tmp_path, own, "linux-x86_64")
    index.says = "ERROR: No matching distribution found for rich>=14\n"
    with pytest.raises(closure.FetchError, match="No matching distribution found") as missing:
        needed(index, tmp_path, own, "linux-x86_64")
    assert not isinstance(missing.value, closure.NoInternet)
    index.says = "ERROR: Could not install packages due to an OSError: [Errno 28] No space left on device\n"
    with pytest.raises(OSError, match="No space left on device"):
        needed(index, tmp_path, own, "linux-x86_64")


@pytest.mark.parametrize("lang", ["zh", "en"])
def test_without_internet_one_line_says_so(
    tmp_path: Path, lang: str, index: Index, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    index.says = NO_NETWORK
    monkeypatch.setattr(own_wheel, "make", lambda place: wheel_of(place, "own", "1.0", "rich>=14"))
    assert command.main([str(tmp_path / "stick"), "--lang", lang, "--platform", "linux-x86_64"]) == 1
    said = capsys.readouterr().err
    assert said.count("\n") == 1 and "Temporary failure in name resolution" in said and "matching" not in said
    assert {"en": "no internet", "zh": "没有网络"}[lang] in said
    assert not (tmp_path / "stick").exists()


def check(stick: Path, *before: str) -> subprocess.CompletedProcess[str]:
    """Run check.py; `before` are lines of Python that make this machine another one."""
    code = "\n".join((*before, "import runpy", f"runpy.run_path({str(stick / folder.CHECK)!r}, run_name='__main__')"))
    return subprocess.run([sys.executable, "-c", code], capture_output=True, encoding="utf-8", cwd="/")


@pytest.mark.process
def test_the_check_on_the_stick_finds_what_was_damaged_on_the_way(tmp_path: Path) -> None:
    stick = tmp_path / "stick"
    here = Target(PLATFORMS[this_platform() or "linux-x86_64"], this_python())
    folder.fill(stick, [wheel_of(tmp_path, "a", "1.0")], texts_for([here]))
    assert check(stick).returncode == (0 if this_platform() else 1)
    with open(next(stick.glob("*.whl")), "r+b") as file:
        file.write(b"?")
    assert check(stick).returncode == 1 and "a-1.0" in check(stick).stdout


@pytest.mark.process
def test_the_check_on_the_stick_says_which_machine_and_python_it_is_for(tmp_path: Path) -> None:
    stick = tmp_path / "stick"
    folder.fill(stick, [], texts_for(HERE))
    linux = "import platform, sys; sys.platform = 'linux'; platform.machine = lambda: 'x86_64'; sys.version_info = (3, {}, 0)"
    assert check(stick, linux.format(12)).returncode == 0
    other = check(stick, linux.format(8))
    assert other.returncode == 1
    assert "this is Python 3.8, the folder is for Python 3.12: python3.12 check.py" in other.stdout
    windows = "import platform, sys; sys.platform = 'win32'; platform.machine = lambda: 'AMD64'; sys.version_info = (3, 11, 0)"
    assert "py -3.12 check.py" in check(stick, windows).stdout
    pi = check(stick, "import platform; platform.machine = lambda: 'aarch64'")
    assert pi.returncode == 1
    assert "not for this machine (linux-aarch64): the folder is for linux-x86_64, windows-x86_64" in pi.stdout
    narrow = check(stick, linux.format(12), "sys.maxsize = 2**31 - 1")
    assert "not for this machine (linux-32-bit)" in narrow.stdout


def test_the_check_is_written_for_old_pythons() -> None:
    ast.parse(guide.checker(HERE), feature_version=(3, 8))


def test_the_guide_names_machines_and_versions_and_types_the_right_python() -> None:
    text = guide.guide(HERE)
    assert text.count("  linux-x86_64, Python 3.12\n") == text.count("  windows-x86_64, Python 3.12\n") == 2
    assert text.count("py -3.12 -m venv") == text.count("python3.12 -m venv") == 2
    assert "in place of" not in text and "{" not in text
    assert "Windows" not in guide.guide(HERE[:1]) and "Linux" not in guide.guide(HERE[1:]).replace("Debian", "")
    several = guide.guide([*HERE, Target(PLATFORMS["linux-x86_64"], "3.10")])
    assert "replace 3.12 with its number" in several and "python3.12 -m venv" in several


@pytest.mark.process
def test_the_wheel_of_an_installed_day6_holds_what_was_installed(tmp_path: Path) -> None:
    from importlib.metadata import distribution

    site = tmp_path / "site"
    info = site / "day6_tui-7.0.dist-info"
    (site / "day6_tui").mkdir(parents=True)
    info.mkdir()
    (site / "day6_tui" / "a.py").write_text("A = 1\n", encoding="utf-8")
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: day6-tui\nVersion: 7.0\n", encoding="utf-8")
    (info / "WHEEL").write_text("Wheel-Version: 1.0\nTag: py3-none-any\n", encoding="utf-8")
    (info / "INSTALLER").write_text("pip\n", encoding="utf-8")
    (info / "RECORD").write_text(
        "day6_tui/a.py,,\nday6_tui/__pycache__/a.cpython-312.pyc,,\n../../bin/day6-tui,,\n"
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
    assert (target / "day6_tui" / "a.py").read_text(encoding="utf-8") == "A = 1\n"


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
