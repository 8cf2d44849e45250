"""A lesson played in a real terminal: from the welcome choice to the end, by keys alone and by mouse alone."""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from mouse import Mouse
from todays import todays
from waiting import until

from day6_tui.core.lessons import catalogue
from day6_tui.core.lessons.progress import pupils
from day6_tui.tui.locale import Texts

if TYPE_CHECKING:
    from place import Place

EXAMPLE = (Path(catalogue.__file__).parent / "example.md").read_text(encoding="utf-8")
COMMAND = "ros2 run turtlesim turtlesim_node"
everybody = pytest.mark.parametrize(
    ("lang", "size"),
    [
        pytest.param(*each, id=f"{each[0]}-{each[1][0]}")
        for each in todays(list(itertools.product(("zh", "en"), ((80, 24), (120, 40)))))
    ],
)


@pytest.fixture
def lessons(place: Place) -> Path:
    """A folder with two lessons."""
    folder = place.work / "lessons"
    folder.mkdir()
    (folder / "one.md").write_text(EXAMPLE, encoding="utf-8")
    second = EXAMPLE.replace("lesson: example", "lesson: second").replace("order: 10", "order: 11")
    (folder / "two.md").write_text(
        second.replace("A little turtle", "Second").replace("一只小海龟", "第二课"), encoding="utf-8"
    )
    return folder


def keyboard_at(title: str) -> Callable[[str], object]:
    """Whether the pane with this title has the keyboard."""
    return lambda seen: re.search(rf"┏[^╭┓\n]* {re.escape(title)}", seen)


@everybody
def test_by_keys_from_the_list_to_the_end(place: Place, lessons: Path, lang: str, size: tuple[int, int]) -> None:
    texts = Texts(lang)
    with place.desktop("--lessons", str(lessons), columns=size[0], rows=size[1], lang=lang) as screen:
        screen.wait(texts("lesson.days"), keyboard_at(texts("lesson.title")))
        screen.press("Enter")
        screen.wait(texts("lesson.step", number=1, all=1))
        for number in (1, 2, 3):
            screen.press("h")
            screen.wait(texts("lesson.hint", number=number, all=3))
        screen.press("Enter")  # types the command; Return is the pupil's
        screen.wait(lambda seen: re.search(r"\$ ros2 run", seen))
        screen.press("Enter")
        screen.wait("TurtleSim", texts("lesson.next.key"))
        screen.press("F5")
        screen.wait(texts("lesson.days"))
        screen.wait(lambda seen: any("✓" in line for line in seen.split("\n")))
        screen.press("Ctrl-Q")
        screen.wait(texts("quit.end"))
        screen.press("y")
        screen.wait_end()
    (anna,) = pupils(place.home)
    assert anna.solved("example") == 1
    assert anna.step("example", "turtle").hints == 3


@everybody
def test_by_mouse_with_the_command_typed(place: Place, lessons: Path, lang: str, size: tuple[int, int]) -> None:
    texts = Texts(lang)
    title = {"zh": "第二课", "en": "Second"}[lang]
    with place.desktop("--lessons", str(lessons), columns=size[0], rows=size[1], lang=lang) as screen:
        mouse = Mouse(screen)
        screen.wait(texts("lesson.days"), title)
        mouse.click_on(title)
        screen.wait(texts("lesson.step", number=1, all=1))
        mouse.click_on(texts("lesson.hint.key"))
        screen.wait(texts("lesson.hint", number=1, all=3))
        mouse.click_on("student@day6")
        screen.line(COMMAND)
        screen.wait("TurtleSim", texts("lesson.next.key"))
        mouse.click_on(texts("lesson.next.key"))
        screen.wait(texts("lesson.days"))


def test_the_welcome_choice_goes_on_where_one_stopped(place: Place) -> None:
    texts = Texts("zh")
    with place.desktop(lang="zh") as screen:
        screen.wait(texts("welcome.lessons"))
        screen.press("4")
        screen.wait(texts("lesson.days"), keyboard_at(texts("lesson.title")))
        screen.press("Enter")
        screen.wait(lambda seen: re.search(r"第 1/\d+ 步", seen))
        screen.press("Right")
        screen.wait(lambda seen: re.search(r"第 2/\d+ 步", seen))
        until(lambda: any(pupil.at.get("day1") for pupil in pupils(place.home)))
        screen.kill()
    with place.desktop(lang="zh") as screen:
        screen.wait("接着上次：第 1 天")
        screen.press("4")
        screen.wait(lambda seen: re.search(r"第 2/\d+ 步", seen))
        screen.press("F5", "L")
        screen.wait(texts("lesson.days"))


def test_the_language_changes_while_a_lesson_runs(place: Place, lessons: Path) -> None:
    with place.desktop("--lessons", str(lessons), "--lesson", "example", lang="zh") as screen:
        screen.wait("打开海龟的窗口")
        screen.press("F7")
        screen.wait(Texts("zh")("menu.palette"))
        screen.send(Texts("zh")("action.language"))
        screen.press("Enter")
        screen.wait("Open the turtle's window", "Step 1 of 1")


def test_a_lesson_that_is_not_there_is_told(place: Place, lessons: Path) -> None:
    with place.desktop("--lessons", str(lessons), "--lesson", "day9", lang="en") as screen:
        screen.wait(Texts("en")("lesson.unknown", name="day9"))


def test_lesson_files_without_a_screen(place: Place) -> None:
    result = place.run("lessons", "new", "mine.md")
    assert (result.returncode, result.stderr) == (0, "")
    assert place.run("lessons", "new", "mine.md").returncode == 1
    assert place.run("lessons", "check", "mine.md").stdout == "mine.md: 1 steps, no mistake\n"
    assert "Open the turtle's window" in place.run("lessons", "preview", "--lang", "en", "mine.md").stdout
    played = place.run("lessons", "play", "mine.md")
    assert (played.returncode, played.stdout[:4]) == (0, "ok  ")
    assert place.run("lessons", "list").returncode == 0
    assert "## Checks" in place.run("lessons", "help").stdout
    bad = place.work / "bad.md"
    bad.write_text(EXAMPLE.replace("- node:", "- nodes:"))
    result = place.run("lessons", "check", "bad.md")
    assert (result.returncode, result.stderr.split(": ", 1)[0]) == (1, "bad.md:13")
    assert (
        place.run("lessons", "check", "nothing.md").stderr
        == "day6-tui lessons: nothing.md: No such file or directory\n"
    )


def test_a_command_typed_at_the_lesson_goes_to_the_terminal(place: Place, lessons: Path) -> None:
    texts = Texts("en")
    with place.desktop("--lessons", str(lessons), "--lesson", "example", lang="en") as screen:
        screen.wait("student@day6:~$", texts("lesson.step", number=1, all=1))
        screen.press("F5")
        screen.wait(keyboard_at("A little turtle"))
        screen.line("echo right here")
        screen.wait_lines("right here")
        screen.wait(texts("lesson.step", number=1, all=1))
