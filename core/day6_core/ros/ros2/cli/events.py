"""Prints the events of services and actions that have introspection switched on."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING, Any

from day6_core.ros.ros2.cli.options import add_length_options

if TYPE_CHECKING:
    from day6_core.session.session import Session


def add_printing_options(parser: ArgumentParser) -> None:
    """Add the options for the format of events."""
    parser.add_argument(
        "--csv", action="store_true", help="Output all recursive fields separated by commas (e.g. for plotting)."
    )
    add_length_options(parser)


class EventPrinter:
    """Prints service events, with the name of the event type instead of its number."""

    def __init__(self, session: Session, args: Namespace) -> None:
        from service_msgs.msg import ServiceEventInfo

        self.session = session
        self.args = args
        names = ("REQUEST_SENT", "REQUEST_RECEIVED", "RESPONSE_SENT", "RESPONSE_RECEIVED")
        self.events = {getattr(ServiceEventInfo, name): name for name in names}
        self.limits: dict[str, Any] = {
            "truncate_length": None if args.full_length else args.truncate_length,
            "no_arr": args.no_arr,
            "no_str": args.no_str,
        }

    def receive(self, message: Any, heading: str = "") -> None:
        """Print one event (or another message of an action) below a heading."""
        from rosidl_runtime_py.convert import message_to_csv, message_to_ordereddict
        from rosidl_runtime_py.yaml_text import dump

        if self.args.csv:
            self.session.print(heading + message_to_csv(message, **self.limits))
            return
        fields = message_to_ordereddict(message, **self.limits)
        info = fields.get("info", {})
        if "event_type" in info:
            info["event_type"] = self.events[info["event_type"]]
        self.session.print(heading + dump(fields, flow_style=self.args.flow_style), end="---\n")
