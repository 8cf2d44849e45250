"""ls, cat, mkdir, rmdir, touch, rm, cp, mv, tee, chmod, tree."""

from __future__ import annotations

import os
import shutil
import stat
import time
from pathlib import Path

from day6_tui.core.session.session import Main, Session
from day6_tui.core.session.streams import FileOutput
from day6_tui.core.shell.builtins.options import UsageError, complain, parse, reason
from day6_tui.core.shell.builtins.text import lines_of
from day6_tui.core.shell.width import text_width


async def ls(session: Session) -> int:
    try:
        options, names = parse(
            session.argv, "laAlhtrRS1FCdp", "", {"--all": "a", "--almost-all": "A", "--color": "C", "--recursive": "R"}
        )
    except UsageError as error:
        complain(session, error)
        return 2
    files: list[str] = []
    folders: list[str] = []
    status = 0
    for name in names or ["."]:
        path = session.cwd / name
        try:
            kind = path.lstat() if "l" in options else path.stat()
        except OSError as error:
            complain(session, f"cannot access '{name}': {reason(error)}")
            status = 2
            continue
        is_folder = stat.S_ISDIR(kind.st_mode) and "d" not in options
        (folders if is_folder else files).append(name)
    _list(session, session.cwd, sorted(files), options)
    pending = sorted(folders)
    several = len(names) > 1 or "R" in options
    first = not files
    while pending:
        name = pending.pop(0)
        path = session.cwd / name
        try:
            entries = _entries(path, options)
        except OSError as error:
            complain(session, f"cannot open directory '{name}': {reason(error)}")
            status = 2
            continue
        if several:
            session.print(("" if first else "\n") + f"{name}:")
        first = False
        if "l" in options:
            session.print(f"total {_total_blocks(path, entries)}")
        _list(session, path, entries, options)
        if "R" in options:
            inside = [
                entry
                for entry in entries
                if entry not in (".", "..") and (path / entry).is_dir() and not (path / entry).is_symlink()
            ]
            pending[:0] = [f"{name.rstrip('/')}/{entry}" for entry in inside]
        await session.stdout.drain()
    return status


def _entries(path: Path, options: dict[str, str]) -> list[str]:
    names = os.listdir(path)
    if "a" in options:
        names += [".", ".."]
    elif "A" not in options:
        names = [name for name in names if not name.startswith(".")]
    names.sort(key=lambda name: (name.lstrip(".").lower(), name))
    if "t" in options:
        names.sort(key=lambda name: -(path / name).lstat().st_mtime_ns)
    if "S" in options:
        names.sort(key=lambda name: -(path / name).lstat().st_size)
    return names[::-1] if "r" in options else names


def _total_blocks(path: Path, entries: list[str]) -> int:
    return sum(getattr((path / name).lstat(), "st_blocks", 0) for name in entries) // 2


def _list(session: Session, folder: Path, names: list[str], options: dict[str, str]) -> None:
    if not names:
        return
    colour = session.stdout.isatty()
    shown = [_coloured(folder / name, name, options, colour) for name in names]
    if "l" in options:
        _long(session, folder, names, shown, options)
    elif not colour or "1" in options:
        session.stdout.write("".join(text + "\n" for text, _ in shown))
    else:
        session.stdout.write(_in_columns(shown, session.stdout.columns))


def _coloured(path: Path, name: str, options: dict[str, str], colour: bool) -> tuple[str, int]:
    """(text to print, width in cells): folders blue, links cyan, executables green, as Ubuntu's ls."""
    try:
        mode = path.lstat().st_mode
    except OSError:
        mode = 0
    suffix, code = "", ""
    if stat.S_ISDIR(mode):
        suffix, code = "/", "01;34"
    elif stat.S_ISLNK(mode):
        suffix, code = "@", "01;36"
    elif mode & 0o111 and os.name != "nt":
        suffix, code = "*", "01;32"
    quoted = f"'{name}'" if colour and any(char in " '\"$&()|;<>*?" for char in name) else name
    suffix = suffix if "F" in options or ("p" in options and suffix == "/") else ""
    text = f"\x1b[{code}m{quoted}\x1b[0m" if colour and code else quoted
    return text + suffix, text_width(quoted) + len(suffix)


def _in_columns(shown: list[tuple[str, int]], columns: int) -> str:
    count = len(shown)
    for rows in range(1, count + 1):
        blocks = [shown[start : start + rows] for start in range(0, count, rows)]
        widths = [max(width for _, width in block) + 2 for block in blocks]
        if sum(widths) - 2 <= columns or rows == count:
            break
    lines = []
    for row in range(rows):
        cells = [(block[row], width) for block, width in zip(blocks, widths, strict=True) if row < len(block)]
        line = "".join(text + " " * (width - used) for (text, used), width in cells[:-1]) + cells[-1][0][0]
        lines.append(line + "\n")
    return "".join(lines)


def _long(
    session: Session, folder: Path, names: list[str], shown: list[tuple[str, int]], options: dict[str, str]
) -> None:
    rows = []
    for name, (text, _) in zip(names, shown, strict=True):
        status = (folder / name).lstat()
        size = _human(status.st_size) if "h" in options else str(status.st_size)
        when = time.localtime(status.st_mtime)
        recent = abs(time.time() - status.st_mtime) < 182 * 86400
        date = time.strftime("%b ", when) + f"{when.tm_mday:>2} " + time.strftime("%H:%M" if recent else " %Y", when)
        if stat.S_ISLNK(status.st_mode):
            text += f" -> {os.readlink(folder / name)}"
        rows.append((stat.filemode(status.st_mode), str(status.st_nlink), size, date, text))
    links = max(len(row[1]) for row in rows)
    sizes = max(len(row[2]) for row in rows)
    for mode, link, size, date, text in rows:
        session.print(f"{mode} {link:>{links}} student student {size:>{sizes}} {date} {text}")


def _human(size: float) -> str:
    for unit in ("", "K", "M", "G"):
        if size < 1024 or unit == "G":
            return f"{size:.1f}{unit}" if unit and size < 10 else f"{size:.0f}{unit}"
        size /= 1024
    return ""


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
    outputs = []
    status = 0
    for name in names:
        try:
            outputs.append(FileOutput(session.cwd / name, append="a" in options))
        except OSError as error:
            complain(session, f"{name}: {reason(error)}")
            status = 1
    try:
        async for _, line in lines_of(session, [], []):
            session.stdout.write(line)
            for output in outputs:
                output.write(line)
    finally:
        for output in outputs:
            output.close()
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


async def tree(session: Session) -> int:
    try:
        options, names = parse(session.argv, "adf", "L")
        deepest = int(options.get("L", "99"))
    except (UsageError, ValueError) as error:
        complain(session, error)
        return 1
    counts = [0, 0]
    for name in names or ["."]:
        path = session.cwd / name
        if not path.is_dir():
            session.print(f"{name}  [error opening dir]")
            continue
        session.print(name)
        _branch(session, path, "", options, deepest, counts)
    folders, files = counts
    text = f"\n{folders} director{'y' if folders == 1 else 'ies'}"
    session.print(text + ("" if "d" in options else f", {files} file{'' if files == 1 else 's'}"))
    return 0


def _branch(session: Session, folder: Path, prefix: str, options: dict[str, str], left: int, counts: list[int]) -> None:
    if left <= 0:
        return
    entries = sorted(entry for entry in folder.iterdir() if "a" in options or not entry.name.startswith("."))
    if "d" in options:
        entries = [entry for entry in entries if entry.is_dir()]
    for entry in entries:
        last = entry is entries[-1]
        session.print(
            f"{prefix}{'└── ' if last else '├── '}{_coloured(entry, entry.name, {}, session.stdout.isatty())[0]}"
        )
        inside = entry.is_dir() and not entry.is_symlink()
        counts[0 if inside else 1] += 1
        if inside:
            _branch(session, entry, prefix + ("    " if last else "│   "), options, left - 1, counts)


COMMANDS: dict[str, Main] = {
    "ls": ls,
    "cat": cat,
    "mkdir": mkdir,
    "rmdir": rmdir,
    "touch": touch,
    "rm": rm,
    "cp": cp,
    "mv": mv,
    "tee": tee,
    "chmod": chmod,
    "tree": tree,
}
