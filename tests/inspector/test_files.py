"""What the inspector reads of workspaces: bounded, and never stopped by what it finds there."""

from __future__ import annotations

from pathlib import Path

import pytest

from day6_core.facts.setup_file import read_setup
from day6_core.facts.workspaces import Unknown, names_file, why_unknown
from day6_core.reason import reason
from day6_core.ros.programs.day6_inspector.facts import Facts
from day6_core.ros.programs.day6_inspector.file_rules import _fits
from day6_core.ros.programs.day6_inspector.files import Files, ParameterFile, Typed, Where, look
from day6_core.ros.programs.day6_inspector.program_rules import script_of
from day6_core.ros.programs.day6_inspector.rules import findings

MANIFEST = (
    "<package format='3'><name>{}</name><version>0.0.0</version><description>.</description>"
    "<maintainer email='a@b.c'>a</maintainer><license>MIT</license></package>"
)


def package(home: Path, name: str, setup: str = "") -> Path:
    folder = home / "ros2_ws/src" / name
    (folder / name).mkdir(parents=True)
    (folder / "package.xml").write_text(MANIFEST.format(name), encoding="utf-8")
    if setup:
        (folder / "setup.py").write_text(setup, encoding="utf-8")
    return folder


def test_a_home_without_anything_is_no_fault(tmp_path: Path) -> None:
    assert findings(Facts(files=look(Where(tmp_path)))) == []


@pytest.mark.parametrize(
    "setup",
    ["setup(", "\0", "x = 1\n" * 10, "setup(entry_points={'console_scripts': [name + '=a.b:c']})", "(" * 5000],
    ids=["broken", "nul", "nothing", "computed", "deep"],
)
def test_a_setup_file_that_cannot_be_read_is_no_finding(tmp_path: Path, setup: str) -> None:
    package(tmp_path, "a", setup)
    assert findings(Facts(files=look(Where(tmp_path)))) == []


def test_entry_points_are_judged_by_the_files(tmp_path: Path) -> None:
    folder = package(tmp_path, "a", "setup(entry_points={'console_scripts': ['x = a.x:main', 'y = a.y:main', 'z']})")
    (folder / "a/x.py").write_text("def main():\n    pass\n", encoding="utf-8")
    found = read_setup(folder)
    assert [(each.name, each.flaw) for each in found.entry_points] == [("x", ""), ("y", "module"), ("z", "form")]


def test_a_folder_in_a_circle_and_thousands_of_files_end(tmp_path: Path) -> None:
    folder = package(tmp_path, "a")
    (folder / "loop").symlink_to(folder, target_is_directory=True)
    for number in range(500):
        (folder / "a" / f"m{number}.py").touch()
    assert len(look(Where(tmp_path)).workspaces[0].packages) == 1


def test_what_may_not_be_read_does_not_end_it(tmp_path: Path, plain_user: None) -> None:
    folder = package(tmp_path, "a", "setup()")
    folder.chmod(0)
    try:
        with pytest.raises(PermissionError):
            (folder / "setup.py").read_text()
        look(Where(tmp_path))
    finally:
        folder.chmod(0o755)


@pytest.mark.parametrize(
    ("key", "node", "fits"),
    [
        ("/turtlesim", "/turtlesim", True),
        ("turtlesim", "/turtlesim", True),
        ("/turtle_sim", "/turtlesim", False),
        ("/**", "/a/b", True),
        ("/*", "/turtlesim", True),
        ("/*", "/a/b", False),
        ("/**/talker", "/a/b/talker", True),
        ("/**/talker", "/talker", True),
        ("/**/talker", "/a/listener", False),
        ("/a/*/c", "/a/b/c", True),
    ],
)
def test_keys_of_parameter_files_mean_nodes_as_in_rcl(key: str, node: str, fits: bool) -> None:
    assert _fits(key, (node,)) is fits


def test_a_parameter_file_is_read_from_the_running_line(tmp_path: Path) -> None:
    (tmp_path / "p.yaml").write_text("team:\n  talker:\n    ros__parameters: {a: 1}\n", encoding="utf-8")
    (tmp_path / "bad.yaml").write_text("a: [", encoding="utf-8")
    with pytest.raises(FileNotFoundError) as error:
        (tmp_path / "no").open()
    names = ("p.yaml", "bad.yaml", "no")
    lines = tuple(Typed(f"ros2 run a b --ros-args --params-file {name}", (tmp_path,), tmp_path) for name in names)
    found = look(Where(tmp_path, lines=lines)).parameters
    assert [(each.keys, each.problem) for each in found] == [
        (("/team/talker",), ""),
        ((), "no YAML"),
        ((), reason(error.value)),
    ]


def test_a_name_begins_where_the_line_was_typed_or_in_the_home_of_its_terminal(tmp_path: Path) -> None:
    """Not in that of who runs the desktop; and where a process was started is not known."""
    home, cwd = tmp_path / "home", tmp_path / "cwd"
    typed, started = Typed("", (tmp_path, cwd), home), Typed("", (), home)
    assert typed.path("p.yaml") == tmp_path / "p.yaml"
    cwd.mkdir()
    (cwd / "p.yaml").touch()
    assert typed.path("p.yaml") == cwd / "p.yaml"
    assert typed.path("~/p.yaml") == started.path("~/p.yaml") == home / "p.yaml"
    assert started.path(str(cwd / "p.yaml")) == cwd / "p.yaml"
    assert started.path("p.yaml") is None
    assert typed.path("q.yaml") == tmp_path / "q.yaml"
    assert typed._replace(source="cd x; y").path("q.yaml") is None
    line = Typed("/x/talker.py --ros-args --params-file p.yaml", (), home)
    assert look(Where(home, lines=(line,))).parameters == ()


def test_values_for_a_node_that_does_not_run_yet_are_no_fault_where_no_node_runs() -> None:
    files = Files(parameters=(ParameterFile(Path("p.yaml"), "", ("/a",)),))
    assert findings(Facts(files=files)) == []
    assert [each.id for each in findings(Facts(files=files, nodes=("/b",)))] == ["inspector.parameter_keys"]


@pytest.mark.parametrize(
    ("line", "script"),
    [
        ("python3 a.py x", "a.py"),
        ("python3 ~/a.py", "home/a.py"),
        ("python a.py", "a.py"),
        ("./a.py", "a.py"),
        ("python3 -c 1", ""),
        ("echo 'a", ""),
    ],
)
def test_the_script_of_a_line(tmp_path: Path, line: str, script: str) -> None:
    assert script_of(line, tmp_path, tmp_path / "home") == (tmp_path / script if script else None)


@pytest.mark.parametrize(
    ("script", "text", "named"),
    [
        ("setup.py", "('share/a/launch', ['launch/x.launch.py'])", True),
        ("setup.py", "('share/a/launch', ['launch/y.launch.py'])", False),
        ("setup.py", "('share/a/launch', glob('launch/*.py'))", True),
        (
            "setup.py",
            "(os.path.join('share', name, 'launch'), glob(os.path.join('launch', '*launch.[pxy][yma]*')))",
            True,
        ),
        ("setup.py", "('share/a/launch', glob('launch/*.xml'))", False),
        ("setup.py", "('share/a', ['package.xml'])", False),
        ("CMakeLists.txt", "install(DIRECTORY launch worlds\n  DESTINATION share/${PROJECT_NAME})", True),
        ("CMakeLists.txt", "install(DIRECTORY worlds/launch DESTINATION share/${PROJECT_NAME})", False),
    ],
)
def test_a_launch_file_is_named_by_itself_by_a_wildcard_or_by_its_folder(
    tmp_path: Path, script: str, text: str, named: bool
) -> None:
    (tmp_path / script).write_text(text, encoding="utf-8")
    assert names_file(tmp_path / script, "launch/x.launch.py") is named


def test_a_terminal_knows_a_package_that_was_there_when_it_sourced_the_workspace(tmp_path: Path) -> None:
    manifest = package(tmp_path, "new") / "package.xml"
    install = tmp_path / "ros2_ws/install"
    home = {"HOME": str(tmp_path)}
    before = {**home, "AMENT_PREFIX_PATH": str(install / "old")}
    assert why_unknown("new", home, tmp_path) == Unknown(
        "not_built", tmp_path / "ros2_ws", tmp_path / "ros2_ws/src/new"
    )
    whole = manifest.read_text(encoding="utf-8")
    manifest.write_text(whole.replace("<license>", "<licence>"), encoding="utf-8")
    refused = why_unknown("new", home, tmp_path)
    assert refused is not None and refused.because == "refused"  # colcon leaves it out
    manifest.write_text(whole, encoding="utf-8")
    share = install / "new/share/new"
    share.mkdir(parents=True)
    (share / "package.xml").touch()
    assert why_unknown("new", before, tmp_path) == Unknown("not_sourced", tmp_path / "ros2_ws", install)
    assert why_unknown("new", {**home, "AMENT_PREFIX_PATH": str(install / "new")}, tmp_path) is None
    assert why_unknown("new", {**home, "AMENT_PREFIX_PATH": str(install)}, tmp_path) is None
    assert why_unknown("none", home, tmp_path) is None


def test_entry_points_that_are_computed_are_known_by_the_names_that_are_written(tmp_path: Path) -> None:
    folder = package(
        tmp_path, "a", "scripts = ['x = a.x:main', 'no entry']\nsetup(entry_points={'console_scripts': scripts})"
    )
    assert (read_setup(folder).entry_points, read_setup(folder).programs) == ((), ("x",))
    (folder / "setup.py").write_text("s = ['x = a.x:main'\n'y = a.y:main']", encoding="utf-8")
    assert read_setup(folder).comma == 1
