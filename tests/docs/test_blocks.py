"""Every block of code in the documentation is run, page after page, in its own home: see tests/docs/pages.py."""

from __future__ import annotations

import os
import re
import shutil
import textwrap
from collections.abc import Iterator
from pathlib import Path
from time import sleep

import pytest

from tests.docs.pages import Block, Page, commands, with_blocks
from tests.docs.typed import RETRIED, Terminal, Typed
from tests.support.waiting import Deadline, run

pytestmark = pytest.mark.process


@pytest.fixture
def terminal(request: pytest.FixtureRequest, tmp_path: Path, short_folder: Path) -> Iterator[Terminal]:
    made = Terminal(tmp_path, short_folder, request.getfixturevalue("page").language)
    yield made
    made.close()


PAGES = [page for page in with_blocks() if any(block.kind != "not run" for block in page.blocks())]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_the_blocks_of_a_page_do_what_it_says(page: Page, terminal: Terminal) -> None:
    for block in page.blocks():
        if block.kind == "file":
            file = terminal.home / block.says.removeprefix("~/")
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(textwrap.dedent(block.code), encoding="utf-8")
        elif block.kind == "run" and block.language in RUNNERS:
            RUNNERS[block.language](block, terminal)


def _console(block: Block, terminal: Terminal) -> None:
    *before, (last, output) = commands(block)
    for command, lines in before:
        _typed(block, terminal, command, lines)
    _typed(block, terminal, last, output, **block.words)


def _python(block: Block, terminal: Terminal) -> None:
    file = terminal.real / f"program_{block.place.rpartition(':')[2]}.py"
    file.write_text(textwrap.dedent(block.code), encoding="utf-8")
    _typed(block, terminal, f"day6-tui python '{file}'", [], **block.words)


def _sh(block: Block, terminal: Terminal) -> None:
    bash = shutil.which("bash")
    if bash is None or os.name != "posix":
        pytest.skip("this system has no bash for the lines of the real shell")
    done = run([bash, "-e"], block.code, cwd=terminal.real, env=terminal.environment)
    assert (done.returncode != 0) == ("fails" in block.words), f"{block.place}: {done.stdout}{done.stderr}"


RUNNERS = {"console": _console, "python": _python, "sh": _sh}


def _typed(block: Block, terminal: Terminal, command: str, lines: list[str], **words: str) -> None:
    """Type a command, and compare what it does with what the page says."""
    if "background" in words:
        _wait_for(block, terminal.start(command), command, lines)
    elif "timeout" in words:
        typed = terminal.interrupt_after(terminal.start(command), float(words["timeout"]))
        assert not typed.failed_by_itself(), f"{block.place}: {command}\n{typed.printed}"
        _compare(block, typed, command, [*lines, "..."])
    elif lines[-1:] == ["^C"]:
        typed = terminal.start(command)
        if lines[:-1]:
            _wait_for(block, typed, command, lines[:-1])
            terminal.interrupt(typed)
        else:
            terminal.interrupt_after(typed, 2)
        assert not typed.failed_by_itself(), f"{block.place}: {command}\n{typed.printed}"
    elif lines and command.endswith("&"):
        _wait_for(block, terminal.start_job(command.removesuffix("&")), command, lines)
    else:
        typed = terminal.type(command)
        deadline = Deadline(RETRIED)
        while "retry" in words and not _is_so(typed, lines) and not deadline.is_over():
            sleep(0.2)
            typed = terminal.type(command)
        _compare(block, typed, command, lines)
        assert (typed.status != 0) == ("fails" in words), f"{block.place}: {command}: {typed.status}\n{typed.printed}"


def _wait_for(block: Block, typed: Typed, command: str, lines: list[str]) -> None:
    """Wait until a program has printed these lines."""
    wanted = [*lines, "..."]
    deadline = Deadline(RETRIED)
    while not _is_so(typed, wanted) and typed.status in (None, 0) and not deadline.is_over():
        sleep(0.02)
    _compare(block, typed, command, wanted)


def _compare(block: Block, typed: Typed, command: str, lines: list[str]) -> None:
    if not _is_so(typed, lines):
        wanted = "\n".join(lines)
        pytest.fail(f"{block.place}: {command}\n-- wanted\n{wanted}\n-- printed\n{typed.printed}", pytrace=False)


def _is_so(typed: Typed, lines: list[str]) -> bool:
    """Whether it has printed these lines; any, if there are none."""
    return not lines or re.fullmatch(pattern(lines), typed.printed, re.DOTALL) is not None


def pattern(lines: list[str]) -> str:
    """Return the regular expression of an output: a line "..." is any lines, "..." within a line any text."""
    return "".join(
        r"(?:[^\n]*\n)*?" if line.strip() == "..." else r"[^\n]*?".join(map(re.escape, line.split("..."))) + r"\n"
        for line in lines
    )


@pytest.mark.parametrize(
    ("lines", "printed", "is_so"),
    [
        (["a", "...", "b"], "a\nb\n", True),
        (["a", "...", "b"], "a\n1\n2\nb\n", True),
        (["a", "..."], "b\n", False),
        (["x: ... m"], "x: 1.5 m\n", True),
        (["x: ... m"], "x: 1.5\n m\n", False),
        (["a"], "a\nb\n", False),
        (["a.c"], "abc\n", False),
    ],
)
def test_dots_stand_for_what_differs(lines: list[str], printed: str, is_so: bool) -> None:
    assert bool(re.fullmatch(pattern(lines), printed, re.DOTALL)) is is_so
