"""What checks say to a pupil: sentences, never a regular expression, and never the name of a lesson's own program."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from day6_core.language import LANGUAGES
from day6_core.lessons.catalogue import days, drills
from day6_core.lessons.checks import Condition, condition_of, kinds
from day6_core.lessons.checks.judged import _said
from day6_core.lessons.checks.patterns import readable
from day6_core.lessons.texts import Say


def conditions() -> Iterator[Condition]:
    """Every check of the six days and the drills."""
    for lesson in (*days(), *drills()):
        for step in lesson.steps:
            for condition in step.checks:
                yield from condition.every()


@pytest.mark.parametrize(
    ("pattern", "text"),
    [
        (r"ros2 (run|launch) lamp\b", "ros2 run lamp"),
        (r"^cd( ~| -|)/?$", "cd ~/"),
        (r"ros2 pkg list.*\| ?grep .*[Tt]urtle", "ros2 pkg list…| grep …Turtle"),
        (r"python3? (\S*/)?compass\.py", "python3 compass.py"),
        (r"^(?!.*test_ws).*gate_ws/install/gate", "gate_ws/install/gate"),
        (r"^[1-9][0-9]* turns", "1 turns"),
        (r"class \w+\(Node\)", "class …(Node)"),
        (r"(?i)hello( world){2,3}", "hello world"),
        (r"a{0,2}b", "b"),
        (r"(?P<who>x|y)=\d+?", "x="),
        (r"setup.bash", "setup.bash"),
        (r".*", ".*"),
    ],
)
def test_a_pattern_is_told_as_a_text_that_it_matches(pattern: str, text: str) -> None:
    assert readable(pattern) == text


def test_what_a_pupil_reads_of_a_pattern_would_be_right() -> None:
    wrong = []
    for condition in conditions():
        kind = kinds().get(condition.name)
        for parameter in kind.patterns if kind is not None else ():
            pattern = condition.arguments.get(parameter, "")
            text = readable(pattern).replace("…", "x")
            if not any(re.search(pattern, each, re.MULTILINE) for each in (text, f"{text} x")):
                wrong.append((pattern, text))
    assert wrong == []


def test_an_empty_list_is_told_in_a_sentence() -> None:
    empty = Say("package.saw", names=()), Say("node.saw", name="/talker", nodes=()), Say("running.saw", lines=())
    assert [each.text("zh") for each in empty] == [
        "现在一个也没有。",
        "没有节点 /talker，现在一个节点也没有。",
        "现在什么也没有运行。",
    ]
    assert [each.text("en") for each in empty] == [
        "There are none.",
        "There is no node /talker, or any other node.",
        "Nothing is running.",
    ]
    assert Say("package.saw", names=("a", "b")).text("zh") == "现在有：a、b。"


@pytest.mark.parametrize("kind", ["folder", "file"])
def test_what_is_not_there_yet_is_told_in_one_breath(tmp_path: Path, kind: str) -> None:
    condition: Any = condition_of({kind: "~/my_robot"})
    live: Any = SimpleNamespace(path=lambda path: tmp_path / path[2:], memory=lambda condition: {}, remembered={})
    noun = {"folder": "文件夹", "file": "文件"}[kind]
    missing = condition.judge(live)
    assert missing.text("zh") == f"要有{noun} ~/my_robot（现在还没有）"
    assert missing.text("en") == f"the {kind} ~/my_robot exists (not yet)"
    (tmp_path / "my_robot").mkdir() if kind == "folder" else (tmp_path / "my_robot").touch()
    assert condition.judge(live).text("zh") == f"要有{noun} ~/my_robot"


def test_what_a_program_of_a_lesson_looks_for_is_told_in_its_own_sentence() -> None:
    own = [condition for condition in conditions() if condition.name == "python"]
    assert own and all(condition.arguments.get(language) for condition in own for language in LANGUAGES)
    driver = next(each for each in own if each.arguments["file"] == "check_driver.py")
    live: Any = SimpleNamespace(folder=Path("nowhere"), memory=lambda condition: {}, remembered={})
    assert driver.judge(live).wanted.text("zh") == "driver 的话，海龟真的听到了"
    assert driver.judge(live).wanted.text("en") == "the turtle really hears what driver says"


@pytest.mark.parametrize(
    ("line", "zh", "en"),
    [
        ("叶片不动 (the sail stands still)", "叶片不动", "the sail stands still"),
        ("it (still) waits", "it (still) waits", "it (still) waits"),
        ("只有中文", "只有中文", "只有中文"),
    ],
)
def test_what_a_program_of_a_lesson_says_is_read_in_one_language(line: str, zh: str, en: str) -> None:
    said = _said(line)
    assert (said.text("zh"), said.text("en")) == (zh, en)


SIDES = re.compile(
    r"[左右上下](边|面|方)(那|这)个|RViz ?(左|右)边|(box|window|pane|terminal) (on|at) the (left|right)"
    r"|(left|right) (side of|of|in) RViz"
)
"""Where something lies on the screen: on a phone it lies elsewhere."""


def test_no_lesson_says_on_which_side_of_the_screen_something_is() -> None:
    said = []
    for lesson in (*days(), *drills()):
        for step in lesson.steps:
            for language, page in step.pages.items():
                texts = (page.body, page.do, *page.hints, *(answer.text for answer in page.answers))
                said += [
                    (lesson.name, step.name, language, found[0]) for text in texts for found in SIDES.finditer(text)
                ]
    assert said == []
