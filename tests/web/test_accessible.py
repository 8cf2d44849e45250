"""What axe-core finds wrong on our pages for people who see little, hear a page or use no mouse: nothing that counts.

`DAY6_AXE` names an axe.min.js (`.ci/tools` fetches one); `DAY6_AXE_TO=FILE` appends what is found, a line of JSON a page.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from tests.support.short_folder import make_short_folder

if TYPE_CHECKING:
    from tests.web.background import Background
    from tests.web.chromium import Chromium, Page
    from tests.web.page_server import PageServer

pytestmark = pytest.mark.browser

COUNTED = ("serious", "critical")
RULES = {"label-content-name-mismatch": {"enabled": True}, "target-size": {"enabled": True}}
"""Besides those that axe plays by itself."""
LOOKS = [("en", "light"), ("zh", "dark")]
"""Each language and each scheme once; all four are no different from these two."""

SCREEN = {"columns": 40, "rows": 5, "ansi": "\x1b[32mstudent@day6\x1b[0m:~$ ros2 topic list\n/rosout\n"}
LESSON = {"name": "day1", "title": {"zh": "第一天", "en": "Day 1"}, "step": 3, "all": 12, "solved": True, "hints": 1}
TROUBLE = {"title": {"zh": "没有这个包", "en": "No such package"}, "line": "Package 'turtlsim' not found"}
NOW = {"lesson": LESSON, "trouble": TROUBLE, "nodes": ["/turtlesim"], "idle": 300, "hand": True, "screen": SCREEN}
ROWS = [
    {"name": "安娜", "state": "here", "address": "192.168.1.5", "watched": True, "seen": True, "frozen": True, **NOW},
    {"name": "ben", "state": "away", **NOW, "hand": False},
    {"name": "eva", "state": "full", "idle": 0},
    {"name": "fay", "state": "gone", "lesson": LESSON, "idle": 0},
    {"name": "gus", "state": "absent", "idle": 0, "listed": True},
]
WAITING = [
    {"id": number, "name": f"new {number}", "address": "10.0.0.7", "source": "10.0.0.7", "why": why}
    for number, why in enumerate(("many", "known", "removed"))
]
LARGE = "document.querySelector('.pupil .open').click()"

MACHINE = (
    "classPage._machine.show({warnings: ['disk: 300 MB left'], memory: {total: 4e9, free: 1e9}, disk: 3e8, cores: 2,"
    " room: 'Room for 4', measured: true, most: {memory: 1e9, disk: 5e8}, desktops: [{name: 'anna', memory: 6e7, cpu: 0.1,"
    " processes: 3, disk: 1e6}]}, classPage._texts), document.getElementById('machine-open').click()"
)


def opens(dialog: str) -> str:
    return f"document.getElementById({dialog!r}).click()"


Act = Callable[["Page", "PageServer"], None]


def does(script: str, until: str = "true") -> Act:
    def act(page: Page, server: PageServer) -> None:
        page.evaluate(script)
        page.wait_for(until)

    return act


def shows_class(*scripts: str, rows: list[dict[str, Any]] | None = None) -> Act:
    def act(page: Page, server: PageServer) -> None:
        page.evaluate("classPage._hello({lang: document.documentElement.lang, word: true, lessons: [], scenes: []})")
        server.say(
            {"t": "rows", "rows": ROWS if rows is None else rows, "frozen": True, "asks": True, "lobby": WAITING}
        )
        page.wait_for(f"document.querySelectorAll('.pupil').length === {len(ROWS if rows is None else rows)}")
        for script in scripts:
            page.evaluate(script)

    return act


DESK: dict[str, tuple[bool, Act]] = {
    "desk": (False, does("desk._showKeys(true)")),
    "desk on a phone": (True, does("desk._say('nothing_selected', 60000)")),
    "desk, pasting": (False, does("document.getElementById('paste-dialog').showModal()")),
    "desk, help": (False, does(opens("help"))),
    "desk, lost": (False, does("desk._strip.show('taken', 1, desk._texts)")),
    "desk, key row": (True, does(opens("choose-keys"))),
}
CLASS: dict[str, tuple[bool, Act]] = {
    "class, nothing heard yet": (False, does("true")),
    "class, empty": (False, shows_class(rows=[])),
    "class": (False, shows_class(opens("screens"))),
    "class on a phone": (True, shows_class()),
    "class, one large": (False, shows_class(LARGE)),
    "class, machine": (False, shows_class(MACHINE)),
}


def axe_source() -> str:
    path = os.environ.get("DAY6_AXE", "")
    if not path:
        pytest.skip("no axe-core: DAY6_AXE names none")
    return Path(path).read_text(encoding="utf-8")


class Looker:
    """A tab in which axe looks at pages."""

    def __init__(self, page: Page, source: str) -> None:
        self.page = page
        self._source = source

    def wear(self, lang: str, scheme: str, *, mobile: bool) -> None:
        """As somebody has it who reads this language and likes it dark or light."""
        self.page.device(*((390, 844) if mobile else (1280, 800)), mobile=mobile)
        self.page.ask(
            "Emulation.setEmulatedMedia",
            features=[
                {"name": "prefers-color-scheme", "value": scheme},
                {"name": "prefers-reduced-motion", "value": "reduce"},
            ],
        )
        self.page.ask("Network.setExtraHTTPHeaders", headers={"Accept-Language": lang})

    def found(self, name: str) -> list[str]:
        """What counts, as 'rule: the elements'; everything goes to DAY6_AXE_TO."""
        self.page.evaluate(f"{self._source}\n;true")
        options = {"rules": RULES, "resultTypes": ["violations"]}
        result = json.loads(
            self.page.evaluate(f"axe.run(document, {json.dumps(options)}).then(r => JSON.stringify(r.violations))")
        )
        if report := os.environ.get("DAY6_AXE_TO"):
            with open(report, "a", encoding="utf-8") as file:
                for each in result:
                    file.write(json.dumps([name, each["impact"], each["id"], len(each["nodes"])]) + "\n")
        return [
            f"{name}: {each['id']}: {node['html'][:120]} {[n['message'] for k in ('any', 'all', 'none') for n in node[k]]}"
            for each in result
            if each["impact"] in COUNTED
            for node in each["nodes"]
        ]


@pytest.fixture(scope="module")
def looker(chromium: Chromium) -> Iterator[Looker]:
    source = axe_source()
    page = chromium.page()
    yield Looker(page, source)
    page.close()


@pytest.fixture(scope="module")
def scripted(background: Background) -> Iterator[PageServer]:
    from tests.web.page_server import PageServer

    server = PageServer(background)
    yield server
    server.close()


@pytest.mark.parametrize("name", [*DESK, *CLASS])
def test_axe_finds_nothing_serious_on_a_page_with_a_script(looker: Looker, scripted: PageServer, name: str) -> None:
    kind, (mobile, act) = ("desk", DESK[name]) if name in DESK else ("class", CLASS[name])
    found = []
    for lang, scheme in LOOKS:
        scripted.hello = {"t": "hello", "name": "anna", "read_only": False, "lang": lang, "lessons": [], "scenes": []}
        looker.wear(lang, scheme, mobile=mobile)
        looker.page.navigate(f"{scripted.address}/{kind}?lang={lang}")
        thing = {"desk": "desk", "class": "classPage"}[kind]
        looker.page.wait_for(f"Boolean(window.{thing}) && {thing}._connection.isOpen")
        act(looker.page, scripted)
        found += looker.found(f"{name}, {lang}, {scheme}")
    assert found == []


@pytest.fixture(scope="module")
def real(background: Background) -> Iterator[tuple[str, str]]:
    """The address of a server in this process, and the teacher's link."""
    from day6_core.isolation.modes import ModeOffer
    from day6_core.isolation.same_user import Nothing
    from day6_tui.web.server import Server
    from day6_tui.web.settings import ServerSettings

    folder = make_short_folder("d6x-")
    (folder / "pupils.csv").write_text("anna\n王小明\n", encoding="utf-8")
    said: dict[str, str] = {}

    def tell(key: str, **values: object) -> None:
        said[key] = str(values.get("address") or values.get("link"))

    settings = ServerSettings(data=folder / "class", port=0, word="turtle", unasked=0, class_file=folder / "pupils.csv")
    server = Server(settings, ModeOffer("none", Nothing()), tell)
    background.run(server.open())
    yield said["serve.at"], said["serve.teacher"]
    background.run(server.close())


def enters(word: str, name: str) -> str:
    return (
        f"document.querySelector('[name=word]').value = {word!r}; document.querySelector('[name=name]').value = {name!r};"
        "document.forms[0].submit()"
    )


def test_axe_finds_nothing_serious_on_a_page_without_a_script(looker: Looker, real: tuple[str, str]) -> None:
    base, teacher = real
    page, found = looker.page, []
    for lang, scheme in LOOKS:
        looker.wear(lang, scheme, mobile=False)
        page.ask("Network.clearBrowserCookies")
        page.navigate(base)
        found += looker.found(f"start, {lang}, {scheme}")
        page.evaluate(enters("wrong", "eva"))
        page.wait_for("location.pathname === '/enter' && document.readyState === 'complete'")
        found += looker.found(f"start, wrong, {lang}, {scheme}")
        page.navigate(base)
        page.evaluate(enters("turtle", "eva"))
        page.wait_for("location.pathname === '/lobby' && document.readyState === 'complete'")
        found += looker.found(f"lobby, {lang}, {scheme}")
        page.navigate(f"{base}desk")
        found += looker.found(f"message, {lang}, {scheme}")
        page.navigate(teacher)
        page.wait_for("location.pathname === '/class' && document.readyState === 'complete'")
        page.navigate(f"{base}links")
        found += looker.found(f"links, {lang}, {scheme}")
    assert found == []
