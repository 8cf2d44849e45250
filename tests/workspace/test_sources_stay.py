"""Whatever a package looks like and however it is built: the pupil's files are the same afterwards, to the byte."""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Mapping
from pathlib import Path

import pytest

from day6_core.workspace import build as build_task
from tests.support.waiting import PATIENCE
from tests.workspace.shapes import CMAKE, PYTHON, STEPS, Shape, changes, lay_out, snapshot
from tests.workspace.workshop import Workshop, edit

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="most shapes need links")


def build(workshop: Workshop, options: str, cwd: Path | None = None) -> tuple[int, str]:
    running = workshop.start(f"colcon build {options}", workshop.terminal(cwd))
    workshop.wait(lambda: running.program.status is not None, 20 * PATIENCE)
    assert running.program.status is not None
    return running.program.status, running.out.text + running.err.text


def results(output: str) -> dict[str, str]:
    return dict(re.findall(r"(?m)^(?:Finished|Failed|Aborted) +<<< (\S+) \[[\d.]+s(.*)\]$", output))


WORKSPACES = 22
"""In which the shapes are built, so that the work can be shared."""


def to_build(shapes: Mapping[str, Shape], step: int) -> dict[str, Shape]:
    """What a step builds: first all, then every second one, and of those whose sources stay alike every fourth."""
    if step == 0:
        return dict(shapes)
    alike = [name for name, shape in shapes.items() if shape.later is None]
    changing = [name for name, shape in shapes.items() if shape.later is not None]
    chosen = {*alike[step % 4 :: 4], *changing[step % 2 :: 2]}
    return {name: shape for name, shape in shapes.items() if name in chosen} or dict(shapes)


@pytest.mark.process
@pytest.mark.parametrize("number", range(WORKSPACES))
def test_no_shape_of_a_package_costs_a_source_file(workshop: Workshop, number: int) -> None:
    shapes = dict(list({**PYTHON, **CMAKE}.items())[number::WORKSPACES])
    assert len(shapes) * WORKSPACES >= 88
    wrong: list[str] = []
    for step, (option, later) in enumerate(STEPS):
        lay_out(workshop.workspace / "src", shapes, later)
        before = snapshot(workshop.home)
        built = to_build(shapes, step)
        _, output = build(workshop, f"--continue-on-error {option} --packages-select {' '.join(built)}")
        kept = {path: what for path, what in before.items() if path.startswith("ros2_ws/src") or "ros2_ws" not in path}
        after = {
            path: what
            for path, what in snapshot(workshop.home).items()
            if path.startswith("ros2_ws/src") or path in kept
        }
        assert changes(kept, after) == [], f"step {step}: colcon build {option}"
        ended = results(output)
        assert ended.keys() == built.keys()
        for name, shape in built.items():
            used = shape.later if later and shape.later is not None else shape
            failed = used.fails or used.refused or (used.fails_linked and bool(option))
            if not shape.either and bool(ended[name]) != failed:
                wrong.append(f"step {step} {option}, {name}: {ended[name]}")
    assert wrong == []


def package_at(folder: Path, name: str, shape: Shape) -> dict[str, tuple[object, ...]]:
    shape.write(folder, name)
    return snapshot(folder)


def lost(before: dict[str, tuple[object, ...]], folder: Path) -> list[str]:
    """What became of what was there; what was made is told by other tests."""
    return [line for line in changes(before, snapshot(folder)) if not line.endswith(": made")]


@pytest.mark.process
@pytest.mark.parametrize("option", ["", "--symlink-install"])
def test_a_package_that_is_its_own_workspace_keeps_what_lies_in_its_folder_build(
    workshop: Workshop, option: str
) -> None:
    folder = workshop.home / "alone"
    shape = Shape(
        "['{n}', 'build']", files={"build/__init__.py": "", "build/notes.txt": "n\n", "install/notes.txt": "n\n"}
    )
    before = package_at(folder, "alone", shape)
    for _ in range(2):
        status, output = build(workshop, option, folder)
        assert (status, lost(before, folder)) == (0, []), output


@pytest.mark.parametrize("option", ["", "--symlink-install"])
def test_a_build_folder_with_a_pupil_s_own_files_is_refused(workshop: Workshop, option: str) -> None:
    folder = workshop.home / "alone"
    before = package_at(
        folder, "alone", Shape(files={"build/alone/setup.py": "MINE = 1\n", "build/alone/alone/x.py": ""})
    )
    for _ in range(2):
        status, output = build(workshop, option, folder)
        assert status == 1
        assert "build/alone' exists already and was not made by colcon: move it away" in output
        assert lost(before, folder) == []


@pytest.mark.parametrize(
    "options",
    [
        "--build-base src",
        "--install-base src",
        "--build-base .",
        "--install-base . --merge-install",
        "--build-base src/one/inside/..",
        "--install-base ..",
        "--build-base here --paths src/one",
        "--test-result-base src",
        "--symlink-install --build-base src --paths src/one",
    ],
)
def test_a_base_that_holds_sources_is_refused_and_stays_as_it_is(workshop: Workshop, options: str) -> None:
    Shape(files={"inside/x.txt": ""}).write(workshop.workspace / "src/one", "one")
    (workshop.workspace / "here").symlink_to("src")
    before = snapshot(workshop.workspace / "src")
    status, output = build(workshop, options)
    assert status == 1
    assert "holds sources" in output
    assert changes(before, snapshot(workshop.workspace / "src")) == []


def test_a_log_base_that_holds_sources_is_refused_and_stays_as_it_is(workshop: Workshop) -> None:
    before = package_at(workshop.workspace / "src/one", "one", Shape())
    done = workshop.run("colcon --log-base src build")
    assert done.status == 1
    assert "holds sources" in done.err
    assert changes(before, snapshot(workshop.workspace / "src/one")) == []
    assert not (workshop.workspace / "src/COLCON_IGNORE").exists()


@pytest.mark.process
@pytest.mark.parametrize("option", ["", "--symlink-install"])
def test_a_base_may_be_a_link_to_another_disk(workshop: Workshop, option: str) -> None:
    before = package_at(workshop.workspace / "src/one", "one", Shape())
    for base in ("build", "install", "log"):
        (workshop.home / "disk" / base).mkdir(parents=True)
        (workshop.workspace / base).symlink_to(workshop.home / "disk" / base)
    status, output = build(workshop, option)
    assert (status, lost(before, workshop.workspace / "src/one")) == (0, []), output
    assert (workshop.home / "disk/install/one/share/one/package.xml").is_file()


@pytest.mark.process
@pytest.mark.parametrize("option", ["", "--symlink-install"])
@pytest.mark.parametrize("place", ["build/one", "install/one", "install/one/lib", "install/one/share/one"])
def test_a_link_below_a_base_that_leads_elsewhere_is_not_written_through(
    workshop: Workshop, option: str, place: str
) -> None:
    mine = workshop.home / "mine"
    (mine / "one").mkdir(parents=True)
    (mine / "package.xml").write_text("mine\n", encoding="utf-8")
    (mine / "one/node").write_text("mine\n", encoding="utf-8")
    Shape().write(workshop.workspace / "src/one", "one")
    before = snapshot(workshop.home / "mine")
    link = workshop.workspace / place
    link.parent.mkdir(parents=True)
    link.symlink_to(mine)
    status, output = build(workshop, option)
    assert status == 1
    assert "left alone" in output or "was not made by colcon: move it away" in output
    assert changes(before, snapshot(mine)) == []
    assert link.is_symlink()


@pytest.mark.process
def test_a_package_may_be_a_link_to_where_its_sources_are(workshop: Workshop) -> None:
    before = package_at(workshop.home / "git/one", "one", PYTHON["slash_below_package"])
    (workshop.workspace / "src").mkdir(parents=True, exist_ok=True)
    (workshop.workspace / "src/one").symlink_to(workshop.home / "git/one")
    for option in ("--symlink-install", "", "--symlink-install"):
        status, output = build(workshop, option)
        assert (status, changes(before, snapshot(workshop.home / "git/one"))) == (0, []), output


_REMOVING = {
    "unlink",
    "rmtree",
    "rmdir",
    "remove",
    "rename",
    "renames",
    "removedirs",
    "symlink_to",
    "touch",
    "truncate",
}
_WRITING = {"write_text", "write_bytes", "copy", "copy2", "copytree", "copyfile", "move"}
_ITS_OWN = {
    "files.py": _REMOVING | _WRITING,
    "logs.py": {"symlink_to"},  # `latest`, in a folder that it has looked at
    "create.py": {"rename", "rmtree", "write_text"},  # a new folder of its own, which then takes the package's name
    "jobs.py": {"copy"},  # lines of a pipe
    "export.py": {"unlink"},  # its own temporary file
    "own_graph.py": {"rmtree"},  # its own temporary folders
    "run_tests.py": {"copytree"},  # JUnit files, into the folder that was named for them
}


def test_one_module_alone_removes_and_writes() -> None:
    folder = Path(build_task.__file__).parent
    for module in sorted(folder.glob("*.py")):
        for node in ast.walk(ast.parse(module.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
                name, owner = node.func.attr, ast.unparse(node.func.value)
                if name in _REMOVING | _WRITING and not owner.endswith(("output", "_output", "_processes", "work")):
                    assert name in _ITS_OWN.get(module.name, ()), f"{module.name}:{node.lineno}: {ast.unparse(node)}"


@pytest.mark.process
@pytest.mark.parametrize("step", ["mv src build install elsewhere && cd elsewhere", "rm -r build"])
def test_links_to_nothing_in_a_prefix_are_no_hindrance(workshop: Workshop, step: str) -> None:
    """As in a public repository that has its `build` and `install` in it: its links lead to a folder of another computer."""
    package = workshop.create("day6_moved")
    edit(
        package / "setup.py",
        "('share/' + package_name, ['package.xml']),",
        "('share/' + package_name, ['package.xml', 'a.yaml']),",
    )
    (package / "a.yaml").write_text("a: 1\n", encoding="utf-8")
    done = workshop.run(f"colcon build --symlink-install && mkdir elsewhere && {step} && colcon build")
    assert done.status == 0 and "failed" not in done.out, done
    there = next(path for path in workshop.workspace.rglob("install/day6_moved/share/day6_moved/a.yaml"))
    assert there.read_text(encoding="utf-8") == "a: 1\n" and not there.is_symlink()


@pytest.mark.process
def test_links_of_others_in_a_merged_prefix_stay_when_a_package_is_built_without_links(workshop: Workshop) -> None:
    for name in ("one", "two"):
        Shape(data="('share/{n}', ['a.txt']),", files={"a.txt": "a\n"}).write(workshop.workspace / "src" / name, name)
    assert build(workshop, "--symlink-install --merge-install")[0] == 0
    own = workshop.workspace / "install/share/own"
    own.symlink_to(workshop.home)
    assert build(workshop, "--merge-install --packages-select one")[0] == 0
    assert own.is_symlink()
    assert (workshop.workspace / "install/share/two/a.txt").is_symlink()
    assert not (workshop.workspace / "install/share/one/a.txt").is_symlink()


def test_the_name_of_a_package_leads_to_no_folder_outside(workshop: Workshop) -> None:
    folder = workshop.workspace / "src/odd"
    folder.mkdir(parents=True)
    (folder / "setup.py").write_text("from setuptools import setup\n\nsetup(name='../../out')\n", encoding="utf-8")
    before = snapshot(workshop.home)
    for option in ("", "--symlink-install"):
        status, output = build(workshop, option)
        assert status == 1, output
    after = snapshot(workshop.home)
    made = [
        line
        for line in changes(before, after)
        if not line.startswith(("ros2_ws/build", "ros2_ws/install", "ros2_ws/log"))
    ]
    assert made == [] or all(line == "ros2_ws: changed" for line in made)
