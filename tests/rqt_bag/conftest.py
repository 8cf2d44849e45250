"""Bags as the tests of this folder need them, and a machine that runs rqt_bag on them."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.rqt_bag.bag_desk import BagDesk
from tests.support.rights import plain_user


@pytest.fixture
def desk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[BagDesk]:
    monkeypatch.chdir(tmp_path)
    made = BagDesk(tmp_path)
    yield made
    made.machine.end()


@pytest.fixture(params=["mcap", "sqlite3"])
def storage(request: pytest.FixtureRequest) -> str:
    return str(request.param)


__all__ = ["plain_user"]
