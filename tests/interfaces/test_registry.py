"""Interfaces are found on the search path, also those of a workspace that is built while the simulator runs."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from day6_core.interfaces import (
    InterfaceNameError,
    UnknownInterfaceError,
    add_prefixes,
    definition_text,
    forget,
    get_action,
    get_interface,
    get_message,
    get_service,
    interface_names,
    packages,
    registry,
    type_hash,
    type_name,
)
from day6_core.interfaces.definition import InvalidSpecification
from day6_core.interfaces.package import package_files
from day6_core.ros.environment import PYTHON_PATH


class Workspace:
    """A prefix with packages, as a build leaves it."""

    def __init__(self, prefix: Path) -> None:
        self.prefix = prefix

    def write(self, name: str, text: str) -> None:
        """Write the text of 'package/kind/Name'."""
        package, kind, own = name.split("/")
        path = self.prefix / "share" / package / kind / f"{own}.{kind}"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Workspace]:
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    yield Workspace(tmp_path)
    forget("parts")


def test_names_become_classes() -> None:
    assert type_name(get_message("std_msgs/msg/String")) == "std_msgs/msg/String"
    assert type_name(get_service("std_srvs/srv/SetBool")) == "std_srvs/srv/SetBool"
    assert type_name(get_action("example_interfaces/action/Fibonacci")) == "example_interfaces/action/Fibonacci"
    assert type_name(get_interface("std_srvs/srv/SetBool_Request")) == "std_srvs/srv/SetBool_Request"


def test_the_class_is_the_one_that_is_imported() -> None:
    from std_msgs.msg import String
    from std_srvs.srv import SetBool

    assert get_message("std_msgs/msg/String") is String
    assert get_service("std_srvs/srv/SetBool") is SetBool
    assert get_interface("std_srvs/srv/SetBool_Response") is SetBool.Response


@pytest.mark.parametrize("name", ["String", "std_msgs/String", "std_msgs/msg/", "a/b/c", "std_msgs/msg/String/x", ""])
def test_a_malformed_name_is_an_error_of_its_own(name: str) -> None:
    with pytest.raises(InterfaceNameError, match=r"is not the full name of an interface, like 'std_msgs/msg/String'$"):
        get_interface(name)


def test_the_kind_asked_for_is_checked() -> None:
    with pytest.raises(InterfaceNameError, match=r"is not the full name of a service, like 'package/srv/Name'$"):
        get_service("std_msgs/msg/String")
    with pytest.raises(InterfaceNameError, match=r"is not the full name of a message"):
        get_message("std_srvs/srv/SetBool")
    with pytest.raises(InterfaceNameError, match="is not the full name of an action"):
        get_action("std_srvs/srv/SetBool")


@pytest.mark.parametrize(
    ("name", "known", "text"),
    [
        ("foo/msg/Bar", False, "unknown interface 'foo/msg/Bar': package 'foo' not found"),
        ("std_msgs/msg/Bar", True, "unknown interface 'std_msgs/msg/Bar': package 'std_msgs' has no such interface"),
        ("std_msgs/msg/string", True, "unknown interface 'std_msgs/msg/string': package 'std_msgs' has no such interface"),
        ("std_msgs/srv/Bar_Request", True, "unknown interface 'std_msgs/srv/Bar': package 'std_msgs' has no such interface"),
        ("../msg/A", False, "unknown interface '../msg/A': package '..' not found"),
    ],
)  # fmt: skip
def test_what_does_not_exist_is_an_unknown_interface(name: str, known: bool, text: str) -> None:
    with pytest.raises(UnknownInterfaceError) as caught:
        get_interface(name)
    assert (str(caught.value), caught.value.package_known) == (text, known)


def test_the_packages_of_an_installation_are_listed() -> None:
    names = packages()
    assert names == sorted(names)
    assert {"std_msgs", "geometry_msgs", "turtlesim", "tf2_msgs", "rcl_interfaces", "example_interfaces"} <= set(names)
    assert interface_names("std_srvs") == ["srv/Empty", "srv/SetBool", "srv/Trigger"]
    assert interface_names("turtlesim") == [
        "msg/Color", "msg/Pose", "srv/Kill", "srv/SetPen", "srv/Spawn", "srv/TeleportAbsolute", "srv/TeleportRelative",
        "action/RotateAbsolute",
    ]  # fmt: skip
    assert interface_names("turtlesim", "action") == ["action/RotateAbsolute"]
    assert interface_names("nothing_like_this") == []


def test_the_text_of_an_interface_is_given_as_it_is() -> None:
    assert "float64 x 0\n" in definition_text("geometry_msgs/msg/Quaternion")
    with pytest.raises(UnknownInterfaceError):
        definition_text("geometry_msgs/msg/Quaternions")


def test_a_workspace_adds_interfaces(workspace: Workspace) -> None:
    workspace.write("parts/msg/Wheel", "float64 radius 0.5 # m\ngeometry_msgs/Point position\nSide side")
    workspace.write("parts/msg/Side", "uint8 LEFT=0\nuint8 RIGHT=1\nuint8 side")
    assert "parts" in packages()
    wheel = get_message("parts/msg/Wheel")
    assert (wheel().radius, wheel().side.RIGHT) == (0.5, 1)
    assert repr(wheel()) == (
        "parts.msg.Wheel(radius=0.5, position=geometry_msgs.msg.Point(x=0.0, y=0.0, z=0.0), "
        "side=parts.msg.Side(side=0))"
    )


@pytest.mark.process
def test_a_program_imports_the_interfaces_of_a_workspace(workspace: Workspace, tmp_path: Path) -> None:
    workspace.write("parts/msg/Wheel", "float64 radius")
    workspace.write("parts/srv/Turn", "float64 angle\n---\nbool done")
    for path, text in package_files("parts", ["msg", "srv"]).items():
        file = tmp_path / "lib" / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    code = "from parts.msg import Wheel; from parts.srv import Turn; print(Wheel(), Turn.Request(angle=1.0))"
    done = subprocess.run(
        [sys.executable, "-S", "-c", code],
        env={**os.environ, "PYTHONPATH": os.pathsep.join([str(PYTHON_PATH), str(tmp_path / "lib")])},
        capture_output=True,
        text=True,
    )
    assert (done.stdout, done.stderr) == ("parts.msg.Wheel(radius=0.0) parts.srv.Turn_Request(angle=1.0)\n", "")


def test_an_interface_that_was_built_anew_replaces_the_old_one(workspace: Workspace) -> None:
    workspace.write("parts/msg/Wheel", "float64 radius")
    workspace.write("parts/msg/Cart", "Wheel[4] wheels")
    old = get_message("parts/msg/Cart"), type_hash(get_message("parts/msg/Cart"))
    workspace.write("parts/msg/Wheel", "float64 radius\nfloat64 width")
    assert get_message("parts/msg/Cart") is old[0]
    forget("parts")
    new = get_message("parts/msg/Cart")
    assert new().wheels[0].get_fields_and_field_types() == {"radius": "double", "width": "double"}
    assert type_hash(new) != old[1]
    assert not hasattr(old[0]().wheels[0], "width")


def test_more_prefixes_can_be_added_while_running(tmp_path: Path) -> None:
    Workspace(tmp_path).write("parts/msg/Late", "int32 a")
    with pytest.raises(UnknownInterfaceError):
        get_message("parts/msg/Late")
    add_prefixes([str(tmp_path)])
    try:
        assert get_message("parts/msg/Late")().a == 0
    finally:
        registry._more_prefixes.remove(str(tmp_path))
        forget("parts")


def test_an_own_package_wins_over_one_of_the_same_name(workspace: Workspace) -> None:
    workspace.write("std_msgs/msg/String", "int32 surprise")
    assert definition_text("std_msgs/msg/String").endswith("string data\n")


def test_a_message_that_contains_itself_is_refused(workspace: Workspace) -> None:
    workspace.write("parts/msg/A", "B b")
    workspace.write("parts/msg/B", "A[] a")
    with pytest.raises(
        InterfaceNameError, match="'parts/msg/A' contains itself: parts/msg/A > parts/msg/B > parts/msg/A"
    ):
        get_message("parts/msg/A")
    workspace.write("parts/msg/B", "int32 a")
    forget("parts")
    assert get_message("parts/msg/A")().b.a == 0


def test_a_field_of_an_unknown_type_names_that_type(workspace: Workspace) -> None:
    workspace.write("parts/msg/A", "Gone b")
    with pytest.raises(UnknownInterfaceError, match="unknown interface 'parts/msg/Gone'"):
        get_message("parts/msg/A")


def test_a_field_python_can_not_name_is_refused(workspace: Workspace) -> None:
    workspace.write("parts/msg/A", "int32 from")
    with pytest.raises(InvalidSpecification, match="'from' is a Python keyword and can not be the name of a field"):
        get_message("parts/msg/A")


def test_defaults_that_are_no_numbers_are_kept(workspace: Workspace) -> None:
    workspace.write("parts/msg/A", "float64 a nan\nfloat64 b -inf\nfloat32[] c [inf, 1]")
    message = get_message("parts/msg/A")()
    assert repr(message) == "parts.msg.A(a=nan, b=-inf, c=[inf, 1.0])"


def test_every_thread_gets_the_same_classes(workspace: Workspace) -> None:
    for number in range(20):
        workspace.write(f"parts/msg/N{number}", f"N{number + 1}[] a\nN{number + 1} b" if number < 19 else "int32 a")
    found: list[list[Any]] = []
    start = threading.Barrier(8)

    def ask() -> None:
        start.wait()
        found.append([get_message(f"parts/msg/N{number}") for number in range(20)])

    threads = [threading.Thread(target=ask) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 8
    assert all(classes == found[0] for classes in found)
