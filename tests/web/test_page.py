"""The page of a desktop, in a real browser: what a pupil does with it."""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from tests.web.chromium import Page
    from tests.web.page_server import PageServer

pytestmark = pytest.mark.browser

WIDE_AND_NARROW = (
    "海龟",
    "🐢",
    "▀▄█░",
    "┌─┐",
    "👩\u200d💻",
    "⚠️",
    "❤️",
    "🇨🇳",
    "👍🏽",
    "é",
    "e\u0301",
    "，。",
    "…",
    "→",
    "①",
    "⠿",
    "한글",
)
MOUSE_ON = "\x1b[?1000h\x1b[?1003h\x1b[?1006h"


class Desk:
    """The page and the server behind it."""

    def __init__(self, page: Page, server: PageServer) -> None:
        self.page = page
        self.server = server
        self.is_fresh = False
        """Whether the page is loaded, and nobody changed anything that stays."""
        self._drawn = 0

    def open(self, *, renderer: str = "auto", **hello: Any) -> Desk:
        """Load the page and wait until it is connected; one that is as asked for and undamaged is only emptied."""
        wanted = {"t": "hello", "name": "anna", "read_only": False, "lang": "en"} | hello
        if self.is_fresh and self.server.hello == wanted and self.page.evaluate("desk._connection.isOpen"):
            self.page.evaluate("desk._terminal.reset(); desk._terminal.focus()")
            self.server.forget()
            return self
        self.server.hello = wanted
        self.server.forget()
        self.server.connections.clear()
        self.page.navigate(f"{self.server.address}/desk?renderer={renderer}")
        self.page.wait_for("Boolean(window.desk) && desk._connection.isOpen")
        self.page.evaluate("desk._terminal.onTitleChange(title => { window.drawn = title })")
        self.is_fresh = True
        return self

    def part(self, why: str) -> None:
        """Say goodbye and hang up; what is cut off at once may take the last word with it."""
        self.server.say({"t": "bye", "why": why})
        self.page.wait_for(f"desk._connection._bye === {why!r}")
        self.server.hang_up()

    def device(self, width: int, height: int, *, mobile: bool = False) -> None:
        """Take another device for this test."""
        self.is_fresh = False
        self.page.device(width, height, mobile=mobile)

    def shows(self, text: str) -> None:
        """Send output, and wait until it was drawn."""
        self._drawn += 1
        self.server.output(f"{text}\x1b]2;drawn {self._drawn}\x07")
        self.page.wait_for(f"window.drawn === 'drawn {self._drawn}'")

    def line(self, number: int) -> str:
        return str(self.page.evaluate(f"desk._terminal.buffer.active.getLine({number}).translateToString(true)"))

    def cell(self, column: int, row: int) -> tuple[float, float]:
        """The middle of a cell, in pixels of the page."""
        x, y, w, h = self.page.evaluate(
            "(r => [r.x, r.y, r.width, r.height])(document.querySelector('.xterm-screen').getBoundingClientRect())"
        )
        cols, rows = self.page.evaluate("[desk._terminal.cols, desk._terminal.rows]")
        return x + w * (column + 0.5) / cols, y + h * (row + 0.5) / rows

    def strip(self) -> str:
        return str(self.page.evaluate("document.getElementById('strip').dataset.state || ''"))


@pytest.fixture(scope="module")
def whole_desk(scripted_tab: tuple[Page, PageServer]) -> Desk:
    """One tab and one server for all tests of this file."""
    return Desk(*scripted_tab)


@pytest.fixture
def desk(whole_desk: Desk) -> Desk:
    if not whole_desk.is_fresh:
        whole_desk.page.device(1000, 600)
    return whole_desk


@pytest.fixture
def loaded_anew(whole_desk: Desk) -> Iterator[None]:
    whole_desk.is_fresh = False
    whole_desk.page.troubles.clear()
    yield
    whole_desk.is_fresh = False
    whole_desk.server.farewell, whole_desk.server.refuses, whole_desk.server.is_mute = None, False, False
    whole_desk.page.evaluate("localStorage.clear()")


anew = pytest.mark.usefixtures("loaded_anew")
"""For tests that need a page of their own, or leave one that nobody else can use."""


@pytest.mark.parametrize("renderer", ["dom", "webgl"])
@anew
def test_chinese_characters_fill_their_two_cells(desk: Desk, renderer: str) -> None:
    """None is set wide apart, as the glyphs of a font would be whose square is narrower than two Latin letters."""
    desk.open(renderer=renderer)
    assert desk.page.evaluate("desk._screen.renderer") == renderer
    if not desk.page.evaluate(
        '[...document.fonts].some((face) => face.family.includes("Chinese") && face.status == "loaded")'
    ):
        pytest.skip("the system has none of the Chinese fonts that the page names")
    gap = """(() => {
      const { fontFamily, fontSize } = desk._terminal.options;
      const context = document.createElement("canvas").getContext("2d");
      context.font = `${fontSize}px ${fontFamily}`;
      const { w, cols } = desk._screen.size();
      return Math.abs(context.measureText("海").width - 2 * w / cols) / (w / cols);
    })()"""
    for size in (12, 13, 15, 20):
        desk.page.evaluate(f"desk._screen.fontSize = {size}")
        desk.page.wait_for(f"{gap} < 0.05")
    desk.shows("海龟在动 Turtle")
    assert desk.line(0).startswith("海龟在动 Turtle")


@anew
def test_until_the_desktop_has_drawn_the_page_says_that_it_starts_and_how_many_are_before(desk: Desk) -> None:
    starting = "(p => p.checkVisibility() ? p.textContent : '')(document.getElementById('starting'))"
    desk.page.ask("Network.enable")
    desk.page.ask("Network.setBlockedURLs", urls=["*/desk.js"])
    desk.page.navigate(f"{desk.server.address}/desk")
    desk.page.wait_for("document.readyState === 'complete'")
    assert desk.page.evaluate(starting) == "桌面正在打开… / The desktop is opening…"
    desk.page.ask("Network.setBlockedURLs", urls=[])
    desk.page.troubles.clear()
    for lang, opening, soon, now, watched in (
        (
            "en",
            "The desktop is opening…",
            "Your desktop will start soon… 3 before you.",
            "Your desktop is starting…",
            "This",
        ),
        ("zh", "桌面正在打开…", "你的桌面马上启动…前面还有 3 个。", "你的桌面正在启动…", "这个"),
    ):
        desk.open(lang=lang)
        desk.is_fresh = False
        desk.page.wait_for(f"{starting} === {opening!r}")
        assert desk.page.evaluate("document.getElementById('starting').getAttribute('role')") == "status"
        for before, text in ((3, soon), (0, now)):
            desk.server.say({"t": "starting", "before": before})
            desk.page.wait_for(f"{starting} === {text!r}")
        desk.page.press("a")
        desk.server.wait_for_keys(b"a")
        desk.shows("\x1b[?1049h\x1b[?25l\x1b[2J")
        assert desk.page.evaluate(starting) == now  # that was no picture
        desk.shows("$ ")
        assert desk.page.evaluate(starting) == ""
        desk.server.hang_up()
        desk.page.wait_for("desk._connection.isOpen && desk._connection._attempts === 0 || !desk._connection.isOpen")
        assert desk.page.evaluate(starting) == ""
        desk.open(lang=lang, read_only=True)
        desk.server.say({"t": "starting", "before": 2})
        desk.page.wait_for(f"{starting}.startsWith({watched!r})")
        desk.part("full")
        desk.page.wait_for(f"document.getElementById('strip').dataset.state === 'full' && {starting} === ''")
        desk.is_fresh = False


def test_the_first_key_reaches_the_desktop_without_a_click(desk: Desk) -> None:
    desk.open()
    desk.page.press("a")
    desk.server.wait_for_keys(b"a")


def test_keys_that_browsers_know_reach_the_desktop(desk: Desk) -> None:
    desk.open()
    desk.page.evaluate("window.same = true")
    keys = {
        (("F1",), b"\x1bOP"),
        (("F3",), b"\x1bOR"),
        (("F5",), b"\x1b[15~"),
        (("F6",), b"\x1b[17~"),
        (("F10",), b"\x1b[21~"),
        (("f", "ctrl"), b"\x06"),
        (("p", "ctrl"), b"\x10"),
        (("s", "ctrl"), b"\x13"),
        (("c", "ctrl"), b"\x03"),
        (("f", "ctrl", "shift"), b"\x1b[102;6u"),
        (("ArrowLeft", "alt"), b"\x1b[1;3D"),
        (("\\", "alt"), b"\x1b\\"),
        (("-", "alt"), b"\x1b-"),
        (("1", "alt"), b"\x1b1"),
        (("F3", "shift"), b"\x1b[1;2R"),
        (("Tab",), b"\t"),
        (("Escape",), b"\x1b"),
    }
    for (key, *held), sent in keys:
        desk.server.forget()
        desk.page.press(key, *held)
        desk.server.wait_for_keys(sent)
    assert desk.page.evaluate("window.same && document.activeElement === desk._terminal.textarea")


def test_a_key_reaches_the_desktop_when_a_button_has_the_focus(desk: Desk) -> None:
    desk.open()
    desk.page.evaluate("document.getElementById('help').focus(); window.same = true")
    desk.page.press("F5")
    desk.page.press("x")
    desk.server.wait_for_keys(b"x")
    assert desk.page.evaluate("window.same")


def test_chinese_is_typed_with_an_input_method(desk: Desk) -> None:
    desk.open()
    desk.page.compose("n", "ni", "nihao", result="你好")
    desk.server.wait_for_keys("你好".encode())
    # What would come twice comes by a timer of the terminal, set before this one.
    desk.page.evaluate("new Promise(done => setTimeout(done))")
    desk.page.press("x")
    desk.server.wait_for_keys(b"x")
    assert desk.server.keys == "你好x".encode()


def test_what_is_pasted_is_marked_and_cannot_press_keys(desk: Desk) -> None:
    desk.open()
    desk.shows("\x1b[?2004h")
    desk.page.evaluate(
        "(d => { d.setData('text/plain', 'ls\\n\\x1b[201~\\x03rm 文件'); desk._terminal.textarea.dispatchEvent("
        "new ClipboardEvent('paste', {clipboardData: d, bubbles: true, cancelable: true})) })(new DataTransfer())"
    )
    desk.server.wait_for_keys(b"\x1b[201~")
    assert desk.server.keys == "\x1b[200~ls\r[201~rm 文件\x1b[201~".encode()


@anew
def test_ctrl_v_pastes(desk: Desk) -> None:
    desk.open()
    desk.shows("\x1b[?2004h")
    desk.page.allow_clipboard()
    desk.page.evaluate("navigator.clipboard.writeText('ros2 node list')")
    desk.page.press("v", "ctrl", command="paste")
    desk.server.wait_for_keys(b"\x1b[200~ros2 node list\x1b[201~")
    assert b"\x16" not in desk.server.keys


@anew
def test_where_the_clipboard_cannot_be_read_a_field_takes_what_is_pasted(desk: Desk) -> None:
    desk.open()
    desk.page.evaluate("navigator.clipboard.readText = async () => { throw new Error('not allowed') }")
    desk.page.click_on("#paste")
    desk.page.wait_for("document.getElementById('paste-dialog').open")
    desk.page.ask("Input.insertText", text="ls 文件")
    desk.page.click_on("#paste-dialog button[value=send]")
    desk.server.wait_for_keys("ls 文件".encode())
    desk.page.press("x")
    desk.server.wait_for_keys(b"x")


@anew
def test_copying_works_without_https(desk: Desk) -> None:
    desk.open()
    desk.page.evaluate("navigator.clipboard.writeText = async () => { throw new Error('not allowed') }")
    desk.page.allow_clipboard()
    desk.shows("\x1b[2J\x1b[Hros2 topic list")
    desk.page.evaluate("desk._terminal.select(0, 0, 15)")
    desk.page.press("c", "ctrl", "shift")
    assert desk.page.wait_for("navigator.clipboard.readText()") == "ros2 topic list"


def test_clicks_and_the_wheel_reach_the_desktop(desk: Desk) -> None:
    desk.open()
    desk.shows(MOUSE_ON)
    desk.page.click(*desk.cell(10, 4))
    desk.server.wait_for_keys(b"\x1b[<0;11;5M")
    desk.server.wait_for_keys(b"\x1b[<0;11;5m")
    desk.page.mouse("mouseWheel", *desk.cell(10, 4), "none", deltaX=0, deltaY=120)
    desk.server.wait_for_keys(b"\x1b[<65;11;5M")


@anew
def test_text_is_selected_with_shift_and_copied(desk: Desk) -> None:
    desk.open()
    desk.shows(MOUSE_ON + "\x1b[2J\x1b[Hros2 话题 list")
    desk.server.forget()
    desk.page.evaluate("addEventListener('copy', e => { window.copied = e.clipboardData.getData('text/plain') })")
    desk.page.evaluate("navigator.clipboard.writeText = async text => { window.copied = text }")
    x, y = desk.cell(0, 0)
    desk.page.mouse("mousePressed", x - 3, y, "left", "shift")
    desk.page.mouse("mouseMoved", *desk.cell(9, 0), "left", "shift")
    desk.page.mouse("mouseReleased", *desk.cell(9, 0), "left", "shift")
    desk.page.press("c", "ctrl", "shift")
    assert str(desk.page.wait_for("window.copied")).startswith("ros2 话题")
    assert b"\x03" not in desk.server.keys


@anew
def test_a_program_may_fill_the_clipboard_but_not_read_it(desk: Desk) -> None:
    desk.open()
    desk.page.evaluate("navigator.clipboard.writeText = async text => { window.copied = text }")
    desk.page.evaluate("navigator.clipboard.readText = async () => { window.read = true; return 'secret' }")
    desk.shows(f"\x1b]52;c;{base64.b64encode('/海龟'.encode()).decode()}\x07")
    assert desk.page.wait_for("window.copied") == "/海龟"
    desk.shows("\x1b]52;c;?\x07")
    assert not desk.page.evaluate("Boolean(window.read)")
    assert base64.b64encode(b"secret") not in desk.server.keys


@anew
def test_the_copy_button_copies_what_the_desktop_has_marked(desk: Desk) -> None:
    desk.open()
    desk.page.evaluate("window.copied = []; navigator.clipboard.writeText = async text => { copied.push(text) }")
    desk.page.click_on("#copy")
    hint = "Nothing to copy yet. Drag over the text with the mouse and let go to copy it."
    desk.page.wait_for(f"document.getElementById('notice').textContent === {hint!r}")
    desk.shows(f"\x1b]52;c;{base64.b64encode(b'/turtle1/pose').decode()}\x07")
    desk.page.wait_for("document.getElementById('notice').textContent === 'Copied'")
    desk.page.click_on("#copy")
    desk.page.wait_for("copied.length === 2")
    assert desk.page.evaluate("copied") == ["/turtle1/pose"] * 2


@anew
def test_a_browser_that_copies_only_after_a_click_gets_one(desk: Desk) -> None:
    desk.open()
    desk.page.evaluate(
        "navigator.clipboard.writeText = async () => { throw new Error('not allowed') };"
        "document.execCommand = () => false"
    )
    desk.shows(f"\x1b]52;c;{base64.b64encode(b'/rosout').decode()}\x07")
    hint = "This browser only copies after a click: press the copy button."
    desk.page.wait_for(f"document.getElementById('notice').textContent === {hint!r}")
    desk.page.evaluate("navigator.clipboard.writeText = async text => { window.copied = text }")
    desk.page.click_on("#copy")
    assert desk.page.wait_for("window.copied") == "/rosout"


@anew
@pytest.mark.parametrize("width", [1280, 1000, 800, 390])
def test_what_the_page_says_is_read_whole(desk: Desk, width: int) -> None:
    desk.device(width, 844)
    desk.open(lang="en")
    before = desk.page.evaluate("document.getElementById('screen').getBoundingClientRect().toJSON()")
    desk.page.evaluate("document.getElementById('copy').click()")
    box = desk.page.wait_for(
        "(e => e.textContent && e.scrollWidth <= e.clientWidth && e.getBoundingClientRect().toJSON())"
        "(document.getElementById('notice'))"
    )
    assert box["left"] >= 0 and box["right"] <= width and box["height"] > 15
    assert desk.page.evaluate("document.getElementById('screen').getBoundingClientRect().toJSON()") == before


@anew
def test_the_desktop_is_told_the_size_and_follows_the_window(desk: Desk) -> None:
    desk.open()
    first = desk.server.connections[0]
    assert int(first["cols"]) == desk.page.evaluate("desk._terminal.cols")
    assert int(first["w"]) > 900
    desk.page.device(700, 400)
    desk.server.wait_for(lambda: desk.server.of_kind("size") and desk.server.of_kind("size")[-1]["w"] < 700)
    assert desk.server.of_kind("size")[-1]["cols"] < int(first["cols"])


@anew
def test_larger_letters_mean_fewer_cells_and_are_remembered(desk: Desk) -> None:
    desk.open()
    before = desk.page.evaluate("desk._terminal.cols")
    for _ in range(4):
        desk.page.click_on("#larger")
    desk.server.wait_for(lambda: any(size["cols"] < before * 0.85 for size in desk.server.of_kind("size")))
    after = desk.page.evaluate("desk._terminal.cols")
    desk.open()
    assert desk.page.evaluate("desk._terminal.cols") == after


@anew
def test_the_size_the_server_allows_is_taken(desk: Desk) -> None:
    desk.open()
    desk.server.say({"t": "size", "cols": 60, "rows": 20})
    assert desk.page.wait_for("desk._terminal.cols === 60 && desk._terminal.rows === 20")


@anew
def test_an_answer_that_comes_late_does_not_undo_the_next_size(desk: Desk) -> None:
    desk.open()
    desk.page.evaluate("desk._screen.resize(80, 24); desk._screen.resize(90, 30)")

    def asked() -> list[tuple[int, int]]:
        return [(size["cols"], size["rows"]) for size in desk.server.of_kind("size")]

    desk.server.wait_for(lambda: asked()[-2:] == [(80, 24), (90, 30)])
    sizes, count = desk.server.of_kind("size")[-2:], len(asked())
    for size in sizes:
        desk.server.say(size)
    desk.shows("")
    assert desk.page.evaluate("[desk._terminal.cols, desk._terminal.rows]") == [90, 30]
    assert len(asked()) == count


@anew
def test_a_watcher_sees_a_large_screen_whole(desk: Desk) -> None:
    desk.open(read_only=True)
    desk.server.say({"t": "size", "cols": 200, "rows": 60})
    desk.page.wait_for("desk._terminal.cols === 200")
    assert desk.page.wait_for(
        "(r => r.width <= 1000.5 && r.height <= 572.5 && (r.width > 990 || r.height > 560))"
        "(document.querySelector('.xterm-screen').getBoundingClientRect())"
    )


@anew
def test_what_was_drawn_is_acknowledged(desk: Desk) -> None:
    desk.open()
    for _ in range(5):
        desk.server.output(b"x" * 40_000)
    desk.server.wait_for(lambda: any(ack["bytes"] == 200_000 for ack in desk.server.of_kind("ack")))


def test_pictures_of_real_pixels_are_drawn(desk: Desk) -> None:
    desk.open()
    desk.shows("\x1b[c\x1b[16t\x1b[14t")
    desk.server.wait_for_keys(b"\x1b[?62;4;9;22c")
    desk.server.wait_for_keys(b"\x1b[4;")
    desk.shows('\x1b[2;2H\x1bP0;1;0q"1;1;40;40#1;2;100;0;0' + "-".join(["#1!40~"] * 6) + "\x1b\\")
    pixel = (
        "(c => c && [...c.getContext('2d').getImageData(c.width * 0.03, c.height * 0.06, 1, 1).data])"
        "(document.querySelector('.xterm-image-layer'))"
    )
    assert desk.page.wait_for(pixel) == [255, 0, 0, 255]


def test_block_characters_meet_without_gaps(desk: Desk) -> None:
    desk.open()
    desk.shows("\x1b[2J\x1b[?25l\x1b[31m" + "".join(f"\x1b[{row};1H{'█' * 20}" for row in range(1, 6)))
    (left, top), (right, bottom) = desk.cell(0, 0), desk.cell(19, 4)
    clip = {"x": left, "y": top, "width": right - left, "height": bottom - top, "scale": 1}
    desk.page.wait_for("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))")
    colours = _colours(desk.page.ask("Page.captureScreenshot", format="png", clip=clip)["data"])
    assert len(colours) == 1, colours


def _colours(png: str) -> set[tuple[int, ...]]:
    from io import BytesIO

    from PIL import Image

    picture = Image.open(BytesIO(base64.b64decode(png))).convert("RGB")
    found = picture.getcolors(256 * 256) or []
    return {colour for _, colour in found}  # type: ignore[misc]


@anew
def test_a_watcher_sends_nothing_and_is_told_so(desk: Desk) -> None:
    desk.open(read_only=True)
    desk.page.press("a")
    desk.shows(MOUSE_ON + "\x1b[c")
    desk.page.click(*desk.cell(3, 3))
    assert desk.page.evaluate("document.getElementById('watching').getBoundingClientRect().width > 20")
    desk.server.wait_for(lambda: desk.server.of_kind("ping"))
    assert desk.server.keys == b""


@anew
def test_the_page_speaks_the_language_of_the_desktop(desk: Desk) -> None:
    desk.open(lang="zh")
    assert desk.page.evaluate("document.documentElement.lang") == "zh-CN"
    assert desk.page.evaluate("document.getElementById('larger').title") == "字大一点"


def test_both_languages_have_every_text(desk: Desk) -> None:
    desk.open()
    keys = json.loads(desk.page.evaluate("import('./static/texts.js').then(m => JSON.stringify(m.KEYS))"))
    assert sorted(keys["zh"]) == sorted(keys["en"])


def test_latency_is_measured_and_shown(desk: Desk) -> None:
    desk.open()
    assert desk.page.wait_for("/^[0-9]+ ms$/.test(document.getElementById('latency').textContent)")


@anew
def test_a_lost_connection_comes_back_and_begins_with_an_empty_screen(desk: Desk) -> None:
    desk.open()
    desk.shows("old text")
    desk.server.hang_up()
    desk.server.wait_for(lambda: len(desk.server.connections) == 2)
    desk.page.wait_for("desk._connection.isOpen")
    assert desk.line(0) == ""
    desk.page.press("b")
    desk.server.wait_for_keys(b"b")


@pytest.mark.parametrize("why", ["server", "restart"])
@anew
def test_a_server_that_is_away_or_restarts_the_desktop_is_told_and_tried_again(desk: Desk, why: str) -> None:
    desk.open()
    desk.server.farewell = why
    desk.server.hang_up()
    desk.page.wait_for(f"document.getElementById('strip').dataset.state === {why!r}")
    assert "restarting" in desk.page.evaluate("document.getElementById('strip').innerText") or why == "server"
    tried = len(desk.server.connections)
    desk.server.farewell = None
    desk.page.evaluate("dispatchEvent(new Event('online'))")
    desk.page.wait_for("desk._connection.isOpen")
    assert len(desk.server.connections) == tried + 1
    assert desk.page.evaluate("document.getElementById('strip').hidden")


@anew
def test_a_network_that_takes_connections_and_answers_nothing_is_tried_until_it_does(desk: Desk) -> None:
    desk.open()
    desk.server.is_mute = True
    desk.server.hang_up()
    for attempt in (1, 2):
        desk.page.wait_for(f"desk._connection._attempts === {attempt} && Boolean(desk._connection._socket)")
        desk.page.evaluate("desk._connection._begun = -1e6")  # as if it had waited for the answer long enough
    desk.page.wait_for("desk._connection._attempts === 3")
    desk.server.is_mute = False
    desk.page.evaluate("desk._connection._begun = -1e6")
    desk.page.wait_for("desk._connection.isOpen")


@anew
def test_another_tab_that_took_the_desktop_is_not_fought_with(desk: Desk) -> None:
    desk.open()
    desk.part("taken")
    desk.page.wait_for("document.getElementById('strip').dataset.state === 'taken'")
    desk.page.evaluate("dispatchEvent(new Event('online'))")
    assert len(desk.server.connections) == 1
    desk.page.click_on("#strip button")
    desk.page.wait_for("desk._connection.isOpen")
    assert len(desk.server.connections) == 2


@anew
@pytest.mark.parametrize(
    ("read_only", "words"),
    [
        (False, "You have left your desktop. It keeps running, and so do its programs."),
        (True, "This pupil has left the desktop. It keeps running."),
    ],
)
def test_a_desktop_that_was_left_is_said_to_go_on(desk: Desk, read_only: bool, words: str) -> None:
    desk.open(read_only=read_only)
    desk.part("left")
    desk.page.wait_for("!document.getElementById('strip').hidden")
    assert desk.page.evaluate("document.querySelector('#strip span').textContent") == words
    assert desk.page.evaluate("document.querySelector('#strip button').textContent") == "Open again"
    desk.page.click_on("#strip button")
    desk.page.wait_for("desk._connection.isOpen")


@anew
@pytest.mark.parametrize("why", ["ended", "idle", "disk"])
def test_an_ended_desktop_is_told_and_waits_for_the_user(desk: Desk, why: str) -> None:
    desk.open()
    desk.part(why)
    desk.page.wait_for(f"document.getElementById('strip').dataset.state === '{why}'")
    assert desk.page.evaluate("document.querySelector('#strip button').textContent") == "Open again"


@anew
def test_a_link_that_is_no_longer_valid_is_told(desk: Desk) -> None:
    desk.open()
    desk.server.refuses = True
    desk.server.hang_up()
    desk.page.wait_for("document.getElementById('strip').dataset.state === 'refused'")


def test_retries_wait_longer_and_never_over_five_seconds(desk: Desk) -> None:
    desk.open()
    delays = desk.page.evaluate(
        "import('./static/connection.js').then(m => [1,2,3,4,5,6,30,2000].map(n => m.retryDelay(n, 1)))"
    )
    assert delays == [250, 500, 1000, 2000, 4000, 5000, 5000, 5000]


@anew
def test_a_phone_has_the_keys_it_lacks(desk: Desk) -> None:
    desk.device(390, 844, mobile=True)
    desk.open()
    assert desk.page.evaluate("document.documentElement.scrollWidth") <= 390
    assert desk.page.evaluate("desk._terminal.cols") >= 50
    buttons = desk.page.evaluate(
        "[...document.querySelectorAll('header button')].filter(e => e.checkVisibility())"
        ".map(e => [e.id, e.getBoundingClientRect().left, e.getBoundingClientRect().right])"
    )
    assert "copy" in [name for name, *_ in buttons]
    assert all(left >= 40 and right <= 390 for _, left, right in buttons)
    desk.page.evaluate("[...document.querySelectorAll('#keys button')].find(b => b.textContent === 'Ctrl').click()")
    desk.page.ask("Input.insertText", text="c")
    desk.server.wait_for_keys(b"\x03")
    desk.page.ask("Input.insertText", text="d")
    desk.server.wait_for_keys(b"\x03d")
    desk.shows("\x1b[?1h")
    desk.page.evaluate("[...document.querySelectorAll('#keys button')].find(b => b.textContent === '↑').click()")
    desk.server.wait_for_keys(b"\x1bOA")


@anew
def test_a_finger_scrolls(desk: Desk) -> None:
    desk.device(390, 844, mobile=True)
    desk.open()
    desk.shows(MOUSE_ON)
    desk.page.swipe((200, 500), (200, 300))
    desk.server.wait_for(lambda: desk.server.keys.count(b"\x1b[<65;") >= 8)
    assert b"\x1b[<64;" not in desk.server.keys


@anew
@pytest.mark.parametrize("renderer", ["auto", "dom"])
def test_a_finger_that_rested_selects_as_the_mouse_does(desk: Desk, renderer: str) -> None:
    desk.device(390, 844, mobile=True)
    desk.open(renderer=renderer)
    desk.shows(MOUSE_ON + "\x1b[2J\x1b[Hros2 topic list")
    start, end = desk.cell(0, 0), desk.cell(9, 0)
    desk.page.ask("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": start[0], "y": start[1]}])
    desk.server.wait_for_keys(b"\x1b[<0;1;1M")
    desk.shows("\x1b[H\x1b[7mros2\x1b[m topic list")  # drawn anew under the finger
    desk.page.ask("Input.dispatchTouchEvent", type="touchMove", touchPoints=[{"x": end[0], "y": end[1]}])
    desk.page.ask("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
    desk.server.wait_for_keys(b"\x1b[<32;10;1M\x1b[<0;10;1m")
    assert b"\x1b[<6" not in desk.server.keys and desk.server.keys.count(b"\x1b[<0;") == 2


@anew
def test_nothing_is_asked_of_any_other_machine_and_nothing_fails(desk: Desk) -> None:
    desk.open()
    desk.shows("海龟 ▀▄█ 🐢")
    desk.page.wait_for("document.getElementById('latency').textContent")
    home = desk.server.address.split("//")[1]
    assert [
        address for address in desk.page.requests if home not in address and not address.startswith(("data:", "blob:"))
    ] == []
    assert len(desk.page.requests) > 10
    assert desk.page.troubles == []


@pytest.mark.parametrize("text", WIDE_AND_NARROW)
def test_characters_are_as_wide_as_the_desktop_thinks(widths: dict[str, int], text: str) -> None:
    from day6_tui.panes.cells import cell_len

    assert widths[text] == cell_len(text)


@pytest.fixture(scope="module")
def widths(whole_desk: Desk) -> dict[str, int]:
    """The cells each text took on the page."""
    whole_desk.open()
    measure = (
        "t => new Promise(r => desk._terminal.write('\\r\\x1b[2K' + t, () => r(desk._terminal.buffer.active.cursorX)))"
    )
    return {text: whole_desk.page.evaluate(f"({measure})({json.dumps(text)})") for text in WIDE_AND_NARROW}
