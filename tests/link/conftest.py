"""Where the suite's participants come from."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

# Tests are imported by path (--import-mode=importlib), their helpers by name.
from tests.link.link_harness import HOUR, LEASE, World
from tests.support.free_port import free_port


@pytest.fixture
def world(short_folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[World]:
    runtime = short_folder / "r"
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(runtime))
    monkeypatch.setenv("DAY6_LINK", "on")
    made = World(tmp_path, runtime)
    yield made
    made.close()


@pytest.fixture
def port() -> int:
    return free_port()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item, call: pytest.CallInfo[None]) -> Iterator[None]:
    """Add what the participants knew to the report of a test that failed."""
    report: Any = yield
    world = getattr(item, "funcargs", {}).get("world")
    if report.failed and call.when == "call" and isinstance(world, World):
        report.sections.append(("what the participants know", world.knowledge()))
    return report


@pytest.fixture
def hour_of_lease(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whoever falls silent is missed after an hour only: one whose end is noticed was noticed at once, by his socket."""
    from day6_core.link import config

    monkeypatch.setitem(config._COMMON, LEASE, HOUR)
    monkeypatch.setenv("TEST_LEASE", HOUR)


_LINKS = {
    "two graphs": "on",
    "two processes": "on",
    "two processes on TCP": "tcp",
    "two graphs without Zenoh": "local",
    "two processes without Zenoh": "local",
    "two processes on TCP without Zenoh": "local-tcp",
}
"""The ways to be apart, with the DAY6_LINK of each."""

_APART = [pytest.param(how, marks=pytest.mark.process) for how in _LINKS]


@pytest.fixture(params=["one graph", *_APART])
def pair(request: pytest.FixtureRequest, world: World, monkeypatch: pytest.MonkeyPatch) -> tuple[Any, Any]:
    """Two participants, in every way in which they can be apart."""
    if request.param == "one graph":
        peer = world.here(joined=False)
        return peer, peer
    monkeypatch.setenv("DAY6_LINK", _LINKS[request.param])
    return world.here(), world.here() if request.param.startswith("two graphs") else world.process()
