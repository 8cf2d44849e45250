"""A lesson played in a real terminal: from the welcome choice to the end, by keys alone and by mouse alone."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from day6_core.lessons import catalogue
from day6_core.lessons.progress import pupils
from day6_core.lessons.scene import scenes
from day6_tui.locale import Texts
from tests.e2e.mouse import Mouse
from tests.support.waiting import until

if TYPE_CHECKING:
    from tests.e2e.place import Place

pytestmark = pytest.mark.person

EXAMPLE = (Path(catalogue.__file__).parent / "example.md").read_text(encoding="utf-8")
COMMAND = "ros2 run turtlesim turtlesim_node"
LESSONS = str(1 + sum(scene.is_action for scene in scenes().values()))
"""The number of their choice at the start: the scenes come before it."""


def both(large: str) -> pytest.MarkDecorator:
    """Play a test in both languages where there is little room, and in one of them where there is much."""
    chosen = [("zh", (80, 24)), ("en", (80, 24)), (large, (120, 40))]
    return pytest.mark.parametrize(
        ("lang", "size"), [pytest.param(lang, size, id=f"{lang}-{size[0]}") for lang, size in chosen]
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


@both(large="en")
def test_by_keys_from_the_list_to_the_end(place: Place, lessons: Path, lang: str, size: tuple[int, int]) -> None:
    texts = Texts(lang)
    with place.desktop("--lessons", str(lessons), columns=size[0], rows=size[1], lang=lang) as screen:
        screen.wait(texts("lesson.own"), keyboard_at(texts("lesson.title")))
        screen.press("Enter")
        screen.wait(texts("lesson.step", number=1, all=1))
        for number in (1, 2, 3):
            screen.press("h")
            screen.wait(texts("lesson.hint", number=number, all=3))
        screen.press("Enter")  # types the command; Return is the pupil's
        screen.wait(lambda seen: re.search(r"\$ ros2 run", seen))
        screen.press("Enter")
        screen.wait("TurtleSim", texts("lesson.next.key", next=texts("lesson.key.next.day")))
        screen.press("F5")
        screen.wait(texts("lesson.own"))
        screen.wait(lambda seen: any("✓" in line for line in seen.split("\n")))
        screen.press("Ctrl-Q")
        screen.wait(texts("quit.running"))
        screen.press("y")
        screen.wait_end()
    (anna,) = pupils(place.home)
    assert anna.solved("example") == 1
    assert anna.step("example", "turtle").hints == 3


@both(large="zh")
def test_by_mouse_with_the_command_typed(place: Place, lessons: Path, lang: str, size: tuple[int, int]) -> None:
    texts = Texts(lang)
    title = {"zh": "第二课", "en": "Second"}[lang]
    with place.desktop("--lessons", str(lessons), columns=size[0], rows=size[1], lang=lang) as screen:
        mouse = Mouse(screen)
        screen.wait(texts("lesson.own"), title)
        mouse.click_on(title)
        screen.wait(texts("lesson.step", number=1, all=1))
        mouse.click_on(texts("lesson.hint.key"))
        screen.wait(texts("lesson.hint", number=1, all=3))
        mouse.click_on("student@day6")
        screen.line(COMMAND)
        screen.wait("TurtleSim", texts("lesson.next.key", next=texts("lesson.key.next.day")))
        mouse.click_on(texts("lesson.next.key", next=texts("lesson.key.next.day")))
        screen.wait(texts("lesson.own"))


def test_the_welcome_choice_goes_on_where_one_stopped(place: Place) -> None:
    texts = Texts("zh")
    with place.desktop(lang="zh") as screen:
        screen.wait(texts("welcome.lessons"))
        screen.press(LESSONS)
        screen.wait(texts("lesson.days"), keyboard_at(texts("lesson.title")))
        screen.press("Enter")
        screen.wait(lambda seen: re.search(r"第 1/\d+ 步", seen))
        screen.press("Right")
        screen.wait(lambda seen: re.search(r"第 2/\d+ 步", seen))
        second = catalogue.days()[0].steps[1].name
        until(lambda: any(pupil.at.get("day1") == second for pupil in pupils(place.home)))
        screen.kill()
    with place.desktop(lang="zh") as screen:
        screen.wait("接着上次：第 1 天")
        screen.press(LESSONS)
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


def test_a_lesson_that_is_not_there_is_refused_before_the_desktop_opens(place: Place, lessons: Path) -> None:
    with place.desktop("--lessons", str(lessons), "--lesson", "day9", lang="en", columns=200) as screen:
        assert screen.wait_end() == 2
        assert "there is no lesson 'day9'; the lessons are example, second" in screen.look()
        assert b"\x1b[?1049h" not in screen.output


def test_lesson_files_without_a_screen(place: Place) -> None:
    result = place.run("lessons", "new", "mine.md")
    assert (result.returncode, result.stderr) == (0, "")
    assert place.run("lessons", "new", "mine.md").returncode == 1
    assert place.run("lessons", "check", "mine.md").stdout == "mine.md: 1 step, no mistake\n"
    assert "Open the turtle's window" in place.run("lessons", "preview", "--lang", "en", "mine.md").stdout
    played = place.run("lessons", "play", "mine.md")
    assert (played.returncode, played.stdout[:4]) == (0, "ok  ")
    assert place.run("lessons", "list").returncode == 0
    for language, heading in (("en", "## Checks"), ("zh", "## 检查")):
        assert heading in place.run("lessons", "help", DAY6_LANG=language).stdout
    bad = place.work / "bad.md"
    bad.write_text(EXAMPLE.replace("- node:", "- nodes:"))
    result = place.run("lessons", "check", "bad.md")
    assert (result.returncode, result.stderr.split(": ", 1)[0]) == (1, "bad.md:14")
    bad.write_text(EXAMPLE.replace("- wait: {node: /teleop_turtle}", "- write: {file: ../../x.txt, text: a}"))
    result = place.run("lessons", "play", "bad.md")
    assert (result.returncode, result.stderr.split(": ", 1)[0]) == (1, "bad.md:21")
    assert "'../../x.txt' has to lie in the home folder" in result.stderr
    bad.write_text(EXAMPLE.replace("lesson: example", "lesson: day1"))
    result = place.run("lessons", "check", "bad.md")
    assert (result.returncode, result.stdout) == (1, "bad.md: 1 step, 1 mistake\n")
    assert result.stderr == "bad.md:2: a lesson that comes with day6-tui is called 'day1' too: take another name\n"
    wide = place.work / "wide.md"
    wide.write_text(EXAMPLE.replace("A turtle lives", f"~~~\n{'x' * 40}\n~~~\n\nA turtle lives"))
    result = place.run("lessons", "check", "wide.md")
    assert (result.returncode, result.stdout) == (0, "wide.md: 1 step, no mistake, 1 warning\n")
    assert "warning: 40 columns of code: the window has 34 at 80x24" in result.stderr
    assert place.run("lessons", "new", "--drill", "fault.md").returncode == 0
    played = place.run("lessons", "play", "fault.md")
    assert (played.returncode, played.stdout[:4]) == (0, "ok  ")
    assert place.run("lessons", "new", "mine").returncode == 2
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


def question(place: Place) -> Path:
    """A folder with a lesson of four steps: a command, a command and a question, a question, a command."""
    steps = {
        "one": ("  - ran: {line: '^echo one'}\n", ""),
        "two": ("  - ran: {line: '^echo two'}\n  - answer: b\n", "### answers\n\n- a: this\n- b: that | Right.\n\n"),
        "three": ("  - answer: a\n", "### answers\n\n- a: this | Right.\n- b: that\n\n"),
        "four": ("  - ran: {line: '^echo one', since: step}\n", ""),
    }
    text = "---\nlesson: asks\norder: 1\nminutes: 5\ntitle:\n  zh: 问\n  en: Asks\n---\n"
    for name, (check, answers) in steps.items():
        text += f"\n# {name}\n\n~~~yaml\ncheck:\n{check}~~~\n"
        for language in ("zh", "en"):
            hints = "".join(f"{number}. hint\n" for number in (1, 2, 3))
            text += f"\n## {language} {name}\n\nText.\n\n### do\n\nDo {name}.\n\n{answers}### hints\n\n{hints}"
    folder = place.work / "asking"
    folder.mkdir()
    (folder / "asks.md").write_text(text, encoding="utf-8")
    return folder


@both(large="en")
def test_the_keyboard_is_where_the_step_is_done(place: Place, lang: str, size: tuple[int, int]) -> None:
    texts = Texts(lang)
    title = {"zh": "问", "en": "Asks"}[lang]
    letters = texts("list.comma").join("ab")

    def seen_whole(words: str) -> Callable[[str], object]:
        """Lines are broken in a narrow window."""
        wanted = re.sub(r"\s", "", words)
        return lambda seen: wanted in re.sub(r"[\s│┃]", "", "".join(line[size[0] // 2 :] for line in seen.split("\n")))

    with place.desktop(
        "--lessons", str(question(place)), "--lesson", "asks", columns=size[0], rows=size[1], lang=lang
    ) as screen:
        screen.wait("student@day6:~$", texts("lesson.step", number=1, all=4), f"F5 {texts('lesson.hint.key')}")
        screen.line("echo one")
        screen.wait(seen_whole(texts("lesson.solved", key="F5", go_on=texts("lesson.go_on"))))
        screen.press("F5")
        screen.wait(texts("lesson.step", number=2, all=4), seen_whole(texts("lesson.answer", letters=letters)))
        screen.line("echo two")
        screen.wait(
            keyboard_at("1 ~"), lambda seen: screen.pieces().count("two") == 2
        )  # what is printed, and the title
        screen.press("F5")
        screen.wait(keyboard_at(title), seen_whole(texts("lesson.answer.here", letters=letters)))
        for key in "basename abba":  # a command is no answer, however slowly it is typed
            screen.press(key)
            screen.look(0.1)
        screen.press("Enter")
        screen.wait_lines("abba")
        screen.press("F5")
        screen.wait(keyboard_at(title))
        screen.press("a", "b", "Enter")
        screen.wait(seen_whole(texts("lesson.solved", key="Enter", go_on=texts("lesson.go_on"))))
        screen.press("Enter")
        screen.wait(texts("lesson.step", number=3, all=4), keyboard_at(title))  # there is only something to choose
        screen.press("Left")
        screen.wait(texts("lesson.step", number=2, all=4), seen_whole(texts("lesson.done_before")))
        screen.press("Right")
        screen.wait(texts("lesson.step", number=3, all=4))  # an answer is one to the question that is seen
        screen.press("a", "Enter")
        screen.wait(seen_whole(texts("lesson.solved", key="Enter", go_on=texts("lesson.go_on"))))
        screen.press("Enter")
        screen.wait(texts("lesson.step", number=4, all=4), keyboard_at("1 ~"))  # there is something to be typed
        screen.press("Up", "Up", "Up", "Enter")
        screen.wait(seen_whole(texts("lesson.solved", key="F5", go_on=texts("lesson.go_on.day"))))
        screen.press("F5")
        told = texts("lesson.finished", title=title, how=texts("lesson.finished.best"))
        screen.wait(seen_whole(told), keyboard_at(texts("lesson.title")))


@both(large="zh")
def test_the_lesson_is_there_again_behind_the_question(
    place: Place, lessons: Path, lang: str, size: tuple[int, int]
) -> None:
    texts = Texts(lang)
    words = ("--lessons", str(lessons))
    with place.desktop(*words, "--lesson", "example", columns=size[0], rows=size[1], lang=lang) as screen:
        screen.wait("student@day6:~$", texts("lesson.step", number=1, all=1))
        screen.line("sleep 1000")
        screen.wait(keyboard_at("1 sleep"))
        screen.press("Ctrl-Q")
        screen.wait(texts("quit.running"))
        screen.press("y")
        screen.wait_end()
    with place.desktop(*words, columns=size[0], rows=size[1], lang=lang) as screen:
        screen.wait(texts("session.title"), texts("session.back"), texts("lesson.step", number=1, all=1))
        screen.press("F2", "F5", "F6")  # nothing happens unseen behind a question
        screen.press("Esc")
        screen.wait_gone(texts("session.title"))
        seen = screen.wait("student@day6:~$", texts("lesson.step", number=1, all=1), keyboard_at("1 ~"))
        assert not re.search(r"[╭┏] 3 ", seen)


def test_a_teachers_own_drill_has_its_heading_and_the_notes_come_into_sight(place: Place, lessons: Path) -> None:
    example = Path(catalogue.__file__).with_name("example_drill.md").read_text(encoding="utf-8")
    (lessons / "drill.md").write_text(example.replace("drill: example", "drill: own"), encoding="utf-8")
    long = EXAMPLE.replace(
        "A turtle lives", "\n\n".join(f"Line {number}." for number in range(40)) + "\n\nA turtle lives"
    )
    (lessons / "one.md").write_text(long, encoding="utf-8")
    texts = Texts("en")
    with place.desktop("--lessons", str(lessons), lang="en") as screen:
        screen.wait("student@day6:~$", texts("lesson.own"), texts("lesson.drills.own"), "The listener hears")
    with place.desktop("--lessons", str(lessons), "--lesson", "example", lang="en") as screen:
        screen.wait("student@day6:~$", "Line 0.")
        screen.press("F5")
        screen.wait(keyboard_at("A little turtle"))
        screen.press("T")
        screen.wait(texts("lesson.notes"), "message aloud")
