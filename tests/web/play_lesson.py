"""A whole lesson in a real browser, to be looked at.

    python -m tests.web.play_lesson FOLDER [--isolation none] [--lang zh] [--more N]

A teacher and eight pupils, each in a browser of their own, from the first link to the returned marks: what is said and answered,
hands, groups, freezing, screens that are shown, typing for a pupil, a link and a file, a pupil who leaves, a server that is
killed, an assignment that is handed out, collected, graded, marked and given back, the log and the report. Each step waits for
what a person would see, and fails if it doesn't come; screenshots go to FOLDER, numbered. Prints how long each step took, and
what the server and the desktops took of a core. With --more so many others take part, on sockets of their own. Needs Chromium
and the extra `serve`; takes some minutes.
"""

from __future__ import annotations

import argparse
import csv
import io
import json
import signal
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from day6_tui.locale import Texts
from tests.support.waiting import until
from tests.web.background import Background
from tests.web.chromium import Chromium, Page, program
from tests.web.cpu import cpu_of
from tests.web.crowd import Crowd
from tests.web.serving import Serving

NAMES = ("Anna", "Ben", "王小明", "李雷", "韩梅梅", "Dora", "Emil", "Fay")
LANGUAGES = {"zh": "zh-CN", "en": "en-US"}
SIZE = (1280, 800)
PHONE = (390, 780)

STAR = """\
import math
import time

import rclpy
from geometry_msgs.msg import Twist

rclpy.init()
node = rclpy.create_node('star')
keys = node.create_publisher(Twist, '/turtle1/cmd_vel', 10)
time.sleep(1.0)


def press(ahead, turn):
    message = Twist()
    message.linear.x = ahead
    message.angular.z = turn
    keys.publish(message)
    time.sleep(1.5)


for tip in range(5):
    press(3.0, 0.0)
    press(0.0, math.radians(TURN) / 1.008)
"""
"""What pupils hand in for day 3; with 144 degrees it is right."""

MARKS = (b"day6_tui.main\0serve", b"day6_tui.detached", b"day6_tui.main", b"chromium")
"""What the command lines of server, keepers, desktops and browser hold. Forked desktops have one, too."""


class Lesson:
    """The browser, the server and where pictures go."""

    def __init__(self, folder: Path, browser: Chromium, serving: Serving, texts: Texts, others: list[str]) -> None:
        self.folder = folder
        self.others = others
        """The names of the pupils who are in no browser."""
        self.all = len(NAMES) + len(others)
        self.browser = browser
        self.serving = serving
        self.texts = texts
        self.teacher = browser.page()
        self.pupils: dict[str, Page] = {}
        self.crowd: Crowd | None = None
        self._pictures = 0

    @contextmanager
    def step(self, what: str) -> Iterator[None]:
        began = time.monotonic()
        yield
        print(f"{time.monotonic() - began:7.1f} s  {what}", flush=True)

    def picture(self, page: Page, name: str) -> None:
        self._pictures += 1
        page.screenshot(self.folder / f"{self._pictures:02}-{name}.png")

    # -- the teacher ---------------------------------------------------------------------------------------------------

    def rows(self, condition: str, count: int) -> None:
        """Wait until so many pupils are like this, as the page knows."""
        self.teacher.wait_for(f"classPage._rows.filter((row) => {condition}).length === {count}")

    def click(self, selector: str) -> None:
        self.teacher.click_on(selector)

    def fill(self, selector: str, value: str) -> None:
        """Write into a field, or choose what has this value."""
        self.teacher.evaluate(
            f"(e => {{ e.value = {json.dumps(value)}; e.dispatchEvent(new Event('input', {{bubbles: true}}));"
            f" e.dispatchEvent(new Event('change', {{bubbles: true}})) }})(document.querySelector({selector!r}))"
        )

    def card(self, name: str, part: str) -> str:
        """The selector of a part of a pupil's card."""
        return f'.pupil[data-key="{name}"] {part}'

    def choose(self, *names: str) -> None:
        for name in names:
            self.teacher.evaluate(f"document.querySelector({self.card(name, '.choose')!r}).click()")

    def say(self, text: str, *, asks: bool = False) -> None:
        self.teacher.evaluate(
            f"(e => e.checked === {json.dumps(asks)} || e.click())(document.querySelector('#say-asks'))"
        )
        self.fill("#say-text", text)
        self.click("#say button")

    def fetched(self, address: str) -> list[list[str]]:
        """A table that the teacher saves."""
        text = self.teacher.evaluate(f"fetch({address!r}).then((answer) => answer.text())")
        return list(csv.reader(io.StringIO(text.lstrip("\ufeff"))))

    # -- a pupil -------------------------------------------------------------------------------------------------------

    def screen(self, name: str) -> str:
        """What a pupil's terminal shows."""
        return str(
            self.pupils[name].evaluate(
                "(t => [...Array(t.rows).keys()].map((y) => t.buffer.active.getLine(t.buffer.active.viewportY + y)"
                "?.translateToString(true) ?? '').join('\\n'))(desk._terminal)"
            )
        )

    def sees(self, name: str, *wanted: str) -> None:
        until(lambda: all(text in self.screen(name) for text in wanted), told=lambda: f"{wanted} {self.screen(name)}")

    def press(self, name: str, *keys: str) -> None:
        for key in keys:
            self.pupils[name].press(key)

    def write(self, name: str, text: str) -> None:
        """Paste into the terminal, as one does with a text from the board."""
        self.pupils[name].evaluate(f"desk._screen.paste({json.dumps(text)})")

    def command(self, name: str, line: str) -> None:
        self.write(name, line)
        self.press(name, "Enter")

    def act(self, name: str, action: str) -> None:
        """Choose something in the list of F7."""
        self.press(name, "F7")
        time.sleep(1)
        self.pupils[name].ask("Input.insertText", text=self.texts(f"action.{action}"))
        time.sleep(1)
        self.press(name, "Enter")


def come(lesson: Lesson) -> None:
    """Everybody opens a link."""
    front, serving = lesson.teacher, lesson.serving
    front.device(*SIZE)
    front.navigate(serving.link("the teacher"))
    front.wait_for("location.pathname.endsWith('/class') && window.classPage?._rows.length > 0")
    front.evaluate("window.confirm = () => true")
    lesson.picture(front, "nobody-yet")
    for number, name in enumerate(NAMES):
        page = lesson.pupils[name] = lesson.browser.page()
        page.device(*(PHONE if number == len(NAMES) - 1 else SIZE), mobile=number == len(NAMES) - 1)
        page.navigate(serving.link(name))
    lesson.crowd = Crowd(serving.base, map(serving.link, lesson.others))
    lesson.picture(lesson.pupils[NAMES[-2]], "it-starts")
    for name in NAMES:
        lesson.sees(name, "@day6")
    lesson.rows("row.state === 'here'", lesson.all)
    lesson.picture(lesson.pupils["Anna"], "pupil")
    lesson.picture(lesson.pupils["Fay"], "pupil-phone")


def talk(lesson: Lesson) -> None:
    """Something is said over a picture, something is asked and answered, hands are raised."""
    anna, ben = "Anna", "Ben"
    lesson.command(anna, "ros2 run turtlesim turtlesim_node &")
    lesson.command(ben, "ls")
    lesson.rows("row.nodes.includes('/turtlesim')", 1)
    lesson.say("Look at the board, please. 请看黑板。")
    for name in NAMES:
        lesson.sees(name, "Look at the board")
    time.sleep(1)
    lesson.picture(lesson.pupils[anna], "said-over-a-picture")
    lesson.say("Can you see the turtle?", asks=True)
    for name, key in ((anna, "y"), (ben, "n"), ("Dora", "d")):
        lesson.sees(name, "Can you see the turtle?")
        lesson.press(name, "F10")
        time.sleep(1.5)
        lesson.press(name, key)
    lesson.teacher.wait_for("classPage._questions.at(-1)?.replies.size === 3")
    lesson.picture(lesson.teacher, "answers")
    lesson.click("#questions .question button:last-of-type")
    for name in (ben, "李雷"):
        lesson.act(name, "hand")
        lesson.rows(f"row.hand && row.name === {json.dumps(name)}", 1)
    lesson.teacher.wait_for("document.querySelectorAll('#queue li').length === 2")
    lesson.picture(lesson.teacher, "hands")
    lesson.click("#queue li:first-child .answer")
    lesson.teacher.wait_for("classPage._panes.length === 1")
    lesson.rows("row.hand", 1)


def type_for_one(lesson: Lesson) -> None:
    """The pane of the pupil whose hand was up is open: the teacher types there, if the pupil agrees."""
    lesson.click(".pane .ask")
    lesson.rows("row.asked", 1)
    time.sleep(2)
    lesson.picture(lesson.pupils["Ben"], "consent")
    lesson.press("Ben", "y")
    lesson.rows("row.mayType", 1)
    lesson.click(".pane .mirror")
    for letter in "echo 6-7":
        lesson.teacher.press(letter)
    lesson.teacher.press("Enter")
    lesson.sees("Ben", "echo 6-7")
    lesson.picture(lesson.teacher, "typing-for-ben")
    lesson.click(".pane .stop")
    lesson.rows("row.mayType", 0)
    lesson.click(".pane .close")


def freeze(lesson: Lesson) -> None:
    lesson.click("#freeze")
    lesson.rows("row.frozen", lesson.all)
    time.sleep(1)
    lesson.picture(lesson.pupils["Anna"], "frozen-over-a-picture")
    lesson.click("#freeze")
    lesson.rows("row.frozen", 0)


def group(lesson: Lesson) -> None:
    """A few get a drill."""
    lesson.choose("Dora", "Emil")
    lesson.fill("#groups form input", "table 2")
    lesson.click("#groups form button")
    lesson.teacher.wait_for("document.querySelectorAll('#groups .list button').length > 0")
    option = "[...document.querySelector('#start').options].find((o) => o.value.includes('lamp_not_found')).value"
    lesson.fill("#start", lesson.teacher.evaluate(option))
    lesson.rows("row.lesson && ['Dora', 'Emil'].includes(row.name)", 2)
    lesson.rows("row.lesson", 2)
    lesson.picture(lesson.teacher, "group")
    lesson.teacher.evaluate("classPage._chosen.set([])")


def show(lesson: Lesson) -> None:
    """The teacher's own screen, then a pupil's who agrees."""
    lesson.teacher.evaluate("window.open = () => null")  # the tab is opened here
    mine = lesson.teacher.beside()
    mine.device(*SIZE)
    mine.navigate(f"{lesson.serving.base}mine")
    mine.wait_for("window.desk?._isDrawn")
    lesson.click("#show")
    for name in NAMES:
        lesson.pupils[name].wait_for("!document.querySelector('#shown').hidden")
    mine.evaluate("desk._screen.paste('ros2 topic list')")
    mine.press("Enter")
    time.sleep(3)
    lesson.picture(lesson.pupils["王小明"], "the-teachers-screen")
    lesson.picture(lesson.pupils["Fay"], "the-teachers-screen-phone")
    lesson.picture(lesson.teacher, "showing")
    lesson.click("#showing .stop")
    lesson.pupils["Ben"].wait_for("document.querySelector('#shown').hidden")
    lesson.click(lesson.card("Anna", ".open"))
    lesson.click(".pane .show")
    lesson.rows("row.name === 'Anna'", 1)
    time.sleep(2.5)
    lesson.picture(lesson.pupils["Anna"], "may-it-be-shown")
    lesson.press("Anna", "y")
    lesson.pupils["Ben"].wait_for("!document.querySelector('#shown').hidden")
    time.sleep(2)
    lesson.picture(lesson.pupils["Ben"], "annas-screen")
    lesson.picture(lesson.pupils["Anna"], "anna-is-shown")
    lesson.click(".pane .close")
    lesson.click("#showing .stop")
    mine.ask("Page.close")


def hand_out(lesson: Lesson) -> None:
    """A link to all, and day 3 as an assignment."""
    lesson.click("#hand summary")
    lesson.fill("#hand .link input", "https://docs.ros.org/")
    lesson.click("#hand .link button")
    lesson.sees("Ben", "docs.ros.org")
    lesson.teacher.evaluate("document.querySelector('#hand').open = false")
    lesson.click("#assign")
    lesson.click("dialog.assignments .new")
    lesson.fill("dialog.assignments .kind", "lesson")
    lesson.fill("dialog.assignments .what", "day3")
    lesson.picture(lesson.teacher, "hand-out")
    lesson.click("dialog.assignments .give")
    lesson.teacher.wait_for(f"document.querySelectorAll('dialog.assignments tbody tr').length === {lesson.all}")
    lesson.click("dialog.assignments .top .close")
    lesson.rows("row.lesson?.step >= 1", lesson.all)


def work(lesson: Lesson) -> None:
    """Four write a star, one of them a wrong one; one closes the laptop."""
    for name, turn in (("Anna", 144), ("Ben", 72), ("王小明", 144), ("Emil", 144)):
        lesson.command(name, f"cat > star.py <<'EOF'\n{STAR.replace('TURN', str(turn))}EOF\n")
        lesson.command(name, "ls")
        lesson.sees(name, "star.py")
    lesson.pupils["Emil"].navigate("about:blank")
    lesson.rows("row.state === 'away'", 1)
    lesson.click("#screens")
    time.sleep(5)
    lesson.picture(lesson.teacher, "screens")
    lesson.click("#screens")


def kill_the_server(lesson: Lesson) -> None:
    """The desktops go on, and everybody comes back by themselves."""
    port = lesson.serving.base.rstrip("/").rpartition(":")[2]
    lesson.serving.end(signal.SIGKILL)
    lesson.pupils["Anna"].wait_for("!document.querySelector('#strip').hidden")
    lesson.picture(lesson.pupils["Anna"], "server-killed")
    lesson.serving.start("--port", port)
    lesson.teacher.navigate(lesson.serving.link("the teacher"))  # the teacher's link is new at each start
    lesson.teacher.wait_for("window.classPage?._rows.length > 0")
    lesson.teacher.evaluate("window.confirm = () => true")
    lesson.rows("row.state === 'here'", lesson.all - 1)


def collect(lesson: Lesson) -> None:
    """Collected, graded, marked and given back."""
    lesson.click("#assign")
    lesson.teacher.wait_for(f"document.querySelectorAll('dialog.assignments tbody tr').length === {lesson.all}")
    lesson.click("dialog.assignments .collect")
    states = "[...document.querySelectorAll('dialog.assignments tbody tr')].map((e) => e.dataset.state)"
    lesson.teacher.wait_for(f"{states}.filter((state) => state === 'collected').length >= 4")
    lesson.picture(lesson.teacher, "collected")
    lesson.click("dialog.assignments .grade")
    cells = "['name', 'points'].map((each) => e.querySelector(`.${each}`).textContent)"
    points = f"[...document.querySelectorAll('dialog.assignments tbody tr')].map((e) => {cells})"
    busy = "classPage._assignments._chosen.working"
    lesson.teacher.wait_for(busy)
    time.sleep(3)
    lesson.picture(lesson.teacher, "grading")
    until(lambda: not lesson.teacher.evaluate(busy), 1200)
    said = "document.querySelector('dialog.assignments').innerText"
    until(
        lambda: sum(bool(mark) for _, mark in lesson.teacher.evaluate(points)) == 4,
        told=lambda: str(lesson.teacher.evaluate(said)),
    )
    found = dict(lesson.teacher.evaluate(points))
    print({name: mark for name, mark in found.items() if mark})
    assert found["Anna"] == found["王小明"] == found["Emil"] and found["Ben"] != found["Anna"], found
    for row, name in enumerate(lesson.teacher.evaluate(points), 1):
        if name[0] == "Anna":
            lesson.fill(f"dialog.assignments tbody tr:nth-child({row}) .mark", "A")
            lesson.fill(f"dialog.assignments tbody tr:nth-child({row}) .line", "A fine star. 很好！")
    lesson.click("dialog.assignments .return")
    lesson.teacher.wait_for(f"{states}.filter((state) => state === 'returned').length >= 1 && !{busy}")
    lesson.picture(lesson.teacher, "given-back")
    table = lesson.fetched(lesson.teacher.evaluate("document.querySelector('dialog.assignments .csv').href"))
    assert any("A fine star. 很好！" in row for row in table), table
    lesson.click("dialog.assignments .top .close")
    lesson.press("Anna", "F10")
    lesson.sees("Anna", "marks/")
    time.sleep(1.5)
    lesson.press("Anna", "o")
    lesson.sees("Anna", "A fine star")
    lesson.picture(lesson.pupils["Anna"], "the-mark")


def look_back(lesson: Lesson) -> None:
    """The log has what happened before the server was killed, too; the report has everybody."""
    log = lesson.fetched(f"{lesson.serving.base}class/log.csv")
    (lesson.folder / "log.csv").write_text("\n".join(",".join(row) for row in log), encoding="utf-8")
    text = "\n".join(" ".join(row) for row in log)
    for wanted in ("Look at the board", "Can you see the turtle?", "docs.ros.org", "Anna", "Ben"):
        assert wanted in text, (wanted, text)
    report = lesson.fetched(f"{lesson.serving.base}class/report.csv")
    names = {*NAMES, *lesson.others}
    assert {name for name in names if any(name in row for row in report)} == names, report
    lesson.picture(lesson.teacher, "the-end")


STEPS = (come, talk, type_for_one, freeze, group, show, hand_out, work, kill_the_server, collect, look_back)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=Path)
    parser.add_argument("--isolation", default="none")
    parser.add_argument("--lang", choices=tuple(LANGUAGES), default="en")
    parser.add_argument("--more", type=int, default=0, metavar="N")
    options = parser.parse_args()
    executable = program()
    if executable is None:
        sys.exit("there is no Chromium here")
    options.folder.mkdir(parents=True, exist_ok=True)
    others = [f"P{number:02}" for number in range(1, options.more + 1)]
    place = Path(tempfile.mkdtemp(prefix="d6l-"))
    place.chmod(0o711)  # pupils who are other users get to their homes
    (place / "pupils.csv").write_text("".join(f"{name}\n" for name in ("name", *NAMES, *others)), encoding="utf-8")
    words = ("--class", str(place / "pupils.csv"), "--isolation", options.isolation)
    background = Background()
    browser = Chromium(executable, background, (f"--accept-lang={LANGUAGES[options.lang]}",))
    try:
        with Serving(place, *words) as serving:
            lesson = Lesson(options.folder, browser, serving, Texts("en"), others)
            before, began = cpu_of(MARKS), time.monotonic()
            for step in STEPS:
                with lesson.step((step.__doc__ or step.__name__).strip().partition("\n")[0]):
                    step(lesson)
            took = time.monotonic() - began
            for name, seconds in cpu_of(MARKS).items():
                print(f"{name!r:40} {100 * (seconds - before[name]) / took:6.1f} % of a core over {took:.0f} s")
            pages = (lesson.teacher, *lesson.pupils.values())
            if lesson.crowd is not None:
                lesson.crowd.close()
            troubles = [each for page in pages for each in page.troubles if "ERR_CONNECTION_REFUSED" not in each]
            assert not troubles, troubles
    finally:
        browser.close()
        background.close()


if __name__ == "__main__":
    main()
