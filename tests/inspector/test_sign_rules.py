"""From which figures on what a program measures of itself is a fault, and that all else is none."""

from __future__ import annotations

from typing import Any

import pytest

from day6_core.ros.programs.day6_inspector.facts import Facts
from day6_core.ros.programs.day6_inspector.process_reports import Busy, Hidden, Place, ReportedProcess, Sign, Standing
from day6_core.ros.programs.day6_inspector.program_rules import of_programs
from day6_core.ros.programs.day6_inspector.sign_rules import of_signs

PLACE = Place("/home/a/mine.py", 7, "self.tick()")
LATE = {"what": "tick", "wanted": 10.0, "share": 0.5, "rate": 5.0}
LOSSES = {"topic": "/t", "what": "heard", "share": 0.9, "lost": 90, "count": 100, "rate": 50.0, "depth": 10}
GROWS = {"kind": "clients", "name": "/add", "count": 30, "least": 5}
SWALLOWED = {"what": "heard", "error": "KeyError: 1", "raised": "mine.py:3", "count": 9, "calls": 10}
ACTION = {"name": "/fly", "what": "execute", "seconds": 9.0}
SYNC = {
    "topics": "/a, /b", "silent": "", "unpublished": 0, "least": 9, "most": 90, "matches": 0, "timeless": 0, "callbacks": 1,
    "slop": 0.1, "queue_size": 10, "gap": 2.0, "short": "",
}  # fmt: skip


def judged(kind: str, values: dict[str, Any]) -> list[tuple[str, str]]:
    process = ReportedProcess("z", 1, ("/home/a/mine.py",), signs=(Sign(kind, "/mine", values, PLACE),))
    found = list(of_signs(Facts(processes=(process,))))
    assert all("/mine" in each.text and "{" not in each.text for each in found)
    return [(each.level, each.id.removeprefix("inspector.")) for each in found]


@pytest.mark.parametrize(
    ("kind", "values", "said"),
    [
        ("late", LATE, ("warning", "timer_late")),
        ("late", {**LATE, "wanted": 1e7, "share": 1.0}, ("warning", "timer_late")),
        ("late", {**LATE, "wanted": 0.0}, ("warning", "timer_zero")),
        ("late", {**LATE, "share": 0.3}, None),
        ("seldom", {"what": "tick", "period": 500.0}, ("info", "timer_seldom")),
        ("seldom", {"what": "tick", "period": 60.0}, None),
        ("losses", LOSSES, ("warning", "losses")),
        ("losses", {**LOSSES, "depth": 1}, ("info", "losses")),
        ("losses", {**LOSSES, "share": 0.4}, None),
        ("losses", {**LOSSES, "lost": 5}, None),
        ("flood", {"topic": "/t", "rate": 5000.0}, ("warning", "flood")),
        ("flood", {"topic": "/t", "rate": 1000.0}, None),
        *((("grows", {**GROWS, "kind": kind}, ("error", f"grows_{kind}")))
          for kind in ("publishers", "subscriptions", "clients", "services", "timers")),
        ("grows", {**GROWS, "least": 2}, None),
        ("goal_unsettled", ACTION, ("error", "goal_unsettled")),
        ("goal_waits", ACTION, ("error", "goal_waits")),
        ("goal_waits", {**ACTION, "seconds": 1.0}, None),
        ("cancel_ignored", ACTION, ("warning", "cancel_ignored")),
        ("cancel_ignored", {**ACTION, "seconds": 1.0}, None),
        ("cancel_unheard", ACTION, ("error", "cancel_unheard")),
        ("cancel_unheard", {**ACTION, "seconds": 0.5}, None),
        ("empty_list", {"name": "names"}, ("info", "empty_list")),
        ("launch_text", {"name": "speed", "value": "<launch.substitutions.…>"}, ("error", "launch_text")),
        ("swallowed", SWALLOWED, ("error", "swallowed")),
        ("swallowed", {**SWALLOWED, "count": 7}, None),
        ("swallowed", {**SWALLOWED, "count": 2, "calls": 2}, None),
        ("sync", SYNC, ("error", "sync_stamps")),
        ("sync", {**SYNC, "slop": 0.0}, ("error", "sync_exact")),
        ("sync", {**SYNC, "short": "/a"}, ("error", "sync_queue")),
        ("sync", {**SYNC, "short": "/a", "gap": 1000.0}, ("error", "sync_stamps")),
        ("sync", {**SYNC, "matches": 1}, None),
        ("sync", {**SYNC, "gap": 0.05}, None),
        ("sync", {**SYNC, "least": 2}, None),
        ("sync", {**SYNC, "timeless": 5}, ("error", "sync_timeless")),
        ("sync", {**SYNC, "callbacks": 0, "matches": 5}, ("error", "sync_no_callback")),
        ("sync", {**SYNC, "silent": "/b", "least": 0}, ("warning", "sync_silent")),
        ("sync", {**SYNC, "silent": "/b", "least": 0, "unpublished": 1}, ("info", "sync_silent")),
        ("sync", {**SYNC, "silent": "/b", "least": 0, "most": 10}, None),
        ("of another version", {}, None),
        ("late", {"what": "tick"}, None),
        ("sync", {**SYNC, "gap": "far"}, None),
    ],
)  # fmt: skip
def test_a_figure_is_a_fault_from_here_on(kind: str, values: dict[str, Any], said: tuple[str, str] | None) -> None:
    assert judged(kind, values) == ([said] if said else [])


BUSY = Busy("/mine", "tick", 1.0, "call", PLACE, "/trigger", "thread")


@pytest.mark.parametrize(
    ("busy", "said"),
    [
        (BUSY, "calls_in_callback"),
        (BUSY._replace(blocked="group"), "calls_in_group"),
        (BUSY._replace(other="serve"), "calls_own_service"),
        (BUSY._replace(other="serve", blocked="group"), "calls_own_in_group"),
        (BUSY._replace(waits_for="future"), "calls_in_callback"),
        (BUSY._replace(waits_for="future", waits_on=""), "future_in_callback"),
        (BUSY._replace(waits_for="rate", waits_on=""), "rate_in_callback"),
        (BUSY._replace(waits_for="spin"), "spins_in_callback"),
        (BUSY._replace(blocked="", waits_for=""), None),
        (BUSY._replace(blocked="", waits_for="event"), None),
        (BUSY._replace(blocked="", waits_for="event", seconds=20.0), "event_in_callback"),
        (
            BUSY._replace(blocked="", waits_for="", seconds=20.0, place=PLACE._replace(text="x = input()")),
            "input_in_callback",
        ),
        (BUSY._replace(seconds=0.5), None),
        (BUSY._replace(blocked="who knows"), "stays_in_callback"),
    ],
)
def test_who_waits_for_what_cannot_come_is_told_of_both(busy: Busy, said: str | None) -> None:
    found = list(of_programs(Facts(processes=(ReportedProcess("z", 1, ("/home/a/mine.py",), busy=(busy,)),))))
    assert [each.id for each in found] == ([f"inspector.{said}"] if said else [])
    for each in found:
        assert all(name in each.text for name in (busy.waits_on, busy.other) if said and said.startswith("calls"))


TRIGGER = {"services": {"/trigger": ("std_srvs/srv/Trigger",)}, "servers": {"/trigger": ("/other",)}}


@pytest.mark.parametrize(
    ("name", "seconds", "said"),
    [
        ("/triger", 1.0, "program_waits_near"),
        ("/nothing_like_it", 1.0, "program_waits_service"),
        ("/trigger", 2.0, "program_waits_type"),
        ("/trigger", 1.0, None),
        ("/triger", 0.5, None),
    ],
)
def test_a_service_that_is_waited_for_is_compared_with_those_there_are(
    name: str, seconds: float, said: str | None
) -> None:
    process = ReportedProcess("z", 1, ("/home/a/mine.py",), standing=(Standing("service", name, seconds, PLACE),))
    found = [each.id for each in of_programs(Facts(**TRIGGER, processes=(process,)))]
    assert found == ([f"inspector.{said}"] if said else [])


def test_a_thread_that_ended_is_not_the_program() -> None:
    process = ReportedProcess(
        "z", 1, ("/home/a/mine.py",), hidden=(Hidden("", "KeyError: 1", PLACE, "Thread-1 (work)"),)
    )
    (found,) = of_programs(Facts(processes=(process,)))
    assert found.id == "inspector.thread_died" and "Thread-1 (work)" in found.text and "goes on" in found.text
