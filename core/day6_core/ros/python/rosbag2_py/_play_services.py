"""The services by which other programs control a player: `/rosbag2_player/pause` and so on."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import rosbag2_interfaces.srv

from day6_core.ros.differences import has_interface

if TYPE_CHECKING:
    from rclpy.node import Node
    from rosbag2_py._playing import Playing

SECOND = 1_000_000_000


def offer_services(node: Node, playing: Playing) -> None:
    """Create the services on the player's node."""

    def empty_response(action: Callable[[], object]) -> Callable[[Any], dict[str, Any]]:
        def run(request: Any) -> dict[str, Any]:
            action()
            return {}

        return run

    def seek(request: Any) -> dict[str, Any]:
        playing.seek(request.time.sec * SECOND + request.time.nanosec)
        return {"success": True}

    def play(request: Any) -> dict[str, Any]:
        # The command lives as long as its playback, so every caller finds one running.
        node.get_logger().warning("Trying to play() while in playback, dismissing request.")
        return {"success": False}

    table: dict[str, tuple[str, Callable[[Any], dict[str, Any]]]] = {
        "pause": ("Pause", empty_response(playing.pause)),
        "resume": ("Resume", empty_response(playing.resume)),
        "toggle_paused": ("TogglePaused", empty_response(playing.toggle_paused)),
        "stop": ("Stop", empty_response(playing.stop)),
        "is_paused": ("IsPaused", lambda request: {"paused": playing.clock.paused}),
        "get_rate": ("GetRate", lambda request: {"rate": playing.clock.rate}),
        "set_rate": ("SetRate", lambda request: {"success": playing.set_rate(request.rate)}),
        "play_next": ("PlayNext", lambda request: {"success": playing.play_next()}),
        "burst": ("Burst", lambda request: {"actually_burst": playing.burst(request.num_messages)}),
        "seek": ("Seek", seek),
        "play": ("Play", play),
    }
    for name, (kind, serve) in table.items():
        if has_interface(f"rosbag2_interfaces/srv/{kind}"):
            node.create_service(getattr(rosbag2_interfaces.srv, kind), f"~/{name}", _callback(serve))


def _callback(serve: Callable[[Any], dict[str, Any]]) -> Callable[[Any, Any], Any]:
    def callback(request: Any, response: Any) -> Any:
        for field, value in serve(request).items():
            setattr(response, field, value)
        return response

    return callback
