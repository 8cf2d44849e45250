"""Where somebody else has been before: whatever lies in the place of the meeting folder is not trusted, and another is found."""

from __future__ import annotations

import os
import socket
import stat
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from day6_core.link import paths
from day6_core.link.paths import LinkError, meeting_place
from tests.link.link_harness import World
from tests.support.waiting import until

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="folders have other rights there")


def make_file(path: Path) -> None:
    path.touch()


def make_dangling_link(path: Path) -> None:
    path.symlink_to(path.with_name("nowhere"))


def make_link_to_folder(path: Path) -> None:
    path.with_name("elsewhere").mkdir(mode=0o700)
    path.symlink_to(path.with_name("elsewhere"))


def make_open_folder(path: Path) -> None:
    path.mkdir()
    path.chmod(0o777)


def make_folder_of_another(path: Path) -> None:
    if os.geteuid() != 0:
        pytest.skip("only root can give a folder to somebody else")
    path.mkdir(mode=0o700)
    os.chown(path, 12345, 12345)


def make_fifo(path: Path) -> None:
    os.mkfifo(path)


TRAPS = [make_file, make_dangling_link, make_link_to_folder, make_open_folder, make_folder_of_another, make_fifo]


@pytest.fixture
def folders(short_folder: Path, monkeypatch: pytest.MonkeyPatch) -> tuple[Path, Path]:
    """The usual folder and the next, as if they were in /tmp and in the home folder."""
    usual, other = short_folder / "usual", short_folder / "home" / "run"
    monkeypatch.setattr(paths, "runtime_folders", lambda: [usual, other])
    return usual, other


@pytest.mark.parametrize("trap", TRAPS)
def test_what_another_user_put_there_is_passed_over(folders: tuple[Path, Path], trap: Callable[[Path], None]) -> None:
    usual, other = folders
    trap(usual)
    before = usual.lstat()
    place = meeting_place(0)
    assert place.folder == other / "0" == meeting_place(0).folder
    assert stat.S_IMODE(place.folder.stat().st_mode) == 0o700
    (reason,) = place.passed_over
    assert str(usual) in reason
    assert usual.lstat().st_mode == before.st_mode


@pytest.mark.parametrize("trap", TRAPS)
def test_a_folder_that_was_named_is_used_or_refused(
    short_folder: Path, monkeypatch: pytest.MonkeyPatch, trap: Callable[[Path], None]
) -> None:
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(short_folder / "trap"))
    trap(short_folder / "trap")
    with pytest.raises(LinkError, match="trap"):
        meeting_place(0)


def test_a_folder_that_others_could_replace_is_passed_over(folders: tuple[Path, Path], short_folder: Path) -> None:
    _, other = folders
    short_folder.chmod(0o777)
    (short_folder / "home").mkdir(mode=0o700)
    assert meeting_place(0).folder == other / "0"


def test_who_comes_later_finds_those_who_had_to_go_elsewhere(folders: tuple[Path, Path]) -> None:
    usual, other = folders
    usual.touch()
    place = meeting_place(0)
    place.own_socket("abc1").touch()
    usual.unlink()
    assert meeting_place(0).folder == place.folder == other / "0"
    place.own_socket("abc1").unlink()
    assert meeting_place(0).folder == usual / "0"


@pytest.mark.process
def test_where_sockets_are_tcp_a_taken_port_is_not_waited_for(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DAY6_LINK", "tcp")
    place = meeting_place(0)
    with socket.socket() as thief:
        thief.bind(("127.0.0.1", place.meeting_port))
        thief.listen()
        one, other = world.here(), world.process(DAY6_LINK="tcp")
        other.node("pupil")
        assert until(lambda: one.nodes() == ["/pupil"])
        assert place.meeting_port != thief.getsockname()[1]
