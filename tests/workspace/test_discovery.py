"""Which packages there are, in which order they are built, and which of them are chosen."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from day6_core.workspace.manifest import ManifestError, read_manifest
from day6_core.workspace.meta import MetaFiles
from day6_core.workspace.order import OrderError, plan
from day6_core.workspace.packages import Package, find_packages
from tests.workspace.workshop import Workshop

MANIFEST = """\
<?xml version="1.0"?>
<?xml-model href="http://download.ros.org/schema/package_format3.xsd" schematypens="http://www.w3.org/2001/XMLSchema"?>
<package format="3">
  <name>{name}</name>
  <version>0.0.0</version>
  <description>d</description>
  <maintainer email="a@b.cn">李 雷</maintainer>
  <license>MIT</license>
{more}
  <export><build_type>ament_python</build_type></export>
</package>
"""


BOMB = b'<!DOCTYPE package [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;&a;">]><package format="3"><name>&b;</name></package>'


def make(folder: Path, name: str, more: str = "") -> Path:
    folder.mkdir(parents=True)
    (folder / "package.xml").write_text(MANIFEST.format(name=name, more=more), encoding="utf-8")
    return folder


def found(cwd: Path, *base_paths: str) -> list[str]:
    return [
        package.shown for package in find_packages(base_paths or ["."], cwd, {}, lambda logger, text, level="": None)
    ]


def test_packages_are_found_however_deep_they_lie(tmp_path: Path) -> None:
    make(tmp_path / "src" / "one", "one")
    make(tmp_path / "src" / "src" / "two", "two")
    make(tmp_path / "src" / "我的 包", "three")
    assert found(tmp_path) == ["src/one", "src/我的 包", "src/src/two"]


@pytest.mark.parametrize("marker", ["COLCON_IGNORE", "AMENT_IGNORE", "CATKIN_IGNORE"])
def test_a_folder_with_an_ignore_marker_is_left_out_with_all_below(tmp_path: Path, marker: str) -> None:
    make(tmp_path / "src" / "one" / "inner", "one")
    (tmp_path / "src" / "one" / marker).touch()
    assert found(tmp_path) == []


def test_what_is_inside_of_a_package_is_no_package(tmp_path: Path) -> None:
    make(tmp_path / "one", "one")
    make(tmp_path / "one" / "src" / "two", "two")
    assert found(tmp_path) == ["one"]


def test_a_loop_of_links_ends(tmp_path: Path) -> None:
    make(tmp_path / "src" / "one", "one")
    (tmp_path / "src" / "loop").symlink_to(tmp_path, target_is_directory=True)
    assert found(tmp_path) == ["src/one"]


def test_ten_thousand_files_are_no_burden(tmp_path: Path) -> None:
    import time

    make(tmp_path / "src" / "one", "one")
    for number in range(100):
        folder = tmp_path / "data" / str(number)
        folder.mkdir(parents=True)
        for file in range(100):
            (folder / f"{file}.png").touch()
    began = time.process_time()
    assert found(tmp_path) == ["src/one"]
    assert time.process_time() - began < 2.0


@pytest.mark.parametrize(
    ("before", "after", "text"),
    [
        ("  <name>one</name>\n", "", 'The manifest must contain exactly one "name" tag'),
        ("<version>0.0.0", "<version>0.0", 'Package version "0.0" does not follow version conventions'),
        ("<name>one", "<name>My Package", 'Package name "My Package" does not follow naming conventions'),
        ("<license>MIT</license>", "", 'The package node must contain at least one "license" tag'),
        (
            "<license>MIT</license>",
            "<license>MIT</license><dependd>rclpy</dependd>",
            'Error(s):\n- The manifest of package "one" (with format version 3) must not contain the following tags: dependd',
        ),
        (
            "<license>MIT</license>",
            "<license>MIT</license><depend>one</depend>",
            "\n".join(
                f'The package "one" must not "{kind}_depend" on a package with the same name as this package'
                for kind in ("build", "build_export", "exec")
            ),
        ),
    ],
)
def test_a_fault_of_the_manifest_is_told_in_catkin_pkgs_words(
    tmp_path: Path, before: str, after: str, text: str
) -> None:
    folder = make(tmp_path / "one", "one")
    file = folder / "package.xml"
    assert before in file.read_text(encoding="utf-8")
    file.write_text(file.read_text(encoding="utf-8").replace(before, after), encoding="utf-8")
    with pytest.raises(ManifestError) as error:
        read_manifest(folder, "src/one", {})
    assert str(error.value) == f"Error(s) in package 'src/one/package.xml':\n{text}"
    assert error.value.schema_named


@pytest.mark.parametrize(
    ("before", "after", "text"),
    [
        ('format="3"', 'format="9"', "Unable to handle package.xml format version '9', please update catkin_pkg"),
        (' email="', ' mail="', 'The "maintainer" tag must have the attribute "email"'),
    ],
)
def test_two_faults_are_told_without_the_name_of_the_file(tmp_path: Path, before: str, after: str, text: str) -> None:
    folder = make(tmp_path / "one", "one")
    file = folder / "package.xml"
    assert before in file.read_text(encoding="utf-8")
    file.write_text(file.read_text(encoding="utf-8").replace(before, after), encoding="utf-8")
    with pytest.raises(ManifestError) as error:
        read_manifest(folder, "src/one", {})
    assert str(error.value).startswith(text)


DEEP = MANIFEST.format(name="one", more="").replace(">d<", ">" + "<b>" * 5000 + "</b>" * 5000 + "<").encode()
QUOTED = MANIFEST.format(name="One Two", more="").replace('href="', "href='").replace('.xsd"', ".xsd'").encode()


@pytest.mark.parametrize(
    "data",
    [BOMB, DEEP, QUOTED, BOMB.decode().encode("utf-16"), b"", b"\xff\xfe\x00", b"<package>", "<包>".encode("gbk")],
)
def test_a_broken_file_is_no_package_and_no_crash(tmp_path: Path, data: bytes) -> None:
    make(tmp_path / "one", "one")
    (tmp_path / "one" / "package.xml").write_bytes(data)
    assert found(tmp_path) == []


def test_a_condition_decides_whether_a_dependency_counts(tmp_path: Path) -> None:
    more = (
        "<depend condition=\"$ROS_VERSION == 2 and ($ROS_DISTRO == 'jazzy' or $ROS_DISTRO == 'humble')\">rclpy</depend>"
    )
    folder = make(tmp_path / "one", "one", more)
    kept = read_manifest(folder, "one", {"ROS_VERSION": "2", "ROS_DISTRO": "jazzy"})
    gone = read_manifest(folder, "one", {"ROS_VERSION": "1", "ROS_DISTRO": "jazzy"})
    assert kept is not None and kept.run_depends == ["rclpy"]
    assert gone is not None and gone.run_depends == []


def package(name: str, *needs: str) -> Package:
    return Package(
        name, "ros.ament_python", Path(name), name, depends={"build": list(needs), "run": list(needs), "test": []}
    )


def test_what_a_package_needs_comes_before_it_and_otherwise_the_name_decides() -> None:
    planned = plan([package("a", "c"), package("b"), package("c", "d"), package("d")])
    assert [each.package.name for each in planned] == ["b", "d", "c", "a"]
    assert planned[-1].needs == ["d", "c"]


def test_a_circle_is_told_with_its_members() -> None:
    with pytest.raises(OrderError) as error:
        plan([package("a", "b"), package("b", "a"), package("c")])
    assert str(error.value) == "Unable to order packages topologically:\na: ['b']\nb: ['a']"


@pytest.mark.parametrize(
    ("options", "names"),
    [
        ("", ["one", "other", "two"]),
        ("--paths", ["one", "other", "two"]),
        ("--paths src/one", ["one"]),
        ("--paths 'src/*'", ["one", "two"]),
        ("--paths src/hidden nowhere", []),
        ("--base-paths src", ["one", "two"]),
        ("--base-paths 'sr*'", ["one", "two"]),
        ("--base-paths . --paths src/one", ["one", "other", "two"]),
        ("--base-paths src/one --paths other", ["one", "other"]),
        ("--base-paths", []),
    ],
)
def test_only_the_ways_of_discovery_that_are_named_are_gone(workshop: Workshop, options: str, names: list[str]) -> None:
    for place in ("src/one", "src/two", "other"):
        make(workshop.workspace / place, Path(place).name)
    make(workshop.workspace / "src/hidden", "hidden")
    (workshop.workspace / "src/hidden/COLCON_IGNORE").touch()
    for verb in ("list -n", "info", "graph"):
        told = workshop.run(f"colcon {verb} {options}")
        found = [name for name in ("one", "other", "two", "hidden") if re.search(rf"\b{name}\b", told.out)]
        assert found == names, verb
        assert told.status == 0 or not names


COLCON = "colcon.colcon_core."
DISCOVERY = f"{COLCON}package_discovery: Exception in package discovery extension 'colcon_meta'"
AUGMENTATION = f"{COLCON}package_augmentation: Exception in package augmentation extension 'colcon_pkg'"
INCOMPLETE = f"{COLCON}package_identification: package 'src/c' has type or name but is incomplete"
NOT_A_DICT = (
    "colcon.colcon_metadata.package_discovery.colcon_meta: Skipping metadata file 'colcon.meta' since it doesn't "
    "contain a dict"
)


@pytest.mark.parametrize(
    ("files", "packages", "said"),
    [
        ({"colcon.meta": "names: {a: {dependencies: [b]}}"}, ["a ros.ament_python b", "b", "c"], []),
        (
            {"colcon.meta": "paths: {src/c: {name: cc}, src/b: {run-dependencies: [cc]}}"},
            ["a", "b ros.ament_python cc", "cc"],
            [],
        ),
        ({"colcon.meta": "paths: {src/c: {name: cc, type: python}}"}, ["a", "b", "cc python"], []),
        ({"colcon.meta": "names: {a: {type: python}}"}, ["a ros.ament_python", "b", "c"], []),
        ({"colcon.meta": "[1, 2]"}, ["a", "b", "c"], [NOT_A_DICT]),
        (
            {"colcon.meta": "names: {a: 7}"},
            ["a", "b", "c"],
            [f"{DISCOVERY}: 'int' object has no attribute 'items'"],
        ),
        (
            {".colcon/metadata/deep/x.meta": "names: {b: {build-dependencies: [c]}}"},
            ["a", "b ros.ament_python c", "c"],
            [],
        ),
        (
            {".colcon/metadata/.git/x.meta": "names: {b: {build-dependencies: [c]}}"},
            ["a", "b ros.ament_python", "c"],
            [],
        ),
        ({"src/c/colcon.pkg": "name: other"}, ["a", "b", "other ros.ament_python"], []),
        ({"src/c/colcon.pkg": "type: ros"}, ["a", "b", "c ros.ament_python"], []),
        ({"src/c/colcon.pkg": "type: python"}, ["a", "b", "c python"], []),
        ({"src/c/colcon.pkg": "type: ros.ament_cmake"}, ["a", "b"], [INCOMPLETE]),
        ({"src/c/colcon.pkg": "{type: odd, name: c}"}, ["a", "b", "c odd"], []),
        ({"src/c/colcon.pkg": "{run-dependencies: [a], dependencies: [b]}"}, ["a", "b", "c ros.ament_python a b"], []),
        ({"src/c/colcon.pkg": "just words"}, ["a", "b", "c ros.ament_python"], []),
        (
            {"src/c/colcon.pkg": "dependencies: 3"},
            ["a", "b", "c ros.ament_python"],
            [f"{AUGMENTATION}: 'int' object is not iterable"],
        ),
        (
            {"src/c/colcon.pkg": "{name: d}", "colcon.meta": "paths: {src/c: {name: e}}"},
            ["a", "b", "d"],
            [f"{COLCON}package_identification: name 'd' of package 'src/c' does not match configured name 'e'"],
        ),
    ],
)
def test_what_files_beside_the_manifest_say_is_heeded(
    tmp_path: Path, files: dict[str, str], packages: list[str], said: list[str]
) -> None:
    """As colcon-core 0.21, colcon-ros 0.5 and colcon-metadata 0.3 did it."""
    for name in "abc":
        folder = make(tmp_path / "src" / name, name)
        (folder / "setup.py").write_text(f"from setuptools import setup\nsetup(name='{name}')\n", encoding="utf-8")
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    heard: list[str] = []

    def warn(logger: str, text: str, level: str = "") -> None:
        heard.append(f"{logger}: {text.replace(f'{tmp_path}/', '')}")

    metas = MetaFiles(warn)
    metas.read(["./colcon.meta"], tmp_path, {"HOME": str(tmp_path)}, of_user=True)
    found = find_packages(["."], tmp_path, {}, warn, metas=metas)
    whole = [" ".join([each.name, each.type, *sorted(each.dependencies())]) for each in found]
    assert all(have == want or have.split()[0] == want for have, want in zip(whole, packages, strict=True)), whole
    assert heard == said


@pytest.mark.process
def test_a_meta_file_gives_a_package_its_hooks_and_options(workshop: Workshop) -> None:
    folder = workshop.create("mine")
    text = "names: {mine: {hooks: [share/mine/hook/x.sh], pytest-args: [-k, second], notes: [1]}}\n"
    (workshop.workspace / "colcon.meta").write_text(text, encoding="utf-8")
    (folder / "test").mkdir(exist_ok=True)
    tests = "def test_first():\n    assert False\n\n\ndef test_second():\n    pass\n"
    (folder / "test" / "test_x.py").write_text(tests, encoding="utf-8")
    done = workshop.run("colcon build && colcon test --packages-select mine && colcon info mine")
    assert done.status == 0, done
    scripts = (workshop.workspace / "install/mine/share/mine/package.dsv").read_text(encoding="utf-8")
    assert scripts.endswith("source;share/mine/hook/x.sh\n")
    assert "with test failures" not in done.out + done.err
    assert "  hooks: share/mine/hook/x.sh\n  metadata:\n" in done.out
    assert "    notes: [1]\n    pytest-args: ['-k', 'second']\n" in done.out
