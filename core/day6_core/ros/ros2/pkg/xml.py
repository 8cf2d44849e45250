"""`ros2 pkg xml`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.completion import package_names
from day6_core.ros.ros2.cli.options import completed

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Output the XML of the package manifest or a specific tag"


def add_arguments(parser: ArgumentParser) -> None:
    completed(parser.add_argument("package_name", help="The package name"), package_names)
    parser.add_argument("-t", "--tag", help="The XML tag to output (e.g. 'version')")


async def main(session: Session, args: Namespace) -> str | None:
    from xml.etree import ElementTree

    from day6_core.ros.ros2.cli.packages import prefix_of

    prefix = prefix_of(session, args.package_name)
    if prefix is None:
        return "Package not found"
    manifest = Path(prefix, "share", args.package_name, "package.xml")
    if not manifest.is_file():
        return "Package XML manifest not found"
    root = ElementTree.parse(manifest).getroot()
    if args.tag is None:
        session.print(ElementTree.tostring(root, encoding="unicode").rstrip("\n"))
        return None
    elements = root.findall(args.tag)
    if not elements:
        return "XML tag not found"
    for element in elements:
        session.print(element.text)
    return None
