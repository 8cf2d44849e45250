"""Checks of files and packages. Nothing is changed, and only ordinary files of an ordinary size are read."""

from __future__ import annotations

import os
import re
import stat
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from day6_core.lessons.checks import Verdict, check
from day6_core.lessons.checks.patterns import readable
from day6_core.lessons.texts import Say
from day6_core.reason import reason
from day6_core.workspace.manifest import Manifest, ManifestError, read_manifest

if TYPE_CHECKING:
    from day6_core.lessons.live import Live

LARGEST = 2_000_000
"""Bytes of a file that a check reads."""

MOST_FILES = 2000
"""Files of a package that are looked at."""

SOURCES = "~/ros2_ws/src"


class Unreadable(Exception):
    """A file that is there and cannot be read."""


def read(path: Path) -> str | None:
    """The text of a file, None if there is none. Raises Unreadable."""
    try:
        found = path.stat()
        if not stat.S_ISREG(found.st_mode):
            raise Unreadable("no ordinary file")
        if found.st_size > LARGEST:
            raise Unreadable(f"larger than {LARGEST} bytes")
        return path.read_text(encoding="utf-8", errors="replace")
    except FileNotFoundError:
        return None
    except NotADirectoryError:
        return None
    except OSError as error:
        raise Unreadable(reason(error)) from None


@check("file", patterns=("has", "lacks"), paths=("path",))
def file(live: Live, path: str, has: str = "", lacks: str = "") -> Verdict:
    wanted = Say("file", path=path)
    if has:
        wanted = Say("file.has", path=path, pattern=readable(has))
    elif lacks:
        wanted = Say("file.lacks", path=path, pattern=readable(lacks))
    try:
        text = read(live.path(path))
    except Unreadable as error:
        return Verdict(False, wanted, Say("file.unread", path=path, reason=error))
    if text is None:
        if has or lacks:
            return Verdict(False, wanted, Say("file.saw_none", path=path))
        return Verdict(False, Say("missing", inner=wanted))
    if has and not re.search(has, text, re.MULTILINE):
        return Verdict(False, wanted, Say("file.saw_not"))
    if lacks and re.search(lacks, text, re.MULTILINE):
        return Verdict(False, Say("file.lacks", path=path, pattern=readable(lacks)), Say("file.saw_still"))
    return Verdict(True, wanted)


@check("folder", paths=("path",))
def folder(live: Live, path: str) -> Verdict:
    wanted, ok = Say("folder", path=path), live.path(path).is_dir()
    return Verdict(ok, wanted if ok else Say("missing", inner=wanted))


@check("no_file", paths=("path",))
def no_file(live: Live, path: str) -> Verdict:
    there = os.path.lexists(live.path(path))
    return Verdict(not there, Say("no_file", path=path), Say("no_file.saw", path=path) if there else None)


class _Package(NamedTuple):
    """A folder with a package.xml, and what that says, or why it cannot be read."""

    folder: Path
    manifest: Manifest | str


def _packages(top: Path, deep: int = 1) -> dict[str, list[_Package]]:
    """The packages that lie directly in a folder, by their names in package.xml; `deep`: so many levels below."""
    found: dict[str, list[_Package]] = {}
    for path in sorted(top.glob("*/" * deep + "package.xml"))[:MOST_FILES]:
        package = _Package(path.parent, _manifest(path.parent))
        name = package.manifest.name if isinstance(package.manifest, Manifest) else package.folder.name
        found.setdefault(name, []).append(package)
    return found


def _manifest(folder: Path) -> Manifest | str:
    try:
        return read_manifest(folder, folder.name, {"ROS_VERSION": "2"}) or "package.xml"
    except ManifestError as error:
        return str(error).splitlines()[-1]


def _shown(folder: Path, live: Live) -> str:
    return f"~/{folder.relative_to(live.home).as_posix()}"


@check("package", paths=("in",))
def package(live: Live, name: str, type_: str = "", depends: list[str] | None = None, in_: str = SOURCES) -> Verdict:
    wanted = Say("package", name=name, folder=in_)
    top = live.path(in_)
    packages = _packages(top)
    if name not in packages:
        deeper = _packages(top, 2).get(name) or _packages(top, 3).get(name)
        if deeper is not None:
            return Verdict(False, wanted, Say("package.saw_deeper", path=_shown(deeper[-1].folder, live)))
        return Verdict(False, wanted, Say("package.saw", names=tuple(packages)))
    copies = [each.folder for each in packages[name] if isinstance(each.manifest, Manifest)]
    if len(copies) > 1:  # colcon builds none of them
        return Verdict(False, wanted, Say("package.saw_twice", paths=tuple(_shown(each, live) for each in copies)))
    manifest = packages[name][-1].manifest
    if isinstance(manifest, str):
        return Verdict(False, wanted, Say("package.bad", reason=manifest))
    if type_ and manifest.build_type != type_:
        return Verdict(False, Say("package.type", type=type_), Say("package.saw_type", type=manifest.build_type))
    known = {*manifest.build_depends, *manifest.run_depends}
    missing = [each for each in depends or () if each not in known]
    if missing:
        names = tuple(depends or ())
        return Verdict(False, Say("package.depends", names=names), Say("package.saw_missing", names=tuple(missing)))
    return Verdict(True, wanted)


_ENTRY = re.compile(r"""['"]\s*([\w.-]+)\s*=\s*([\w.]+:[\w.]+)\s*['"]""")


@check("entry_point", patterns=("to",), paths=("in",))
def entry_point(live: Live, package: str, name: str, to: str = "", in_: str = SOURCES) -> Verdict:
    wanted = Say("entry_point.to" if to else "entry_point", package=package, name=name, to=readable(to))
    path = live.path(in_) / package / "setup.py"
    try:
        text = read(path)
    except Unreadable as error:
        return Verdict(False, wanted, Say("file.unread", path="setup.py", reason=error))
    if text is None:
        return Verdict(False, wanted, Say("file.saw_none", path=f"{in_}/{package}/setup.py"))
    code = "\n".join(line for line in text.splitlines() if not line.lstrip().startswith("#"))
    entries = dict(_ENTRY.findall(code))
    ok = name in entries and re.search(to, entries[name]) is not None
    shown = tuple(f"{key} = {value}" for key, value in entries.items())
    return Verdict(ok, wanted, None if ok else Say("entry_point.saw", names=shown))


@check("built", paths=("in",))
def built(live: Live, name: str, in_: str = SOURCES) -> Verdict:
    wanted = Say("built", name=name)
    top = live.path(in_)
    sources = _packages(top).get(name)
    source = sources[-1].folder if sources else None
    install = top.parent / "install"
    share = next(
        (
            each
            for each in (install / name / "share" / name, install / "share" / name)
            if (each / "package.xml").is_file()
        ),
        None,
    )
    if source is None or share is None:
        return Verdict(False, wanted, Say("built.saw_never"))
    result = top.parent / "build" / name / "colcon_build.rc"
    if not result.is_file() or (read(result) or "").strip() != "0":
        return Verdict(False, wanted, Say("built.saw_failed"))
    when = result.stat().st_mtime_ns
    linked = _is_linked(top.parent / "build" / name)
    for path in sorted(source.rglob("*"))[:MOST_FILES]:
        parts = path.relative_to(source).parts
        if any(part.startswith(".") or part == "__pycache__" or part.endswith(".egg-info") for part in parts):
            continue
        if linked and path.suffix == ".py" and path.name != "setup.py":
            continue
        if path.is_file() and path.stat().st_mtime_ns > when:
            return Verdict(False, wanted, Say("built.saw_old", path=path.relative_to(source).as_posix()))
    return Verdict(True, wanted)


def _is_linked(build: Path) -> bool:
    """Whether it was built with --symlink-install, so that its modules need no build."""
    return any(each.is_symlink() for each in build.glob("*"))
