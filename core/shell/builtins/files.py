"""cat, mkdir, rmdir, touch, rm, cp, mv, tee, chmod."""

from __future__ import annotations

import shutil
import stat
from pathlib import Path

from day6_tui.core.session.session import Main, Session
from day6_tui.core.session.streams import FileOutput, OutputStream, WriteError
from day6_tui.core.shell.builtins.options import UsageError, complain, parse, reason
from day6_tui.core.shell.builtins.text import lines_of
from day6_tui.core.shell.outside import asking


async def cat(session: Session) -> int:
    try:
        options, names = parse(session.argv, "nbAEsTvu")
    except UsageError as error:
        complain(session, error)
        return 1
    problems: list[str] = []
    number = 0
    async for _, line in lines_of(session, names, problems):
        if "n" in options or ("b" in options and line != "\n"):
            number += 1
            line = f"{number:>6}\t{line}"
        if "E" in options or "A" in options:
            line = line.replace("\n", "$\n")
        session.stdout.write(line)
    return 1 if problems else 0


async def tee(session: Session) -> int:
    options, names = parse(session.argv, "ai")
    files: list[FileOutput] = []
    targets: dict[str, OutputStream] = {"'standard output'": session.stdout}
    status = 0
    for name in names:
        try:
            files.append(FileOutput(session.cwd / name, append="a" in options))
        except OSError as error:
            complain(session, f"{name}: {reason(error)}")
            status = 1
        else:
            targets[name] = files[-1]
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
            (session.cwd / name).mkdir(parents="p" in options, exist_ok="p" in options)
        except OSError as error:
            complain(session, f"cannot create directory ‘{name}’: {reason(error)}")
            status = 1
        else:
            if "v" in options:
                session.print(f"mkdir: created directory '{name}'")
    return status


async def rmdir(session: Session) -> int:
    status = 0
    for name in session.argv[1:]:
        try:
            (session.cwd / name).rmdir()
        except OSError as error:
            complain(session, f"failed to remove '{name}': {reason(error)}")
            status = 1
    return status


async def touch(session: Session) -> int:
    status = 0
    names = [word for word in session.argv[1:] if not word.startswith("-")]
    if not names:
        complain(session, "missing file operand\nTry 'touch --help' for more information.")
        return 1
    for name in names:
        try:
            (session.cwd / name).touch()
        except OSError as error:
            complain(session, f"cannot touch '{name}': {reason(error)}")
            status = 1
    return status


async def rm(session: Session) -> int:
    try:
        options, names = parse(session.argv, "rRfvid", "", {"--recursive": "r", "--force": "f", "--verbose": "v"})
    except UsageError as error:
        complain(session, error)
        return 1
    if not names and "f" not in options:
        complain(session, "missing operand\nTry 'rm --help' for more information.")
        return 1
    status = 0
    home = Path(session.env.get("HOME", "/"))
    for name in names:
        path = session.cwd / name
        whole = path.resolve()
        if whole == home.resolve() or whole in home.resolve().parents:
            complain(session, f"it is dangerous to operate recursively on '{name}'")
            status = 1
            continue
        try:
            _remove(path, recursive="r" in options or "R" in options)
        except FileNotFoundError as error:
            if "f" not in options:
                complain(session, f"cannot remove '{name}': {reason(error)}")
                status = 1
        except OSError as error:
            complain(session, f"cannot remove '{name}': {reason(error)}")
            status = 1
        else:
            if "v" in options:
                session.print(f"removed '{name}'")
    return status


def _remove(path: Path, *, recursive: bool) -> None:
    if path.is_dir() and not path.is_symlink():
        if not recursive:
            raise IsADirectoryError(21, "Is a directory")
        shutil.rmtree(path)
    else:
        path.unlink()


async def cp(session: Session) -> int:
    return _transfer(session, move=False)


async def mv(session: Session) -> int:
    return _transfer(session, move=True)


def _transfer(session: Session, *, move: bool) -> int:
    try:
        options, names = parse(session.argv, "rRafvinpu", "", {"--recursive": "r", "--verbose": "v", "--force": "f"})
    except UsageError as error:
        complain(session, error)
        return 1
    if len(names) < 2:
        missing = f"missing destination file operand after '{names[0]}'" if names else "missing file operand"
        complain(session, f"{missing}\nTry '{session.name} --help' for more information.")
        return 1
    *sources, target = names
    folder = (session.cwd / target).is_dir()
    if len(sources) > 1 and not folder:
        complain(
            session, f"target '{target}' is not a directory" if not move else f"target '{target}': Not a directory"
        )
        return 1
    status = 0
    for name in sources:
        source = session.cwd / name
        goal = session.cwd / target / source.name if folder else session.cwd / target
        problem = _transfer_problem(session, source, goal, name, target, options, move=move)
        if problem:
            complain(session, problem)
            status = 1
    return status


def _transfer_problem(
    session: Session, source: Path, goal: Path, name: str, target: str, options: dict[str, str], *, move: bool
) -> str:
    """Copy or move one thing; '' if that worked, else what to complain about."""
    recursive = bool({"r", "R", "a"} & options.keys())
    if not source.exists() and not source.is_symlink():
        return f"cannot stat '{name}': No such file or directory"
    if source.is_dir() and not move and not recursive:
        return f"-r not specified; omitting directory '{name}'"
    if goal.exists() and source.resolve() == goal.resolve():
        return f"'{name}' and '{target}' are the same file"
    if source.is_dir() and source.resolve() in goal.resolve().parents:
        if move:
            return f"cannot move '{name}' to a subdirectory of itself, '{target}'"
        return f"cannot copy a directory, '{name}', into itself, '{target}'"
    if "n" in options and goal.exists():
        return ""
    try:
        if move:
            shutil.move(source, goal)
        elif source.is_dir():
            shutil.copytree(source, goal, symlinks=True, dirs_exist_ok=True)
        else:
            (shutil.copy2 if {"p", "a"} & options.keys() else shutil.copy)(source, goal)
    except OSError as error:
        what = f"move '{name}' to '{target}'" if move else f"create regular file '{target}'"
        return f"cannot {what}: {reason(error)}"
    if "v" in options:
        session.print(f"{'renamed ' if move else ''}'{name}' -> '{target}'")
    return ""


async def chmod(session: Session) -> int:
    words = [word for word in session.argv[1:] if word != "-R"]
    if len(words) < 2:
        complain(session, "missing operand\nTry 'chmod --help' for more information.")
        return 1
    mode, *names = words
    status = 0
    for name in names:
        path = session.cwd / name
        try:
            path.chmod(_new_mode(mode, path.stat().st_mode))
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


def _all(names: list[str]) -> list[str]:
    return names


COMMANDS: dict[str, Main] = {
    "cat": cat,
    "mkdir": asking(mkdir, _all),
    "rmdir": asking(rmdir, _all),
    "touch": asking(touch, _all),
    "rm": asking(rm, _all),
    "cp": asking(cp, lambda names: names[-1:]),
    "mv": asking(mv, _all),
    "tee": asking(tee, _all),
    "chmod": asking(chmod, lambda names: names[1:]),
}
