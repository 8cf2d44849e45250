"""The node of joint_state_publisher as a class for programs of their own: they read and move its joints."""

from __future__ import annotations

import sys
from argparse import ArgumentParser
from collections.abc import Callable, Iterator, MutableMapping
from contextlib import suppress
from pathlib import Path
from typing import Any

import rclpy
from day6_core.ros.programs.joint_state_publisher.joints import FreeJoint
from day6_core.ros.programs.joint_state_publisher.publisher import NAME, OPTIONS
from day6_core.ros.programs.joint_state_publisher.publisher import JointStatePublisher as _Publisher
from rclpy.node import Node
from rclpy.utilities import remove_ros_args

_FIELDS = {"min": "minimum", "max": "maximum"}
_KEYS = ("min", "max", "zero", "position", "velocity", "effort", "continuous", "forward")
_ABSENT = {"continuous": False, "forward": True}
"""What a key has that isn't there; of the others it is None."""


class _Joint(MutableMapping[str, Any]):
    """A joint that can be set, seen as the dictionary that programs know."""

    def __init__(self, joint: FreeJoint) -> None:
        self._joint = joint

    def __getitem__(self, key: str) -> Any:
        value = getattr(self._joint, _FIELDS.get(key, key)) if key in _KEYS else None
        if value is _ABSENT.get(key):
            raise KeyError(key)
        return value

    def __setitem__(self, key: str, value: Any) -> None:
        if key not in _KEYS:
            raise KeyError(key)
        setattr(self._joint, _FIELDS.get(key, key), value)

    def __delitem__(self, key: str) -> None:
        self[key] = _ABSENT.get(key)

    def __iter__(self) -> Iterator[str]:
        return (key for key in _KEYS if key in self)

    def __len__(self) -> int:
        return sum(1 for _ in self)


class JointStatePublisher(Node):
    """Publishes the joints of the description in a file, or of the topic robot_description."""

    def __init__(self, description_file: str | None) -> None:
        super().__init__(NAME, **OPTIONS)  # type: ignore[arg-type]
        text = None if description_file is None else Path(description_file).read_text(encoding="utf-8")
        self._joint_states = _Publisher(self, text)

    @property
    def free_joints(self) -> dict[str, MutableMapping[str, Any]]:
        """The joints that can be set: their limits, zero, position, velocity and effort."""
        return {name: _Joint(joint) for name, joint in self._joint_states.joints.free.items()}

    @property
    def joint_list(self) -> list[str]:
        """The names of all joints, in the order of the description."""
        return self._joint_states.joints.names

    @property
    def dependent_joints(self) -> dict[str, dict[str, Any]]:
        """The joints that follow others: their parent, factor and offset."""
        followers = self._joint_states.joints.followers
        return {
            name: {"parent": each.parent, "factor": each.factor, "offset": each.offset}
            for name, each in followers.items()
        }

    def set_robot_description_update_cb(self, user_cb: Callable[[], None] | None) -> None:
        """Set what is called when another description was read."""
        self._joint_states.on_joints = user_cb

    def set_source_update_cb(self, user_cb: Callable[[], None] | None) -> None:
        """Set what is called when a message of `source_list` moved joints."""
        self._joint_states.on_source = user_cb


def main() -> None:
    """Run the node until Ctrl-C."""
    rclpy.init()
    parser = ArgumentParser()
    parser.add_argument("description_file", help="Robot description file to use", nargs="?", default=None)
    node = JointStatePublisher(parser.parse_args(remove_ros_args(args=sys.argv)[1:]).description_file)
    with suppress(KeyboardInterrupt):
        rclpy.spin(node)
    node.destroy_node()
    rclpy.try_shutdown()
