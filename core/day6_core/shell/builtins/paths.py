"""ln, readlink, realpath; pushd, popd and dirs."""

from __future__ import annotations

import os
from pathlib import Path
from uuid import uuid4

from day6_core.session.session import Session
from day6_core.shell.builtins.options import UsageError, complain, complain_as_shell, parse, reason
from day6_core.shell.language.interpreter import shell_of
from day6_core.shell.outside import asking


@asking(lambda names: names[-1:] if len(names) > 1 else [])
async def ln(session: Session) -> int:
    """`ln -s TARGET [NAME]`, also hard links; `-f` replaces what is there."""
    try:
        options, names = parse(session.argv, "sfnvT", long={"--symbolic": "s", "--force": "f"})
    except UsageError as error:
        complain(session, error)
        return 1
    if not names:
        session.print_error("ln: missing file operand\nTry 'ln --help' for more information.")
        return 1
    targets, last = (names[:-1], names[-1]) if len(names) > 1 else (names, ".")
    into_folder = (session.cwd / last).is_dir()
    if len(targets) > 1 and not into_folder:
        complain(session, f"target '{last}' is not a directory")
        return 1
    status = 0
    for target in targets:
        shown = os.path.join(last, os.path.basename(target.rstrip("/"))) if into_folder else last
        if not _link(session, target, shown, symbolic="s" in options, force="f" in options):
            status = 1
    return status


def _link(session: Session, target: str, name: str, *, symbolic: bool, force: bool) -> bool:
    place = session.cwd / name
    source = session.cwd / target
    if force and not place.is_dir() and _is_entry(source if not symbolic else place.parent / target, place, symbolic):
        complain(session, f"'{target}' and '{name}' are the same file")
        return False
    # As the original does: made beside, then renamed, so that what was there is lost only to a link that could be made.
    made = place.with_name(f".day6-{uuid4().hex}") if force and (place.is_symlink() or place.is_file()) else place
    try:
        if symbolic:
            made.symlink_to(target)
        else:
            os.link(source, made)
        if made != place:
            os.replace(made, place)
    except OSError as error:
        if made != place:
            made.unlink(missing_ok=True)
        kind = "symbolic" if symbolic else "hard"
        arrow = "" if symbolic else f" => '{target}'"
        complain(session, f"failed to create {kind} link '{name}'{arrow}: {reason(error)}")
        return False
    return True


def _is_entry(source: Path, place: Path, symbolic: bool) -> bool:
    """Whether a link at `place` would replace its own target."""
    if symbolic:
        same_folder = os.path.realpath(source.parent) == os.path.realpath(place.parent)
        return same_folder and source.name == place.name and os.path.lexists(place)
    return not place.is_symlink() and place.exists() and source.exists() and source.samefile(place)


async def readlink(session: Session) -> int:
    """`readlink NAME` prints what a link points to, `readlink -f NAME` the final target."""
    try:
        options, names = parse(session.argv, "fenm")
    except UsageError as error:
        complain(session, error)
        return 1
    if not names:
        session.print_error("readlink: missing operand\nTry 'readlink --help' for more information.")
        return 1
    status = 0
    for name in names:
        place = session.cwd / name
        if options.keys() & set("fem"):
            session.print(os.path.realpath(place))
        elif place.is_symlink():
            session.print(os.readlink(place))
        else:
            status = 1
    return status


async def realpath(session: Session) -> int:
    """The path without links and dots."""
    try:
        _, names = parse(session.argv, "ems")
    except UsageError as error:
        complain(session, error)
        return 1
    if not names:
        session.print_error("realpath: missing operand\nTry 'realpath --help' for more information.")
        return 1
    status = 0
    for name in names:
        found = os.path.realpath(session.cwd / name)
        if os.path.exists(os.path.dirname(found)):
            session.print(found)
        else:
            complain(session, f"{name}: No such file or directory")
            status = 1
    return status


async def pushd(session: Session) -> int:
    """`pushd FOLDER` changes there and remembers the old working directory; `pushd` swaps the two."""
    shell = shell_of(session)
    names = [word for word in session.argv[1:] if not word.startswith("-")]
    if not names and not shell.folders:
        session.print_error(f"{shell.name}: pushd: no other directory")
        return 1
    target = names[0] if names else shell.folders[0]
    before = str(shell.cwd)
    if not _go(session, target):
        return 1
    shell.folders = [before, *(shell.folders if names else shell.folders[1:])]
    return await dirs(session)


async def popd(session: Session) -> int:
    """Go back to where the last `pushd` was."""
    shell = shell_of(session)
    if not shell.folders:
        session.print_error(f"{shell.name}: popd: directory stack empty")
        return 1
    if not _go(session, shell.folders[0]):
        return 1
    shell.folders = shell.folders[1:]
    return await dirs(session)


async def dirs(session: Session) -> int:
    """Print the directory stack, the working directory first."""
    shell = shell_of(session)
    home = shell.variables.get("HOME", "")
    shown = [
        "~" + folder[len(home) :] if home and (folder == home or folder.startswith(home + os.sep)) else folder
        for folder in (str(shell.cwd), *shell.folders)
    ]
    session.print(" ".join(shown))
    return 0


def _go(session: Session, target: str) -> bool:
    shell = shell_of(session)
    path = Path(os.path.normpath(shell.cwd / target))
    if not path.is_dir():
        wrong = "Not a directory" if path.exists() else "No such file or directory"
        complain_as_shell(session, f"{target}: {wrong}")
        return False
    shell.variables["OLDPWD"], shell.variables["PWD"] = str(shell.cwd), str(path)
    shell.cwd = path
    return True
