"""Moving to another disk, files that grow, jobs that are stopped as a whole, and the desk's link to other processes."""

from __future__ import annotations

import errno
import os
import threading
from pathlib import Path
from typing import Any

import pytest

from day6_core import link
from day6_core.graph.graph import Graph
from day6_core.session.clock import WorldClock
from day6_core.session.streams import Captured, InputStream
from day6_core.shell.desk import Desk
from day6_core.shell.language.redirection import Streams
from tests.shell.conftest import Machine
from tests.support.waiting import until

# -- mv to another disk ------------------------------------------------------------------------------------------------


@pytest.fixture
def disks(machine: Machine, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The home folder, where nothing can be renamed: as if every folder were a disk of its own."""

    def refused(source: object, goal: object, **folders: object) -> None:
        raise OSError(errno.EXDEV, os.strerror(errno.EXDEV))

    monkeypatch.setattr("day6_core.shell.builtins.transfer.os.replace", refused)
    return machine.desk.home


def test_a_file_goes_to_another_disk_with_its_mode_and_time(machine: Machine, disks: Path) -> None:
    (disks / "a").write_text("1", encoding="utf-8")
    (disks / "a").chmod(0o640)
    os.utime(disks / "a", (1_000_000_000, 1_000_000_000))
    assert machine.run("mv -v a b") == (0, "renamed 'a' -> 'b'\n", "")
    assert not (disks / "a").exists() and (disks / "b").read_text(encoding="utf-8") == "1"
    assert (disks / "b").stat().st_mtime == 1_000_000_000
    assert os.name != "posix" or (disks / "b").stat().st_mode & 0o777 == 0o640


@pytest.mark.skipif(os.name != "posix", reason="links need a right elsewhere")
def test_a_folder_and_a_link_go_to_another_disk_whole(machine: Machine, disks: Path) -> None:
    assert machine.run("mkdir -p d/e; echo 1 > d/e/f; ln -s nope d/l; mv d new; mv new/l m").err == ""
    assert not (disks / "d").exists() and (disks / "new" / "e" / "f").read_text(encoding="utf-8") == "1\n"
    assert os.readlink(disks / "m") == "nope" and not os.path.lexists(disks / "new" / "l")


def test_what_did_not_arrive_is_not_removed(machine: Machine, disks: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    machine.run("mkdir d; echo 1 > d/a; echo 2 > d/b")
    opened = os.open

    def failing(path: Any, *more: Any, **named: Any) -> int:
        if Path(path) == disks / "new" / "a":
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return opened(path, *more, **named)

    monkeypatch.setattr("day6_core.shell.builtins.transfer.os.open", failing)
    result = machine.run("mv -v d new")
    assert (result.status, result.err) == (1, "mv: cannot create regular file 'new/a': No space left on device\n")
    assert sorted(path.name for path in (disks / "d").iterdir()) == ["a", "b"]
    assert (disks / "new" / "b").read_text(encoding="utf-8") == "2\n"


def test_a_source_that_cannot_be_removed_is_told(
    machine: Machine, disks: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    machine.run("mkdir d; echo 1 > f")

    def refused(path: object, **folders: object) -> None:
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))

    monkeypatch.setattr("day6_core.shell.builtins.files.deep.os.rmdir", refused)
    result = machine.run("mv -v d new")
    assert result == (1, "", f"mv: cannot remove 'd': {os.strerror(errno.EACCES)}\n")
    assert (disks / "d").is_dir() and (disks / "new").is_dir()


def test_another_reason_than_the_disk_is_told(machine: Machine, monkeypatch: pytest.MonkeyPatch) -> None:
    def refused(source: object, goal: object, **folders: object) -> None:
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))

    monkeypatch.setattr("day6_core.shell.builtins.transfer.os.replace", refused)
    assert machine.run("touch a; mv -v a b") == (1, "", f"mv: cannot move 'a' to 'b': {os.strerror(errno.EACCES)}\n")
    assert (machine.desk.home / "a").exists()


def test_cp_f_replaces_a_file_that_cannot_be_opened(machine: Machine, monkeypatch: pytest.MonkeyPatch) -> None:
    goal = machine.desk.home / "b"
    opened = os.open

    def failing(path: Any, flags: int, *more: Any, **named: Any) -> int:
        if Path(path) == goal and flags & os.O_WRONLY and goal.exists():
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        return opened(path, flags, *more, **named)

    monkeypatch.setattr("day6_core.shell.builtins.transfer.os.open", failing)
    machine.run("echo 1 > a")
    goal.write_text("old", encoding="utf-8")
    reason = os.strerror(errno.EACCES)
    assert machine.run("cp a b") == (1, "", f"cp: cannot create regular file 'b': {reason}\n")
    assert goal.read_text(encoding="utf-8") == "old"
    assert machine.run("cp -f a b; cat b") == (0, "1\n", "")


def test_a_file_that_cannot_be_read_is_not_copied(machine: Machine, monkeypatch: pytest.MonkeyPatch) -> None:
    opened = os.open

    def failing(path: Any, *more: Any, **named: Any) -> int:
        if Path(path) == machine.desk.home / "a":
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        return opened(path, *more, **named)

    machine.run("echo 1 > a; echo 2 > c; mkdir d")
    monkeypatch.setattr("day6_core.shell.builtins.transfer.os.open", failing)
    reason = os.strerror(errno.EACCES)
    assert machine.run("cp -v a c d; ls d") == (0, "'c' -> 'd/c'\nc\n", f"cp: cannot open 'a' for reading: {reason}\n")


# -- files that grow ---------------------------------------------------------------------------------------------------


def test_tail_f_prints_what_is_appended_also_after_the_file_was_emptied(machine: Machine) -> None:
    file = machine.desk.home / "f"
    file.write_text("1\n2\n3\n", encoding="utf-8")
    program = machine.start("tail -n 1 -f f")
    machine.go(1)
    assert machine.out.text == "3\n"
    with file.open("a", encoding="utf-8") as more:
        more.write("4\n5")
    machine.go(1)
    assert machine.out.text == "3\n4\n5"
    machine.go(1)
    assert machine.out.text == "3\n4\n5"
    file.write_text("", encoding="utf-8")
    machine.go(1)
    file.write_text("new\n", encoding="utf-8")
    machine.go(1)
    assert machine.out.text == "3\n4\n5new\n"
    program.interrupt()
    machine.go()
    assert program.status == 130


def test_tail_f_follows_several_files_and_one_that_went_away(machine: Machine) -> None:
    home = machine.desk.home
    for name in ("a", "b"):
        (home / name).write_text("", encoding="utf-8")
    program = machine.start("tail -q -f a b nope")
    machine.go(0.1)
    (home / "b").write_text("b\n", encoding="utf-8")
    (home / "a").unlink()
    machine.go(0.3)
    (home / "a").write_text("a again\n", encoding="utf-8")
    machine.go(0.3)
    assert machine.out.text == "b\na again\n"
    program.kill()
    machine.go()


# -- jobs that are stopped as a whole ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "line",
    [
        "(sleep 2; echo done)",
        "timeout 100 bash -c 'sleep 2; echo done'",
        "{ sleep 2; echo done; } | cat",
        "bash -c 'sleep 2; echo done'",
    ],
)
def test_a_stopped_command_stands_still_as_a_whole_and_fg_lets_it_go_on(seat: Any, line: str) -> None:
    seat.line(line)
    seat.settle(1)
    assert "Stopped" in seat.type("\x1a")
    seat.settle(10)
    assert "done" not in seat.look().splitlines()
    seat.line("fg")
    assert "done" in seat.look().splitlines()
    assert seat.terminal.idle


@pytest.mark.parametrize(
    ("line", "status"),
    [
        ("timeout 5 sleep 100", 124),
        ("timeout 100 sleep 1", 0),
        ("timeout -k 1 5 sleep 100", 124),
        ("timeout --preserve-status 5 sleep 100", 143),
        ("timeout -s INT 5 sleep 100", 124),
    ],
)
def test_timeout_ends_with_its_status(machine: Machine, line: str, status: int) -> None:
    assert machine.run(f"{line}; echo $?", seconds=7).out == f"{status}\n"


def test_ctrl_c_ends_what_timeout_started_and_the_line(seat: Any) -> None:
    seat.line("timeout 100 sleep 50; echo after")
    assert [program.session.argv[0] for program in seat.desk.programs.values()].count("sleep") == 1
    assert "after" not in seat.type("\x03").splitlines()
    assert "sleep" not in [program.session.argv[0] for program in seat.desk.programs.values()]
    assert seat.line("echo $?").splitlines()[-2] == "130"


# -- the link ----------------------------------------------------------------------------------------------------------


class Links:
    """Notes which graphs join and leave, and how."""

    def __init__(self) -> None:
        self.joined: list[Graph] = []
        self.left: list[Graph] = []
        self.how: list[dict[str, object]] = []
        self.threads: list[str] = []
        self.problem: Exception | None = None

    def join(self, graph: Graph, **how: object) -> None:
        self.joined.append(graph)
        self.how.append(how)
        self.threads.append(threading.current_thread().name)
        if self.problem is not None:
            raise self.problem


@pytest.fixture
def links(monkeypatch: pytest.MonkeyPatch) -> Links:
    made = Links()
    monkeypatch.delenv("DAY6_LINK", raising=False)
    monkeypatch.setattr(link, "join", made.join)
    monkeypatch.setattr(link, "leave", made.left.append)
    return made


def desk_at(home: Path, **more: Any) -> Desk:
    return Desk(home, domain_id=0, clock=WorldClock(wall=None), **more)


def test_every_graph_is_linked_in_the_background_once_the_link_is_open(tmp_path: Path, links: Links) -> None:
    desk = desk_at(tmp_path, listen="tcp/0.0.0.0:7", connect="tcp/1.2.3.4:7", secret="s")
    early = desk.graph_of(4)
    assert links.joined == []
    desk.open_link()
    desk.open_link()
    late = desk.graph_of(5)
    assert desk.graph_of(5) is late
    desk.close()
    assert sorted(graph.domain_id for graph in links.joined) == [0, 4, 5] and early in links.joined
    assert set(links.threads) == {"day6-join"}
    doors = {"listen": "tcp/0.0.0.0:7", "connect": "tcp/1.2.3.4:7", "secret": "s", "part": None}
    assert links.how == [{"never_wait": True, **doors}] * 3
    assert sorted(graph.domain_id for graph in links.left) == [0, 4, 5]


def test_a_graph_is_linked_when_a_program_first_uses_it(tmp_path: Path, links: Links) -> None:
    desk = desk_at(tmp_path)
    desk.link_on_demand()
    used: list[object] = []

    async def plain(session: Any) -> int:
        return 0

    async def using(session: Any) -> int:
        used.extend([session.graph, session.graph])
        return 0

    def run(main: Any, domain: str) -> None:
        streams = Streams(InputStream(), Captured(), Captured())
        env = {**desk.environment(), "ROS_DOMAIN_ID": domain}
        program = desk.start_program(["prog"], main, streams, env=env, cwd=desk.home)
        desk.scheduler.advance()
        assert program.status == 0

    run(plain, "0")
    assert links.joined == []
    run(using, "3")
    run(using, "3")
    assert links.joined == [desk.graph_of(3)] and set(used) == {desk.graph_of(3)}
    desk.close()
    assert links.left == [desk.graph_of(3)]


@pytest.mark.parametrize("way", ["open_link", "link_on_demand"])
@pytest.mark.parametrize(("join_link", "off"), [(False, False), (True, True)])
def test_a_desk_for_itself_links_nothing(
    tmp_path: Path, links: Links, monkeypatch: pytest.MonkeyPatch, way: str, join_link: bool, off: bool
) -> None:
    if off:
        monkeypatch.setenv("DAY6_LINK", "off")
    desk = desk_at(tmp_path, join_link=join_link)
    getattr(desk, way)()
    desk.graph_of(2)
    desk.close()
    assert (links.joined, links.left) == ([], [])


def test_a_link_that_cannot_be_opened_is_logged_and_the_desk_works_on(
    tmp_path: Path, links: Links, caplog: pytest.LogCaptureFixture
) -> None:
    links.problem = OSError("no sockets here")
    desk = desk_at(tmp_path)
    desk.open_link()
    desk.close()
    assert "the link could not be opened" in caplog.text and "no sockets here" in caplog.text


@pytest.mark.parametrize("linked", [True, False])
def test_a_started_desk_runs_by_itself_and_links_where_it_may(tmp_path: Path, links: Links, linked: bool) -> None:
    desk = Desk(tmp_path, domain_id=0)
    desk.start(link=linked)
    done = threading.Event()
    desk.scheduler.call_soon_threadsafe(done.set)
    until(done.is_set)
    desk.close()
    desk.close()
    assert len(links.joined) == len(links.left) == linked
