"""The node of this package that a container can load."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.action_tutorials_cpp.fibonacci_action_server import FibonacciActionServer

if TYPE_CHECKING:
    from day6_core.ros.programs._component import Component

COMPONENTS: dict[str, type[Component]] = {"action_tutorials_cpp::FibonacciActionServer": FibonacciActionServer}
