"""A screen that is shown to the class, in a real browser: beside the pupil's own desktop, and on the teacher's page."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from tests.web.chromium import Page
    from tests.web.page_server import PageServer

pytestmark = pytest.mark.browser

DRAWN = "desk._shown._mirror._terminal.buffer.active.getLine({}).translateToString(true)"


@pytest.fixture
def desk(scripted_tab: tuple[Page, PageServer]) -> tuple[Page, PageServer]:
    return opened(*scripted_tab, 1280, 800)


def opened(page: Page, server: PageServer, width: int, height: int) -> tuple[Page, PageServer]:
    """A pupil's page on a device of this size, anew: one that is made smaller takes a while to settle."""
    server.hello = {"t": "hello", "name": "ben", "read_only": False, "lang": "en"}
    page.device(width, height)
    page.navigate(f"{server.address}/desk")
    page.wait_for("Boolean(window.desk) && desk._connection.isOpen")
    page.evaluate("localStorage.clear()")
    server.forget()
    return page, server


def shown_at(page: Page, layout: str) -> dict[str, float]:
    """Where the other screen is, once it is laid so."""
    page.wait_for(f"document.querySelector('#shown').dataset.layout === {layout!r}")
    found: dict[str, float] = page.evaluate("document.querySelector('#shown').getBoundingClientRect().toJSON()")
    return found


@pytest.mark.parametrize(("width", "height"), [(1280, 800), (360, 740)])
def test_another_screen_is_seen_in_each_layout_while_the_pupil_types_on(
    scripted_tab: tuple[Page, PageServer], width: int, height: int
) -> None:
    page, server = opened(*scripted_tab, width, height)
    columns = page.evaluate("desk._terminal.cols")
    server.say({"t": "show", "on": True, "name": "anna", "full": False})
    server.picture("\x1b[32mfirst\x1b[0m", "second")
    page.wait_for(f"{DRAWN.format(0)} === 'first'")
    server.wait_for(lambda: len(server.of_kind("ack")) == 1)
    assert page.evaluate("document.querySelector('#shown').innerText").startswith("anna's screen")
    beside = shown_at(page, "beside")
    own = page.evaluate("document.querySelector('#screen').getBoundingClientRect().toJSON()")
    assert (own["right"] <= beside["left"] + 1) if width > height else (own["top"] >= beside["bottom"] - 1)
    page.wait_for(f"desk._terminal.cols {'<' if width > height else '==='} {columns}")
    page.click(beside["x"] + beside["width"] / 2, beside["y"] + beside["height"] * 0.7)
    page.press("l")
    server.wait_for_keys(b"l")
    page.click_on("#shown .corner")
    corner = shown_at(page, "corner")
    assert corner["left"] >= 0 and corner["right"] <= width and corner["width"] < width * 0.6
    page.click_on("#shown .corner")  # and into the next one
    page.wait_for(f"document.querySelector('#shown').getBoundingClientRect().left < {corner['left']}")
    page.click_on("#shown .full")
    assert shown_at(page, "full")["width"] >= width - 1
    server.picture("third")
    page.wait_for(f"{DRAWN.format(0)} === 'third' && {DRAWN.format(1)} === 'second'")
    page.click_on("#shown .close")
    page.wait_for(f"desk._terminal.cols === {columns}")
    server.wait_for(lambda: not server.is_looked_at)
    page.press("s")
    server.wait_for_keys(b"ls")
    page.click_on("#shown-again")
    server.picture("fourth")
    page.wait_for(f"{DRAWN.format(0)} === 'fourth'")
    server.say({"t": "show", "on": True, "name": "anna", "full": True})
    shown_at(page, "full")
    server.say({"t": "show", "on": False})
    page.wait_for("document.querySelector('#shown').hidden && document.querySelector('#shown-again').hidden")
    server.wait_for(lambda: not server.is_looked_at)
    assert page.troubles == []


def test_keys_reach_the_buttons_of_the_other_screen_and_come_back(desk: tuple[Page, PageServer]) -> None:
    page, server = desk
    server.say({"t": "show", "on": True, "name": "", "full": True})
    shown_at(page, "full")
    page.press("k", "ctrl", "shift")
    for _ in range(20):
        if page.evaluate("document.activeElement.matches('#shown .corner')"):
            break
        page.press("Tab")
    page.press("Enter")
    shown_at(page, "corner")
    page.press("Escape")
    page.press("x")
    server.wait_for_keys(b"x")
    server.say({"t": "show", "on": False})


def test_what_a_hostile_screen_holds_is_text_at_most(desk: tuple[Page, PageServer]) -> None:
    page, server = desk
    page.evaluate("window.copied = []; document.execCommand = () => copied.push('command')")
    page.evaluate("navigator.clipboard.writeText = async (text) => { copied.push(text) }")
    server.say({"t": "show", "on": True, "name": "\u202e<img src=x onerror='copied.push(1)'>", "full": False})
    server.picture(
        "\x1b]52;c;cm0=\x07A\x1b]8;;http://evil/\x1b\\B\x1b]8;;\x1b\\",
        "\x1b[6n\x1b[c\x1b[?1003h\x1b]0;owned\x07\x1bP+q544e\x1b\\\x1b_Gi=1;AAAA\x1b\\C",
        "\x1bPq#0;2;100;0;0#0~~~\x1b\\\x1bc\x1b[2JD",
        "\x1b[41mred\x1b[0m",
    )
    page.wait_for(f"{DRAWN.format(3)} === 'red'")
    assert page.evaluate(DRAWN.format(0)).endswith("B]8;;\\") and page.evaluate(DRAWN.format(2)).endswith("D")
    assert page.evaluate("document.title") == "ben · day6" and page.evaluate("copied") == []
    assert page.evaluate("document.querySelectorAll('#shown img, #shown a, #shown canvas').length") == 0
    page.press("l")
    server.wait_for_keys(b"l")
    assert server.keys == b"l"  # and no answer to any question
    before = len(server.of_kind("ack"))
    server.picture("x" * 10**6, columns=10**9, rows=10**9)
    server.wait_for(lambda: len(server.of_kind("ack")) > before)
    assert page.evaluate("desk._shown._mirror._terminal.cols") == 500
    server.say({"t": "show", "on": False})


def test_the_teacher_shows_the_own_screen_or_a_pupils_and_sees_whose_it_is(
    scripted_tab: tuple[Page, PageServer],
) -> None:
    page, server = scripted_tab
    server.hello = {"t": "hello", "lang": "en", "lessons": [], "scenes": []}
    server.forget()
    page.device(1280, 800)
    page.navigate(f"{server.address}/class")
    page.wait_for("Boolean(window.classPage) && classPage._connection.isOpen")
    page.evaluate("window.opened = []; window.open = (address) => { opened.push(address) }")
    anna = {"name": "anna", "state": "here", "idle": 0}

    def told(on: dict[str, Any] | None = None, wanted: dict[str, Any] | None = None, *, mine: bool = False) -> None:
        show = {"on": on, "wanted": wanted, "mine": mine}
        server.say({"t": "rows", "rows": [anna], "frozen": False, "show": show})

    def becomes(selector: str, text: str) -> None:
        page.wait_for(f"document.querySelector({selector!r})?.textContent === {text!r}")

    def asked() -> list[dict[str, Any]]:
        return [{key: message[key] for key in message if key != "t"} for message in server.of_kind("show")]

    told()
    page.click_on("#show")
    page.wait_for("opened.length === 1")
    server.wait_for(lambda: asked() == [{"do": "start", "name": "", "names": "*", "full": False}])
    told(wanted={"name": "", "full": False, "count": None})
    becomes("#showing .what", "Your screen is shown as soon as your desktop is there.")
    told(on={"name": "", "full": False, "count": 2}, mine=True)
    becomes("#showing .what", "Your screen is shown to 2 pupils.")
    page.click_on("#showing .full")
    server.wait_for(lambda: asked()[-1] == {"do": "again", "full": True})
    page.click_on("#show")
    server.wait_for(lambda: len(asked()) == 3)
    assert page.evaluate("opened.length") == 1  # it is open
    page.click_on(".pupil .open")
    page.click_on(".pane .show")
    server.wait_for(lambda: asked()[-1] == {"do": "start", "name": "anna", "names": "*", "full": False})
    told(wanted={"name": "anna", "full": False, "count": None}, mine=True)
    becomes(".pane .hint", "Asked; anna hasn't answered yet")
    told(on={"name": "anna", "full": False, "count": None}, mine=True)
    becomes(".pane .show", "Stop showing")
    page.click_on(".pane .show")
    server.wait_for(lambda: asked()[-1] == {"do": "stop"})
    page.click_on(".pane .close")
    becomes("#showing .what", "anna's screen is shown to all.")
    page.click_on("#showing .stop")
    server.wait_for(lambda: [each["do"] for each in asked()].count("stop") == 2)
    told()
    page.wait_for("document.querySelector('#showing').hidden")
