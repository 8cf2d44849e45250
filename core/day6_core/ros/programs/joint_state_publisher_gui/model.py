"""The model of the slider window: the joints that can be set, as numbers from 0 to 10000, and what the window may do.

The window runs on another thread. It only makes requests; the program's thread carries them out, so that a joint has one owner.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from day6_core.ros.programs.joint_state_publisher.joints import FreeJoint
from day6_core.ros.programs.joint_state_publisher.publisher import JointStatePublisher

if TYPE_CHECKING:
    pass

RANGE = 10_000
"""Steps of a slider (joint_state_publisher_gui.py)."""


@dataclass(frozen=True, slots=True)
class Slider:
    """One joint: radians or metres; `step` is the slider's place, 0 to 10000."""

    name: str
    minimum: float
    maximum: float
    value: float
    step: int
    turns: bool


@dataclass(frozen=True, slots=True)
class Request:
    """What the window wants: 'center', 'randomize', 'zero' (of one joint), 'step' (to a place) or 'value' (an exact number)."""

    kind: str
    joint: str = ""
    number: float = 0.0


class SliderModel:
    """The sliders of one joint_state_publisher. The window reads and calls `request`; everything else is the program's."""

    def __init__(self, publisher: JointStatePublisher, seed: int) -> None:
        self._publisher = publisher
        self._joints: dict[str, FreeJoint] = {}
        self._random = random.Random(seed)
        self._requests: list[Request] = []
        self._others: tuple[str, ...] = ()
        self.sliders: tuple[Slider, ...] = ()
        self.described = False
        """A description was read (it may have no joint to set)."""
        self.version = 0
        self.on_request: Callable[[], object] | None = None
        """Called (any thread) when the window wants something."""
        publisher.on_joints = self.take_joints
        publisher.on_source = self._follow_sources

    # -- the window's side ---------------------------------------------------------------------------------------------

    def request(self, kind: str, joint: str = "", number: float = 0.0) -> None:
        self._requests.append(Request(kind, joint, number))
        if self.on_request is not None:
            self.on_request()

    @property
    def others(self) -> tuple[str, ...]:
        """Other nodes that publish on the same topic: they and this one pull the robot back and forth."""
        return self._others

    # -- the program's side --------------------------------------------------------------------------------------------

    def take_joints(self) -> None:
        """There is another robot: make its sliders, all at their zero."""
        free = self._publisher.joints.free
        self._joints = {
            name: free[name] for name in self._publisher.joints.names if name in free and _can_slide(free[name])
        }
        self.described = True
        self._center()

    def handle_requests(self) -> None:
        """Carry out what the window requested."""
        while self._requests:
            request = self._requests.pop(0)
            joint = self._joints.get(request.joint)
            if request.kind == "center":
                self._center()
            elif request.kind == "randomize":
                self._randomize()
            elif joint is not None:
                _set(joint, request)
        self._show()

    def look_around(self) -> None:
        """See who else publishes joint states; called a few times a second."""
        node = self._publisher.node
        topic = node.resolve_topic_name("joint_states")
        infos = [(info.node_namespace.rstrip("/"), info.node_name) for info in node.get_publishers_info_by_topic(topic)]
        # Leave out this node itself; a second node of the same name then still counts.
        mine = (node.get_namespace().rstrip("/"), node.get_name())
        if mine in infos:
            infos.remove(mine)
        others = tuple(sorted(f"{namespace}/{name}".lstrip("/") for namespace, name in infos))
        if others != self._others:
            self._others = others
            self.version += 1

    def _center(self) -> None:
        self._publisher.node.get_logger().info("Centering")
        for joint in self._joints.values():
            _to_step(joint, _step_of(joint, joint.zero))
        self._show()

    def _randomize(self) -> None:
        self._publisher.node.get_logger().info("Randomizing")
        for joint in self._joints.values():
            _to_step(joint, _step_of(joint, self._random.uniform(joint.minimum, joint.maximum)))

    def _follow_sources(self) -> None:
        for joint in self._joints.values():
            if joint.position is not None:
                _to_step(joint, _step_of(joint, joint.position))
        self._show()

    def _show(self) -> None:
        sliders = tuple(_slider(joint) for joint in self._joints.values())
        if sliders != self.sliders or not self.version:
            self.sliders = sliders
            self.version += 1


def _can_slide(joint: FreeJoint) -> bool:
    """A joint whose limits are equal is not shown (the original); neither is one whose limits are no numbers."""
    return math.isfinite(joint.minimum) and math.isfinite(joint.maximum) and joint.minimum != joint.maximum


def _set(joint: FreeJoint, request: Request) -> None:
    if request.kind == "zero":
        _to_step(joint, _step_of(joint, joint.zero))
    elif request.kind == "step":
        _to_step(joint, int(request.number))
    elif request.kind == "value":
        low, high = sorted((joint.minimum, joint.maximum))
        joint.position = min(max(request.number, low), high)


def _to_step(joint: FreeJoint, step: int) -> None:
    """Move the joint to a place of its slider: so it has one of 10001 values, as in the original."""
    step = min(max(step, 0), RANGE)
    joint.position = joint.minimum + (joint.maximum - joint.minimum) * (step / RANGE)


def _step_of(joint: FreeJoint, value: float) -> int:
    return int((value - joint.minimum) * RANGE / (joint.maximum - joint.minimum))


def _slider(joint: FreeJoint) -> Slider:
    value = joint.position if joint.position is not None else joint.zero
    return Slider(joint.name, joint.minimum, joint.maximum, value, _step_of(joint, value), joint.turns)
