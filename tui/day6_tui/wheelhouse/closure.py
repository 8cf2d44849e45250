"""Everything a requirement needs on another machine.

pip finds wheels for other machines, but judges the markers of requirements (`; sys_platform == "win32"`) by the machine it runs
on. So each project is fetched by itself here, and what it requires is read from its wheel and judged for the target.
"""

from __future__ import annotations

import errno
import os
import re
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from email.parser import BytesParser
from pathlib import Path

from packaging.requirements import Requirement
from packaging.specifiers import SpecifierSet
from packaging.utils import canonicalize_name, parse_wheel_filename

from day6_tui.wheelhouse.targets import Target

MOST_FETCHES = 400

USED = {("trimesh", "easy"): {"pycollada"}}
"""Of what an extra brings, that which is used here: the rest is left out, as `exclude-dependencies` in pyproject.toml has it."""


_CONNECTION = re.compile(
    r"(NewConnectionError|NameResolutionError|ConnectTimeoutError|ReadTimeoutError|ProxyError|ConnectionResetError)"
)
"""What pip's HTTP library (urllib3) calls it when nobody answers."""


class FetchError(Exception):
    """A project cannot be had for a target; the message is pip's."""


class NoInternet(FetchError):
    """Nobody answers; the message is the system's."""


@dataclass
class _Project:
    specifier: SpecifierSet = field(default_factory=SpecifierSet)
    extras: set[str] = field(default_factory=set)
    wheel: Path | None = None
    read: set[str] = field(default_factory=set)
    """The extras ('' for none) whose requirements have been followed."""


def fetch(wheel: Path, extras: Iterable[str], target: Target, folder: Path, tell: Callable[[str], None]) -> set[str]:
    """Fetch what a wheel with these extras needs on a target into `folder`; return the names of the files.

    Raises FetchError, OSError.
    """
    own = canonicalize_name(parse_wheel_filename(wheel.name)[0])
    projects: dict[str, _Project] = {own: _Project(extras=set(extras), wheel=wheel)}
    for _ in range(MOST_FETCHES):
        name = next((name for name, each in projects.items() if each.wheel is None or _unread(each)), None)
        if name is None:
            return {each.wheel.name for each in projects.values() if each.wheel is not None and each.wheel != wheel}
        project = projects[name]
        if project.wheel is None:
            project.wheel = _fetched(f"{name}{project.specifier}", target, folder)
            tell(f"{project.wheel.name} ({target})")
        for extra in _unread(project):
            project.read.add(extra)
            used = USED.get((name, extra))
            for requirement in _requirements(project.wheel, extra, target):
                if used is None or canonicalize_name(requirement.name) in used:
                    _want(projects, requirement)
    raise FetchError(f"{target}: no end of requirements")


def _unread(project: _Project) -> set[str]:
    return {"", *project.extras} - project.read


def _want(projects: dict[str, _Project], requirement: Requirement) -> None:
    """Note a requirement; a project that was fetched in a version it forbids is fetched again."""
    project = projects.setdefault(canonicalize_name(requirement.name), _Project())
    project.extras |= requirement.extras
    project.specifier &= requirement.specifier
    if project.wheel is not None and str(project.specifier):
        version = parse_wheel_filename(project.wheel.name)[1]
        if not project.specifier.contains(version, prereleases=True):
            project.wheel, project.read = None, set()


def _requirements(wheel: Path, extra: str, target: Target) -> list[Requirement]:
    with zipfile.ZipFile(wheel) as packed:
        # At the top only: packages inside (launch_testing …) bring metadata of their own.
        name = next(each for each in packed.namelist() if re.fullmatch(r"[^/]+\.dist-info/METADATA", each))
        found = BytesParser().parsebytes(packed.read(name)).get_all("Requires-Dist") or []
    environment = {**target.markers(), "extra": extra}
    bare = {**environment, "extra": ""}
    wanted = []
    for requirement in map(Requirement, found):
        marker = requirement.marker
        if marker is None:
            holds = not extra
        else:
            holds = marker.evaluate(environment) and (not extra or not marker.evaluate(bare))
        if holds:
            wanted.append(requirement)
    return wanted


def _fetched(requirement: str, target: Target, folder: Path) -> Path:
    """Fetch one project with pip. Raises FetchError."""
    with tempfile.TemporaryDirectory(dir=folder, prefix=".fetching-") as place:
        done = subprocess.run(
            [
                *(sys.executable, "-m", "pip", "--disable-pip-version-check", "--no-input", "download", "--quiet"),
                *("--no-deps", "--dest", place, *target.pip_words(), requirement),
            ],
            capture_output=True,
            encoding="utf-8",
            errors="replace",
            stdin=subprocess.DEVNULL,
        )
        wheels = list(Path(place).glob("*.whl"))
        if done.returncode or len(wheels) != 1:
            raise _why(done.stderr, f"{requirement} ({target})")
        kept = folder / wheels[0].name
        if not kept.exists():
            wheels[0].rename(kept)
    return kept


def _why(said: str, what: str) -> Exception:
    """What is wrong, from what pip has said on stderr: it names a project missing, too, when no index can be reached."""
    lines = said.splitlines()
    if os.strerror(errno.ENOSPC) in said:
        return OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
    broken = [line for line in lines if _CONNECTION.search(line)]
    if broken and "(from versions: none)" in said:
        reason = re.search(r"\[Errno -?\d+\] ([^'\")]+)", broken[-1])
        kind = _CONNECTION.search(broken[-1])
        return NoInternet(reason[1] if reason else kind[1] if kind else "")
    errors = [line for line in lines if line.startswith("ERROR:")] or lines
    return FetchError(f"{what}: {errors[-1] if errors else 'pip fetched nothing'}")
