"""Which engine a process has, where its processes meet, and what is said of what only Zenoh can do."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import pytest

from day6_core.graph import Graph
from day6_core.link import engine, join, leave, state_of
from day6_core.link.paths import meeting_place
from day6_core.link.state import DoorState
from day6_tui.classes import command
from day6_tui.commands import desktop
from tests.link.local.sessions import Sessions


@pytest.fixture
def without_zenoh(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(engine, "_missing", {"zenoh"})


@pytest.fixture
def with_zenoh(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(engine, "_missing", set())
    for name in ("zenoh", "zenoh.ext"):
        monkeypatch.setitem(sys.modules, name, ModuleType(name))
    monkeypatch.setattr(engine, "_has_zenoh", lambda: True)


@pytest.mark.usefixtures("with_zenoh")
@pytest.mark.parametrize(
    ("value", "module"),
    [("on", "zenoh"), ("tcp", "zenoh"), ("local", "day6_core.link.local"), ("local-tcp", "day6_core.link.local")],
)
def test_a_variable_chooses_the_engine(monkeypatch: pytest.MonkeyPatch, value: str, module: str) -> None:
    monkeypatch.setenv("DAY6_LINK", value)
    assert engine.chosen().__name__ == engine.engine_of(None).__name__ == module


@pytest.mark.usefixtures("with_zenoh")
def test_a_session_keeps_its_engine_whatever_becomes_of_the_variable(
    monkeypatch: pytest.MonkeyPatch, short_folder: Path
) -> None:
    sessions = Sessions(short_folder / "0")
    try:
        session = sessions.one()
        monkeypatch.setenv("DAY6_LINK", "on")
        assert engine.engine_of(session).__name__ == "day6_core.link.local"
        assert engine.extras_of(session).__name__ == "day6_core.link.local.ext"
        monkeypatch.setenv("DAY6_LINK", "local")
        assert engine.extras_of(object()).__name__ == "zenoh.ext"
    finally:
        sessions.close()


def test_a_zenoh_that_cannot_be_imported_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(engine, "_missing", set())
    monkeypatch.setattr(engine, "_has_zenoh", lambda: True)
    monkeypatch.setitem(sys.modules, "zenoh", None)
    assert engine.chosen().__name__ == "day6_core.link.local" and engine.is_local()


@pytest.mark.usefixtures("with_zenoh")
def test_the_two_engines_meet_in_folders_of_their_own(monkeypatch: pytest.MonkeyPatch, short_folder: Path) -> None:
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(short_folder))
    places = {}
    for value in ("on", "tcp", "local", "local-tcp"):
        monkeypatch.setenv("DAY6_LINK", value)
        place = meeting_place(7)
        places[value] = (str(place.folder.relative_to(short_folder)).replace("\\", "/"), place.tcp)
        assert place.folder.stat().st_mode & 0o077 == 0 or sys.platform == "win32"
    always = sys.platform == "win32"
    assert places["on"] == ("7", always) and places["tcp"] == ("7", True)
    assert places["local"] == ("local/7", always) and places["local-tcp"] == ("local/7", True)


def parse_desktop(language: str, *words: str) -> None:
    desktop.build_parser(language).parse_args(list(words))


def take_part(language: str, *words: str) -> None:
    command.main([*words, "--lang", language])


@pytest.mark.usefixtures("without_zenoh")
@pytest.mark.parametrize("language", ["en", "zh"])
@pytest.mark.parametrize(
    ("begin", "words"),
    [
        (parse_desktop, ["--listen", "tcp/0.0.0.0:7447"]),
        (parse_desktop, ["--connect", "tcp/192.168.1.5:7447"]),
        (take_part, ["--teacher"]),
        (take_part, ["--join", "192.168.1.5", "--name", "anna"]),
    ],
)
def test_what_reaches_other_machines_says_in_a_sentence_what_it_needs(
    capsys: pytest.CaptureFixture[str], language: str, begin: Callable[..., None], words: list[str]
) -> None:
    with pytest.raises(SystemExit) as ended:
        begin(language, *words)
    said = capsys.readouterr().err
    assert ended.value.code == 2 and said.count("\n") == 1
    assert said.endswith(f"{engine.NEEDS_ZENOH['missing'][language == 'zh']}\n")


@pytest.mark.usefixtures("with_zenoh")
def test_who_has_chosen_to_do_without_zenoh_is_told_so(monkeypatch: pytest.MonkeyPatch) -> None:
    assert engine.why_no_zenoh("en") is None
    monkeypatch.setenv("DAY6_LINK", "local")
    assert engine.why_no_zenoh("en") == engine.NEEDS_ZENOH["chosen"][0].format(value="local")
    monkeypatch.setattr(engine, "_missing", {"zenoh"})
    assert engine.why_no_zenoh("zh") == engine.NEEDS_ZENOH["missing"][1]


@pytest.mark.usefixtures("without_zenoh")
def test_a_door_that_needs_zenoh_stays_shut_and_the_graph_is_joined(
    monkeypatch: pytest.MonkeyPatch, short_folder: Path
) -> None:
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(short_folder))
    graph = Graph()
    link = join(graph, listen="tcp/127.0.0.1:7447")
    try:
        (door,) = state_of(graph).doors
        assert door.state == DoorState.FAILED and "pip install eclipse-zenoh" in door.reason
        assert link.problem is None and link.connected
    finally:
        leave(graph)
