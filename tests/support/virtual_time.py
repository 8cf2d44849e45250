"""Tests marked `virtual_time` run in a pytest of their own, whose time passes only when everything in it waits.

So what takes minutes by waiting takes seconds, and no busy machine makes it slow or lucky. Where there is no virtual time, they
run as any test.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path

import pytest

from day6_core.virtual.surroundings import VARIABLE, environment, is_due

MARK = "virtual_time"
ROOT = Path(__file__).resolve().parents[2]
LONGEST = 400.0
"""Seconds of a core for one test."""


def variables(base: Mapping[str, str]) -> dict[str, str]:
    """Return what a process of a world in virtual time has in its environment, and those that it starts need; or nothing."""
    if not base.get(VARIABLE):
        return {}
    return {name: base[name] for name in (VARIABLE, "DAY6_LINK", "PYTHONPATH", "PYTHONHASHSEED")}


def leave_out_fixtures(item: pytest.Item) -> None:
    """Set up nothing for a test that runs elsewhere."""
    if isinstance(item, pytest.Function) and _runs_elsewhere(item):
        item.fixturenames = []


def run(item: pytest.Function) -> bool | None:
    """Run a test in virtual time, if it is marked so and this isn't it already; return whether that was done."""
    if not _runs_elsewhere(item):
        return None
    from os import environ

    from tests.support import waiting

    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-p", "no:xdist", "-m", "", item.nodeid]
    done = waiting.run(command, limit=LONGEST, env=environment(environ), cwd=ROOT)
    if done.returncode:
        pytest.fail(f"{done.stdout}{done.stderr}", pytrace=False)
    if " passed" not in done.stdout:
        pytest.skip(done.stdout)
    return True


def _runs_elsewhere(item: pytest.Item) -> bool:
    return item.get_closest_marker(MARK) is not None and is_due(real_time=False)
