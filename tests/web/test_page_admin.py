"""The teacher's page in a real browser: desktops that are restarted or reset, and what they take of the machine."""

from __future__ import annotations

import json
from typing import Any

import pytest

from tests.web.test_page_class import ClassPage, classroom, row, tab  # noqa: F401
from tests.web.test_page_tools import EVIL, choose

pytestmark = pytest.mark.browser

MB = 1 << 20
MACHINE = {
    "warnings": ["disk: 300 MB left (most of it is taken by ben: 250 MB)"],
    "memory": {"total": 4000 * MB, "free": 900 * MB},
    "disk": 300 * MB,
    "cores": 2.0,
    "room": "Room for 14 desktops: it has 2 cores",
    "measured": True,
    "most": {"memory": 1024 * MB, "disk": 512 * MB},
    "desktops": [
        {"name": "anna", "teacher": False, "memory": 60 * MB, "cpu": 0.004, "processes": 3, "disk": MB},
        {"name": "ben", "teacher": False, "memory": 310 * MB, "cpu": 0.871, "processes": 12, "disk": 250 * MB},
        {"name": "@teacher", "teacher": True, "memory": 65 * MB, "cpu": None, "processes": 3, "disk": None},
        {"name": EVIL, "teacher": False, "disk": 2 * MB},
    ],
}


def ask(classroom: ClassPage, menu: str, **order: str) -> str:  # noqa: F811
    """Choose an entry of a menu; what the teacher was asked before."""
    value = json.dumps(order, separators=(",", ":"))
    classroom.page.evaluate("window.asked = ''; window.confirm = (text) => { window.asked = text; return true; }")
    classroom.page.evaluate(
        f"(s => {{ s.value = {value!r}; s.dispatchEvent(new Event('change')); }})(document.querySelector({menu!r}))"
    )
    return str(classroom.page.evaluate("window.asked"))


def done(number: int, do: str, **more: Any) -> dict[str, Any]:
    return {"id": number, "do": do, "lesson": "", "name": "", "all": 1, "count": 1, "kept": "", "failed": []} | more


def test_the_page_asks_first_and_names_who_it_is_for_and_says_what_came_of_it(
    classroom: ClassPage,  # noqa: F811
) -> None:
    page, server = classroom.page, classroom.server
    pupils = [row("anna"), row("ben"), row(EVIL), row("dora", state="absent")]
    classroom.show(*pupils, desks=[done(1, "restart", name="anna")])
    assert classroom.text("#notice") == ""  # of another time
    home = "[...document.querySelector('#desks').options].find(o => o.value.includes('home')).disabled"
    assert page.evaluate(home)
    assert "Restart the desktop of the whole class (4)?" in ask(classroom, "#desks", do="restart")
    server.wait_for(lambda: server.of_kind("desk") == [{"t": "desk", "names": "*", "do": "restart"}])
    choose(page, "anna")
    choose(page, "ben")
    assert "Day 1" in (asked := ask(classroom, "#desks", do="lesson", lesson="day1")) and "anna, ben" in asked
    wanted = {"t": "desk", "names": ["anna", "ben"], "do": "lesson", "lesson": "day1"}
    server.wait_for(lambda: server.of_kind("desk")[-1] == wanted)
    choose(page, "ben")
    assert not page.evaluate(home)
    assert "Give anna an empty home?" in ask(classroom, "#desks", do="home")
    failed = [["ben", "No space left on device"], [EVIL, "<b>why</b>"]]
    classroom.show(*pupils, desks=[done(2, "restart", all=4, count=1)])
    classroom.becomes("#notice", "Working on it…")
    classroom.show(*pupils, desks=[done(2, "restart", all=4, count=2, failed=failed)])
    page.wait_for("document.querySelector('#notice').textContent.includes('restarted: 2 pupils')")
    assert "ben (No space left on device)" in classroom.text("#notice")
    assert page.evaluate("window.hit === undefined && !document.querySelector('#notice b')")
    classroom.show(*pupils, desks=[done(3, "home", name="anna", kept="before/anna-20261128-203344")])
    page.wait_for("document.querySelector('#notice').textContent.includes('before/anna-20261128-203344')")
    page.click_on(".pupil .open")
    assert "the desk of anna?" in ask(classroom, ".pane .desks", do="clear")
    server.wait_for(lambda: server.of_kind("desk")[-1] == {"t": "desk", "names": ["anna"], "do": "clear"})


def test_what_desktops_take_is_asked_for_while_it_is_looked_at_and_sorted(classroom: ClassPage) -> None:  # noqa: F811
    page, server = classroom.page, classroom.server
    pupils = [row("anna"), row("ben")]
    classroom.show(*pupils, machine={"warnings": MACHINE["warnings"]})
    assert "300 MB left" in classroom.text("#machine-warning") and not server.of_kind("measure")
    page.click_on("#machine-open")
    server.wait_for(lambda: server.of_kind("measure"))
    classroom.show(*pupils, machine=MACHINE)
    first = "[...document.querySelectorAll('#machine tbody tr')].map(e => e.firstChild.textContent)"
    page.wait_for(f"({first}).length === 4")
    assert page.evaluate(first)[:3] == ["ben", "My desktop", "anna"]
    cells = "[...document.querySelectorAll('#machine tbody tr')].map(e => [...e.children].map(c => c.textContent))"
    assert page.evaluate(cells)[0] == ["ben", "310 MB", "87.1 %", "12", "250 / 512 MB"]
    assert page.evaluate(cells)[1][2:] == ["–", "3", "–"] and page.evaluate(cells)[3][1:4] == ["–"] * 3
    page.click_on("#machine [data-by=name]")
    assert [name for name in page.evaluate(first) if name in ("anna", "ben")] == ["anna", "ben"]
    page.click_on("#machine [data-by=cpu]")
    assert page.evaluate(first)[:2] == ["ben", "anna"]
    assert (
        page.evaluate("document.querySelector('#machine [aria-sort=descending]').textContent.trim()")
        == "CPU (one core)"
    )
    assert page.evaluate("window.hit === undefined && !document.querySelector('#machine img')")
    assert "900 of 4000 MB free" in classroom.text("#machine .sum")
    choose_count = page.evaluate("classPage._chosen.names")
    page.press("Escape")
    page.wait_for("!document.querySelector('#machine').open")
    assert page.evaluate("classPage._chosen.names") == choose_count
    classroom.show(*pupils, machine={"warnings": []})
    assert page.evaluate("document.querySelector('#machine-warning').hidden")
