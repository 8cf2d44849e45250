"""The messages of the demos (demo_nodes, composition, lifecycle, logging_demo, image_tools), from this distribution's package."""

from __future__ import annotations

from importlib import import_module

from day6_core.ros.differences import value

TYPE_CHECKING = False
if TYPE_CHECKING:
    from std_msgs.msg import Bool, Float32, Float64, String
else:
    _messages = import_module(f"{value('demos.messages')}.msg")
    Bool, Float32, Float64, String = _messages.Bool, _messages.Float32, _messages.Float64, _messages.String

__all__ = ["Bool", "Float32", "Float64", "String"]
