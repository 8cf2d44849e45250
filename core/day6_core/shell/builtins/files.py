"""cat, mkdir, rmdir, touch, rm, tee, chmod."""

from __future__ import annotations

import errno
import os
import stat
import time
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Any

from day6_core import deep
from day6_core.session.session import Session
from day6_core.session.streams import FileOutput, OutputStream, WriteError
from day6_core.session.task import let_others_run
from day6_core.shell.builtins.options import UsageError, complain, parse, reason
from day6_core.shell.builtins.text import lines_of
from day6_core.shell.outside import asking
from day6_core.shell.own_streams import own_output, table_of


async def cat(session: Session) -> int:
    try:
        options, names = parse(session.argv, "nbAEsTvu")
    except UsageError as error:
        complain(session, error)
        return 1
    problems: list[str] = []
    number = 0
    async for _, line in lines_of(session, names, problems):
        numbered = ("n" in options and "b" not in options) or ("b" in options and line != "\n")
        if numbered:
            number += 1
            line = f"{number:>6}\t{line}"
        if "T" in options or "A" in options:
            number_mark, tab, rest = line.partition("\t") if numbered else ("", "", line)
            line = number_mark + tab + rest.replace("\t", "^I")
        if "E" in options or "A" in options:
            line = line.replace("\n", "$\n")
        session.stdout.write(line)
    return 1 if problems else 0


def _all(names: list[str]) -> list[str]:
    return names


@asking(_all)
async def tee(session: Session) -> int:
    options, names = parse(session.argv, "ai")
    files: list[FileOutput] = []
    targets: dict[str, OutputStream] = {"'standard output'": session.stdout}
    status = 0
    for name in names:
        try:
            target = own_output(session.cwd / name, table_of(session))
            if target is None:
                if name.endswith("/"):
                    raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
                target = FileOutput(session.cwd / name, append="a" in options)
                files.append(target)
        except OSError as error:
            complain(session, f"{name}: {reason(error)}")
            status = 1
        else:
            targets[name] = target
    try:
        while targets and (line := await session.stdin.read_line()):
            for name, target in list(targets.items()):
                try:
                    target.write(line)
                    await target.drain()
                except WriteError as error:
                    complain(session, f"{name}: {reason(error)}")
                    status = 1
                    del targets[name]  # the others still get theirs
        for name, target in targets.items():
            try:
                target.flush()
            except WriteError as error:
                complain(session, f"{name}: {reason(error)}")
                status = 1
    finally:
        for file in files:
            file.close()
    return status


@asking(_all)
async def mkdir(session: Session) -> int:
    try:
        options, names = parse(session.argv, "pv", "m", {"--parents": "p", "--verbose": "v"})
    except UsageError as error:
        complain(session, error)
        return 1
    if not names:
        complain(session, "missing operand\nTry 'mkdir --help' for more information.")
        return 1
    status = 0
    for name in names:
        try:
            mode = _new_mode(options["m"], 0o777) if "m" in options else None
            made = _make_folder(session.cwd, name, parents="p" in options)
            if mode is not None:
                (session.cwd / name).chmod(mode)
        except ValueError:
            complain(session, f"invalid mode ‘{options['m']}’")
            return 1
        except OSError as error:
            complain(session, f"cannot create directory ‘{error.filename or name}’: {reason(error)}")
            status = 1
        else:
            for each in made if "v" in options else ():
                session.print(f"mkdir: created directory '{each}'")
    return status


def folders_of(name: str, path: Any = os.path) -> list[str]:
    """Return the folders of which a path consists, from above, without the root (of a drive); `path` is the system's module."""
    parts = [name]
    while (above := path.dirname(parts[0].rstrip("/"))) not in ("", ".") and path.dirname(above) != above:
        parts.insert(0, above)
    return parts


def _make_folder(cwd: Path, name: str, *, parents: bool) -> list[str]:
    """Make a folder and return what was made for it. Raises OSError, which names the part of `name` that could not be made."""
    made: list[str] = []
    for part in folders_of(name) if parents else [name]:
        try:
            os.mkdir(os.path.join(cwd, part) if part else "")
            made.append(part)
        except FileExistsError as error:
            if not parents or (part == name and not (cwd / part).is_dir()):
                raise OSError(error.errno, reason(error), part) from None
            if not (cwd / part).is_dir():
                raise NotADirectoryError(errno.ENOTDIR, os.strerror(errno.ENOTDIR), part) from None
        except OSError as error:
            raise OSError(error.errno, reason(error), part) from None
    return made


@asking(_all)
async def rmdir(session: Session) -> int:
    try:
        _, names = parse(session.argv, "")
        if not names:
            raise UsageError("missing operand\nTry 'rmdir --help' for more information.")
    except UsageError as error:
        complain(session, error)
        return 1
    status = 0
    for name in names:
        try:
            (session.cwd / name).rmdir()
        except OSError as error:
            complain(session, f"failed to remove '{name}': {reason(error)}")
            status = 1
    return status


@asking(_all)
async def touch(session: Session) -> int:
    status = 0
    try:
        options, names = parse(session.argv, "acm", "d", {"--no-create": "c", "--date": "d"})
        if not names:
            raise UsageError("missing file operand\nTry 'touch --help' for more information.")
        then = _instant(options["d"]) if "d" in options else time.time()
    except UsageError as error:
        complain(session, error)
        return 1
    for name in names:
        try:
            if not name or (name.endswith("/") and not os.path.lexists(session.cwd / name)):
                raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT))
            path = session.cwd / name
            if not path.exists():
                if "c" in options:
                    continue
                path.touch()
            kind, only = path.stat(), options.keys() & set("am")
            kept = kind.st_atime if only == {"m"} else then, kind.st_mtime if only == {"a"} else then
            os.utime(path, kept if only or "d" in options else None)
        except OSError as error:
            complain(session, f"cannot touch '{name}': {reason(error)}")
            status = 1
    return status


def _instant(text: str) -> float:
    """The seconds of `2024-05-01` or `2024-05-01 12:30`. Raises UsageError."""
    try:
        return datetime.fromisoformat(text).timestamp()
    except (ValueError, OverflowError, OSError):
        raise UsageError(f"invalid date format ‘{text}’") from None


@asking(_all)
async def rm(session: Session) -> int:
    try:
        options, names = parse(
            session.argv, "rRfvid", "", {"--recursive": "r", "--force": "f", "--verbose": "v", "--interactive": "i"}
        )
    except UsageError as error:
        complain(session, error)
        return 1
    if not names and "f" not in options:
        complain(session, "missing operand\nTry 'rm --help' for more information.")
        return 1
    status = 0
    for name in names:
        if not await _removed(session, name, options):
            status = 1
    return status


async def removed(session: Session, name: str) -> bool:
    """Remove a file or a whole folder; return False, with a message, if any part of it could not be removed."""
    return await _removed(session, name, {"r": "r"})


@dataclass
class _Emptied:
    """A folder from which everything is being removed."""

    name: str
    left: list[str]
    """What is still in it, last first."""
    whole: bool = True
    """Whether all so far could be removed."""


async def _removed(session: Session, name: str, options: dict[str, str]) -> bool:
    """Remove one operand of rm; return False, with a message, if any part of it could not be removed."""
    if options.keys() & set("rR") and (refusal := _refusal(session, name)):
        complain(session, refusal)
        return False
    top = _Emptied("", [name])
    around = [top]  # no recursion: a tree may be deeper than Python's stack
    while True:
        folder = around[-1]
        if folder.left:
            found = await _begin_to_remove(session, os.path.join(folder.name, folder.left.pop()), options)
            if isinstance(found, _Emptied):
                around.append(found)
            else:
                folder.whole &= found
            await let_others_run()
        elif folder is top:
            return top.whole
        else:
            around.pop()
            around[-1].whole &= folder.whole and _remove(session, folder.name, options, folder=True)


async def _begin_to_remove(session: Session, name: str, options: dict[str, str]) -> bool | _Emptied:
    """Remove a file and return whether that went well; of a folder return what has to be removed first."""
    path = os.path.join(session.cwd, name)
    recursive = bool(options.keys() & set("rR"))
    try:
        if not name:
            raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT))
        found = deep.status(path)
        folder = stat.S_ISDIR(found.st_mode)
        if name.endswith("/") and not folder:
            raise NotADirectoryError(errno.ENOTDIR if recursive else errno.EISDIR, "")
        if folder and not recursive:
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
        if "i" in options and not await _agreed_to_remove(session, name, found):
            return True
        if folder:
            return _Emptied(name, sorted(deep.names_in(path), reverse=True))
    except FileNotFoundError as error:
        if "f" not in options:
            complain(session, f"cannot remove '{name}': {reason(error)}")
        return "f" in options
    except OSError as error:
        complain(session, f"cannot remove '{name}': {os.strerror(error.errno or 0)}")
        return False
    return _remove(session, name, options, folder=False)


def _remove(session: Session, name: str, options: dict[str, str], *, folder: bool) -> bool:
    try:
        deep.remove(os.path.join(session.cwd, name), folder=folder)
    except OSError as error:
        complain(session, f"cannot remove '{name}': {reason(error)}")
        return False
    if "v" in options:
        session.print(f"removed {'directory ' if folder else ''}'{name}'")
    return True


def _refusal(session: Session, name: str) -> str:
    """Why a folder is never removed recursively, '' if it may be: the root, the home folder and its parents, `.`."""
    if os.path.basename(name.rstrip("/")) in (".", ".."):
        return f"refusing to remove '.' or '..' directory: skipping '{name}'"
    path = session.cwd / name
    if path.is_symlink():
        return ""
    whole, home = path.resolve(), Path(session.env.get("HOME", "/")).resolve()
    if whole.parent == whole:
        return (
            f"it is dangerous to operate recursively on '{name}'\nrm: use --no-preserve-root to override this failsafe"
        )
    if name and (whole == home or whole in home.parents):
        return f"it is dangerous to operate recursively on '{name}'"
    return ""


async def _agreed_to_remove(session: Session, name: str, found: os.stat_result) -> bool:
    """`rm -i` asks."""
    kinds = {stat.S_IFDIR: "directory", stat.S_IFLNK: "symbolic link"}
    kind = kinds.get(stat.S_IFMT(found.st_mode), "regular file" if found.st_size else "regular empty file")
    session.stderr.write(f"rm: remove {kind} '{name}'? ")
    return (await session.stdin.read_line()).strip().lower() in ("y", "yes")


@asking(lambda names: names[1:])
async def chmod(session: Session) -> int:
    words = [word for word in session.argv[1:] if word not in ("-R", "--recursive")]
    recursive = len(words) < len(session.argv) - 1
    if len(words) < 2:
        complain(session, "missing operand\nTry 'chmod --help' for more information.")
        return 1
    mode, *names = words
    status = 0
    for name in names:
        waiting = [str(session.cwd / name)]
        try:
            while waiting:
                each = waiting.pop()
                found = deep.status(each, follow=True)
                deep.set_mode(each, _new_mode(mode, found.st_mode))
                if recursive and stat.S_ISDIR(found.st_mode):
                    below = (f"{each}/{inner}" for inner in sorted(deep.names_in(each), reverse=True))
                    waiting += (entry for entry in below if not deep.is_link(entry))
                    await let_others_run()
        except ValueError:
            complain(session, f"invalid mode: ‘{mode}’\nTry 'chmod --help' for more information.")
            return 1
        except OSError as error:
            complain(session, f"cannot access '{name}': {reason(error)}")
            status = 1
    return status


def _new_mode(text: str, now: int) -> int:
    """`755`, `+x`, `u+rwx,go-w`. Raises ValueError for anything else."""
    if text.isdigit():
        return int(text, 8)
    mode = stat.S_IMODE(now)
    for clause in text.split(","):
        at = next((index for index, char in enumerate(clause) if char in "+-="), -1)
        if at < 0 or not set(clause[:at]) <= set("ugoa") or not set(clause[at + 1 :]) <= set("rwx"):
            raise ValueError(text)
        shifts = [{"u": 6, "g": 3, "o": 0}[who] for who in (clause[:at] if clause[:at] not in ("", "a") else "ugo")]
        bits = sum({"r": 4, "w": 2, "x": 1}[what] for what in set(clause[at + 1 :]))
        for shift in shifts:
            if clause[at] == "=":
                mode &= ~(7 << shift)
            mode = mode & ~(bits << shift) if clause[at] == "-" else mode | (bits << shift)
    return mode
