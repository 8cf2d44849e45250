"""Lesson files: what is read from a good one, and what a bad one is told, with the line."""

from __future__ import annotations

from pathlib import Path

import pytest

from day6_core.language import LANGUAGES
from day6_core.lessons import catalogue
from day6_core.lessons.document import Lesson
from day6_core.lessons.reading import read_lesson
from day6_core.lessons.source import LessonMistakes

EXAMPLE = (Path(catalogue.__file__).parent / "example.md").read_text(encoding="utf-8")


def read(tmp_path: Path, text: str | bytes) -> Lesson:
    path = tmp_path / "lesson.md"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return read_lesson(path)


def mistakes(tmp_path: Path, text: str | bytes) -> list[str]:
    with pytest.raises(LessonMistakes) as raised:
        read(tmp_path, text)
    return [f"{each.line}: {each.text}" for each in raised.value.mistakes]


def test_the_example_is_read_whole(tmp_path: Path) -> None:
    lesson = read(tmp_path, EXAMPLE)
    (step,) = lesson.steps
    assert (lesson.name, lesson.minutes, lesson.is_drill) == ("example", 5, False)
    assert [check.name for check in step.checks] == ["node", "window"]
    assert step.checks[0].arguments == {"name": "/turtlesim"}
    assert step.command == "ros2 run turtlesim turtlesim_node"
    assert step.wrong[0].says == "There is no node /turtlesim"
    assert step.wrong[0].undo == ({"keys": "ctrl+c"},)
    for language in LANGUAGES:
        page = step.pages[language]
        assert len(page.picture) == 5
        assert len(page.hints) == 3
        assert "turtlesim" in page.body
        assert "turtlesim_node" in page.do
        assert page.teacher


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("---\nlesson", "lesson", "1: the file has to begin with '---'"),
        ("lesson: example", "lesson: My Lesson", "2: 'lesson' has to be a name"),
        ("lesson: example", "lesson: example\ncolour: red", "3: unknown key 'colour'"),
        ("minutes: 5", "minutes: soon", "4: 'minutes' has to be a whole number"),
        ("  en: A little turtle\n", "", "5: 'title' needs a text for 'zh' and for 'en'"),
        ("order: 10", "order: [10", "not YAML"),
        ("check:\n", "see: [turtelsim]\ncheck:\n", "see: there is no window 'turtelsim'; did you mean 'turtlesim'?"),
        ("check:\n", "see: turtlesim\ncheck:\n", "'see' has to be a list"),
        ("- node: /turtlesim", "- nodes: /turtlesim", "there is no check 'nodes'; did you mean 'node'?"),
        ("- node: /turtlesim", "- node: {named: /turtlesim}", "unknown argument 'named'; did you mean 'name'?"),
        ("- node: /turtlesim", "- node: {count: 2}", "node: the argument 'name' is missing"),
        ("- node: /turtlesim", "- node: {name: /turtlesim, count: two}", "'count' has to be a whole number, not 'two'"),
        ("- node: /turtlesim", "- node: 7", "node: 'name' has to be a text, not 7 (quote it)"),
        ("- node: /turtlesim", "- ran: 'ros2 ('", "'line' is not a regular expression"),
        ("- node: /turtlesim", "- any: /turtlesim", "'any' combines a list of checks"),
        ("      - keys: ctrl+c", "      - terminal: {running: 'teleop ('}", "'running' is not a regular expression"),
        ("      - keys: ctrl+c", "      - terminal: {runs: teleop}", "terminal: {running: PATTERN} is what may be written"),
        ("      - keys: ctrl+c", "      - terminal: last", "'new', 'idle', a number from 1 or {running: PATTERN}"),
        ("- node: /turtlesim\n  - window", "- node: /turtlesim\n    window", "one check has one name"),
        ("check:\n  - node: /turtlesim\n  - window: turtlesim\n", "", "step 'turtle' checks nothing"),
        ("  - type: ros2 run turtlesim turtlesim_node\nwrong", "  - tipe: x\nwrong", "there is no action 'tipe'"),
        ("keys: ctrl+c", "keys: ctrl+shift+c", "keys: there is no key 'ctrl+shift+c'"),
        ("      - wait: {node: /teleop_turtle}", "      - wait: {nod: /x}", "wait: there is no check 'nod'"),
        ("    says: There", "    sais: There", "wrong: each needs 'do' (actions) and 'says'"),
        ("solve:", "needs: [before]\nsolve:", "needs: no earlier step is called 'before'"),
        ("solve:", "sove: []\nsolve:", "unknown key 'sove'"),
        ("# turtle\n", "# The Turtle\n", "'The Turtle': the name of a step"),
        ("# turtle\n", "hello\n# turtle\n", "text before the first step"),
        ("## en Open", "## fr Open", "expected '## zh TITLE' or '## en TITLE'"),
        ("## zh 打开海龟的窗口", "## zh", "'## zh' has no title"),
        ("### do\n\n在", "### done\n\n在", "unknown part '### done'"),
        ("2. 后面", "   后面", "step 'turtle', zh: 3 hints are needed, there are 2"),
        ("2. 后面", "* 后面", "step 'turtle', zh: 3 hints are needed, there are 2"),
        ("|          @             |", "|          @             |" + "x" * 12, "the most are 34 and 9"),
        ("~~~picture\n", "~~~picture\n" + "|\n" * 8, "the most are 34 and 9"),
        ("有人会把", "有人\x1b[2J会把", "control character"),
    ],
)  # fmt: skip
def test_a_mistake_is_named_with_its_line(tmp_path: Path, old: str, new: str, told: str) -> None:
    assert EXAMPLE.count(old) >= 1, old
    found = mistakes(tmp_path, EXAMPLE.replace(old, new, 1))
    assert any(told in each for each in found), found
    assert all(each.split(":")[0].isdigit() for each in found)


def test_lines_of_mistakes_are_those_of_the_file(tmp_path: Path) -> None:
    at = EXAMPLE.split("\n").index("# turtle") + 1
    (found,) = mistakes(tmp_path, EXAMPLE.replace("check:\n  - node: /turtlesim\n  - window: turtlesim\n", ""))
    assert found == f"{at}: step 'turtle' checks nothing"


@pytest.mark.parametrize(
    "text",
    [b"", b"\xff\xfe\x00", b"---", b"---\n---\n", b"---\n- a\n---\n# x\n", b"# x\n" * 500, b"---\n" + b"[" * 3000],
)
def test_anything_at_all_is_refused_in_words(tmp_path: Path, text: bytes) -> None:
    assert mistakes(tmp_path, text)


def test_a_drill_has_one_step(tmp_path: Path) -> None:
    drill = EXAMPLE.replace("lesson: example", "drill: example\nfault: 12\ntopic: names")
    lesson = read(tmp_path, drill)
    assert (lesson.is_drill, lesson.fault, lesson.topic) == (True, 12, "names")
    second = drill[drill.index("# turtle") :].replace("# turtle", "# again")
    assert mistakes(tmp_path, drill + second) == [f"{len(drill.split(chr(10)))}: a drill has one step, not 2"]


def test_two_steps_of_one_name_are_refused(tmp_path: Path) -> None:
    (found,) = mistakes(tmp_path, EXAMPLE + EXAMPLE[EXAMPLE.index("# turtle") :])
    assert "there are two steps 'turtle'" in found


def test_every_shipped_file_can_be_read() -> None:
    for folder in ("days", "drills"):
        found = catalogue.lessons_in(catalogue.HERE / folder)
        assert [str(each) for each in found.broken] == []
        names = [lesson.name for lesson in found.all]
        assert len(names) == len(set(names))
