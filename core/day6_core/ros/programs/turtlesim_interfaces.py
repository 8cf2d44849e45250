"""The interfaces of turtlesim, from the package that has them in this distribution: turtlesim or turtlesim_msgs."""

from __future__ import annotations

from importlib import import_module

from day6_core.ros.differences import value

PACKAGE: str = value("turtlesim.interfaces")
_messages, _services = import_module(f"{PACKAGE}.msg"), import_module(f"{PACKAGE}.srv")

Color, Pose = _messages.Color, _messages.Pose
Kill, SetPen, Spawn = _services.Kill, _services.SetPen, _services.Spawn
TeleportAbsolute, TeleportRelative = _services.TeleportAbsolute, _services.TeleportRelative
RotateAbsolute = import_module(f"{PACKAGE}.action").RotateAbsolute
