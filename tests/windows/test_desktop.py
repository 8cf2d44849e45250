"""The desktop on Windows: its layout, and keys as that system's console gives them (`typist.py`)."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from tests.windows import typist

pytestmark = [pytest.mark.process, pytest.mark.skipif(sys.platform != "win32", reason="has no such console")]

KEYS = {
    "echo $((6 * 7)) \u00fc\r": "42 \u00fc",
    "\x1b[18~": "type to search",
    "\x1b": "",
    "\x1bOP": "Help: Terminals",
    "\x1b ": "",
}
"""What is typed and then read: a command, F7 and F1 with Esc between them."""


def test_the_desktop_is_drawn_hears_its_keys_and_ends_with_ctrl_q(tmp_path: Path) -> None:
    answer = tmp_path / "answer.json"
    command = [sys.executable, typist.__file__, str(answer), str(tmp_path / "home"), *KEYS, "\x11"]
    subprocess.run(command, creationflags=subprocess.CREATE_NEW_CONSOLE, check=True)  # type: ignore[attr-defined]
    (first, *screens), status = json.loads(answer.read_text(encoding="utf-8"))
    if not screens:
        pytest.skip("the console of Wine hears no keys without a display")
    lines = first.split("\n")
    assert lines[0].startswith(" day6 ") and "F2 Terminal" in lines[-1] and "^Q Quit" in lines[-1]
    assert {line[0] + line[-1] for line in lines[2:-2]} <= {"││", "│┃"}, first
    assert [said for said, screen in zip(KEYS.values(), screens, strict=False) if said not in screen] == []
    assert "type to search" not in screens[2] and "Help: Terminals" not in screens[4]
    assert status == 0
