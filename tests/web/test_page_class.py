"""The teacher's page in a real browser: what a teacher sees and orders, and what pupils cannot do to it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from tests.web.chromium import Page
    from tests.web.page_server import PageServer

pytestmark = pytest.mark.browser

DAYS = ("2026-03-03", "2026-03-02")
"""Of which there is a log."""
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


TALL_SCREEN = {"columns": 50, "rows": 80, "ansi": "phone\n" * 80}


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

    def show(self, *rows: dict[str, Any], frozen: bool = False, **more: Any) -> None:
        """Send rows, and wait until they are on the page."""
        self.page.evaluate("window.before = classPage._rows")
        self.server.say({"t": "rows", "rows": list(rows), "frozen": frozen, **more})
        self.page.wait_for("classPage._rows !== before")
        assert self.page.evaluate("document.querySelectorAll('.pupil').length") == len(rows)

    def answer(self, do: str, count: int, *missed: str) -> None:
        """What the server says to an order."""
        self.server.say({"t": "sent", "do": do, "count": count, "missed": list(missed)})

    def becomes(self, selector: str, text: str) -> None:
        """Wait until an element says this."""
        self.page.wait_for(f"document.querySelector({selector!r})?.textContent === {text!r}")

    def box(self, selector: str) -> dict[str, float]:
        """Where an element is, in pixels."""
        found: dict[str, float] = self.page.evaluate(
            f"document.querySelector({selector!r}).getBoundingClientRect().toJSON()"
        )
        return found

    def names(self) -> list[str]:
        found: list[str] = self.page.evaluate("[...document.querySelectorAll('.pupil .name')].map(e => e.textContent)")
        return found

    def text(self, selector: str) -> str:
        return str(self.page.evaluate(f"document.querySelector({selector!r}).innerText"))

    def orders(self, name: str) -> list[dict[str, Any]]:
        """What was ordered of one name."""
        return [message["order"] for message in self.server.of_kind("order") if name in message["names"]]


@pytest.fixture(scope="module")
def tab(scripted_tab: tuple[Page, PageServer]) -> tuple[Page, PageServer]:
    page, server = scripted_tab
    lesson, scene = (
        {"name": "day1", "title": LESSON["title"]},
        {"name": "turtle", "title": {"zh": "海龟", "en": "Turtle"}},
    )
    server.hello = {"t": "hello", "lang": "en", "lessons": [lesson], "scenes": [scene], "days": list(DAYS)}
    page.device(1280, 800)
    return page, server


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
    assert classroom.text("#hands") == "1 hand up"
    classroom.page.click_on(".pupil .hand")
    classroom.server.wait_for(lambda: classroom.orders("carl") == [{"do": "lower_hand"}])
    classroom.show(row("anna", hand=True), row("ben", hand=True), row("carl"), row("dora"))
    assert classroom.text("#hands") == "2 hands up"
    classroom.page.wait_for("document.querySelector('.pupil .name').textContent === 'anna'")


def test_who_never_came_and_who_found_no_room_are_told_last_and_counted(classroom: ClassPage) -> None:
    missing = {"name": "dora", "state": "absent", "idle": 0, "stuck": False, "listed": True}
    outside = {"name": "eva", "state": "full", "idle": 0, "stuck": False, "listed": True}
    ended = row("fay", state="gone", lesson=LESSON, nodes=["/turtlesim"], hand=True, idle=900, screen=SCREEN)
    classroom.page.evaluate("document.getElementById('screens').click()")
    classroom.show(missing, outside, ended, row("anna"), row("ben", state="away"))
    assert classroom.names() == ["anna", "ben", "eva", "fay", "dora"]
    assert classroom.text("#here") == "1 of 5 here · 1 tab closed · 1 found no room"
    texts = classroom.page.evaluate("[...document.querySelectorAll('.pupil')].map(e => e.innerText)")
    assert texts[2].split("\n") == ["eva", "no room: the class is full"]
    assert texts[4].split("\n") == ["dora", "not here yet"]
    assert "desktop ended" in texts[3] and "step 3/12" in texts[3]
    assert "/turtlesim" not in texts[3] and "hand up" not in texts[3] and "15 min" not in texts[3]
    assert classroom.page.evaluate("document.querySelectorAll('.small-screen .xterm').length") == 0


@pytest.mark.parametrize("name", ["Wolfeschlegelsteinhausen-Berger", "李雷"])
def test_on_the_narrowest_card_the_name_has_its_room_beside_everything(classroom: ClassPage, name: str) -> None:
    classroom.show(row(name, hand=True, watched=True, frozen=True, seen=True))
    classroom.page.evaluate("document.getElementById('grid').style.gridTemplateColumns = '230px'")
    card = classroom.box(".pupil")
    assert card["width"] == 230
    parts = [f".pupil .{each}" for each in ("name", "state", "hand", "watched", "seen", "frozen")]
    for part in parts:
        box = classroom.box(part)
        assert box["width"] > 10 and box["left"] >= card["left"] + 8 and box["right"] <= card["right"] - 8
        overflow = f"(e => e.scrollWidth > Math.ceil(e.clientWidth))(document.querySelector({part!r}))"
        assert not classroom.page.evaluate(overflow), part
    assert classroom.box(".pupil .name")["bottom"] <= classroom.box(".pupil .hand")["top"] + 1


def test_a_tall_screen_makes_no_tall_card(classroom: ClassPage) -> None:
    classroom.page.evaluate("document.getElementById('screens').click()")
    classroom.show(row("anna", screen=SCREEN), row("phone", screen=TALL_SCREEN))
    classroom.page.wait_for("document.querySelectorAll('.small-screen .xterm-screen').length === 2")
    boxes = (
        "[...document.querySelectorAll('.pupil')].map(e => ['.small-screen', '.xterm-screen'].map("
        "s => e.querySelector(s).getBoundingClientRect().toJSON()))"
    )
    classroom.page.wait_for(
        f"({boxes}).every(([out, within]) => within.height <= out.height + 1 && within.height > 50)"
    )
    for out, within in classroom.page.evaluate(boxes):
        assert out["width"] / out["height"] == pytest.approx(5 / 3, abs=0.02)
        assert within["left"] - out["left"] == pytest.approx(out["right"] - within["right"], abs=1)
        assert within["top"] - out["top"] == pytest.approx(out["bottom"] - within["bottom"], abs=1)


def test_small_screens_show_what_can_be_read_and_the_whole_one_at_a_look(classroom: ClassPage) -> None:
    page = classroom.page
    lines = [f"line {number}".ljust(139, ".") for number in range(44)]
    lines[20] = "." * 70 + "right here" + "." * 59
    screen = {"columns": 140, "rows": 44, "ansi": "\n".join(lines), "work": [70, 1, 70, 42, 20]}
    page.evaluate("document.getElementById('screens').click()")
    pupils = [row(f"pupil {number}", screen=screen) for number in range(8)]
    classroom.show(*pupils)
    page.wait_for("document.querySelectorAll('.small-screen .xterm-screen').length === 8")
    letter = "(e => e.getBoundingClientRect().width / 140)(document.querySelector('.small-screen .xterm-screen'))"
    page.wait_for(f"{letter} > 5")  # pixels
    at = page.evaluate(
        "(e => { const s = e.querySelector('.xterm-screen').getBoundingClientRect(), o = e.getBoundingClientRect();"
        "return [(o.left - s.left) * 140 / s.width, (o.top - s.top) * 44 / s.height, (o.bottom - s.top) * 44 / s.height] })"
        "(document.querySelector('.small-screen'))"
    )
    assert at[0] == pytest.approx(70, abs=0.5) and at[1] >= 0.9 and 21 <= at[2] <= 43, at
    assert page.evaluate("document.documentElement.scrollHeight <= innerHeight")  # all eight are seen
    box = classroom.box(".small-screen")
    page.mouse("mouseMoved", box["left"] + 20, box["top"] + 20, "none")
    page.wait_for("document.querySelector('#preview .xterm-rows')?.innerText.includes('line 43')")
    shown, whole = classroom.box("#preview"), classroom.box("#preview .xterm-screen")
    assert whole["width"] / 140 > 5 and whole["width"] <= shown["width"] + 1 and whole["height"] <= shown["height"] + 1
    assert 0 <= shown["left"] >= box["right"] and shown["right"] <= 1280 and 0 <= shown["top"] <= shown["bottom"] <= 800
    page.mouse("mouseMoved", 5, 5, "none")
    page.wait_for("document.getElementById('preview').hidden")
    page.click_on("#zoom")
    page.wait_for(f"{letter} < 3")
    page.evaluate("(e => { e.value = 900; e.dispatchEvent(new Event('input')) })(document.getElementById('size'))")
    page.wait_for("document.querySelector('.pupil').clientWidth >= 890")
    page.evaluate("localStorage.clear()")


def test_small_screens_are_as_large_as_all_of_them_fit_and_never_too_small(classroom: ClassPage) -> None:
    places = [(1, 1280, 700), (8, 1280, 700), (30, 1280, 700), (8, 1920, 980), (3, 390, 700)]
    found = classroom.page.evaluate(
        f"import('./static/sizes.js').then(m => {list(map(list, places))}.map(p => m.fitting(...p)))"
    )
    assert found == [1252, 305, 300, 465, 300]


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
        row("nowhere", screen=SCREEN | {"work": [evil, 1e99, {}, -3, None]}),
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


def test_a_line_with_chinese_punctuation_is_as_long_as_any_other(classroom: ClassPage) -> None:
    lines = "".join(
        f"{text}{' ' * (39 - 2 * len(text))}|\n" for text in ("左边，那个：（终端）。", "，，，。。。（（））", "")
    )
    classroom.show(row("anna", screen=SCREEN | {"ansi": lines}))
    classroom.page.click_on(".pupil .open")
    classroom.page.wait_for("document.querySelector('.pane .xterm-rows')?.innerText.includes('终端')")
    within = (
        "getBoundingClientRect().right - document.querySelector('.pane .xterm-screen').getBoundingClientRect().right"
    )
    ends = classroom.page.evaluate(
        f"[...document.querySelectorAll('.pane .xterm-rows > div')].slice(0, 3).map(e => e.lastChild.{within})"
    )
    assert ends == pytest.approx([0, 0, 0], abs=3)


def test_nobody_is_watched_before_the_teacher_looks(classroom: ClassPage) -> None:
    classroom.show(row("anna"), row("ben"))
    classroom.page.evaluate("classPage._watch()")
    classroom.page.click_on(".pupil .open")
    classroom.server.wait_for(lambda: classroom.orders("anna"))
    assert all(order == {"do": "watch", "seconds": 10} for order in classroom.orders("anna"))  # again every 4 s
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
    classroom.show(row("anna"), frozen=True)
    classroom.page.click_on("#freeze")
    expected = [
        {"do": "scene", "text": "turtle"},
        {"do": "lesson", "text": "day1"},
        {"do": "freeze", "on": True},
        {"do": "freeze", "on": False},
    ]
    classroom.server.wait_for(lambda: classroom.orders("*") == expected)


def test_the_tools_are_for_those_who_are_chosen(classroom: ClassPage) -> None:
    classroom.show(row("anna"), row("ben"), row("carl"), row("dora", state="gone"))
    for name in ("anna", "ben"):
        classroom.page.click_on(f".pupil[data-key={name}] .choose")
    classroom.becomes("#chosen > span", "2 chosen")
    assert classroom.text("#freeze") == "Freeze the chosen"
    classroom.page.click_on("#freeze")
    classroom.server.wait_for(lambda: classroom.orders("ben") == [{"do": "freeze", "on": True}])
    assert classroom.orders("anna") == classroom.orders("ben") and classroom.orders("carl") == []
    classroom.show(row("anna", frozen=True), row("ben", frozen=True), row("carl"))
    assert classroom.text("#freeze") == "Unfreeze the chosen"
    classroom.show(row("anna", state="gone"), row("ben"), row("carl"))  # who comes again is meant, too
    classroom.becomes("#chosen > span", "2 chosen, 1 of them not here")
    classroom.show(row("ben"), row("carl"))  # whoever was removed from the class is not
    classroom.becomes("#chosen > span", "1 chosen")
    classroom.page.click_on("#chosen button")
    assert classroom.text("#freeze") == "Freeze all"


def test_the_page_says_plainly_that_the_class_is_frozen_and_what_the_button_does(classroom: ClassPage) -> None:
    classroom.show(row("anna", frozen=True))
    assert (classroom.text("#frozen"), classroom.text("#freeze")) == ("", "Freeze all")
    classroom.show(frozen=True)
    assert (classroom.text("#frozen"), classroom.text("#freeze")) == ("The class is frozen", "Unfreeze all")
    classroom.show(row("anna"))
    assert (classroom.text("#frozen"), classroom.text("#freeze")) == ("", "Freeze all")


def test_the_server_says_whom_an_order_reached(classroom: ClassPage) -> None:
    classroom.show(row("anna"), row("ben"), row("carl"))
    assert classroom.page.evaluate("document.getElementById('notice').role") == "status"
    classroom.page.click_on("#freeze")
    assert classroom.text("#notice") == ""
    classroom.answer("freeze", 2, "ben")
    classroom.becomes("#notice", "Sent to 2. Not reached: ben.")
    classroom.page.click_on("#freeze")
    classroom.answer("freeze", 0)
    classroom.becomes("#notice", "Nobody is here, so nothing was sent.")
    place = classroom.box("#freeze")
    classroom.page.evaluate("document.getElementById('notice').textContent = ''")
    assert classroom.box("#freeze") == place


def test_what_was_sent_to_one_pupil_is_told_in_the_large_view(classroom: ClassPage) -> None:
    classroom.show(row("anna"))
    classroom.page.click_on(".pupil .open")
    for text in ("one", "two"):
        classroom.page.click_on(".pane form input")
        classroom.page.ask("Input.insertText", text=text)
        classroom.page.press("Enter")
    classroom.answer("say", 1)
    classroom.becomes(".pane .sent", "Sent to anna.")
    classroom.answer("say", 0, "anna")
    classroom.becomes(".pane .sent", "Not reached: anna.")
    assert classroom.page.evaluate("document.querySelector('.pane .sent').role") == "status"
    assert classroom.text("#notice") == ""


def test_what_cannot_be_sent_stays_in_its_field(classroom: ClassPage) -> None:
    classroom.show(row("anna"))
    classroom.page.click_on("#say-text")
    classroom.page.ask("Input.insertText", text="hello")
    classroom.page.evaluate("classPage._connection._greeted = false")
    classroom.page.press("Enter")
    classroom.becomes("#notice", "Not sent: no connection to the server.")
    assert classroom.page.evaluate("document.getElementById('say-text').value") == "hello"


def test_the_large_view_says_asked_only_while_the_desktop_says_so(classroom: ClassPage) -> None:
    classroom.show(row("anna", screen=SCREEN))
    classroom.page.click_on(".pupil .open")
    classroom.page.click_on(".pane .ask")
    classroom.becomes(".pane .hint", "…")
    classroom.show(row("anna", screen=SCREEN))
    classroom.becomes(".pane .hint", "")
    classroom.show(row("anna", screen=SCREEN, asked=True))
    classroom.becomes(".pane .hint", "Asked; anna hasn't answered yet")
    classroom.show(row("anna", screen=SCREEN, refused="the pupil said no"))
    classroom.becomes(".pane .hint", "the pupil said no")
    classroom.show(row("anna", screen=SCREEN))
    classroom.becomes(".pane .hint", "")


@pytest.mark.parametrize(
    ("state", "words"),
    [
        ("gone", "The desktop of anna has ended, so there is no screen. The files are kept."),
        ("absent", "anna isn't here yet, so there is no screen."),
    ],
)
def test_of_who_is_not_there_the_large_view_has_no_picture_and_nothing_to_press(
    classroom: ClassPage, state: str, words: str
) -> None:
    classroom.show(row("anna", screen=SCREEN), row("ben"))
    classroom.page.click_on(".pupil .open")
    drawn = "document.querySelector('.pane .xterm-rows').innerText.includes('/rosout')"
    classroom.page.wait_for(drawn)
    classroom.show(row("anna", state=state, screen=SCREEN), row("ben"))
    classroom.becomes(".pane .nobody", words)
    classroom.page.wait_for(f"!{drawn} && document.querySelector('.pane .mirror').hidden")
    usable = "[...document.querySelectorAll('.pane :is(button, input, select):not(:disabled)')].map(e => e.className)"
    assert classroom.page.evaluate(usable) == ["close", "beside", "desks", "remove"]  # files are there
    classroom.server.forget()
    classroom.page.evaluate("classPage._watch(); classPage._connection._pulse()")
    classroom.server.wait_for(lambda: classroom.server.of_kind("ping"))
    assert classroom.orders("anna") == []  # which would have come before the ping
    classroom.show(row("anna", screen=SCREEN), row("ben"))
    classroom.page.wait_for(drawn)
    assert classroom.page.evaluate(f"({usable}).length") == 12


@pytest.mark.parametrize("width", [1280, 1024, 800, 390])
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_close_is_always_at_the_top_right_and_nothing_is_cut(classroom: ClassPage, width: int, lang: str) -> None:
    page = classroom.page
    page.device(width, 800)
    page.evaluate(f"classPage._hello({{lang: {lang!r}}})")
    classroom.show(row("Wolfeschlegelsteinhausen-Berger"), row("ben"))
    page.click_on(".pupil .open")
    close, end = classroom.box(".pane .close"), classroom.box(".pane .end")
    assert close["right"] == pytest.approx(width - 10, abs=1) and close["top"] == pytest.approx(10, abs=1)
    assert end["top"] >= close["bottom"]
    cut = (
        "[...document.querySelectorAll('.pane button, .pane select')].filter(e => e.checkVisibility()"
        " && (e.scrollWidth > e.clientWidth + 1 || e.getBoundingClientRect().right > innerWidth)).map(e => e.className)"
    )
    assert page.evaluate(cut) == []
    others = page.evaluate(
        "[...document.querySelectorAll('.pane-tools > :not(.end, .remove)')].map(e => e.getBoundingClientRect().toJSON())"
    )
    for other in others:
        assert other["bottom"] <= end["top"] or other["right"] <= end["left"] - 40
    page.device(1280, 800)


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
    classroom.server.wait_for(lambda: {"do": "watch", "seconds": 10} in classroom.orders("ben"))


def test_the_report_and_the_logs_are_there_to_be_saved_and_the_links_leave_the_class_open(classroom: ClassPage) -> None:
    report, log, mine, links = classroom.page.evaluate(
        "[...document.querySelectorAll('header a')].map(e => [e.getAttribute('href'), e.download, e.target, e.rel])"
    )
    assert log[0] == "class/log.csv" and log[1] == ""
    assert report[:2] == ["class/report.csv", ""]
    assert classroom.page.evaluate("document.querySelectorAll('#report[download], #log[download]').length") == 2
    assert mine == ["mine", "", "day6-mine", ""]  # the tab that is open, if one is
    assert links == ["links", "", "_blank", "noopener"]
    classroom.page.evaluate(
        "HTMLAnchorElement.prototype.click = function () { window.saved = this.getAttribute('href') }"
    )
    classroom.page.wait_for("!document.querySelector('#log-days').hidden")
    days = "document.querySelector('#log-days')"
    assert classroom.page.evaluate(f"[...{days}.options].map(each => each.text)") == ["Earlier logs…", *DAYS]
    classroom.page.evaluate(f"({days}.value = '{DAYS[1]}', {days}.dispatchEvent(new Event('change')))")
    assert classroom.page.evaluate("window.saved") == f"class/log.csv?day={DAYS[1]}"


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


def newcomer(number: int, name: str, address: str = "192.168.1.5", why: str = "many", **more: Any) -> dict[str, Any]:
    return {"id": number, "name": name, "address": address, "source": address, "why": why} | more


WAITING = [newcomer(1, "安娜"), newcomer(2, "ben"), newcomer(3, "<b>eve</b>", "2001:db8::7", "removed")]


def wait(classroom: ClassPage, *waiting: dict[str, Any], asks: bool = False, news: tuple[str, ...] = ()) -> None:
    classroom.server.say({"t": "rows", "rows": [row("dora", address="192.168.1.9")], "frozen": False, "asks": asks,
                          "lobby": list(waiting), "news": list(news)})  # fmt: skip
    classroom.page.wait_for(f"document.querySelectorAll('#lobby li').length === {len(waiting)}")


def test_who_waits_is_shown_by_address_and_let_in_or_turned_away(classroom: ClassPage) -> None:
    page = classroom.page
    wait(classroom, *WAITING)
    assert page.evaluate("[...document.querySelectorAll('.place .from')].map(e => e.textContent)") == [
        "1 from 2001:db8::7",
        "2 from 192.168.1.5",
    ]
    assert classroom.text(".place li .why") == "somebody from this address was removed or turned away"
    assert page.evaluate("document.querySelectorAll('#lobby b').length") == 0
    assert classroom.text("#hands") == "3 waiting to be let in" and page.evaluate("document.title").startswith(
        "3 waiting"
    )
    for selector in (".place + .place .all", ".place + .place .none", ".place li:nth-child(2) .in", ".place .away"):
        page.click_on(selector)
    expected = [
        {"t": "door", "do": "admit", "ids": [1, 2], "trust": True},
        {"t": "door", "do": "turn_away", "ids": [1, 2]},
        {"t": "door", "do": "admit", "ids": [2], "trust": False},
        {"t": "door", "do": "turn_away", "ids": [3]},
    ]
    classroom.server.wait_for(lambda: classroom.server.of_kind("door") == expected)
    wait(classroom)
    assert page.evaluate("document.getElementById('lobby').hidden") and classroom.text("#hands") == ""


def test_who_says_to_be_a_pupil_that_there_is_is_let_in_alone_and_the_teacher_sees_what_that_one_was(
    classroom: ClassPage,
) -> None:
    known = [
        newcomer(4, "gil", why="known"),
        newcomer(5, "Ida", why="listed", was="10.0.0.9"),
        newcomer(6, "<i>Jo</i>", why="known", was="10.0.0.8", here=True),
    ]
    wait(classroom, newcomer(1, "ben"), *known)
    assert classroom.page.evaluate("[...document.querySelectorAll('.place li .why')].map(e => e.textContent)")[1:] == [
        "gil has been here before, in another browser: is it really gil?",
        "Ida was here before, from 10.0.0.9: is it really Ida?",
        "<i>Jo</i> is here right now, from 10.0.0.8: is it really <i>Jo</i>?",
    ]
    classroom.page.click_on(".place .all")
    classroom.page.click_on(".place li:nth-child(2) .in")
    expected = [{"ids": [1], "trust": True}, {"ids": [4], "trust": False}]
    classroom.server.wait_for(
        lambda: classroom.server.of_kind("door") == [{"t": "door", "do": "admit"} | each for each in expected]
    )
    wait(classroom, *known)
    assert not classroom.page.evaluate("document.querySelector('.place .all').checkVisibility()")


def test_the_teacher_chooses_to_be_asked_sees_where_from_removes_and_hears_the_news(classroom: ClassPage) -> None:
    page = classroom.page
    assert page.evaluate("document.getElementById('asking').hidden")  # without a word nobody comes unasked
    page.evaluate("classPage._hello({lang: 'en', word: true})")
    wait(classroom, news=("10.0.0.7: the name <i>x</i> was refused",))
    classroom.becomes("#notice", "10.0.0.7: the name <i>x</i> was refused")
    assert classroom.text(".pupil .address") == "from 192.168.1.9"
    page.click_on("#ask")
    page.click_on(".pupil .open")
    page.click_on(".pane .remove")
    expected = [{"t": "door", "do": "ask", "on": True}, {"t": "door", "do": "remove", "name": "dora"}]
    classroom.server.wait_for(lambda: classroom.server.of_kind("door") == expected)
    classroom.show(row("fay", state="gone"), row("gus", state="absent", listed=True))
    page.wait_for("document.getElementById('large').hidden")  # dora's
    shown = "[...document.querySelectorAll('.pupil')].map(e => e.querySelector('.remove').checkVisibility())"
    assert page.evaluate(shown) == [True, False]


@pytest.mark.parametrize("width", [1280, 390])
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_nothing_at_the_door_is_cut(classroom: ClassPage, width: int, lang: str) -> None:
    page = classroom.page
    page.device(width, 800)
    page.evaluate(f"classPage._hello({{lang: {lang!r}, word: true}})")
    wait(classroom, *WAITING, newcomer(4, "Wolfeschlegelsteinhausen-Berger", why="known", was="10.0.0.9"))
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    cut = (
        "[...document.querySelectorAll('#lobby :is(button, .name, .why, .from), #asking')].filter(e => "
        "e.scrollWidth > e.clientWidth + 1 && e.clientWidth || e.getBoundingClientRect().right > innerWidth"
        ").map(e => e.className)"
    )
    assert page.evaluate(cut) == []
    page.device(1280, 800)
