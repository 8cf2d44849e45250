"""A class on a network as its people see it: two machines, each with a home and a runtime folder of its own."""

from __future__ import annotations

import csv
import socket
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from day6_tui.locale import Texts
from tests.e2e.mouse import Mouse
from tests.e2e.place import Place
from tests.e2e.test_observed import answer_consent, choose
from tests.support.free_port import free_port
from tests.support.waiting import until

if TYPE_CHECKING:
    from tests.e2e.terminal import Terminal

pytestmark = pytest.mark.person

pytest.importorskip("termios", reason="this system has no pseudo-terminals to try the screen in")

PROMPT = "student@day6:~$"
END_TYPING = "\x1d"


@pytest.fixture
def address() -> str:
    return f"127.0.0.1:{free_port()}"


@pytest.fixture
def desk(tmp_path: Path) -> Iterator[Place]:
    """The teacher's machine."""
    folder = tmp_path / "teacher"
    folder.mkdir()
    made = Place(folder)
    yield made
    made.close()


def teach(desk: Place, address: str, *options: str, lang: str = "en", columns: int = 80, rows: int = 24) -> Terminal:
    words = ("class", "--teacher", "--listen", address, "--home", str(desk.home), "--lang", lang, *options)
    return desk.terminal(*words, columns=columns, rows=rows)


def join(
    place: Place, address: str, name: str, *options: str, lang: str = "en", columns: int = 80, rows: int = 24
) -> Terminal:
    words = ("class", "--join", address, "--name", name, "--home", str(place.home), "--lang", lang, *options)
    return place.terminal(*words, columns=columns, rows=rows)


@pytest.mark.parametrize(("lang", "columns", "rows"), [("en", 120, 40), ("zh", 80, 24)])
def test_the_teacher_sees_a_pupil_and_the_pupil_sees_that(
    place: Place, desk: Place, address: str, lang: str, columns: int, rows: int
) -> None:
    texts, unread = Texts(lang), "class.bar.unread" if columns > 100 else "class.bar.unread.short"
    with teach(desk, address, lang=lang, columns=columns, rows=rows) as teacher:
        teacher.wait(texts("teacher.empty")[:12])
        teacher.wait("day6-tui class --join")
        with join(place, address, "anna", "--scene", "empty", lang=lang, columns=columns, rows=rows) as pupil:
            pupil.wait(PROMPT)
            pupil.wait(texts("bar.door.joined", host="127.0.0.1"))
            pupil.line("ros2 run turtlesim turtlesim_node &")
            teacher.wait("/turtlesim")
            pupil.wait(texts("class.bar.raise"))
            Mouse(pupil).click_on(texts("class.bar.raise"))
            pupil.wait(texts("class.bar.hand"))
            teacher.wait(texts("teacher.hand"), texts("teacher.bar.hand"))
            assert texts("class.bar.watched") not in pupil.look()
            teacher.press("Enter")
            pupil.wait(texts("class.bar.watched"))
            pupil.line("echo here-$((40 + 2))")
            teacher.wait("here-42")
            teacher.press("s")
            teacher.wait(texts("teacher.say", name="anna"))
            teacher.line("well done")
            pupil.wait("well done")
            teacher.wait(texts("teacher.sent", name="anna"))
            pupil.wait(texts(unread, count=1))
            choose(pupil, texts("action.sayings"))
            pupil.wait_gone(texts(unread, count=1))
            pupil.press("Esc")
            until(lambda: "/anna/turtlesim" in desk.nodes())
            until(lambda: "/turtlesim" in place.nodes())
            assert "/anna/turtlesim" not in place.nodes()
            pupil.quit()
        teacher.wait(texts("teacher.here", here=0, all=1))
        teacher.quit()


def begin_typing(teacher: Terminal, pupil: Terminal) -> None:
    """The teacher asks whether she may type for anna, who agrees."""
    texts = Texts("en")
    pupil.wait(PROMPT)
    teacher.wait(texts("teacher.here", here=1, all=1))
    teacher.press("t")
    pupil.wait(texts("class.consent.yes"))
    teacher.wait(texts("teacher.awaited"))
    answer_consent(pupil, "y")
    pupil.wait(texts("class.bar.types.short"))
    teacher.wait(texts("teacher.typing", name="anna"))


def test_the_teacher_types_for_who_agrees_and_writes_the_report(place: Place, desk: Place, address: str) -> None:
    texts = Texts("en")
    with teach(desk, address) as teacher, join(place, address, "anna", "--scene", "empty") as pupil:
        begin_typing(teacher, pupil)
        teacher.send("echo typed-$((40 + 2))\r")
        pupil.wait("typed-42")
        teacher.send(END_TYPING)
        pupil.wait_gone(texts("class.bar.types.short"))
        teacher.press("e")
        teacher.wait(texts("teacher.csv"))
        teacher.press("Enter")
        teacher.wait_gone(texts("prompt.keys"))
        log, report = sorted(desk.home.glob("class-*.csv"))
        teacher.wait(f"{report.name}, {log.name}")
    with report.open(encoding="utf-8-sig", newline="") as file:
        assert list(csv.reader(file))[1] == ["anna", "", "", ""]
    with log.open(encoding="utf-8-sig", newline="") as file:
        rows = [row[1:4] for row in csv.reader(file)]
    for by, what in (
        ("pupil", "came"),
        ("teacher", "asked to type"),
        ("pupil", "let the teacher type"),
        ("teacher", "began to type"),
    ):
        assert rows.count([by, "anna", what]) == 1, what


@pytest.mark.parametrize("how", ["taken_back", "gone"])
def test_keys_for_a_pupil_never_become_commands_for_the_class(
    place: Place, desk: Place, address: str, how: str
) -> None:
    texts = Texts("en")
    with teach(desk, address) as teacher, join(place, address, "anna", "--scene", "empty") as pupil:
        begin_typing(teacher, pupil)
        teacher.send("echo")
        pupil.wait("echo")
        if how == "gone":
            pupil.quit()
        else:
            Mouse(pupil).click_on(texts("class.bar.types.short"))
        teacher.wait(texts(f"teacher.over.{how}", name="anna"))
        teacher.send("fxSd")
        teacher.look(0.5)
        teacher.wait(texts(f"teacher.over.{how}", name="anna"))
        assert texts("teacher.frozen") not in teacher.look() and texts("teacher.end", name="anna") not in teacher.look()
        teacher.press("Esc")
        teacher.wait_gone(texts(f"teacher.over.{how}", name="anna"))


def test_a_class_whose_port_is_taken_invites_nobody(desk: Place, address: str) -> None:
    with socket.socket() as other:
        host, port = address.split(":")
        other.bind((host, int(port)))
        other.listen()
        with teach(desk, address) as teacher:
            teacher.wait(Texts("en")("teacher.port_in_use", port=port)[:40])
            assert "--join" not in teacher.look()


def test_leaving_a_class_asks_while_a_pupil_is_joined(place: Place, desk: Place, address: str) -> None:
    texts = Texts("en")
    with teach(desk, address) as teacher, join(place, address, "anna", "--scene", "empty") as pupil:
        teacher.wait(texts("teacher.here", here=1, all=1))
        teacher.press("Ctrl-Q")
        teacher.wait(texts("quit.class"), "1 pupil is connected")
        teacher.press("Ctrl-Q")
        assert teacher.wait_end() == 0
        pupil.line("echo still-$((40 + 2))")
        pupil.wait("still-42")


def test_a_taken_name_is_told_and_the_own_machine_works_on(place: Place, desk: Place, address: str) -> None:
    other = desk.home.parent / "other"
    other.mkdir()
    third = Place(other)
    try:
        with teach(desk, address), join(place, address, "anna") as first:
            first.wait("joined 127.0.0.1")
            with join(third, address, "anna", "--scene", "empty") as second:
                second.wait(Texts("en")("bar.door.name_taken"))
                second.line("echo still-$((40 + 2))")
                second.wait("still-42")
    finally:
        third.close()


def test_in_a_room_scenes_begin_below_the_pupils_name(place: Place, desk: Place, address: str) -> None:
    with teach(desk, address, "--room"), join(place, address, "anna") as pupil:
        pupil.wait("joined 127.0.0.1")
        choose(pupil, Texts("en")("action.scene.turtle"))
        pupil.wait("Use arrow keys")
        desk.wait_nodes("/anna/teleop_turtle", "/anna/turtlesim")


@pytest.mark.parametrize(
    ("words", "says"),
    [
        ((), "--teacher"),
        (("--join", "host"), "--name"),
        (("--join", "host", "--name", "安娜"), "安娜"),
        (("--join", "host", "--name", "安娜"), "wang_xiaoming"),
        (("--join", "host", "--name", "a__b"), "no two _ in a row"),
        (("--join", "host", "--name", "a" * 33), "at most 32"),
        (("--join", "host", "--name", "Teacher"), "the teacher's"),
        (("--join", "a b", "--name", "anna"), "a b"),
        (("--join", "127.0.0.1:99999", "--name", "anna"), "99999 isn't a port"),
        (("--join", "host:" + "9" * 5000, "--name", "anna"), "isn't a port"),
        (("--teacher", "--join", "host"), "not allowed with"),
        (("--teacher", "--name", "anna"), "--join"),
        (("--join", "host", "--name", "anna", "--room"), "--teacher"),
        (("--teacher", "--connect", "tcp/host:7447"), "--join"),
    ],
)
def test_what_does_not_fit_is_told(place: Place, words: tuple[str, ...], says: str) -> None:
    done = place.run("class", *words, DAY6_LANG="en")
    assert done.returncode == 2
    assert says in done.stderr.splitlines()[-1]
    assert "Traceback" not in done.stderr


def test_the_help_names_the_port_and_how_another_one_is_written(place: Place) -> None:
    told = place.run("class", "--help", "--lang", "zh").stdout
    assert "7447" in told and "HOST:PORT" in told and "\n班级：\n" in told and "\n选项：\n" in told
