"""The keeper of a desktop, without one: what it does with a key."""

from __future__ import annotations

import os
import select
import socket
import sys
from pathlib import Path

import pytest

if sys.platform == "win32":
    pytest.skip("Windows has no keepers", allow_module_level=True)

import pytest

from day6_tui.detached import meeting, wire
from day6_tui.detached.keeper import UNSENT, Keeper
from day6_tui.detached.wire import Connection


def test_a_key_is_in_the_terminal_before_the_next_frame_is_read() -> None:
    ours, theirs = socket.socketpair()
    terminal, master = os.pipe()
    os.set_blocking(master, False)
    try:
        client = Connection(ours)
        keeper = Keeper(meeting.Held(-1, theirs), client, "home", "folder", [], os._exit)  # type: ignore[arg-type]  # which starts no desktop
        keeper._arrived, keeper._client, keeper._master = [], client, master
        keeper._reads_keys = keeper._is_here = True
        keeper._hear(client, wire.INPUT, b"x\n")
        assert select.select([terminal], [], [], 0)[0] and os.read(terminal, 8) == b"x\n"
        keeper._reads_keys = False
        keeper._hear(client, wire.INPUT, b"y\n")
        assert not select.select([terminal], [], [], 0)[0], "the desktop is leaving this terminal"
        client.send(wire.OUTPUT, b"x" * (1 << 20))
        assert client.unsent > UNSENT and not keeper._takes_output, "frames that nobody takes are not read"
    finally:
        ours.close()
        theirs.close()
        os.close(master)
        os.close(terminal)


@pytest.mark.parametrize("lost", [".lock", ""])
def test_what_cleaners_took_is_held_again_as_soon_as_it_can_be(
    short_folder: Path, monkeypatch: pytest.MonkeyPatch, lost: str
) -> None:
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(short_folder / "run"))
    home = short_folder / "home"
    held = meeting.hold(home)
    Path(f"{held.files[0]}{lost}").unlink()
    with monkeypatch.context() as full:
        full.setattr(meeting, "hold", lambda *_: (_ for _ in ()).throw(OSError(28, "No space left on device")))
        held = meeting.hold_again(held, home)
    assert held.lock == -1
    held = meeting.hold_again(held, home)
    assert all(path.exists() for path in held.files)
    with pytest.raises(BlockingIOError):
        meeting.hold(home)
    connection = meeting.connect(home)
    assert connection is not None
    connection.close()
    held.close()
