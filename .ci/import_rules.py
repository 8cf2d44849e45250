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

TREE = Path(__file__).resolve().parents[1]
PARTS = ("core", "tui", "urdf")
ON_THE_PATH = Path("core", "day6_core", "ros", "python")
OF_DISTRIBUTIONS = ON_THE_PATH.with_name("python_of")
"""The packages that not every distribution has; a folder for each one, which repeat each other."""
SHARE = ON_THE_PATH.with_name("share")
"""Data, launch files among them."""
FOR_STUDENTS = ON_THE_PATH / "day6_core" / "__init__.py"
"""Only for their processes: where a plain Python finds the real one."""
CONTAINERS = {"day6_core", "day6_core.ros"}
"""Folders whose contents are in several layers; their own `__init__` has only a docstring and imports nothing."""
BY_NAME = {
    "day6_core.interfaces.stubs": "what an editor's type checker imports",
    "day6_core.ros.executables": "day6-tui's own command line",
    "day6_core.shell.outward.subshell": "day6-tui's own command line",
    "launch._entry_points": "what are entry points in ROS",
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


def layers_contract(tree: Path) -> dict[str, list[str]]:
    """Return the options of the contract of type `layers`."""
    from importlinter.application.use_cases import read_user_options
    from importlinter.configuration import configure

    configure()
    options = read_user_options(str(tree / "pyproject.toml")).contracts_options
    contract: dict[str, list[str]] = next(each for each in options if each["type"] == "layers")
    return contract


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
    folders = (*PARTS, ON_THE_PATH, *sorted((tree / OF_DISTRIBUTIONS).iterdir()))
    sys.path[:0] = [str(tree / folder) for folder in folders]


def main(tree: Path = TREE) -> int:
    """Print every violation; returns the exit status."""
    from importlinter.cli import lint_imports

    make_importable(tree)
    layers = layers_contract(tree)["layers"]
    lines = [*escaping(tree, named_in(layers)), *reaching_up(tree, layers)]
    for line in lines:
        print(line)
    return lint_imports(str(tree / "pyproject.toml"), no_cache=tree != TREE) or int(bool(lines))


if __name__ == "__main__":
    sys.exit(main(*map(Path, sys.argv[1:])))
