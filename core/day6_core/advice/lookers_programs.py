"""Lookers that look for what a Python program wanted and did not find."""

from __future__ import annotations

import re
from pathlib import Path

from day6_core.advice.lookers_files import elsewhere, of_package_file, short
from day6_core.advice.looking import Found, Situation, found, looker
from day6_core.facts.folders import names_in
from day6_core.facts.names import nearest
from day6_core.facts.workspaces import find_package, workspaces_around

_SHARED = re.compile(r"/install/(?:.+/)?share/(\w+)/(.+)$")
"""A file that belongs to an installed package."""


@looker
def program_file(scene: Situation) -> Found | None:
    """A file that a program opens: of somebody else's home, of a package that does not install it, or nearly another's name."""
    name = scene.value("name")
    if (foreign := re.match(r"(/home/[^/]+)(/.*)?$", name)) is not None and not Path(foreign[1]).exists():
        return found("program.example", "", name=name, wrong=foreign[1])
    if not name or (whole := scene.cwd / name).exists():
        return None
    if (shared := _SHARED.search(name.replace("\\", "/"))) is not None:
        lies = find_package(shared[1], workspaces_around(scene.variables, scene.cwd))
        cause = of_package_file(Path(shared[2]).name, lies, scene) if lies is not None else None
        if cause is not None:
            return cause
    near = nearest(whole.name, names_in(whole.parent))
    if near and len(whole.name) > 2:
        return found("path.near", "", name=name, near=name.removesuffix(whole.name) + near)
    there = elsewhere(whole.name, scene)
    if there is not None:
        return found(
            "program.elsewhere", "", name=whole.name, place=short(there, scene), folder=short(scene.cwd, scene)
        )
    return None
