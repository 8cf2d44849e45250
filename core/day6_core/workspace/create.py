"""Creates a new package, as `ros2 pkg create` does. The folder appears complete or not at all."""

from __future__ import annotations

import os
import secrets
import shutil
from collections.abc import Callable
from pathlib import Path

from day6_core.reason import reason
from day6_core.ros.differences import value
from day6_core.workspace import templates
from day6_core.workspace.templates import PackagePlan

_LICENSES = Path(__file__).with_name("licenses")

LICENSES = (
    "Apache-2.0",
    "BSL-1.0",
    "BSD-2.0",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "GPL-3.0-only",
    "LGPL-3.0-only",
    "MIT",
    "MIT-0",
)
"""SPDX names of the licenses that get a LICENSE file."""


class _Draft:
    """The files of the package and the lines printed about them, in the original's order."""

    def __init__(self, shown: str) -> None:
        self.shown = shown
        """The package's folder as printed."""
        self.files: dict[str, str] = {}
        self.folders: list[str] = []
        self.lines: list[str] = []

    def folder(self, name: str = "") -> None:
        self.lines.append(f"creating folder {os.path.join(self.shown, name) if name else self.shown}")
        self.folders.append(name)

    def file(self, name: str, text: str) -> None:
        self.lines.append(f"creating {os.path.join(self.shown, name)}")
        self.files[name] = text


def create(plan: PackagePlan, destination: Path, shown: str, print_line: Callable[[str], object]) -> None:
    """Create the package in `destination` (`shown` as it was typed) and print each step.

    Raises:
        OSError: it could not be written; nothing is left behind.
    """
    draft = _Draft(os.path.join(shown, plan.name))
    draft.folder()
    draft.file("package.xml", templates.package_xml(plan))
    {"ament_python": _draft_python, "ament_cargo": _draft_rust}.get(plan.build_type, _draft_cpp)(draft, plan)
    if plan.license in LICENSES:
        draft.files["LICENSE"] = (_LICENSES / f"{plan.license}.txt").read_text(encoding="utf-8")
    _write(draft, destination, plan.name)
    for line in draft.lines:
        print_line(line)
    if plan.license not in LICENSES:
        print_line(
            f"\n[WARNING]: Unknown license '{plan.license}'.  This has been set in the package.xml, but no LICENSE file has "
            f"been created.\nIt is recommended to use one of the ament license {value('pkg.create_licences')}:\n"
            + "\n".join(LICENSES)
        )


def _draft_python(draft: _Draft, plan: PackagePlan) -> None:
    draft.lines.append("creating source folder")
    draft.folder(plan.name)
    draft.file("setup.py", templates.setup_py(plan))
    draft.file("setup.cfg", templates.setup_cfg(plan))
    draft.folder("resource")
    draft.file(os.path.join("resource", plan.name), "")
    draft.file(os.path.join(plan.name, "__init__.py"), "")
    draft.folder("test")
    for name, text in templates.TESTS.items():
        draft.file(os.path.join("test", name), text)
    if plan.node:
        draft.file(os.path.join(plan.name, f"{plan.node}.py"), templates.python_node(plan))
    if plan.library:
        draft.folder(os.path.join(plan.name, plan.library))
        draft.file(os.path.join(plan.name, plan.library, "__init__.py"), "")


def _draft_rust(draft: _Draft, plan: PackagePlan) -> None:
    draft.lines.append("creating source folder")
    draft.folder("src")
    draft.file("Cargo.toml", templates.cargo_toml(plan))
    draft.file(os.path.join("src", "main.rs"), templates.rust_node(plan))


def _draft_cpp(draft: _Draft, plan: PackagePlan) -> None:
    include = os.path.join("include", plan.name)
    draft.lines.append("creating source and include folder")
    draft.folder("src")
    draft.folder(include)
    if plan.build_type == "cmake":
        draft.file("CMakeLists.txt", templates.cmake_lists(plan))
        draft.file(f"{plan.name}Config.cmake.in", templates.cmake_config(plan))
        draft.file(f"{plan.name}ConfigVersion.cmake.in", templates.cmake_config_version(plan))
    else:
        draft.file("CMakeLists.txt", templates.ament_cmake_lists(plan))
    if plan.node:
        draft.file(os.path.join("src", f"{plan.node}.cpp"), templates.cpp_node(plan))
    if plan.library:
        draft.file(os.path.join(include, f"{plan.library}.hpp"), templates.cpp_header(plan))
        draft.file(os.path.join("src", f"{plan.library}.cpp"), templates.cpp_library(plan))
        draft.file(os.path.join(include, "visibility_control.h"), templates.cpp_visibility(plan))


def _write(draft: _Draft, destination: Path, name: str) -> None:
    target = destination / name
    target.parent.mkdir(parents=True, exist_ok=True)
    try:
        folder = target.parent / f".day6-new-{secrets.token_hex(6)}"
        folder.mkdir()
    except OSError as error:
        raise OSError(error.errno, reason(error), draft.shown) from error
    try:
        for inner in draft.folders:
            (folder / inner).mkdir(parents=True, exist_ok=True)
        for path, text in draft.files.items():
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_text(text, encoding="utf-8", errors="surrogateescape", newline="\n")
        folder.rename(target)
    except OSError as error:
        shutil.rmtree(folder, ignore_errors=True)
        raise OSError(error.errno, reason(error), draft.shown) from error
