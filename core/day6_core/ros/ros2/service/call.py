"""`ros2 service call`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from importlib import import_module
from typing import TYPE_CHECKING, Any

from day6_core.ros.ros2.cli.completion import request_prototype, service_names, service_types_of_service
from day6_core.ros.ros2.cli.node import PREFIX, appears, plain_node
from day6_core.ros.ros2.cli.options import add_qos_options, add_response_timeout, completed
from day6_core.ros.ros2.cli.pace import Pace
from day6_core.ros.ros2.cli.yaml_text import safe_load

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Call a service"


def add_arguments(parser: ArgumentParser) -> None:
    completed(
        parser.add_argument("service_name", help="Name of the ROS service to call to (e.g. '/add_two_ints')"),
        service_names,
    )
    completed(
        parser.add_argument("service_type", help="Type of the ROS service (e.g. 'std_srvs/srv/Empty')"),
        service_types_of_service,
    )
    source = parser.add_mutually_exclusive_group()
    completed(
        source.add_argument(
            "values",
            nargs="?",
            default="{}",
            help="Values to fill the service request with in YAML format (e.g. '{a: 1, b: 2}'), otherwise the service "
            "request will be published with default values",
        ),
        request_prototype,
    )
    source.add_argument("--stdin", action="store_true", help="Read values from standard input")
    parser.add_argument("-r", "--rate", metavar="N", type=float, help="Repeat the call at a specific rate in Hz")
    add_response_timeout(parser)
    add_qos_options(parser, "service client", "services_default")


async def main(session: Session, args: Namespace) -> str | None:
    from rosidl_runtime_py.set_message import set_message_fields

    from day6_core.ros.ros2.cli.qos import profile_from_options

    if args.rate is not None and args.rate <= 0:
        raise RuntimeError("rate must be greater than zero")
    text = (await session.stdin.read_all()).encode() if args.stdin else args.values
    package, kind = _service_class(args.service_type)
    values = await safe_load(text)
    node = await plain_node(session, f"{PREFIX}_requester_{package}_{kind.__name__}")
    client = node.create_client(kind, args.service_name, qos_profile=profile_from_options(args))
    request = kind.Request()
    try:
        set_message_fields(request, values)
    except Exception as error:
        return f"Failed to populate field: {error}"
    if not client.service_is_ready():
        session.print("waiting for service to become available...")
        if not await appears(session, client.service_is_ready, args.timeout):
            return f"Service is not available after waiting {args.timeout} seconds."
    session.executor.add_node(node)
    pace = Pace(session, 1.0 / args.rate) if args.rate else None
    while True:
        session.print(f"requester: making request: {request!r}\n")
        future = client.call_async(request)
        if not await session.spin_until(future, args.timeout):
            return f"Timed out waiting for service response (timeout: {args.timeout}s)"
        response = future.result()
        if response is None:
            raise RuntimeError(f"Exception while calling service: {future.exception()!r}")
        session.print(f"response:\n{response!r}\n")
        if pace is None:
            return None
        await session.stdout.drain()
        await pace.turn()


def _service_class(type_name: str) -> tuple[str, Any]:
    """Return `(package, class)` of a service type, in which `srv/` may be missing."""
    parts = type_name.split("/")
    if len(parts) == 2:
        parts.insert(1, "srv")
    package = ".".join(parts[:-1])
    if package.startswith("."):
        raise TypeError(f"the 'package' argument is required to perform a relative import for '{package}'")
    try:
        if not all(part.isidentifier() for part in parts[:-1]):
            raise ValueError(type_name)
        kind = getattr(import_module(package), parts[-1])
    except (AttributeError, ModuleNotFoundError, ValueError):
        raise RuntimeError("The passed service type is invalid") from None
    if not (hasattr(kind, "Request") and hasattr(kind, "Response")):
        raise RuntimeError("The passed type is not a service")
    return parts[0], kind
