"""`ros2 pkg create`."""

from __future__ import annotations

import errno
import os
import shutil
from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.differences import value
from day6_core.ros.ros2.cli.completion import package_names
from day6_core.ros.ros2.cli.options import completed

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from day6_core.workspace.templates import PackagePlan

SUMMARY = "Create a new ROS 2 package"


def add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("package_name", help="The package name")
    parser.add_argument(
        "--package-format", "--package_format", type=int, default=3, choices=[2, 3], help="The package.xml format."
    )
    parser.add_argument(
        "--description", default="TODO: Package description", help="The description given in the package.xml"
    )
    parser.add_argument(
        "--license",
        default="TODO: License declaration",
        help="The license attached to this package; this can be an arbitrary string, but a LICENSE file will only be generated "
        "if it is one of the supported licenses (pass '?' to get a list)",
    )
    parser.add_argument(
        "--destination-directory", default=os.curdir, help="Directory where to create the package directory"
    )
    parser.add_argument(
        "--build-type",
        default="ament_cmake",
        choices=["cmake", "ament_cmake", *(["ament_cargo"] if value("pkg.create_rust") else []), "ament_python"],
        help="The build type to process the package with",
    )
    completed(parser.add_argument("--dependencies", nargs="+", default=[], help="list of dependencies"), package_names)
    parser.add_argument("--maintainer-email", help="email address of the maintainer of this package")
    parser.add_argument("--maintainer-name", help="name of the maintainer of this package")
    parser.add_argument("--node-name", help="name of the empty executable")
    parser.add_argument("--library-name", help="name of the empty library")


async def main(session: Session, args: Namespace) -> str | None:
    from day6_core.session.folder import LOST
    from day6_core.workspace.create import LICENSES, create
    from day6_core.workspace.templates import PackagePlan

    if args.license == "?":
        session.print("Supported licenses:", *LICENSES, sep="\n")
        return None
    node = args.node_name
    if node and node == args.library_name:
        node = f"{node}_node"
        session.print_error("[WARNING] node name can not be equal to the library name")
        session.print_error(f"[WARNING] renaming node to {node}")
    if args.build_type == "ament_python" and args.package_name == "test":
        return "Aborted since 'ament_python' packages can't be named 'test'. Please choose a different package name."
    destination = session.cwd / args.destination_directory
    shown = os.path.join(args.destination_directory, args.package_name)
    if (session.cwd / shown).exists():
        return (
            f"\nAborted!\nThe directory already exists: {shown}\nEither remove the directory or choose a different destination "
            "directory or package name"
        )
    name = args.maintainer_name or _user(session)
    plan = PackagePlan(
        args.package_name,
        args.build_type,
        args.description,
        args.license,
        name,
        args.maintainer_email or f"{name}@todo.todo",
        args.package_format,
        args.dependencies,
        node,
        args.library_name,
    )
    if not session.cwd.is_dir():
        return f"ros2 pkg create: {LOST}"
    if args.build_type == "ament_cargo" and shutil.which("cargo", path=session.env.get("PATH")) is None:
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), "cargo")
    _announce(session, plan, os.path.normpath(session.cwd / destination))
    create(plan, destination, args.destination_directory, session.print)
    return None


def _user(session: Session) -> str:
    """Return the user's name from the variables that getpass reads."""
    names = ("LOGNAME", "USER", "LNAME", "USERNAME")
    return next((session.env[name] for name in names if session.env.get(name)), "root")


def _announce(session: Session, plan: PackagePlan, destination: str) -> None:
    session.print("going to create a new package")
    session.print("package name:", plan.name)
    session.print("destination directory:", destination)
    session.print("package format:", plan.package_format)
    session.print("version: 0.0.0")
    session.print("description:", plan.description)
    session.print("maintainer:", [f"{plan.maintainer} <{plan.email}>"])
    session.print("licenses:", [plan.license])
    session.print("build type:", plan.build_type)
    session.print("dependencies:", plan.dependencies)
    if plan.node:
        session.print("node_name:", plan.node)
    if plan.library:
        session.print("library_name:", plan.library)
