"""Imports go one way, over all folders: what `.ci/import_rules.py` says of this tree, and of a copy with faults planted in it."""

from __future__ import annotations

import itertools
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

from tests.support.loaded import loaded

pytestmark = pytest.mark.process

ROOT = Path(__file__).resolve().parents[2]
CHECK = ROOT / ".ci" / "import_rules.py"
SCREEN = "day6_tui.main"

pytest.importorskip("importlinter")

rules = loaded(".ci/import_rules.py")


def said(tree: Path) -> tuple[str, int]:
    """What the check says of a tree, in one long line, and its exit status."""
    done = subprocess.run([sys.executable, str(CHECK), str(tree)], capture_output=True, text=True, encoding="utf-8")
    return " ".join((done.stdout + done.stderr).split()), done.returncode


@dataclass(frozen=True)
class Fault:
    """Imports that are planted in a module, of a package in a new module `name` of it."""

    module: str
    text: str
    imported: tuple[str, ...]
    name: str = "planted"

    def plant(self, tree: Path) -> None:
        where = self._place(tree)
        if where.is_dir():
            where = where / f"{self.name}.py"
        with where.open("a", encoding="utf-8") as file:
            file.write(f"\n{self.text}\n")

    def _place(self, tree: Path) -> Path:
        first, *rest = self.module.split(".")
        distributions = (rules.OF_DISTRIBUTIONS / name for name in ("humble", "jazzy", "kilted"))
        tops = (*rules.PARTS, rules.ON_THE_PATH, *distributions)
        path = next(there for top in tops if (there := tree / top / first).is_dir()).joinpath(*rest)
        return path if path.is_dir() else path.with_suffix(".py")

    def missing(self, output: str) -> list[str]:
        """What the check should have said of it, and did not: `module -> imported (l.5)`."""
        importer = f"{self.module}.{self.name}" if self._place(ROOT).is_dir() else self.module
        return [line for each in self.imported if (line := f" {importer} -> {each} (l.") not in output]


def fault(module: str, imported: str, name: str = "planted") -> Fault:
    return Fault(module, f"import {imported}", (imported,), name)


def in_every_layer() -> list[Fault]:
    """In each module of a layer: the screen at the top, and the layer directly above inside a function."""
    found = [sorted(rules.named_in([layer])) for layer in rules.layers(ROOT)]
    return [
        Fault(module, f"import {SCREEN}\ndef later() -> None:\n    import {above[0]}", (SCREEN, above[0]))
        for above, these in itertools.pairwise(found)
        for module in these
    ]


NEIGHBOURS = [
    fault("day6_core.graph", "day6_core.interfaces", "neighbour"),
    fault("day6_core.link", "std_msgs.msg", "neighbour"),
    fault("day6_urdf", "day6_core.places", "neighbour"),
    fault("launch", "day6_core.session", "neighbour"),
]
FOR_TYPES = Fault(
    "day6_core.session",
    f"from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from {SCREEN} import main",
    (SCREEN,),
    "for_types",
)
DOORS = [
    Fault("rclpy", "def later() -> None:\n    import rich.text", ("rich",), "door"),
    Fault("day6_core.shell", "import textual.app", ("textual",), "door"),
    fault("day6_tui", "zenoh", "door"),
    fault("tf2_ros", "zenoh", "door"),
    fault("day6_core.ros.programs", "yourdfpy", "door"),
]
BY_NAME = [
    Fault("day6_core.link", 'importlib.import_module("day6_tui.app")', (), "by_name"),
    Fault("rclpy", "__import__('day6_core.session.session')", (), "by_name"),
]
ESCAPED = {
    "core/day6_core/sound/__init__.py": "is in no layer of pyproject.toml",
    "core/day6_core/ros/python/moveit/__init__.py": "is in no layer of pyproject.toml",
    "core/day6_core/shell/loose/module.py": "is in a folder without __init__.py",
    "core/day6_core/ros/__init__.py": "imports something, and is in no layer",
}


@pytest.fixture(scope="module")
def planted(tmp_path_factory: pytest.TempPathFactory) -> str:
    """What the check says of a copy of the tree with all the faults of this module in it."""
    tree = tmp_path_factory.mktemp("planted") / "tree"
    for _, path in rules.modules(ROOT):
        (tree / path).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / path, tree / path)
    shutil.copyfile(ROOT / "pyproject.toml", tree / "pyproject.toml")
    for each in [*in_every_layer(), *NEIGHBOURS, FOR_TYPES, *DOORS, *BY_NAME]:
        each.plant(tree)
    for name in ESCAPED:
        (tree / name).parent.mkdir(exist_ok=True)
        (tree / name).write_text("import sys\n", encoding="utf-8")
    output, status = said(tree)
    assert status == 1
    return output


def test_the_tree_as_it_is_keeps_every_rule() -> None:
    output, status = said(ROOT)
    assert "3 kept, 0 broken" in output
    assert status == 0, output


def test_a_forbidden_import_is_seen_in_every_layer_at_the_top_and_inside_a_function(planted: str) -> None:
    faults = in_every_layer()
    assert {"launch", "rclpy", "tf2_ros", "day6_core.graph"} <= {each.module for each in faults}
    assert [line for each in faults for line in each.missing(planted)] == []


def test_neighbours_in_a_layer_do_not_know_each_other(planted: str) -> None:
    assert [line for each in NEIGHBOURS for line in each.missing(planted)] == []


def test_what_is_imported_only_for_the_type_checker_counts_too(planted: str) -> None:
    assert FOR_TYPES.missing(planted) == []


def test_the_screen_zenoh_and_yourdfpy_have_one_door_each(planted: str) -> None:
    assert [line for each in DOORS for line in each.missing(planted)] == []


def test_no_module_escapes_the_layers(planted: str) -> None:
    assert [name for name, why in ESCAPED.items() if f"{name} {why}" not in planted] == []


def test_a_higher_layer_is_not_reached_by_its_name_in_a_string_either(planted: str) -> None:
    assert "core/day6_core/link/by_name.py names day6_tui.app, which is in a higher layer" in planted
    assert "core/day6_core/ros/python/rclpy/by_name.py names day6_core.session.session, which is in a higher" in planted
