"""What a teacher is told of a mistake: its line, what to do, nothing that only follows from it; and matters of taste."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from day6_core.language import LANGUAGES
from day6_core.lessons import catalogue, remarks
from day6_core.lessons.actions import WINDOWS
from day6_core.lessons.command import WRITING
from day6_core.lessons.reading import read_lesson
from day6_core.lessons.source import LessonMistakes
from tests.support.window_kinds import window_kinds

EXAMPLE = (catalogue.HERE / "example.md").read_text(encoding="utf-8")
DRILL = (catalogue.HERE / "example_drill.md").read_text(encoding="utf-8")
SOLVE = "  - type: ros2 run turtlesim turtlesim_node\n"
WAIT = "      - wait: {node: /teleop_turtle}\n"


def mistakes(folder: Path, text: str | bytes) -> list[str]:
    path = folder / "lesson.md"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    with pytest.raises(LessonMistakes) as raised:
        read_lesson(path)
    return [f"{each.line}: {each.text}" for each in raised.value.mistakes]


def remarked(folder: Path, text: str) -> list[tuple[int, str, bool]]:
    path = folder / "lesson.md"
    path.write_text(text, encoding="utf-8")
    return [(each.line, each.text, each.warning) for each in read_lesson(path).remarks]


def test_the_examples_have_no_mistake_and_no_warning(tmp_path: Path) -> None:
    assert remarked(tmp_path, EXAMPLE) == []
    assert remarked(tmp_path, DRILL) == []


@pytest.mark.parametrize(
    ("old", "new", "marked", "told"),
    [
        # A line of its own for whatever stands in the block or in the front matter, and the nearest name.
        ("  - node: /turtlesim", "  - nodee: /turtlesim", "nodee", "check: there is no check 'nodee'; did you mean 'node'?"),
        ("  - window: turtlesim", "  - window: turtlsim", "turtlsim", "did you mean 'turtlesim'?"),
        ("  - window: turtlesim", "  - trail: {shape: hexagon}", "hexagon", "there are pentagram, square, triangle"),
        ("  - window: turtlesim", "  - node: {nam: /x}", "nam:", "unknown argument 'nam'; did you mean 'name'?"),
        ("  - window: turtlesim", "  - node:\n      name: /x\n      count: two", "two", "has to be a whole number"),
        ("  - window: turtlesim", "  - any:\n      - node: /x\n      - nod: /y", "nod:", "any: there is no check 'nod'"),
        ("  - window: turtlesim", "  - node: turtlesim", "node: turtlesim", "'name' is a full name: write /turtlesim"),
        ("  - window: turtlesim", "  - ran: 'ros2 ('", "ros2 (", "'line' is not a regular expression"),
        ("  - window: turtlesim", "  - python: nothere.py", "nothere", "there is no file 'nothere.py' beside the lesson"),
        (SOLVE, "  - typ: x\n", "typ:", "solve: there is no action 'typ'; did you mean 'type'?"),
        ("keys: ctrl+c", "keys: ctrl+xx", "ctrl+xx", "there is no key 'ctrl+xx'; did you mean 'ctrl+x'?"),
        (WAIT, "      - close: turtlsim\n", "close", "there is no window 'turtlsim'; did you mean 'turtlesim'?"),
        (WAIT, "      - wait: {nod: /x}\n", "nod:", "do: wait: there is no check 'nod'"),
        ("    says: There", "    sayz: There", "sayz", "'sayz' is unknown; did you mean 'says'?"),
        ("solve:", "solv:", "solv:", "unknown key 'solv'; did you mean 'solve'?"),
        ("order: 10", "oder: 10", "oder", "unknown key 'oder'; did you mean 'order'?"),
        ("minutes: 5", "minutes: -5", "minutes", "'minutes' has to be a whole number from 1 on"),
        ("lesson: example", "lesson: my lesson", "my lesson", "'lesson' has to be a name of letters"),
        ("solve:", "check:\n  - node: /b\nsolve:", "check:\n  - node: /b\n", "'check' is there twice (line 13)"),
        ("### do\n\n在", "### doo\n\n在", "### doo", "unknown part '### doo'; did you mean 'do'?"),
        ("2. 后面先写功能包的名字 `turtlesim`，再写程序的名字。\n", "", "### hints", "3 hints are needed, there are 2"),
        ("2. 后面先写功能包的名字 `turtlesim`，再写程序的名字。", "2.", "2.\n", "this hint has no text"),
        ("### hints\n\n1. 要", "### answers\n\n- b two\n\n### hints\n\n1. 要", "- b two", "an answer is '- a: TEXT | REASON'"),
        # What is no YAML, in words that say what to do.
        ("  - window", "   - window", "   - window", "not YAML: this line is not indented like the lines it belongs to"),
        ("  - window", "\t- window", "\t- window", "not YAML: a tab: indent with blanks"),
        (SOLVE, '  - type: ros2 topic pub -1 /lamp std_msgs/msg/Bool "{data: true}"\n', "{data", "a command below 'type: |'"),
        ("A little turtle\n", "A turtle: a little one\n", "A turtle:", "put the text in quotes"),
        ("  - window: turtlesim", "  - window: @x", "@x", "needs quotes"),
        ("  - window: turtlesim", "  - window: [a", "[a", "a '[' or '{' that is not closed"),
        ("  - window: turtlesim", "  - window: 'a", "window: 'a", "a quote that is not closed"),
        ("check:\n", "check: &a [*a]\nx:\n", "&a", "it contains itself"),
        # One mistake, not what follows from it.
        ("      - keys: ctrl+c\n~~~", "      - keys: ctrl+c", "~~~yaml", "this block is not closed: '~~~' (as it began)"),
        ("\n---\n\n# turtle", "\n\n# turtle", "---\nlesson", "the '---' that ends the front matter is missing"),
        ("# turtle\n", "hello\n\nhello\n\n# turtle\n", "hello\n\nhello", "text before the first step"),
        ("## zh 打", "## fr 打", "## fr", "expected '## zh TITLE' or '## en TITLE'"),
        # Nothing outside of the pupil's home folder and of the lesson's own.
        ("  - window: turtlesim", "  - file: /etc/passwd", "/etc/passwd", "has to lie in the home folder: write ~/passwd"),
        ("  - window: turtlesim", "  - no_file: ~/../x", "~/../x", "has to lie in the home folder"),
        ("  - window: turtlesim", "  - package: {name: a, in: /opt}", "/opt", "has to lie in the home folder"),
        ("  - window: turtlesim", "  - python: ../../../etc/x.py", "../etc", "has to lie in the folder of the lesson"),
        (SOLVE, "  - write: {file: ../../x.txt, text: a}\n", "../../x.txt", "write: '../../x.txt' has to lie in the home folder"),
        (SOLVE, "  - write:\n      file: /etc/x\n      text: a\n", "file: /etc/x", "has to lie in the home folder"),
        (SOLVE, "  - replace: {file: x, old: a, new: b}\n", "file: x", "has to lie in the home folder: write ~/x"),
    ],
)  # fmt: skip
def test_a_mistake_is_told_once_in_its_line(tmp_path: Path, old: str, new: str, marked: str, told: str) -> None:
    assert old in EXAMPLE, old
    text = EXAMPLE.replace(old, new, 1)
    line = text[: text.index(marked)].count("\n") + 1
    (found,) = mistakes(tmp_path, text)
    assert found.startswith(f"{line}: "), found
    assert told in found


def test_another_encoding_is_told_as_one(tmp_path: Path) -> None:
    (found,) = mistakes(tmp_path, EXAMPLE.encode("gbk"))
    assert found == "6: the file is not UTF-8: save it again, in your editor, with the encoding UTF-8"


def test_a_program_is_no_lesson(tmp_path: Path) -> None:
    (found,) = mistakes(tmp_path, "import rclpy\n\n\ndef main():\n    # a comment\n    rclpy.init()\n")
    assert found.startswith("1: the file has to begin with '---'")


def test_a_text_that_repeats_itself_without_measure_is_refused(tmp_path: Path) -> None:
    rows = ["a: &a [x, x, x, x, x, x, x, x, x, x]"]
    for before, name in zip("abcdefgh", "bcdefghi", strict=True):
        rows.append(f"{name}: &{name} [{', '.join([f'*{before}'] * 10)}]")
    (found,) = mistakes(tmp_path, EXAMPLE.replace("check:\n", "\n".join([*rows, "check:\n"])))
    assert "it repeats too much" in found


@pytest.mark.parametrize(
    ("old", "new", "line", "told", "warning"),
    [
        ("solve:\n" + SOLVE, "", 10, "step 'turtle' has no 'solve'", False),
        ("  en: A little turtle", f"  en: {'long ' * 13}", 7, "a title of 64 columns: the most are 60", False),
        ("order: 10", "order: 10\nfault: 3", 4, "'fault' is for drills", False),
        (EXAMPLE[EXAMPLE.index("wrong:") : EXAMPLE.index("~~~\n\n## zh")], "", 10, "has no wrong answer", True),
        (EXAMPLE[EXAMPLE.index("~~~picture") : EXAMPLE.index("`turtlesim` 里")], "", 10, "there is no picture", True),
        (
            "`turtlesim` 里",
            f"~~~\n{'x' * 35}\n~~~\n\n`turtlesim` 里",
            38,
            "35 columns of code: the window has 34",
            True,
        ),
        ("，再按回车。", "，再按回车。" * 200, 10, "'### do' is long", True),
    ],
)
def test_what_a_class_would_meet_is_told_and_matters_of_taste_are_warnings(
    tmp_path: Path, old: str, new: str, line: int, told: str, warning: bool
) -> None:
    assert old in EXAMPLE
    ((at, text, is_warning),) = remarked(tmp_path, EXAMPLE.replace(old, new, 1))
    assert (at, is_warning) == (line, warning), text
    assert told in text


@pytest.mark.parametrize(
    ("old", "new", "told", "warning"),
    [
        ("topic: names", "topic: zzz", "topic 'zzz'; there are environment, ", True),
        ("topic: names", "topic: name", "topic 'name'; did you mean 'names'?", True),
        ("topic: names\n", "", "'topic' is missing", True),
        ("topic: names", "topic: names\nfault: 99", "'fault' is a number of the list of faults, 1 to 46", False),
        (DRILL[DRILL.index("before:") : DRILL.index("check:")], "", "a drill needs 'before'", False),
        (DRILL[DRILL.index("  - do:                       # a cap") : DRILL.index("~~~\n\n## zh")], "",
         "a drill needs 3 wrong answers, there are 2", False),
    ],
)  # fmt: skip
def test_what_a_drill_needs(tmp_path: Path, old: str, new: str, told: str, warning: bool) -> None:
    assert old in DRILL
    ((_, text, is_warning),) = remarked(tmp_path, DRILL.replace(old, new, 1))
    assert told in text
    assert is_warning == warning


def test_shipped_files_have_nothing_but_wide_code_against_them() -> None:
    for folder in ("days", "drills"):
        for lesson in catalogue.lessons_in(catalogue.HERE / folder).all:
            assert [each for each in lesson.remarks if "columns of code" not in each.text] == [], lesson.name


def test_names_that_ship_are_known_without_reading_the_files() -> None:
    assert catalogue.shipped_names() == {lesson.name for lesson in (*catalogue.days(), *catalogue.drills())}


def test_the_windows_a_lesson_may_name_are_those_there_are() -> None:
    assert set(WINDOWS) == set(window_kinds()) - {"classroom", "shown"}  # of a class


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_documentation_names_every_window_and_topic(language: str) -> None:
    text = (WRITING / f"{language}.md").read_text(encoding="utf-8")
    assert [name for name in (*WINDOWS, *remarks.TOPICS) if f"`{name}`" not in text and name != "lesson"] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_blocks_of_the_documentation_can_be_read(tmp_path: Path, language: str) -> None:
    text = (WRITING / f"{language}.md").read_text(encoding="utf-8")
    found = re.findall(r"\n```yaml\n(.*?)```\n", text, re.DOTALL)
    assert len(found) == 2
    for block, example in zip(found, (EXAMPLE, DRILL), strict=True):
        before, after = example.index("~~~yaml\n") + len("~~~yaml\n"), example.index("~~~\n\n## zh")
        remarked(tmp_path, example[:before] + block + example[after:])
