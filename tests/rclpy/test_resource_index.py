"""The resource index, as programs that look for plugins and packages ask it."""

from __future__ import annotations

from pathlib import Path

import pytest
from ament_index_python import (
    InvalidResourceNameError,
    InvalidResourceTypeNameError,
    get_resource,
    get_resource_types,
    get_resources,
    has_resource,
)


@pytest.fixture
def overlay(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """A prefix with one package and one plugin."""
    index = tmp_path / "share" / "ament_index" / "resource_index"
    for kind, name, text in (
        ("packages", "day6_car", ""),
        ("plugins", "wheel", "round\n"),
        ("packages", "rclpy", "mine"),
    ):
        (index / kind).mkdir(parents=True, exist_ok=True)
        (index / kind / name).write_text(text, encoding="utf-8")
    (index / "plugins" / ".hidden").touch()
    (index / "plugins" / "folder").mkdir()
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    return str(tmp_path)


def test_what_an_overlay_has_comes_before_what_is_installed(overlay: str) -> None:
    assert get_resource("plugins", "wheel") == ("round\n", overlay)
    assert get_resource("packages", "rclpy") == ("mine", overlay)
    assert get_resources("plugins") == {"wheel": overlay}
    assert {"packages", "plugins"} <= get_resource_types()
    packages = get_resources("packages")
    assert packages["day6_car"] == packages["rclpy"] == overlay and packages["std_msgs"] not in ("", overlay)


def test_the_packages_that_came_with_us_are_resources_too() -> None:
    content, prefix = get_resource("packages", "std_msgs")
    assert content == "" and prefix == has_resource("packages", "std_msgs")
    assert has_resource("packages", "nope") is False


def test_the_interfaces_of_our_packages_are_resources_as_a_build_registers_them() -> None:
    """As tools ask that list what there is, and tests of programs that must not know packages by name."""
    content, prefix = get_resource("rosidl_interfaces", "std_srvs")
    assert content.split() == ["srv/Empty.srv", "srv/SetBool.srv", "srv/Trigger.srv"]
    assert prefix == has_resource("rosidl_interfaces", "std_srvs") == get_resources("rosidl_interfaces")["std_msgs"]
    assert "rosidl_interfaces" in get_resource_types()
    assert has_resource("rosidl_interfaces", "rclpy") is False


def test_impossible_names_are_refused(overlay: str) -> None:
    with pytest.raises(LookupError, match=r"^Could not find the resource 'nope' of type 'plugins'$"):
        get_resource("plugins", "nope")
    with pytest.raises(InvalidResourceTypeNameError, match=r"^Resource type 'a/b' is invalid$"):
        get_resources("a/b")
    with pytest.raises(InvalidResourceNameError, match="is invalid"):
        has_resource("plugins", "a\\b")
    with pytest.raises(AssertionError, match=r"^The resource type must not be empty$"):
        get_resource("", "x")
