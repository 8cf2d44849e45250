"""`ros2 doctor`: checks a graph for common problems and reports on this machine. It needs no internet."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from day6_core.ros.differences import value
from day6_core.ros.ros2.cli.node import graph_node, services
from day6_core.session.threads import in_thread

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node

SUMMARY = "Check ROS setup and other potential issues"
_SKIPPED = ("/parameter_events", "/rosout")


class Finding(NamedTuple):
    """One finding; warnings do not fail a check unless `--include-warnings` is given."""

    is_error: bool
    text: str


def add_arguments(parser: ArgumentParser) -> None:
    reports = parser.add_mutually_exclusive_group()
    reports.add_argument("--report", "-r", action="store_true", help="Print all reports.")
    reports.add_argument("--report-failed", "-rf", action="store_true", help="Print reports of failed checks only.")
    parser.add_argument("--exclude-packages", "-ep", action="store_true", help="Exclude package checks or report.")
    parser.add_argument(
        "--include-warnings",
        "-iw",
        action="store_true",
        help="Include warnings as failed checks. Warnings are ignored by default.",
    )


async def main(session: Session, args: Namespace) -> None:
    if args.report or args.report_failed:
        await in_thread(_query_platform)
    async with graph_node(session) as node:
        if args.report:
            for title, (category, _) in reports().items():
                if category != "package" or not args.exclude_packages:
                    _print_report(session, node, title)
            return
        failed: list[str] = []
        for category, check in CHECKS.items():
            findings = list(check(session, node))
            for finding in findings:
                _warn(session, finding)
            if any(finding.is_error or args.include_warnings for finding in findings):
                failed.append(category)
        if not failed:
            session.print(f"\nAll {len(CHECKS)} checks passed\n")
            return
        session.print(f"\n{len(failed)}/{len(CHECKS)} check(s) failed\n")
        session.print("Failed modules:", *failed)
        if args.report_failed:
            for title, (category, _) in reports().items():
                if category in failed:
                    _print_report(session, node, title)


def _warn(session: Session, finding: Finding) -> None:
    """Print a warning; the real one puts a file and a line of ros2doctor before it, for which there is nothing here."""
    error = "ERROR: " if finding.is_error else ""
    session.print_error(f"UserWarning: {error}{finding.text}")


def _print_report(session: Session, node: Node, title: str) -> None:
    session.print(*report_lines(title, list(REPORTS[title][1](session, node))), sep="\n")


def report_lines(title: str, rows: Sequence[tuple[str, object]]) -> list[str]:
    """Return a report as it is printed."""
    longest = max((len(name) for name, _ in rows), default=0)
    width = longest + 4 if longest >= 8 else 8
    return [f"\n   {title}", *(f"{name:{width}}: {value}" for name, value in rows)]


async def findings(session: Session, category: str) -> list[Finding]:
    """Return what one check finds."""
    async with graph_node(session) as node:
        return list(CHECKS[category](session, node))


async def rows(session: Session, title: str) -> list[tuple[str, object]]:
    """Return the rows of one report."""
    await in_thread(_query_platform)
    async with graph_node(session) as node:
        return list(REPORTS[title][1](session, node))


def _check_network(session: Session, node: Node) -> Iterator[Finding]:
    """Check whether other programs can see this command's graph, and the connections to other machines."""
    import os

    from day6_core.link import state_of
    from day6_core.ros.programs.day6_inspector.rules import link_findings

    if session.graph is not None:
        for finding in link_findings(state_of(session.graph)):
            yield Finding(finding.level == "error", finding.text)
    if os.environ.get("DAY6_LINK") == "off":
        yield Finding(False, "The link to other programs is switched off (DAY6_LINK=off).")


def _check_qos(session: Session, node: Node) -> Iterator[Finding]:
    from rclpy.qos import QoSCompatibility

    for topic, _, _, compatibility, reason in _pairs(node):
        text = reason.partition(": ")[2] if reason.lower().startswith(("warning: ", "error: ")) else reason
        if compatibility == QoSCompatibility.WARNING:
            yield Finding(False, f"QoS compatibility warning found on topic '{topic}': {text}")
        elif compatibility == QoSCompatibility.ERROR:
            yield Finding(True, f"QoS compatibility error found on topic '{topic}': {text}")


def _check_topics(session: Session, node: Node) -> Iterator[Finding]:
    for topic, _ in node.get_topic_names_and_types():
        publishers, subscribers = node.count_publishers(topic), node.count_subscribers(topic)
        if topic in _SKIPPED:
            continue
        if publishers and not subscribers:
            yield Finding(False, f"Publisher without subscriber detected on {topic}.")
        elif subscribers and not publishers:
            yield Finding(False, f"Subscriber without publisher detected on {topic}.")


def _pairs(node: Node) -> Iterator[tuple[str, Any, Any, Any, str]]:
    """Yield `(topic, publisher, subscription, compatibility, reason)` for every publisher and subscription of every topic."""
    from rclpy.qos import qos_check_compatible

    for topic, _ in node.get_topic_names_and_types():
        for publisher in node.get_publishers_info_by_topic(topic):
            for subscription in node.get_subscriptions_info_by_topic(topic):
                compatibility, reason = qos_check_compatible(publisher.qos_profile, subscription.qos_profile)
                yield topic, publisher, subscription, compatibility, reason


def _report_network(session: Session, node: Node) -> Iterator[tuple[str, object]]:
    from day6_core.link import state_of
    from day6_core.ros.programs.day6_inspector.rules import link_findings
    from day6_core.ros.ros2.doctor._network import interfaces

    if session.graph is not None:
        yield from (("link", finding.text) for finding in link_findings(state_of(session.graph)))
    for interface in interfaces():
        yield from ((name, value) for name, value in interface.items() if value)


def _report_packages(session: Session, node: Node) -> Iterator[tuple[str, object]]:
    """Report the installed packages. Their newest versions are on the internet only, which this machine may not reach."""
    from pathlib import Path
    from xml.etree import ElementTree

    from day6_core.ros.ros2.cli.packages import packages, prefix_of

    for name in packages(session):
        manifest = Path(prefix_of(session, name) or "", "share", name, "package.xml")
        try:
            version = ElementTree.parse(manifest).findtext("version", "").strip()
        except (OSError, ElementTree.ParseError):
            version = ""
        yield name, f"latest=N/A, local={version}"


def _report_distribution(session: Session, node: Node) -> Iterator[tuple[str, object]]:
    name = session.env.get("ROS_DISTRO", "")
    if name:
        yield "distribution name", name.lower()
        yield "distribution type", f"ros{session.env.get('ROS_VERSION', '2')}"


def _query_platform() -> None:
    """Fill the cache of `platform`, which starts `uname` or `ver` the first time."""
    import platform

    platform.platform()
    platform.processor()


def _report_platform(session: Session, node: Node) -> Iterator[tuple[str, object]]:
    import platform

    yield "system", platform.system()
    yield "platform info", platform.platform()
    if platform.system() == "Darwin":
        yield "mac OS version", platform.mac_ver()
    yield "release", platform.release()
    yield "processor", platform.processor()


def _report_qos(session: Session, node: Node) -> Iterator[tuple[str, object]]:
    from rclpy.qos import QoSCompatibility

    found = False
    for topic, publisher, subscription, compatibility, reason in _pairs(node):
        found = True
        yield "topic [type]", f"{topic} [{publisher.topic_type}]"
        yield "publisher node", publisher.node_name
        yield "subscriber node", subscription.node_name
        yield "compatibility status", "OK" if compatibility == QoSCompatibility.OK else reason
    if not found:
        yield "compatibility status", "No publisher/subscriber pairs found"


def _report_middleware(session: Session, node: Node) -> Iterator[tuple[str, object]]:
    from rclpy.utilities import get_rmw_implementation_identifier

    yield "middleware name", get_rmw_implementation_identifier()


def _report_topics(session: Session, node: Node) -> Iterator[tuple[str, object]]:
    topics = [topic for topic, _ in node.get_topic_names_and_types() if topic not in _SKIPPED]
    for topic in topics or ["none"]:
        yield "topic", topic
        yield "publisher count", node.count_publishers(topic) if topics else 0
        yield "subscriber count", node.count_subscribers(topic) if topics else 0


def _report_services(session: Session, node: Node) -> Iterator[tuple[str, object]]:
    names = [name for name, _ in services(node, hidden=False)]
    for name in names or ["none"]:
        yield "service", name
        yield "service count", node.count_services(name) if names else 0
        yield "client count", node.count_clients(name) if names else 0


def _report_actions(session: Session, node: Node) -> Iterator[tuple[str, object]]:
    from day6_core.ros.ros2.action.info import clients, servers
    from rclpy.action import get_action_names_and_types

    names = [name for name, _ in get_action_names_and_types(node)]
    for name in names or ["none"]:
        yield "action", name
        yield "action server count", len(servers(node, name)) if names else 0
        yield "action client count", len(clients(node, name)) if names else 0


def _report_environment(session: Session, node: Node) -> Iterator[tuple[str, object]]:
    for title, word in (("ROS", "ROS"), ("rcutils", "RCUTILS"), ("rmw", "RMW")):
        found = [f"{name}={text}" for name, text in session.env.items() if word in name]
        yield f"{title} environment variables", ", ".join(found)


CHECKS: dict[str, Callable[[Session, Node], Iterator[Finding]]] = {
    "network": _check_network,
    "middleware": _check_qos,
    "topic": _check_topics,
}
"""By category, the names that `Failed modules:` lists."""

REPORTS: dict[str, tuple[str, Callable[[Session, Node], Iterator[tuple[str, object]]]]] = {
    "ACTION LIST": ("action", _report_actions),
    "NETWORK CONFIGURATION": ("network", _report_network),
    "PACKAGE VERSIONS": ("package", _report_packages),
    "PLATFORM INFORMATION": ("platform", _report_platform),
    "QOS COMPATIBILITY LIST": ("middleware", _report_qos),
    "RMW MIDDLEWARE": ("middleware", _report_middleware),
    "ROS 2 INFORMATION": ("platform", _report_distribution),
    "ROS ENVIRONMENT": ("environment", _report_environment),
    "SERVICE LIST": ("topic", _report_services),
    "TOPIC LIST": ("topic", _report_topics),
}
"""By title: the category, and the function that yields the rows."""


def reports() -> dict[str, tuple[str, Callable[[Session, Node], Iterator[tuple[str, object]]]]]:
    """Return the reports of this distribution."""
    return {title: row for title, row in REPORTS.items() if title not in value("doctor.lacks_reports")}
