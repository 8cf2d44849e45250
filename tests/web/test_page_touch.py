"""The page of a desktop under fingers, on what pupils bring along: phones, tablets, Chromebooks; and installed there."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest

from tests.web.test_page import MOUSE_ON, Desk

if TYPE_CHECKING:
    from tests.web.chromium import Page
    from tests.web.page_server import PageServer

pytestmark = pytest.mark.browser

DEVICES = {"phone": (360, 740), "tablet": (768, 1024), "tablet on its side": (1024, 768), "Chromebook": (1366, 768)}
SEEN_KEYS = (
    "[...document.querySelectorAll('#keys button')].filter(e => e.getBoundingClientRect().right <= innerWidth)"
    ".map(e => e.textContent)"
)
ROW = "[...document.querySelectorAll('#keys button')].map(e => e.textContent)"
SPOKEN = "[...document.querySelectorAll('#spoken p')].map(e => e.textContent)"


@pytest.fixture(scope="module")
def tab(scripted_tab: tuple[Page, PageServer]) -> Desk:
    return Desk(*scripted_tab)


@pytest.fixture
def desk(tab: Desk) -> Iterator[Desk]:
    tab.is_fresh = False
    tab.page.troubles.clear()
    yield tab
    tab.page.evaluate("localStorage.clear()")


def key(label: str) -> str:
    return f"[...document.querySelectorAll('#keys button')].find(b => b.textContent === {label!r}).click()"


def touch(desk: Desk, kind: str, *places: tuple[float, float]) -> None:
    points = [{"x": x, "y": y, "id": number} for number, (x, y) in enumerate(places)]
    desk.page.ask("Input.dispatchTouchEvent", type=f"touch{kind}", touchPoints=points)


@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize("device", DEVICES)
def test_everything_is_within_reach_on_each_device(desk: Desk, device: str, lang: str) -> None:
    width, height = DEVICES[device]
    desk.device(width, height, mobile=True)
    desk.open(lang=lang)
    assert desk.page.evaluate("[document.documentElement.scrollWidth, document.body.offsetHeight]") == [width, height]
    tools = desk.page.evaluate(
        "[...document.querySelectorAll('header button')].filter(e => e.checkVisibility())"
        ".map(e => e.getBoundingClientRect()).map(r => [r.left, r.right, r.height])"
    )
    assert len(tools) >= 7 and all(left >= 0 and right <= width and high >= 36 for left, right, high in tools)
    assert {"Esc", "Tab", "Ctrl", "Enter", "F5", "^C", "←", "↑", "↓", "→"} <= set(desk.page.evaluate(SEEN_KEYS))
    screen = desk.page.evaluate("document.getElementById('screen').getBoundingClientRect().toJSON()")
    assert screen["height"] > 0.75 * height and desk.page.evaluate("desk._terminal.cols") >= 55


def test_enter_and_f5_are_on_the_row_of_a_phone(desk: Desk) -> None:
    desk.device(*DEVICES["phone"], mobile=True)
    desk.open()
    for label, sent in (("F5", b"\x1b[15~"), ("Enter", b"\r"), ("Alt", b""), ("Enter", b"\x1b\r")):
        desk.server.forget()
        desk.page.evaluate(key(label))
        desk.server.wait_for_keys(sent)


def test_the_row_keeps_to_one_line_beside_a_soft_keyboard(desk: Desk) -> None:
    desk.device(360, 400, mobile=True)
    desk.open()
    assert desk.page.evaluate("document.getElementById('keys').offsetHeight") < 60


def test_the_keys_of_the_row_and_their_order_are_chosen_and_stay(desk: Desk) -> None:
    desk.device(*DEVICES["phone"], mobile=True)
    desk.open()
    page, usual = desk.page, desk.page.evaluate(ROW)
    page.evaluate("document.getElementById('choose-keys').click()")
    page.wait_for("document.getElementById('choose-dialog').open")
    for selector in (
        "#choose-dialog .chosen [data-key=tab]",
        "#choose-dialog .others [data-key='|']",  # after it
        "#choose-dialog [data-do=earlier]",
        "#choose-dialog .chosen [data-key=esc]",
        "#choose-dialog [data-do=remove]",
        "#choose-dialog .chosen [data-key=ctrl]",
        "#choose-dialog [data-do=later]",
    ):
        page.click_on(selector)
    inside = page.evaluate(
        "[...document.querySelectorAll('#choose-dialog button')].every(e => e.getBoundingClientRect().right <= innerWidth)"
    )
    page.click_on("#choose-dialog button[value=close]")
    wanted = ["|", "Tab", "F5", "Ctrl", *usual[4:]]
    assert inside and page.evaluate(ROW) == wanted
    page.evaluate(key("|"))
    desk.server.wait_for_keys(b"|")
    desk.is_fresh = False
    desk.open()
    assert page.evaluate(ROW) == wanted
    page.evaluate("document.getElementById('choose-keys').click()")
    page.click_on("#choose-dialog [data-do=reset]")
    page.click_on("#choose-dialog button[value=close]")
    assert page.evaluate(ROW) == usual
    assert page.evaluate("localStorage.getItem('day6.row')") is None


def test_what_the_browser_remembers_of_the_row_is_judged(desk: Desk) -> None:
    desk.page.navigate(f"{desk.server.address}/desk")
    kept = [None, "", "nothing known", "esc esc tab __proto__ f5", "\x00 f13 constructor"]
    call = f"import('./static/key_row.js').then(m => [m.USUAL, ...{json.dumps(kept)}.map(m.chosenKeys)])"
    usual, *found = desk.page.evaluate(call)
    assert found == [usual, usual, usual, ["esc", "tab", "f5"], usual]


def test_two_fingers_scroll(desk: Desk) -> None:
    desk.device(*DEVICES["tablet"], mobile=True)
    desk.open()
    desk.shows(MOUSE_ON)
    size = desk.page.evaluate("desk._screen.fontSize")
    touch(desk, "Start", (300, 600), (400, 600))
    for y in range(580, 380, -20):
        touch(desk, "Move", (300, y), (400, y))
    touch(desk, "End")
    desk.server.wait_for(lambda: desk.server.keys.count(b"\x1b[<65;") >= 8)
    assert b"\x1b[<64;" not in desk.server.keys and b"\x1b[<0;" not in desk.server.keys
    assert desk.page.evaluate("desk._screen.fontSize") == size


@pytest.mark.parametrize(("ends", "grows"), [(360, True), (40, False)])
def test_a_pinch_changes_the_size_of_letters_which_stays(desk: Desk, ends: int, grows: bool) -> None:
    desk.device(*DEVICES["Chromebook"], mobile=True)
    desk.open()
    desk.shows(MOUSE_ON)
    before = desk.page.evaluate("desk._screen.fontSize")
    touch(desk, "Start", (600, 300), (800, 300))
    for step in range(1, 9):
        half = 100 + (ends / 2 - 100) * step / 8
        touch(desk, "Move", (700 - half, 300), (700 + half, 300))
    touch(desk, "End")
    after = desk.page.wait_for(f"desk._screen.fontSize !== {before} && desk._screen.fontSize")
    assert (after > before) == grows
    desk.shows("")
    assert desk.server.keys == b""
    desk.is_fresh = False
    desk.open()
    assert desk.page.evaluate("desk._screen.fontSize") == after
    desk.server.wait_for(lambda: int(desk.server.connections[-1]["cols"]) == desk.page.evaluate("desk._terminal.cols"))


def test_a_finger_that_rests_on_a_word_marks_it(desk: Desk) -> None:
    desk.device(*DEVICES["phone"], mobile=True)
    desk.open()
    desk.shows(MOUSE_ON + "\x1b[2J\x1b[Hlook at /turtle1/cmd_vel (twist)")
    touch(desk, "Start", desk.cell(12, 0))
    desk.server.wait_for_keys(b"\x1b[<0;13;1M")
    touch(desk, "End")
    desk.server.wait_for_keys(b"\x1b[<0;13;1m\x1b[<0;9;1M\x1b[<32;24;1M\x1b[<0;24;1m")
    desk.server.forget()
    touch(desk, "Start", desk.cell(25, 0))  # the bracket
    desk.server.wait_for_keys(b"\x1b[<0;26;1M")
    touch(desk, "End")
    desk.server.wait_for_keys(b"\x1b[<0;26;1m")
    desk.shows("")
    assert desk.server.keys.count(b"\x1b[<0;") == 2


def test_nothing_needs_https_or_this_machine(desk: Desk) -> None:
    """Where a browser has none of what it keeps for pages that come safely."""
    desk.device(*DEVICES["tablet"], mobile=True)
    away = "['clipboard', 'keyboard', 'wakeLock', 'serviceWorker', 'credentials', 'storage', 'locks']"
    script = f"for (const each of {away}) Object.defineProperty(Navigator.prototype, each, {{ value: undefined }});"
    added = desk.page.ask("Page.addScriptToEvaluateOnNewDocument", source=script)
    try:
        desk.open()
        desk.page.allow_clipboard()
        desk.shows("\x1b[2J\x1b[Hros2 topic list")
        desk.page.evaluate("desk._terminal.select(0, 0, 15)")
        desk.page.click_on("#copy")
        desk.page.wait_for("document.getElementById('notice').textContent === 'Copied'")
        desk.page.click_on("#paste")
        desk.page.wait_for("document.getElementById('paste-dialog').open")
        desk.page.click_on("#paste-dialog button[value=close]")
        desk.page.click_on("#full")
        desk.page.wait_for("Boolean(document.fullscreenElement)")
        desk.page.click_on("#full")
        desk.page.wait_for("!document.fullscreenElement")
        assert desk.page.troubles == []
    finally:
        desk.page.ask("Page.removeScriptToEvaluateOnNewDocument", identifier=added["identifier"])


@pytest.mark.parametrize("page", ["desk", "class"])
def test_a_browser_may_install_the_page(desk: Desk, page: str) -> None:
    desk.page.navigate(f"{desk.server.address}/{page}")
    found = desk.page.ask("Page.getAppManifest")
    assert found["errors"] == [] and json.loads(found["data"])["start_url"] == page
    assert desk.page.ask("Page.getInstallabilityErrors")["installabilityErrors"] in (
        [],
        [{"errorId": "in-incognito", "errorArguments": []}],  # as every tab of a test is
    )


# -- what is heard -----------------------------------------------------------------------------------------------------


def pane(column: int, width: int, title: str, *lines: str, heavy: bool) -> str:
    """A pane of the desktop as it is drawn: with a heavy frame it has the keyboard."""
    top, side, foot = ("┏━┓", "┃", "┗━┛") if heavy else ("╭─╮", "│", "╰─╯")
    rows = [f"{top[0]} {title} ".ljust(width - 1, top[1]) + top[2]]
    rows += [side + line.ljust(width - 2) + side for line in (*lines, *[""] * (3 - len(lines)))]
    rows.append(foot[0] + foot[1] * (width - 2) + foot[2])
    return "".join(f"\x1b[{number};{column}H{row}" for number, row in enumerate(rows, 1))


LESSON = "\x1b[2J" + pane(1, 26, "1 ~", "$ ros2 run", heavy=False) + pane(27, 14, "2 Lesson", "Type ls", heavy=True)
TERMINAL = (
    pane(1, 26, "1 ~", "student:~$", heavy=True) + pane(27, 14, "2 Lesson", "Type ls", heavy=False) + "\x1b[2;13H"
)


def hears(desk: Desk, *lines: str) -> None:
    desk.page.wait_for(
        f"JSON.stringify({SPOKEN}) === {json.dumps(json.dumps(list(lines), ensure_ascii=False, separators=(',', ':')))}"
    )


def test_a_screen_reader_hears_the_new_lines_of_the_pane_with_the_keyboard_and_only_if_wanted(desk: Desk) -> None:
    desk.device(1000, 600)
    desk.open()
    desk.shows(LESSON)
    assert desk.page.evaluate("document.getElementById('spoken').getAttribute('aria-live')") == "polite"
    assert desk.page.evaluate(SPOKEN) == []
    desk.page.click_on("#help")
    desk.page.click_on("#speak")
    hears(desk, "2 Lesson", "Type ls")
    desk.page.click_on("#help-dialog button")
    desk.page.evaluate("document.getElementById('spoken').replaceChildren()")
    desk.shows(TERMINAL)  # F3: another pane; the line with the cursor is being typed
    hears(desk, "1 ~")
    desk.shows("ls\x1b[3;2H海龟 ros2_ws\x1b[4;2Hstudent:~$ \x1b[3;30Hmoving\x1b[4;13H")
    hears(desk, "1 ~", "student:~$ ls", "海龟 ros2_ws")
    desk.shows("\x1b[1;5Hsleep 9 \x1b[2;2H海龟 ros2_ws \x1b[3;2Hstudent:~$ sl 9 \x1b[4;2H9           \x1b[4;3H")
    hears(desk, "1 ~", "student:~$ ls", "海龟 ros2_ws", "student:~$ sl 9")
    desk.is_fresh = False
    desk.open()
    desk.shows(TERMINAL)
    desk.page.wait_for(f"({SPOKEN}).includes('1 ~')")  # the browser remembers
    desk.page.evaluate("document.getElementById('speak').click()")
    assert desk.page.evaluate(SPOKEN) == []


MOVED = [
    (["a", "b"], ["a", "b", "c"], ["c"]),
    (["a", "b", "c"], ["b", "c", "d", "e"], ["d", "e"]),
    (["hello", "hello"], ["hello", "hello", "hello"], ["hello"]),
    (["x", "", "y"], ["x", "", "z"], ["z"]),
    ([], ["a", "", "b"], ["a", "b"]),
    (["a"], [], []),
]


def test_what_is_new_is_told_from_what_moved_up(desk: Desk) -> None:
    desk.page.navigate(f"{desk.server.address}/desk")
    pairs = json.dumps([[before, now] for before, now, _ in MOVED])
    call = f"import('./static/speak.js').then(m => {pairs}.map(pair => m.newLines(...pair)))"
    assert desk.page.evaluate(call) == [new for *_, new in MOVED]
