"""Someone clears the folder in which the processes of a user meet: a cleaner of /tmp, a log-out that ends XDG_RUNTIME_DIR."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.support.short_sockets import LONGEST
from tests.support.waiting import communicate, until

if TYPE_CHECKING:
    from tests.e2e.place import Place

pytestmark = pytest.mark.person

TALKER = """\
import rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node("talker")
publisher = node.create_publisher(String, "chatter", 10)
node.create_timer(0.05, lambda: publisher.publish(String(data="hello")))
rclpy.spin(node)
"""


def everything(folder: Path) -> None:
    """As at the last log-out."""
    gone = folder.with_name(f"{folder.name}-gone")
    folder.rename(gone)  # at once: whoever looks meanwhile makes files in a new one
    shutil.rmtree(gone)


def files_only(folder: Path) -> None:
    """As macOS's tmp_cleaner does: sockets and folders stay."""
    for path in folder.rglob("*"):
        if path.is_file():
            path.unlink(missing_ok=True)


def sockets_only(folder: Path) -> None:
    for path in folder.rglob("*"):
        if path.is_socket():
            path.unlink(missing_ok=True)


@pytest.mark.parametrize("link", [None, "local"])
@pytest.mark.parametrize("clear", [everything, files_only, sockets_only])
def test_desktop_programs_and_commands_meet_again(
    place: Place, clear: Callable[[Path], None], link: str | None
) -> None:
    place.link = link
    talker = place.file("talker.py", TALKER)
    with place.desktop("--scene", "empty") as screen:
        screen.wait("student@day6:~$")
        screen.line("ros2 run turtlesim turtlesim_node &")
        outside = place.start("python", str(talker))
        until(lambda: {"/talker", "/turtlesim"} <= set(place.nodes()))
        clear(place.runtime)
        late = place.start("python", str(talker), "--ros-args", "-r", "__node:=late")
        until(lambda: {"/talker", "/turtlesim", "/late"} <= set(place.nodes()))
        # What a command in a real terminal has seen reaches the desktop's own graph a moment later.
        screen.line("until ros2 node list | grep -c talker; do sleep 0.1; done; ros2 topic echo --once /chatter")
        screen.wait_lines("data: hello")
        for program in (outside, late):
            program.terminate()
            assert "panicked" not in communicate(program)[1]
        until(lambda: set(place.nodes()) & {"/talker", "/late", "/turtlesim"} == {"/turtlesim"})
        assert "panicked" not in screen.look()


def test_in_the_longest_folder_that_is_used_no_path_of_a_socket_is_longer_than_macos_allows(place: Place) -> None:
    shutil.rmtree(place.runtime)
    place.runtime = place.runtime / ("x" * (100 - len("/0/p-0123456789abcdef-4194304.lock") - len(f"{place.runtime}/")))
    with place.desktop("--scene", "empty", "--detach") as screen:
        screen.wait("student@day6:~$")
        found: set[Path] = set()

        def all_kinds() -> bool:  # the desktop makes them one by one, after its first prompt
            found.update(path for path in place.runtime.rglob("*") if path.is_socket())
            return {path.name[:2] for path in found} == {"p-", "me", "de"}

        until(all_kinds)
        assert max(len(os.fsencode(path)) for path in found) <= LONGEST


@pytest.mark.parametrize("clear", [everything, files_only, sockets_only])
def test_a_detached_desktop_is_found_again(place: Place, clear: Callable[[Path], None]) -> None:
    with place.desktop("--scene", "empty", "--detach") as screen:
        screen.wait("student@day6:~$")
        found = list(place.runtime.glob("desktop-*"))
        clear(place.runtime)
        until(lambda: all(path.exists() for path in found))
        with place.terminal("attach", "--home", str(place.home), "--lang", "en") as other:
            other.wait("student@day6:~$")
            other.quit()
            assert other.wait_end() == 0
