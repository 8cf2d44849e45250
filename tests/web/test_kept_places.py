"""The folders of a class in which sockets are look used as long as the server runs."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from day6_core.isolation.same_user import Nothing
from day6_tui.web.places import Places

pytestmark = pytest.mark.skipif(os.name != "posix", reason="this system has no keepers")


def test_sockets_locks_and_folders_look_used_and_links_are_not_followed(
    short_folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(short_folder / "run"))
    places = Places(tmp_path / "data", Nothing())
    places.make()
    inner = places.runtimes / "0a1b2c3d" / "0" / "meeting.lock"
    inner.parent.mkdir(parents=True)
    elsewhere = tmp_path / "elsewhere"
    for file in (inner, places.lock, places.keepers / "desktop-1", elsewhere):
        file.touch()
    (inner.parent / "link").symlink_to(elsewhere)
    ours = (inner, *inner.parents[: len(inner.parents) - len(short_folder.parents) - 1], places.lock, places.keepers)
    for path in (*ours, elsewhere):
        os.utime(path, (0, 0))
    places.mark_as_used()
    assert [path for path in ours if path.stat().st_mtime == 0] == []
    assert elsewhere.stat().st_mtime == 0
