"""Checks pyproject's import contracts, and that nothing escapes them: `python .ci/import_rules.py [TREE]`.

Every module has to be in a layer, and none may reach a higher one by its name in a string (`import_module("day6_tui.app")`).

Nothing needs to be installed: the folders in which packages are come first on the path.
"""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Container, Iterator
from pathlib import Path

from importlinter.adapters.user_options import TomlFileUserOptionReader
from importlinter.application.app_config import settings
from importlinter.application.use_cases import read_user_options
from importlinter.application.user_options import UserOptions
from importlinter.cli import lint_imports
from importlinter.configuration import configure

TREE = Path(__file__).resolve().parents[1]
PARTS = ("core", "tui", "urdf")
ON_THE_PATH = Path("core", "day6_core", "ros", "python")
OF_DISTRIBUTIONS = ON_THE_PATH.with_name("python_of")
"""The packages that not every distribution has; a folder for each one, which repeat each other."""
SHARE = ON_THE_PATH.with_name("share")
"""Data, launch files among them."""
FOR_STUDENTS = ON_THE_PATH / "day6_core" / "__init__.py"
"""Only for their processes: where a plain Python finds the real one."""
INTERFACES = "<interfaces>"
"""What stands in the layers for all packages of interfaces that they do not name."""
CONTAINERS = {"day6_core", "day6_core.ros"}
"""Folders whose contents are in several layers; their own `__init__` has only a docstring and imports nothing."""
BY_NAME = {
    "day6_core.interfaces.stubs": "what an editor's type checker imports",
    "day6_core.ros.executables": "day6-tui's own command line",
    "day6_core.ros.ros2.extension_points": "a group of entry points is named as a module",
    "day6_core.ros.ros2.extensions": "a group of entry points is named as a module",
    "day6_core.shell.outward.subshell": "day6-tui's own command line",
    "launch._entry_points": "what are entry points in ROS",
    "rclpy": "says which module, imported by the program, brings rclpy.action along",
}
"""Modules that may name a module of a higher layer in a string, and the reason."""
_DOTTED_STRING = re.compile(r"""["']([A-Za-z_]\w*(?:\.\w+)+)["']""")


def modules(tree: Path) -> Iterator[tuple[str, Path]]:
    """Yield name and file of every module of the tree, whether Python would find it or not."""
    for part in PARTS:
        for file in sorted((tree / part).rglob("*.py")):
            path = file.relative_to(tree)
            if SHARE in path.parents or path == FOR_STUDENTS:
                continue
            names = path.relative_to(_top(path)).with_suffix("").parts
            yield ".".join(names[:-1] if names[-1] == "__init__" else names), path


def packages_for_programs(tree: Path) -> set[str]:
    """Return the packages that programs of a user have on their path."""
    found = {each.parent.name for base in _bases(tree) for each in (tree / base).glob("*/__init__.py")}
    return found - {FOR_STUDENTS.parent.name}


class Options(TomlFileUserOptionReader):
    """import-linter's options, with the packages for programs; those of interfaces need no line in the layers."""

    def __init__(self, tree: Path) -> None:
        self._tree = tree

    def read_options(self, config_filename: str | None = None) -> UserOptions | None:
        given = super().read_options(config_filename)
        assert given is not None
        packages = packages_for_programs(self._tree)
        given.session_options["root_packages"] += sorted(packages)
        layers = layers_of(given)
        interfaces = " | ".join(sorted(set(filter(self._has_interfaces, packages)) - named_in(layers)))
        layers[:] = [layer.replace(INTERFACES, interfaces) for layer in layers]
        return given

    def _has_interfaces(self, package: str) -> bool:
        kinds = (self._tree / base / package / kind for base in _bases(self._tree) for kind in ("msg", "srv", "action"))
        return any(map(Path.is_dir, kinds))


def layers(tree: Path) -> list[str]:
    """Return the layers of a tree, from the top; import-linter has its options from then on."""
    configure()
    settings.configure(USER_OPTION_READERS={"toml": Options(tree)})
    return layers_of(read_user_options(str(tree / "pyproject.toml")))


def layers_of(given: UserOptions) -> list[str]:
    """Return the layers of the contract of that type, from the top."""
    layers: list[str] = next(each for each in given.contracts_options if each["type"] == "layers")["layers"]
    return layers


def named_in(layers: list[str]) -> set[str]:
    """Return the modules named in the lines of a layers contract."""
    return {name.strip() for layer in layers for name in layer.replace("|", ":").split(":")}


def escaping(tree: Path, layers: set[str]) -> Iterator[str]:
    """Yield a line for every module that the contract doesn't see."""
    for name, path in modules(tree):
        if name in CONTAINERS:
            if any(isinstance(node, (ast.Import, ast.ImportFrom)) for node in ast.walk(_parsed(tree / path))):
                yield f"{path} imports something, and is in no layer"
        elif not any(name == layer or name.startswith(f"{layer}.") for layer in layers):
            yield f"{path} is in no layer of pyproject.toml"
        elif not all((tree / folder / "__init__.py").is_file() for folder in _packages_around(path)):
            yield f"{path} is in a folder without __init__.py, where import-linter sees nothing"


def reaching_up(tree: Path, layers: list[str]) -> Iterator[str]:
    """Yield a line for every module that names a higher layer's module in a string without a reason in BY_NAME."""
    height = {name: -number for number, layer in enumerate(layers) for name in named_in([layer])}
    files = dict(modules(tree))
    for name, path in files.items():
        if name in BY_NAME:
            continue
        own = _height(name, height)
        for named in _strings(tree / path, files):
            if _height(named, height) > own:
                yield f"{path} names {named}, which is in a higher layer"


def _strings(file: Path, wanted: Container[str]) -> list[str]:
    """Return which of the wanted strings are in a file; it is parsed only if a text search finds one."""
    if not any(found in wanted for found in _DOTTED_STRING.findall(file.read_text(encoding="utf-8"))):
        return []
    constants = (node.value for node in ast.walk(_parsed(file)) if isinstance(node, ast.Constant))
    return [value for value in constants if isinstance(value, str) and value in wanted]


def _height(module: str, height: dict[str, int]) -> int:
    """Return the height of a module's layer; a module in no layer is below all of them."""
    while module and module not in height:
        module = module.rpartition(".")[0]
    return height.get(module, -len(height))


def _packages_around(path: Path) -> Iterator[Path]:
    """Yield the folders that have to be packages for the file to be a module of the tree."""
    top = _top(path)
    yield from (folder for folder in path.parents if top in folder.parents)


def _top(path: Path) -> Path:
    """Return the folder in which the file's package is."""
    if OF_DISTRIBUTIONS in path.parents:
        return OF_DISTRIBUTIONS / path.relative_to(OF_DISTRIBUTIONS).parts[0]
    return ON_THE_PATH if ON_THE_PATH in path.parents else Path(path.parts[0])


def _parsed(file: Path) -> ast.Module:
    return ast.parse(file.read_text(encoding="utf-8"), str(file))


def make_importable(tree: Path) -> None:
    """Have the names of the contracts found in this tree and nowhere else."""
    sys.path[:0] = [str(tree / folder) for folder in (*PARTS, *_bases(tree))]


def _bases(tree: Path) -> list[Path]:
    """Return the folders that programs have on their path, of all distributions."""
    return [ON_THE_PATH, *sorted(path.relative_to(tree) for path in (tree / OF_DISTRIBUTIONS).iterdir())]


def main(tree: Path = TREE) -> int:
    """Print every violation; returns the exit status."""
    make_importable(tree)
    in_order = layers(tree)
    lines = [*escaping(tree, named_in(in_order)), *reaching_up(tree, in_order)]
    for line in lines:
        print(line)
    return lint_imports(str(tree / "pyproject.toml"), no_cache=tree != TREE) or int(bool(lines))


if __name__ == "__main__":
    sys.exit(main(*map(Path, sys.argv[1:])))
