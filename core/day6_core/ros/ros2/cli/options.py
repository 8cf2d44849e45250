"""Options that several verbs have, and the types of their values with ros2cli's messages."""

from __future__ import annotations

from argparse import Action, ArgumentParser, ArgumentTypeError
from collections.abc import Callable
from typing import Any

from day6_core.graph.qos import CHOICES
from day6_core.ros.ros2.cli.completion import Completer

PROFILES = (
    "unknown",
    "default",
    "system_default",
    "sensor_data",
    "services_default",
    "parameters",
    "parameter_events",
    "action_status_default",
    "best_available",
    "rosout_default",
)

TRUNCATE_LENGTH = 128


def completed(action: Action, completer: Completer) -> Action:
    """Set the completer for the values of an argument; returns the argument."""
    action.completer = completer  # type: ignore[attr-defined]
    return action


def add_discovery_options(parser: ArgumentParser) -> None:
    """Add the options of verbs that create their own node."""
    parser.add_argument(
        "--spin-time",
        type=float,
        help="Spin time in seconds to wait for discovery (only applies when not using an already running daemon)",
    )
    parser.add_argument("-s", "--use-sim-time", action="store_true", help="Enable ROS simulation time")


def add_strategy_options(parser: ArgumentParser) -> None:
    """Add the options of verbs that query the graph through the daemon or their own node."""
    add_discovery_options(parser)
    parser.add_argument("--no-daemon", action="store_true", help="Do not spawn nor use an already running daemon")


def add_response_timeout(parser: ArgumentParser, option: str = "--timeout", default: float | None = None) -> None:
    """Add the longest time that a service may take to respond; without one that is for ever."""
    parser.add_argument(
        option,
        metavar="N",
        type=float,
        default=default,
        help="Maximum time to wait for service response in seconds "
        + ("(default: waits indefinitely)" if default is None else "(default: %(default)s)"),
    )


def add_hidden_option(parser: ArgumentParser, things: str) -> None:
    """Add `--include-hidden-THINGS`, where `things` is 'topics', 'services' or 'nodes'."""
    parser.add_argument(f"--include-hidden-{things}", action="store_true", help=f"Consider hidden {things} as well")


def add_qos_options(parser: ArgumentParser, doing: str, profile: str) -> None:
    """Add the QoS options of `topic echo` (`doing` is 'subscribe') and `topic pub` ('publish')."""

    def overriding(what: str, key: str, rest: str) -> str:
        return f"{what} setting to {doing} with (overrides {key} value of --qos-profile option{rest}"

    parser.add_argument(
        "--qos-profile",
        choices=PROFILES,
        default=profile,
        help=f"Quality of service preset profile to {doing} with (default: {profile})",
    )
    parser.add_argument("--qos-depth", metavar="N", type=int, help=overriding("Queue size", "depth", ")"))
    quality = "Quality of service"
    # In the real tool those of liveliness and its lease lack their closing bracket.
    ends = {"history": ", default: keep_last)", "liveliness": ""}
    for policy in CHOICES:
        parser.add_argument(
            f"--qos-{policy.name}",
            choices=policy.words,
            help=overriding(
                "History of samples" if policy.name == "history" else f"{quality} {policy.name}",
                policy.name,
                ends.get(policy.name, ", default: Compatible profile with running endpoints )"),
            ),
        )
    parser.add_argument(
        "--qos-liveliness-lease-duration-seconds",
        type=float,
        help=overriding(f"{quality} liveliness lease duration", "liveliness lease duration", ""),
    )


def add_length_options(parser: ArgumentParser) -> None:
    """Add the options that limit how much of a message is printed (`service echo` has them too)."""
    parser.add_argument(
        "--full-length",
        "-f",
        action="store_true",
        help="Output all elements for arrays, bytes, and string with a length > '--truncate-length', by default they are "
        "truncated after '--truncate-length' elements with '...''",
    )
    parser.add_argument(
        "--truncate-length",
        "-l",
        type=unsigned_int,
        default=TRUNCATE_LENGTH,
        help=f"The length to truncate arrays, bytes, and string to (default: {TRUNCATE_LENGTH})",
    )
    parser.add_argument("--no-arr", action="store_true", help="Don't print array fields of messages")
    parser.add_argument("--no-str", action="store_true", help="Don't print string fields of messages")
    parser.add_argument(
        "--flow-style",
        action="store_true",
        help="Print collections in the block style (not available with csv format)",
    )


def number_type(convert: Callable[[str], Any], allowed: Callable[[Any], bool], message: str) -> Callable[[str], Any]:
    """Return an argparse type that rejects a wrong value with `message`."""

    def parse(text: str) -> Any:
        try:
            value = convert(text)
        except ValueError:
            raise ArgumentTypeError(message) from None
        if not allowed(value):
            raise ArgumentTypeError(message)
        return value

    return parse


unsigned_int = number_type(int, lambda value: value >= 0, "value must be non-negative integer")
positive_int = number_type(int, lambda value: value > 0, "value must be a positive integer")


def positive_float(text: str) -> float:
    """The argparse type of rates and durations."""
    try:
        value = float(text)
    except ValueError:
        raise ArgumentTypeError("Expects a floating point number") from None
    if value <= 0.0:
        raise ArgumentTypeError("Value must be positive")
    return value


def nonnegative_int(text: str) -> int:
    """The argparse type of counts; argparse itself words the error, with the name of this function, as in ros2cli."""
    value = int(text)
    if value < 0:
        raise ValueError("Value must be positive or zero")
    return value
