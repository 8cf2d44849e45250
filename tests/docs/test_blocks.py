"""Every block of code in the documentation is run, page after page, in its own home: see tests/docs/pages.py."""

from __future__ import annotations

import os
import re
import shutil
import textwrap
from contextlib import closing
from pathlib import Path
from time import sleep

import pytest

from tests.docs.pages import Block, Page, commands, with_blocks
from tests.docs.typed import RETRIED, Terminal, Typed
from tests.support.waiting import Deadline, run

pytestmark = pytest.mark.process


PAGES = [page for page in with_blocks() if any(block.kind != "not run" for block in page.blocks())]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_the_blocks_of_a_page_do_what_it_says(page: Page, tmp_path: Path, short_folder: Path) -> None:
    _play(page, tmp_path, short_folder)


WRONG = {
    "another output": "```console\n$ echo one\ntwo\n```",
    "more output": "```console\n$ seq 2\n1\n```",
    "a status": "```console\n$ false\n```",
    "no status": "<!-- run: fails -->\n```console\n$ true\n```",
    "ends too early": "```console\n$ echo one\ntwo\n^C\n```",
    "fails in the background": "<!-- run: background -->\n```console\n$ ls nothing\nsomething\n```",
    "fails before its time": "<!-- run: timeout=9 -->\n```python\nraise ValueError\n```",
    "a program that fails": "```python\nraise SystemExit(1)\n```",
    "a line of the real shell": "```sh\nfalse\ntrue\n```",
}


@pytest.mark.parametrize("text", WRONG.values(), ids=WRONG)
def test_a_page_that_says_something_else_fails(text: str, tmp_path: Path, short_folder: Path) -> None:
    file = tmp_path / "page.md"
    file.write_text(f"# Title\n\n{text}\n", encoding="utf-8")
    with pytest.raises(pytest.fail.Exception, match=r"page\.md:"):
        _play(Page(file), tmp_path, short_folder)


def _play(page: Page, folder: Path, runtime: Path) -> None:
    """Do what the blocks of a page say, one after the other, in a home of its own."""
    with closing(Terminal(folder, runtime, page.language)) as terminal:
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
    if (done.returncode != 0) != ("fails" in block.words):
        pytest.fail(f"{block.place}: status {done.returncode}\n{done.stdout}{done.stderr}", pytrace=False)


RUNNERS = {"console": _console, "python": _python, "sh": _sh}


def _typed(block: Block, terminal: Terminal, command: str, lines: list[str], **words: str) -> None:
    """Type a command, and compare what it does with what the page says."""
    if "background" in words:
        _wait_for(block, terminal.start(command), lines)
    elif "timeout" in words:
        typed = terminal.interrupt_after(terminal.start(command), float(words["timeout"]))
        _agree(block, typed, _is_so(typed, [*lines, "..."]) and not typed.failed_by_itself(), lines)
    elif lines[-1:] == ["^C"]:
        typed = terminal.start(command)
        _wait_for(block, typed, lines[:-1])
        terminal.interrupt_after(typed, 0 if lines[:-1] else 2)
        _agree(block, typed, not typed.failed_by_itself(), lines)
    elif lines and command.endswith("&"):
        _wait_for(block, terminal.start_job(command.removesuffix("&")), lines)
    else:
        typed = terminal.type(command)
        deadline = Deadline(RETRIED)
        while "retry" in words and not _is_so(typed, lines) and not deadline.is_over():
            sleep(0.2)
            typed = terminal.type(command)
        _agree(block, typed, _is_so(typed, lines) and (typed.status != 0) == ("fails" in words), lines)


def _wait_for(block: Block, typed: Typed, lines: list[str]) -> None:
    """Wait until a program has printed these lines."""
    wanted = [*lines, "..."]
    deadline = Deadline(RETRIED)
    while not _is_so(typed, wanted) and typed.status is None and not deadline.is_over():
        sleep(0.02)
    _agree(block, typed, _is_so(typed, wanted), wanted)


def _agree(block: Block, typed: Typed, as_said: bool, lines: list[str]) -> None:
    """Fail with what a command was said to print, and what it has printed."""
    if not as_said:
        wanted, status = "\n".join(lines), f"-- status {typed.status}"
        command = typed.file.read_text(encoding="utf-8")
        pytest.fail(f"{block.place}: {command}-- wanted\n{wanted}\n-- printed\n{typed.printed}{status}", pytrace=False)


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
