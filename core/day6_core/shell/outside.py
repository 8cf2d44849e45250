"""Asks in a terminal before something outside the home folder is changed: the disk is the user's own, and `rm` is real.

Scratch folders are excepted. Scripts (`day6-tui exec`, another program's pipe) are not asked: nobody would answer.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from functools import wraps
from pathlib import Path

from day6_core.language import language_of
from day6_core.session.session import Main, Session
from day6_core.session.streams import InputStream, OutputStream

QUESTIONS = {
    "en": "{path} is outside your home folder. Change it? [y/N] ",
    "zh": "{path} 不在你的主目录里，真的要改动它吗？[y/N] ",
}
YES = ("y", "yes", "是")


def is_outside(path: Path, home: Path) -> bool:
    """Whether `path` (absolute; links are followed) is neither in `home` nor in a scratch folder."""
    real = path.resolve()
    inside = (home.resolve(), _scratch().resolve(), Path(real.anchor, "dev"))  # of each drive of Windows
    return not any(real == folder or folder in real.parents for folder in inside)


def _scratch() -> Path:
    """The folder for temporary files. Python looks for one by writing there, which fails on a full disk."""
    import tempfile

    try:
        return Path(tempfile.gettempdir())
    except OSError:
        return Path(os.environ.get("TMPDIR") or "/tmp")


async def agreed(
    name: str, paths: Iterable[Path], keys: InputStream | None, stderr: OutputStream, variables: Mapping[str, str]
) -> bool:
    """Ask about each path that is outside, in a command's name; return False after the first no. Without `keys`, return True."""
    home = Path(variables.get("HOME", "/"))
    question = QUESTIONS[language_of(variables)]
    for path in paths:
        if keys is not None and is_outside(path, home):
            stderr.write(f"{name}: {question.format(path=path)}")
            if (await keys.read_line()).strip().lower() not in YES:
                return False
    return True


def keys_of(stdin: InputStream, *outputs: OutputStream) -> InputStream | None:
    """Where the reply is typed: the simulated terminal that the program reads from or, in a pipe, writes to."""
    if stdin.terminal_of() is not None:
        return stdin
    return next((keys for output in outputs if (keys := output.keyboard()) is not None), None)


def asking(changed: Callable[[list[str]], list[str]]) -> Callable[[Main], Main]:
    """Decorate a command: before it runs its user is asked; `changed` chooses from its operands the files it changes."""

    def decorated(command: Main) -> Main:
        @wraps(command)
        async def run(session: Session) -> int | None:
            names = changed([word for word in session.argv[1:] if not word.startswith("-")])
            keys = keys_of(session.stdin, session.stdout, session.stderr)
            paths = [session.cwd / name for name in names]
            if not await agreed(session.name, paths, keys, session.stderr, session.env):
                return 1
            return await command(session)

        return run

    return decorated
