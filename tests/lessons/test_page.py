"""What the page of a lesson says: how it was done, what comes next, and where its lines break."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from types import SimpleNamespace
from typing import Any

import pytest

from day6_core.lessons.catalogue import days, drills
from day6_core.lessons.document import Lesson
from day6_core.lessons.state import State
from day6_tui.app import make_look
from day6_tui.options import Options
from day6_tui.panes.cells import cell_len, wrap
from day6_tui.windows.lesson.page import PageRow, _finished_rows, step_page
from day6_tui.windows.lesson.text import text_lines
from tests.support.folded import folded

DAY, DRILL = days()[0], drills()[0]


def look(lang: str) -> Any:
    return make_look(Options(lang=lang), {"LANG": "C.UTF-8", "TERM": "xterm-256color"})


def text_of(rows: Sequence[PageRow], lang: str) -> str:
    """What rows of a page say, without the breaks of their lines."""
    joint = "" if lang == "zh" else " "
    return joint.join("".join(segment.text for segment in row.line).strip() for row in rows)


def finished(lesson: Lesson, lang: str, solved: int, hints: int) -> str:
    """What is told of a lesson that was left with so many steps solved and hints read."""
    done = [SimpleNamespace(solved=at < solved, hints=hints * (at == 0)) for at in range(len(lesson.steps))]
    numbers = {step.name: each for step, each in zip(lesson.steps, done, strict=True)}
    course: Any = SimpleNamespace(progress=SimpleNamespace(step=lambda lesson, step: numbers[step]))
    return text_of(_finished_rows(lesson, course, look(lang), 200), lang)


def test_whoever_did_everything_alone_is_praised_and_others_hear_what_they_did() -> None:
    every = len(DAY.steps)
    assert "全部做对，一个提示也没看！Enter" in finished(DAY, "zh", every, 0)
    assert "全部做对，一个提示也没看！Enter" in finished(DRILL, "zh", 1, 0)
    assert "全部做对，看了 2 个提示。" in finished(DAY, "zh", every, 2)
    assert f"{every} 步里做对了 3 步，看了 1 个提示。" in finished(DAY, "zh", 3, 1)
    assert f"{every} 步里做对了 3 步，一个提示也没看。" in finished(DAY, "zh", 3, 0)
    assert "Everything right, without a single hint!" in finished(DAY, "en", every, 0)
    assert "Everything right; hints used: 1." in finished(DRILL, "en", 1, 1)
    assert f"1 of {every} steps right, without a single hint." in finished(DAY, "en", 1, 0)


@pytest.mark.parametrize(
    ("lesson", "index", "zh", "en"),
    [
        (DAY, 0, "按 F5 去下一步。", "F5 goes on to the next step."),
        (DAY, len(DAY.steps) - 1, "按 F5 完成今天的课。", "F5 finishes today's lesson."),
        (DRILL, 0, "按 F5 完成这个练习。", "F5 finishes this drill."),
    ],
    ids=["first", "last", "drill"],
)
def test_the_last_step_says_that_it_is_the_end(lesson: Lesson, index: int, zh: str, en: str) -> None:
    course: Any = SimpleNamespace(kept=SimpleNamespace(failed=""))
    for lang, told in (("zh", zh), ("en", en)):
        state = State(lesson, index, solved=True)
        asked: list[str] = []
        doing = partial(partial, asked.append)
        solved = step_page(course, state, look(lang), 120, doing, here=False).told
        assert {row.news for row in solved} == {"solved"}
        assert told in text_of(solved, lang)
        assert solved[0].action is not None
        solved[0].action()
        assert asked == ["next"], "a click on the sentence does what it says"


PATH = "~/ros2_ws/src/day6_publisher/day6_publisher/wheel_spinner.py"


@folded("width", range(20, 60))
def test_a_path_that_goes_on_below_shows_that_it_does(width: int) -> None:
    lines = ["".join(part.text for part in line) for line in text_lines(f"`{PATH}`", width, look("zh").colours)]
    assert "".join(lines) == PATH and all(cell_len(line) <= width for line in lines)
    assert all(line[-1] in "/_." for line in lines[:-1])


def test_a_command_breaks_at_its_blanks_only() -> None:
    command = (
        'ros2 action send_goal /turtle1/rotate_absolute turtlesim/action/RotateAbsolute "{theta: 1.57}" --feedback'
    )
    for width in range(34, 100):
        lines = wrap(f"写：{command}", width)
        assert " ".join(lines) == f"写：{command}"


def test_a_word_without_any_sign_breaks_where_it_must() -> None:
    assert wrap("a" * 50, 20) == ["a" * 20, "a" * 20, "a" * 10]
    assert wrap("/" + "a" * 30, 20) == ["/" + "a" * 19, "a" * 11], (
        "a sign at the very beginning is no place for a break"
    )
