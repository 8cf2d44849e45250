"""Packages of interfaces have the files by which they are imported; `python -m tests.interfaces.test_packages` writes them."""

from __future__ import annotations

from pathlib import Path

from day6_core.interfaces import registry
from day6_core.interfaces.package import package_files
from day6_core.ros import differences, distribution
from day6_core.ros.environment import PYTHON_PATH


def folders(package: str) -> list[Path]:
    """Return where a package lies: on the path of every program, or of those of the distributions that have it."""
    rows = [each[package][0] for each in (differences.PACKAGES, differences.INTERFACES) if package in each]
    having = [name for name in distribution.NAMES if all(name in row for row in rows)]
    everywhere = len(having) == len(distribution.NAMES)
    return [Path(PYTHON_PATH)] if everywhere else [Path(distribution.python_folder(name)) for name in having]


def files() -> dict[Path, str]:
    """Return what has to be there, by path."""
    found: dict[Path, str] = {}
    for share in Path(registry.OWN_SHARE).iterdir():
        if kinds := [kind for kind in registry.KINDS if (share / kind).is_dir()]:
            texts = package_files(share.name, kinds)
            found |= {folder / path: text for folder in folders(share.name) for path, text in texts.items()}
    return found


def test_every_package_with_interfaces_can_be_imported_where_it_is_there() -> None:
    wanted = files()
    wrong = [path for path, text in wanted.items() if not path.is_file() or path.read_text(encoding="utf-8") != text]
    of_distributions = [
        path for name in distribution.NAMES for path in Path(distribution.python_folder(name)).glob("*/__init__.py")
    ]
    left_over = [path for path in of_distributions if path not in wanted]
    assert (wrong, left_over) == ([], []), __doc__


def _write() -> None:
    for path, text in files().items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    _write()
