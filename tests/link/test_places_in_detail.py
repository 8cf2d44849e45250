"""The meeting place, file by file: names, ports, passwords, who is alive, what the dead left; no session is opened."""

from __future__ import annotations

import os
import shutil
import socket
import stat
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from zlib import crc32

import pytest

from day6_core.link import paths
from day6_core.link.paths import (
    LinkError,
    MeetingPlace,
    Neighbour,
    Neighbourhood,
    close_inherited_sockets,
    meeting_place,
    neighbours,
    password,
    process_exists,
    remove_dead_sockets,
    remove_if_deaf,
)

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="there are no Unix sockets")


@pytest.fixture
def place(short_folder: Path) -> MeetingPlace:
    return MeetingPlace(short_folder, False)


@pytest.fixture
def tcp_place(short_folder: Path) -> MeetingPlace:
    return MeetingPlace(short_folder, True)


@pytest.fixture(scope="module")
def dead() -> int:
    """The id of a process that has ended."""
    with subprocess.Popen([sys.executable, "-c", ""]) as process:
        process.wait()
    return process.pid


@pytest.fixture
def listening(short_folder: Path) -> Iterator[Path]:
    """A socket on which somebody listens, whose process id means nothing here."""
    path = short_folder / "p-abc-999999999"
    with socket.socket(socket.AF_UNIX) as other:
        other.bind(str(path))
        other.listen()
        yield path


def leave_a_socket(path: Path) -> None:
    """Make a socket on which nobody listens any more."""
    with socket.socket(socket.AF_UNIX) as other:
        other.bind(str(path))


# -- names and ports ---------------------------------------------------------------------------------------------------


def test_everything_has_its_name_in_the_folder(place: MeetingPlace, tcp_place: MeetingPlace) -> None:
    folder, pid = place.folder, os.getpid()
    assert place.meeting_endpoint == f"unixsock-stream/{folder}/meet"
    assert place.own_endpoint("abc") == f"unixsock-stream/{folder}/p-abc-{pid}"
    assert (place.meeting_lock, place.own_socket("abc")) == (folder / "meeting.lock", folder / f"p-abc-{pid}")
    port = 21000 + crc32(os.fsencode(folder)) % 10000
    assert tcp_place.meeting_endpoint == f"tcp/127.0.0.1:{port}"
    assert tcp_place.own_endpoint("abc") == "tcp/127.0.0.1:0"


def test_another_port_may_be_chosen_and_is_remembered(tcp_place: MeetingPlace) -> None:
    before = tcp_place.meeting_port
    tcp_place.choose_another_port()
    chosen = tcp_place.meeting_port
    assert chosen != before and 1024 <= chosen <= 65535
    file = tcp_place.folder / "port"
    assert stat.S_IMODE(file.stat().st_mode) == 0o600 and file.read_text() == str(chosen)
    assert [path.name for path in tcp_place.folder.iterdir()] == ["port"]
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", chosen))  # it was free
    file.write_text("54321 and more")
    assert tcp_place.meeting_port == 54321
    file.write_text("nonsense")
    assert tcp_place.meeting_port == before


# -- which folder ------------------------------------------------------------------------------------------------------


def test_a_folder_too_long_for_sockets_gives_way_to_a_short_one(
    short_folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # p-<16 digits>-<7 digits>.lock are 31 characters, the domain's folder 3 with its slashes.
    longest = 100 - 31 - len("/0/")
    fits = short_folder / ("x" * (longest - len(str(short_folder)) - 1))
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(fits))
    assert meeting_place(0).folder == fits / "0"
    assert str(meeting_place(100).folder).startswith(f"/tmp/day6-{os.getuid()}/"), "100 is two characters longer"
    monkeypatch.setenv("DAY6_RUNTIME_DIR", f"{fits}y")
    folder = meeting_place(0).folder
    assert folder == Path(f"/tmp/day6-{os.getuid()}/{crc32(os.fsencode(f'{fits}y')):08x}/0")
    assert stat.S_IMODE(folder.parent.parent.stat().st_mode) == 0o700
    link = short_folder / "link"
    link.symlink_to(fits.with_name(f"{fits.name}y"))
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(link))
    behind = meeting_place(0).folder
    assert behind.parent.parent == folder.parent.parent, "some use the true name, which is longer"
    shutil.rmtree(behind.parent)
    monkeypatch.setenv("DAY6_RUNTIME_DIR", f"{fits}y")
    monkeypatch.setenv("DAY6_LINK", "tcp")
    assert meeting_place(0).folder == Path(f"{fits}y/0")
    for made in (folder.parent, folder.parent.with_name(f"{crc32(os.fsencode(fits)):08x}")):
        shutil.rmtree(made)


def test_the_usual_folders_in_their_order(short_folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("DAY6_RUNTIME_DIR", raising=False)
    monkeypatch.setenv("HOME", str(short_folder))
    usual = [Path(f"/tmp/day6-{os.getuid()}"), short_folder / ".cache/day6-tui/run"]
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(short_folder))
    assert paths.runtime_folders() == [short_folder / "day6", *usual]
    for nothing in ("", str(short_folder / "gone")):
        monkeypatch.setenv("XDG_RUNTIME_DIR", nothing)
        assert paths.runtime_folders() == usual
    monkeypatch.setenv("DAY6_RUNTIME_DIR", "here")
    assert paths.runtime_folders() == [Path.cwd() / "here"]


@pytest.mark.parametrize(
    ("mode", "above", "words"),
    [
        (0o755, 0o755, None),
        (0o700, 0o1777, None),
        (0o775, 0o755, "other users could write to "),
        (0o757, 0o755, "other users could write to "),
        (0o700, 0o777, "other users could replace "),
    ],
)
def test_a_folder_must_be_ones_own(short_folder: Path, mode: int, above: int, words: str | None) -> None:
    parent = short_folder / "parent"
    folder = parent / "mine"
    folder.mkdir(parents=True)
    folder.chmod(mode)
    parent.chmod(above)
    if words is None:
        paths._private_folder(folder)
        assert stat.S_IMODE(folder.stat().st_mode) == 0o700
    else:
        with pytest.raises(LinkError) as raised:
            paths._private_folder(folder)
        assert str(raised.value) == f"{words}{folder}"
        assert stat.S_IMODE(folder.stat().st_mode) == mode


def test_a_folder_that_cannot_be_made_is_told_with_the_systems_words(short_folder: Path) -> None:
    (short_folder / "file").touch()
    with pytest.raises(LinkError, match=f"{short_folder}/file/mine: Not a directory"):
        paths._private_folder(short_folder / "file" / "mine")


# -- who is there ------------------------------------------------------------------------------------------------------


@pytest.mark.process
def test_neighbours_are_the_sockets_of_processes_that_live(place: MeetingPlace, dead: int) -> None:
    for name in (f"p-abc-{os.getpid()}", f"p-def-{dead}", "p-x-y", "q-abc-1", "meet", f"p-abc-{os.getpid()}.lock"):
        (place.folder / name).touch()
    own = place.own_socket("abc")
    assert list(neighbours(place)) == [Neighbour("abc", os.getpid(), own)]


@pytest.mark.process
def test_a_neighbourhood_sees_who_comes_and_who_was_killed_though_the_folder_stays_as_it_is(
    place: MeetingPlace,
) -> None:
    neighbourhood = Neighbourhood(place)
    assert "abc" not in neighbourhood
    with subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE) as process:
        (place.folder / f"p-abc-{process.pid}").touch()
        os.utime(place.folder, ns=(1, 1))  # some file systems count in seconds
        assert "abc" in neighbourhood and "def" not in neighbourhood
        process.kill()
    assert "abc" not in neighbourhood
    shutil.rmtree(place.folder)
    with pytest.raises(FileNotFoundError):
        neighbourhood.__contains__("abc")


def test_of_two_who_come_within_one_tick_of_the_clock_both_are_seen(place: MeetingPlace) -> None:
    neighbourhood = Neighbourhood(place)
    now = time.time_ns()
    for zid in ("abc", "def"):
        (place.folder / f"p-{zid}-{os.getpid()}").touch()
        os.utime(place.folder, ns=(now, now))
        assert zid in neighbourhood


@pytest.mark.process
def test_what_the_dead_left_is_removed_with_its_lock(place: MeetingPlace, dead: int, listening: Path) -> None:
    gone, here = place.folder / f"p-def-{dead}", place.own_socket("abc")
    for path in (gone, here):
        leave_a_socket(path)
        path.with_name(f"{path.name}.lock").touch()
    remove_dead_sockets(place)
    assert not gone.exists() and not gone.with_name(f"{gone.name}.lock").exists()
    assert here.exists() and here.with_name(f"{here.name}.lock").exists()
    assert listening.exists(), "a process of another container listens"


@pytest.mark.process
def test_signs_of_the_dead_are_removed_where_sockets_are_tcp(tcp_place: MeetingPlace, dead: int) -> None:
    gone, here = tcp_place.folder / f"p-def-{dead}", tcp_place.own_socket("abc")
    gone.touch()
    here.touch()
    remove_dead_sockets(tcp_place)
    assert not gone.exists() and here.exists()


@pytest.mark.process
def test_an_old_socket_on_which_nobody_listens_is_removed(
    place: MeetingPlace, listening: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def neighbour(path: Path) -> Neighbour:
        return Neighbour("abc", os.getpid(), path)

    def made(name: str, seconds: float) -> Path:
        path = place.folder / name
        leave_a_socket(path)
        os.utime(path, (time.time() - seconds,) * 2)
        return path

    old = made("p-a-1", 11.0)
    assert remove_if_deaf(neighbour(old)) and not old.exists()
    assert remove_if_deaf(neighbour(old)), "it is gone"
    young = made("p-b-1", 9.0)
    now = young.stat().st_mtime + 9.0
    with monkeypatch.context() as patched:
        patched.setattr(time, "time", lambda: now)  # it stays young however long this takes
        assert not remove_if_deaf(neighbour(young)) and young.exists()
    os.utime(listening, (0, 0))
    assert not remove_if_deaf(neighbour(listening)) and listening.exists()
    file = place.folder / "p-c-1"
    file.touch()
    os.utime(file, (0, 0))
    assert not remove_if_deaf(neighbour(file)) and file.exists()


def test_what_another_process_removes_first_is_no_error(place: MeetingPlace, monkeypatch: pytest.MonkeyPatch) -> None:
    first, second = place.folder / "p-a-1", place.folder / "p-b-1"
    for path in (first, second):
        leave_a_socket(path)
        os.utime(path, (0, 0))
    monkeypatch.setattr(paths, "process_exists", lambda pid: False)

    def refuses(path: Path) -> bool:
        path.unlink()
        return True

    monkeypatch.setattr(paths, "_refuses", refuses)
    assert remove_if_deaf(Neighbour("a", 1, first))
    remove_dead_sockets(place)
    assert list(place.folder.iterdir()) == []


@pytest.mark.process
def test_a_process_exists_as_long_as_it_lives(dead: int) -> None:
    assert process_exists(os.getpid()) and process_exists(1)
    assert not process_exists(dead)


def test_a_process_of_another_user_exists(monkeypatch: pytest.MonkeyPatch) -> None:
    def kill(pid: int, number: int) -> None:
        assert (pid, number) == (5, 0)
        raise PermissionError

    monkeypatch.setattr(os, "kill", kill)
    assert process_exists(5)


@pytest.mark.skipif(not Path("/dev/fd").is_dir(), reason="open files cannot be listed")
def test_a_child_closes_the_sockets_of_the_place_and_no_others(place: MeetingPlace) -> None:
    own, peer = socket.socket(socket.AF_UNIX), socket.socket(socket.AF_UNIX)
    elsewhere, file = [*socket.socketpair(), socket.create_server(("127.0.0.1", 0))], (place.folder / "file").open("w")
    own.bind(str(place.folder / "meet"))
    own.listen()
    peer.connect(str(place.folder / "meet"))
    close_inherited_sockets(place)
    for closed in (own, peer):
        with pytest.raises(OSError):
            os.fstat(closed.fileno())
        closed.detach()
    for kept in (*elsewhere, file):
        os.fstat(kept.fileno())
        kept.close()


# -- the password ------------------------------------------------------------------------------------------------------


def test_all_processes_read_one_password_from_a_file_of_their_user(tcp_place: MeetingPlace) -> None:
    word = password(tcp_place)
    assert len(word) == 32 and int(word, 16) >= 0
    assert password(tcp_place) == word
    secret, users = tcp_place.folder / "secret", tcp_place.folder / "users"
    assert (secret.read_text(), users.read_text()) == (word, f"day6:{word}\n")
    assert {stat.S_IMODE(path.stat().st_mode) for path in (secret, users)} == {0o600}
    assert sorted(path.name for path in tcp_place.folder.iterdir()) == ["secret", "users"]


def test_two_places_do_not_share_a_password(short_folder: Path) -> None:
    words = []
    for name in ("a", "b"):
        (short_folder / name).mkdir()
        words.append(password(MeetingPlace(short_folder / name, True)))
    assert words[0] != words[1]


def test_a_file_without_a_password_is_told_after_a_second(
    tcp_place: MeetingPlace, monkeypatch: pytest.MonkeyPatch
) -> None:
    clock = iter((0.0, 0.5, 0.9, 1.1))
    monkeypatch.setattr(paths.time, "monotonic", lambda: next(clock))
    monkeypatch.setattr(paths.time, "sleep", lambda seconds: None)
    (tcp_place.folder / "secret").write_text("half")
    with pytest.raises(LinkError, match="secret holds no password; remove it"):
        password(tcp_place)


# -- configurations ----------------------------------------------------------------------------------------------------


def test_sessions_listen_and_connect_where_their_kind_does(place: MeetingPlace, tcp_place: MeetingPlace) -> None:
    import json

    from day6_core.link import config

    def settings(made: object, *names: str) -> list[object]:
        return [json.loads(made.get_json(name)) for name in names]  # type: ignore[attr-defined]

    names = ("mode", "listen/endpoints", "connect/endpoints", "connect/exit_on_failure", "connect/timeout_ms")
    meet, own = place.meeting_endpoint, place.own_endpoint("abc")
    assert settings(config.process_config(place, "abc"), *names) == ["peer", [own], [meet], False, -1]
    assert settings(config.command_config(place, "abc"), "mode", *names[2:]) == ["client", [meet], True, 0]
    assert settings(config.meeting_config(place), *names[:2]) == ["router", [meet]]
    assert settings(config.inner_config(place), *names) == ["router", [], [meet], False, -1]
    outer = config.outer_config(["tcp/0.0.0.0:1"], ["tcp/a:2"], "chalk-and-sponge", place.folder / "guests")
    assert settings(outer, *names) == ["router", ["tcp/0.0.0.0:1"], ["tcp/a:2"], False, -1]
    assert settings(outer, "transport/unicast/max_sessions", "transport/link/rx/max_message_size") == [200, 64 << 20]
    assert settings(outer, "scouting/multicast/enabled", "transport/shared_memory/enabled") == [False, False]
    assert settings(outer, "transport/auth/usrpwd/user") == ["day6"]
    open_door = config.outer_config(["tcp/0.0.0.0:1"], [], None, place.folder / "guests")
    assert settings(open_door, "transport/auth/usrpwd/user") == [None]
    assert settings(config.inner_config(place), "transport/auth/usrpwd/user") == [None]
    assert settings(config.inner_config(tcp_place), "transport/auth/usrpwd/user") == ["day6"]
    assert settings(config.process_config(place, "abc"), "id") == ["abc"]
