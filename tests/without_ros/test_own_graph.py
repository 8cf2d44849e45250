"""The folder of a graph that nobody else is on."""

from __future__ import annotations

import os
import time
from pathlib import Path

from day6_core.link.paths import process_exists
from day6_core.workspace.own_graph import remove_abandoned


def test_only_folders_of_killed_processes_are_removed_and_not_at_once(tmp_path: Path) -> None:
    gone = next(number for number in range(99_999, 1, -1) if not process_exists(number))
    alive, long_ago = os.getpid(), time.time() - 7200
    old = [f"day6-test{gone}-abcdefgh", f"day6-test{alive}-abcdefgh", f"day6-test{gone}-notes", "notes"]
    for name in (*old, f"day6-test{gone}-12345678"):
        (tmp_path / name).mkdir()
    for name in old:
        os.utime(tmp_path / name, (long_ago, long_ago))
    (tmp_path / f"day6-test{gone}-ijklmnop").write_text("a file", encoding="utf-8")
    os.utime(tmp_path / f"day6-test{gone}-ijklmnop", (long_ago, long_ago))
    before = set(os.listdir(tmp_path))
    remove_abandoned(tmp_path)
    assert before - set(os.listdir(tmp_path)) == {f"day6-test{gone}-abcdefgh"}
