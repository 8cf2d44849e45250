"""Someone clears the folder in which the processes of a user meet: a cleaner of /tmp, a log-out that ends XDG_RUNTIME_DIR."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

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
    shutil.rmtree(folder)


def files_only(folder: Path) -> None:
    """As macOS's tmp_cleaner does: sockets and folders stay."""
    for path in folder.rglob("*"):
        if path.is_file():
            path.unlink()


def sockets_only(folder: Path) -> None:
    for path in folder.rglob("*"):
        if path.is_socket():
            path.unlink()


@pytest.mark.parametrize("clear", [everything, files_only, sockets_only])
def test_desktop_programs_and_commands_meet_again(place: Place, clear: Callable[[Path], None]) -> None:
    talker = place.file("talker.py", TALKER)
    with place.desktop("--scene", "empty") as screen:
        screen.wait("student@day6:~$")
        screen.line("ros2 run turtlesim turtlesim_node &")
        outside = place.start("python", str(talker))
        until(lambda: {"/talker", "/turtlesim"} <= set(place.nodes()))
        clear(place.runtime)
        late = place.start("python", str(talker), "--ros-args", "-r", "__node:=late")
        until(lambda: {"/talker", "/turtlesim", "/late"} <= set(place.nodes()))
        screen.line("ros2 topic echo --once /chatter")
        screen.wait_lines("data: hello")
        screen.line("ros2 node list")
        screen.wait_lines("/talker")
        for program in (outside, late):
            program.terminate()
            assert "panicked" not in communicate(program)[1]
        until(lambda: set(place.nodes()) & {"/talker", "/late", "/turtlesim"} == {"/turtlesim"})
        assert "panicked" not in screen.look()


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
