"""ls and tree."""

from __future__ import annotations

import os
import re
import stat
import time
from pathlib import Path

from day6_core import deep
from day6_core.session.session import Session
from day6_core.shell.builtins.options import UsageError, complain, parse, reason
from day6_core.shell.language.interpreter import shell_of
from day6_core.width import text_width

_LONG = {"--all": "a", "--almost-all": "A", "--color": "K", "--recursive": "R"}


async def ls(session: Session) -> int:
    try:
        # Of all options this one need not have its value.
        words = ["--color=always" if word == "--color" else word for word in session.argv]
        options, names = parse(words, "laAhtrRS1FCdp", "K", _LONG)
    except UsageError as error:
        complain(session, error)
        return 2
    files: list[str] = []
    folders: list[str] = []
    status = 0
    for name in names or ["."]:
        path = session.cwd / name
        try:
            kind = deep.status(path, follow="l" not in options)
        except OSError as error:
            complain(session, f"cannot access '{name}': {reason(error)}")
            status = 2
            continue
        is_folder = stat.S_ISDIR(kind.st_mode) and "d" not in options
        (folders if is_folder else files).append(name)
    _list(session, session.cwd, _ordered(session.cwd, files, options), options)
    pending = _ordered(session.cwd, folders, options)
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
            inside = [entry for entry in entries if entry not in (".", "..") and deep.is_folder(path / entry)]
            pending[:0] = [f"{name.rstrip('/')}/{entry}" for entry in inside]
        await session.stdout.drain()
    return status


def _entries(path: Path, options: dict[str, str]) -> list[str]:
    names = deep.names_in(path)
    if "a" in options:
        names += [".", ".."]
    elif "A" not in options:
        names = [name for name in names if not name.startswith(".")]
    return _ordered(path, names, options)


def _ordered(path: Path, names: list[str], options: dict[str, str]) -> list[str]:
    names = sorted(names, key=lambda name: (name.lstrip(".").lower(), name))
    if "t" in options:
        names.sort(key=lambda name: -deep.status(path / name).st_mtime_ns)
    if "S" in options:
        names.sort(key=lambda name: -deep.status(path / name).st_size)
    return names[::-1] if "r" in options else names


def _total_blocks(path: Path, entries: list[str]) -> int:
    return sum(getattr(deep.status(path / name), "st_blocks", 0) for name in entries) // 2


def _list(session: Session, folder: Path, names: list[str], options: dict[str, str]) -> None:
    if not names:
        return
    screen = session.stdout.isatty()
    colour = options.get("K") == "always" or (screen and options.get("K") != "never")
    shown = [_coloured(folder / name, name, options, colour) for name in names]
    if "l" in options:
        _long(session, folder, names, shown, options)
    elif "1" in options or not (screen or "C" in options):
        session.stdout.write("".join(text + "\n" for text, _ in shown))
    else:
        session.stdout.write(_in_columns(shown, session.stdout.columns))


def _coloured(path: Path, name: str, options: dict[str, str], colour: bool) -> tuple[str, int]:
    """(text to print, width in cells): folders blue, links cyan, executables green, as Ubuntu's ls."""
    mode = deep.mode(path)
    suffix, code = "", ""
    if stat.S_ISDIR(mode):
        suffix, code = "/", "01;34"
    elif stat.S_ISLNK(mode):
        suffix, code = "@", "01;36"
    elif mode & 0o111 and os.name != "nt":
        suffix, code = "*", "01;32"
    quoted = _quoted(name) if colour else name
    suffix = suffix if "F" in options or ("p" in options and suffix == "/") else ""
    text = f"\x1b[{code}m{quoted}\x1b[0m" if colour and code else quoted
    return text + suffix, text_width(quoted) + len(suffix)


_CONTROLS = re.compile("([\x00-\x1f\x7f-\x9f\ud800-\udfff]+)")
_ESCAPES = {"\a": "\\a", "\b": "\\b", "\f": "\\f", "\n": "\\n", "\r": "\\r", "\t": "\\t", "\v": "\\v"}


def _quoted(name: str) -> str:
    """Quote a name as GNU ls does on a terminal (quoting style shell-escape), so that it reads as one name."""
    parts = _CONTROLS.split(name)
    if len(parts) == 1:
        if "'" in name and not set(name) & set('"$`\\!'):
            return f'"{name}"'
        escaped = name.replace("'", "'\\''")
        return f"'{escaped}'" if any(char in " '\"$&()|;<>*?" for char in name) else name
    shown = [f"'{text}'" if index % 2 == 0 else f"$'{_escaped(text)}'" for index, text in enumerate(parts)]
    return "".join(shown[:-1] if not parts[-1] else shown)


def _escaped(text: str) -> str:
    return "".join(
        _ESCAPES.get(char) or "".join(f"\\{byte:03o}" for byte in char.encode("utf-8", "surrogateescape"))
        for char in text
    )


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
        status = deep.status(folder / name)
        size = _human(status.st_size) if "h" in options else str(status.st_size)
        when = time.localtime(status.st_mtime)
        recent = abs(time.time() - status.st_mtime) < 182 * 86400
        date = time.strftime("%b ", when) + f"{when.tm_mday:>2} " + time.strftime("%H:%M" if recent else " %Y", when)
        if stat.S_ISLNK(status.st_mode):
            text += f" -> {deep.target_of(folder / name)}"
        rows.append((stat.filemode(status.st_mode), str(status.st_nlink), size, date, text))
    links = max(len(row[1]) for row in rows)
    sizes = max(len(row[2]) for row in rows)
    user = shell_of(session).desk.user
    for mode, link, size, date, text in rows:
        session.print(f"{mode} {link:>{links}} {user} {user} {size:>{sizes}} {date} {text}")


def _human(size: float) -> str:
    for unit in ("", "K", "M", "G"):
        if size < 1024 or unit == "G":
            return f"{size:.1f}{unit}" if unit and size < 10 else f"{size:.0f}{unit}"
        size /= 1024
    return ""


async def tree(session: Session) -> int:
    try:
        options, names = parse(session.argv, "adf", "L")
    except UsageError as error:
        complain(session, error)
        return 1
    deepest = int(options.get("L", "99")) if options.get("L", "99").isdigit() else 0
    if not deepest:
        complain(session, "Invalid level, must be greater than 0.")
        return 1
    counts = [0, 0]
    for name in names or ["."]:
        path = session.cwd / name
        if not path.is_dir():
            session.print(f"{name}  [error opening dir]")
            continue
        session.print(name)
        await _branches(session, path, options, deepest, counts)
    folders, files = counts
    text = f"\n{folders} director{'y' if folders == 1 else 'ies'}"
    session.print(text + ("" if "d" in options else f", {files} file{'' if files == 1 else 's'}"))
    return 0


async def _branches(session: Session, top: Path, options: dict[str, str], deepest: int, counts: list[int]) -> None:
    around: list[tuple[Path, str, list[str]]] = [
        (top, "", _shown_by_tree(top, options))
    ]  # what is left in each, last first
    while around:
        folder, prefix, left = around[-1]
        if not left:
            around.pop()
            continue
        name = left.pop()
        entry = folder / name
        session.print(f"{prefix}{'├── ' if left else '└── '}{_coloured(entry, name, {}, session.stdout.isatty())[0]}")
        counts[0 if (inside := deep.is_folder(entry)) else 1] += 1
        if inside and len(around) < deepest:
            around.append((entry, prefix + ("│   " if left else "    "), _shown_by_tree(entry, options)))
        await session.stdout.drain()


def _shown_by_tree(folder: Path, options: dict[str, str]) -> list[str]:
    """The names in a folder, last first."""
    names = sorted((name for name in deep.names_in(folder) if "a" in options or name[0] != "."), reverse=True)
    return [name for name in names if deep.is_folder(folder / name, follow=True)] if "d" in options else names
