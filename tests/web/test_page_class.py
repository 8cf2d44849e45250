"""The teacher's page in a real browser: what a teacher sees and orders, and what pupils cannot do to it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from background import Background
    from chromium import Chromium, Page
    from page_server import PageServer

LESSON = {
    "name": "day1",
    "title": {"zh": "第 1 天：终端和环境", "en": "Day 1: terminal and environment"},
    "step": 3,
    "all": 12,
    "solved": True,
    "hints": 1,
}
TROUBLE = {"title": {"zh": "没有这个包", "en": "No such package"}, "line": "Package 'turtlsim' not found"}
SCREEN = {"columns": 40, "rows": 5, "ansi": "\x1b[32mstudent@day6\x1b[0m:~$ ros2 topic list\n/rosout\n"}


def row(name: str, **more: Any) -> dict[str, Any]:
    return {
        "name": name,
        "state": "here",
        "lesson": None,
        "trouble": None,
        "nodes": [],
        "hand": False,
        "idle": 0,
    } | more


class ClassPage:
    """The page and the server behind it."""

    def __init__(self, page: Page, server: PageServer) -> None:
        self.page = page
        self.server = server

    def show(self, *rows: dict[str, Any]) -> None:
        """Send rows, and wait until they are on the page."""
        self.server.say({"t": "rows", "rows": list(rows)})
        self.page.wait_for(f"document.querySelectorAll('.pupil').length === {len(rows)}")

    def names(self) -> list[str]:
        found: list[str] = self.page.evaluate("[...document.querySelectorAll('.pupil .name')].map(e => e.textContent)")
        return found

    def text(self, selector: str) -> str:
        return str(self.page.evaluate(f"document.querySelector({selector!r}).innerText"))

    def orders(self, name: str) -> list[dict[str, Any]]:
        """What was ordered of one name."""
        return [message["order"] for message in self.server.of_kind("order") if message["name"] == name]


@pytest.fixture(scope="module")
def tab(chromium: Chromium, background: Background) -> Iterator[tuple[Page, PageServer]]:
    from page_server import PageServer

    page, server = chromium.page(), PageServer(background)
    server.hello = {"t": "hello", "lang": "en", "lessons": [{"name": "day1", "title": LESSON["title"]}]}
    page.device(1280, 800)
    yield page, server
    page.close()
    server.close()


@pytest.fixture
def classroom(tab: tuple[Page, PageServer]) -> ClassPage:
    page, server = tab
    server.forget()
    page.navigate(f"{server.address}/class")
    page.wait_for("Boolean(window.classPage) && classPage._connection.isOpen")
    page.evaluate("window.confirm = () => true")
    return ClassPage(page, server)


def test_the_teacher_sees_what_each_pupil_does(classroom: ClassPage) -> None:
    classroom.show(row("安娜", lesson=LESSON, trouble=TROUBLE, nodes=["/turtlesim", "/teleop_turtle"], idle=300))
    text = classroom.text(".pupil")
    for part in (
        "安娜",
        "Day 1: terminal",
        "step 3/12 ✓",
        "hints used for this step: 1",
        "No such package",
        "/teleop_turtle",
        "5 min",
    ):
        assert part in text
    assert classroom.text("#here") == "1 of 1 here"


def test_who_raises_a_hand_comes_first(classroom: ClassPage) -> None:
    classroom.show(row("dora", state="gone"), row("anna"), row("ben"), row("carl", hand=True))
    assert classroom.names() == ["carl", "anna", "ben", "dora"]
    assert classroom.text("#hands") == "1 hands up"
    classroom.page.click_on(".pupil .hand")
    classroom.server.wait_for(lambda: classroom.orders("carl") == [{"do": "lower_hand"}])
    classroom.show(row("anna", hand=True), row("ben"), row("carl"), row("dora"))
    classroom.page.wait_for("document.querySelector('.pupil .name').textContent === 'anna'")


def test_nothing_a_pupil_sends_becomes_part_of_the_page(classroom: ClassPage) -> None:
    evil = "<img src=x onerror='window.hacked=1'>"
    lesson = LESSON | {"title": {"en": evil}, "step": "<b>", "all": None}
    classroom.show(
        row(
            evil,
            lesson=lesson,
            trouble={"title": evil, "line": evil + "\x1b]0;x\x07\u202e"},
            nodes=[evil, 5, None],
        ),
        row("nobody", lesson=[], trouble="x", nodes="abc", idle="long", screen={"columns": "x"}),
    )
    assert evil in classroom.names()
    assert classroom.page.evaluate("document.querySelectorAll('.pupil img').length") == 0
    assert not classroom.page.evaluate("Boolean(window.hacked)")
    assert "\u202e" not in classroom.text("#grid")


def test_a_watched_screen_is_drawn_and_cannot_answer(classroom: ClassPage) -> None:
    evil = SCREEN | {
        "ansi": SCREEN["ansi"] + "\x1b[c\x1b]52;c;eA==\x07\x1b[6n\x1b]8;;http://example.org\x07link\x1b]8;;\x07"
    }  # type: ignore[operator]
    classroom.page.evaluate("document.getElementById('screens').click()")
    classroom.show(row("anna", watched=True, screen=evil))
    shown = classroom.page.wait_for(
        "document.querySelector('.small-screen .xterm-rows')?.innerText.includes('/rosout') && 1"
    )
    assert shown == 1
    classroom.server.wait_for(lambda: {"do": "watch", "seconds": 10} in classroom.orders("anna"))
    assert {order["do"] for order in classroom.orders("anna")} == {"watch"}
    assert classroom.page.evaluate("document.querySelectorAll('.small-screen a').length") == 0
    scale = "(r => r.width <= document.querySelector('.small-screen').clientWidth + 1 && r.width > 100)"
    assert classroom.page.wait_for(
        f"{scale}(document.querySelector('.small-screen .xterm-screen').getBoundingClientRect())"
    )


def test_nobody_is_watched_before_the_teacher_looks(classroom: ClassPage) -> None:
    classroom.show(row("anna"), row("ben"))
    classroom.page.evaluate("classPage._watch()")
    classroom.page.click_on(".pupil .open")
    classroom.server.wait_for(lambda: classroom.orders("anna"))
    assert classroom.orders("anna") == [{"do": "watch", "seconds": 10}]
    assert classroom.orders("ben") == []
    classroom.page.press("Escape")
    classroom.server.wait_for(lambda: {"do": "unwatch"} in classroom.orders("anna"))


def test_something_is_said_to_all_and_to_one(classroom: ClassPage) -> None:
    classroom.show(row("anna"), row("ben"))
    classroom.page.click_on("#say-text")
    classroom.page.ask("Input.insertText", text="请看黑板")
    classroom.page.press("Enter")
    classroom.server.wait_for(lambda: classroom.orders("*") == [{"do": "say", "text": "请看黑板"}])
    classroom.page.click_on(".pupil .open")
    classroom.page.click_on(".pane form input")
    classroom.page.ask("Input.insertText", text="good")
    classroom.page.press("Enter")
    classroom.server.wait_for(lambda: {"do": "say", "text": "good"} in classroom.orders("anna"))


def test_scenes_lessons_and_freezing_are_for_all(classroom: ClassPage) -> None:
    classroom.show(row("anna"))
    choose = (
        "(s => { s.value = [...s.options].find(o => o.textContent === TEXT).value; s.dispatchEvent(new Event('change')) })"
        "(document.getElementById('start'))"
    )
    classroom.page.evaluate(choose.replace("TEXT", "'Turtle'"))
    classroom.page.evaluate(choose.replace("TEXT", repr(LESSON["title"]["en"])))  # type: ignore[index]
    classroom.page.click_on("#freeze")
    classroom.page.click_on("#unfreeze")
    expected = [
        {"do": "scene", "text": "turtle"},
        {"do": "lesson", "text": "day1"},
        {"do": "freeze", "on": True},
        {"do": "freeze", "on": False},
    ]
    classroom.server.wait_for(lambda: classroom.orders("*") == expected)


def test_the_teacher_types_only_with_consent(classroom: ClassPage) -> None:
    classroom.show(row("anna", screen=SCREEN))
    classroom.page.click_on(".pupil .open")
    classroom.page.click_on(".pane .ask")
    classroom.server.wait_for(lambda: {"do": "ask_to_type"} in classroom.orders("anna"))
    classroom.page.click_on(".pane .mirror .xterm-screen")
    classroom.page.press("a")
    classroom.show(row("anna", screen=SCREEN, may_type=True))
    classroom.page.wait_for("document.querySelector('.pane .hint').textContent.startsWith('You may type')")
    classroom.page.press("b")
    classroom.server.wait_for(lambda: {"do": "type", "text": "b"} in classroom.orders("anna"))
    assert {"do": "type", "text": "a"} not in classroom.orders("anna")


def test_two_pupils_are_compared(classroom: ClassPage) -> None:
    classroom.show(row("anna", screen=SCREEN), row("ben", screen=SCREEN))
    classroom.page.click_on(".pupil .open")
    classroom.page.evaluate(
        "(s => { s.value = 'ben'; s.dispatchEvent(new Event('change')) })(document.querySelector('.pane .beside'))"
    )
    classroom.page.wait_for("document.querySelectorAll('.pane .xterm-screen').length === 2")
    classroom.server.wait_for(lambda: classroom.orders("ben") == [{"do": "watch", "seconds": 10}])


def test_the_report_is_a_table_that_no_spreadsheet_takes_for_formulas(classroom: ClassPage) -> None:
    classroom.show(row('=HYPERLINK("x")', lesson=LESSON), row("安娜"))
    table = classroom.page.evaluate(
        "import('./static/rows.js').then(m => m.report(classPage._rows, classPage._texts))"
    ).splitlines()
    assert table[0].startswith('\ufeff"name","state","lesson"')
    assert any(line.startswith('"\'=HYPERLINK(""x"")","here","Day 1') for line in table)
    assert any(line.startswith('"安娜"') for line in table)


def test_thirty_pupils_fit_and_nothing_fails(classroom: ClassPage) -> None:
    classroom.show(*(row(f"pupil {number}", lesson=LESSON, nodes=["/turtlesim"]) for number in range(30)))
    assert classroom.names()[:3] == ["pupil 0", "pupil 1", "pupil 2"]
    assert classroom.page.evaluate("document.documentElement.scrollWidth") <= 1280
    assert classroom.page.troubles == []


def test_both_languages_have_every_text_of_the_class(classroom: ClassPage) -> None:
    keys = classroom.page.evaluate(
        "import('./static/class_texts.js').then(m => [Object.keys(m.CLASS_TEXTS.zh), Object.keys(m.CLASS_TEXTS.en)])"
    )
    assert sorted(keys[0]) == sorted(keys[1])
