"""The dialog of assignments in a real browser, on a server that says what the test wants."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING, Any

import pytest

from tests.web.browser import scripted_page

if TYPE_CHECKING:
    from tests.web.background import Background
    from tests.web.chromium import Chromium, Page
    from tests.web.page_server import PageServer

pytestmark = pytest.mark.browser

HOSTILE = "<img src=x onerror=alert(1)>‮\x1b[2J"


def standing(name: str, state: str = "collected", **more: Any) -> dict[str, Any]:
    return {
        "name": name, "here": True, "state": state, "at": 0, "steps": 12, "solved": 3, "collected": 1.0, "late": False,
        "changed": False, "left_out": 0, "trouble": "", "points": None, "most": None, "unplayed": None, "weak": False,
        "refused": "", "mark": "", "line": "", "returned": 0, "news": False,
    } | more  # fmt: skip


class Dialog:
    """The page, its dialog, and the server behind it."""

    def __init__(self, page: Page, server: PageServer) -> None:
        self.page, self.server, self._version = page, server, 0

    def rows(self, *assignments: dict[str, Any]) -> None:
        self._version += 1
        common = {
            "kind": "lesson",
            "due": 0,
            "closed": False,
            "all": 8,
            "given": 8,
            "collected": 5,
            "working": "",
            "done": 0,
            "of": 0,
        }
        told = [{**common, "title": {"en": each["id"]}, **each} for each in assignments]
        self.server.say(
            {"t": "rows", "rows": [], "frozen": False, "assignments": {"version": self._version, "list": told}}
        )
        self.page.wait_for(f"classPage._assignments._version === {self._version}")

    def asked(self, do: str) -> list[dict[str, Any]]:
        return [each for each in self.server.of_kind("assign") if each["do"] == do]

    def show(self, id_: str, *rows: dict[str, Any]) -> None:
        self.server.wait_for(lambda: self.asked("show"))
        self.server.say({"t": "assign", "do": "show", "id": id_, "rows": list(rows)})
        self.page.wait_for(f"document.querySelectorAll('.assignments .rows tr').length === {len(rows)}")

    def text(self, selector: str) -> str:
        return str(self.page.evaluate(f"document.querySelector('.assignments {selector}').innerText"))


@pytest.fixture
def dialog(chromium: Chromium, background: Background) -> Iterator[Dialog]:
    lessons = [
        {"name": "day1", "title": {"en": "Day 1", "zh": "第 1 天"}, "drill": False},
        {"name": "topic_slip", "title": {"en": "A slip", "zh": "手误"}, "drill": True},
    ]
    with scripted_page(chromium, background) as (page, server):
        server.hello = {"t": "hello", "lang": "en", "lessons": lessons, "scenes": []}
        page.device(1280, 800)
        page.navigate(f"{server.address}/class")
        page.wait_for("Boolean(window.classPage) && classPage._connection.isOpen")
        yield Dialog(page, server)


def test_thirty_pupils_are_marked_by_the_keyboard(dialog: Dialog) -> None:
    dialog.rows({"id": "day1"})
    dialog.page.click_on("#assign")
    kinds = [
        standing("anna", "graded", points=2.2, most=3, late=True, news=True), standing("ben", "missing", collected=None),
        standing("陈" * 30, changed=True, left_out=3), standing(HOSTILE, trouble=HOSTILE), standing("eve", "working", at=4),
    ]  # fmt: skip
    rows = [*kinds, *(standing(f"pupil {number}", "returned", returned=2.0, mark="B") for number in range(25))]
    dialog.show("day1", *rows)
    assert "graded" in dialog.text(".rows tr:nth-child(1)") and "late" in dialog.text(".rows tr:nth-child(1)")
    assert "2.2/3" in dialog.text(".rows tr:nth-child(1)") and "missing" in dialog.text(".rows tr:nth-child(2)")
    assert "changed since" in dialog.text(".rows tr:nth-child(3)") and "3 files left out" in dialog.text(
        ".rows tr:nth-child(3)"
    )
    assert "step 4" in dialog.text(".rows tr:nth-child(5)")
    assert dialog.page.evaluate("document.querySelectorAll('.assignments img').length") == 0
    wide, seen = dialog.page.evaluate(
        "[document.querySelector('.assignments .table').scrollWidth, document.querySelector('.assignments .table').clientWidth]"
    )
    assert wide <= seen
    dialog.page.evaluate("document.querySelector('.assignments tr .mark').focus()")
    for key in "A-":
        dialog.page.press(key)
    dialog.show("day1", *rows)  # while somebody types, what comes overwrites nothing
    dialog.page.press("Tab")
    dialog.server.wait_for(lambda: dialog.asked("word"))
    assert dialog.asked("word")[0] | {"t": "", "line": ""} == {
        "t": "", "do": "word", "id": "day1", "name": "anna", "mark": "A-", "line": "",
    }  # fmt: skip
    dialog.page.device(390, 780)
    assert dialog.page.evaluate("document.documentElement.scrollWidth") <= 390
    seen = dialog.page.evaluate("document.querySelector('.assignments .mark').getBoundingClientRect().right")
    assert 0 < seen <= 390  # marks can be typed without scrolling aside
    dialog.page.press("Escape")
    dialog.page.wait_for("!document.querySelector('.assignments').open")


def test_it_is_handed_out_collected_graded_and_given_back(dialog: Dialog) -> None:
    page = dialog.page
    dialog.rows()
    page.click_on("#assign")
    page.press("Enter")  # the button for handing out has the keyboard
    page.wait_for("!document.querySelector('.assignments .hand-out').hidden")
    page.evaluate("document.querySelector('.hand-out .kind').value = 'drill'")
    page.evaluate("document.querySelector('.hand-out .kind').dispatchEvent(new Event('change'))")
    page.evaluate("document.querySelector('.hand-out .due').value = '2030-01-02T10:40'")
    page.click_on(".hand-out .give")
    (order,) = dialog.server.wait_for(lambda: dialog.asked("new"))
    assert order["kind"] == "drill" and order["names"] == ["topic_slip"] and order["to"] == "*" and order["due"] > 1.8e9
    dialog.server.say({"t": "assign", "do": "new", "wrong": "disk", "why": "No space left on device"})
    page.wait_for("document.querySelector('.assignments .notice').textContent.includes('No space left')")
    dialog.server.say({"t": "assign", "do": "new", "id": "slip"})
    dialog.rows({"id": "slip", "kind": "drill"})
    dialog.show("slip", standing("anna"))
    for what in ("collect", "grade", "return"):
        page.click_on(f".assignments .{what}")
        dialog.server.wait_for(partial(dialog.asked, what))
        assert dialog.asked(what)[0] | {"t": ""} == {"t": "", "do": what, "id": "slip", "names": "*"}
    dialog.rows({"id": "slip", "working": "grade", "done": 5, "of": 8})
    assert dialog.text(".progress") == "Graded 5 of 8…"
    assert page.evaluate("document.querySelector('.assignments .collect').disabled") is True
