"""Checks a robot description as urdfdom 4.0.1's parser does, with its messages, their order, and its tolerance.

Where URDF 1.1 and 1.2 are read (`newest`), the messages about them are those of urdfdom 5.1 and 6.0.

`check_text` returns the robot as plain data and everything the real parser would have written to stderr. check_urdf,
urdf_to_graphviz and robot_state_publisher are built on it, so none of them needs yourdfpy. The numbers are line numbers in
urdfdom's model.cpp. Only a text too large to read without a stall, for which urdfdom has no message, gets one of ours.
"""

from __future__ import annotations

import os
import re
from dataclasses import replace

from day6_urdf.diagnostics import OLDEST, Diagnostics, Refused, Version
from day6_urdf.joint_reader import read_joint
from day6_urdf.link_reader import read_link, read_material
from day6_urdf.model import Joint, Link, Material, Robot
from day6_urdf.report import Diagnostic, Report
from day6_urdf.xmlreader import Element, XmlError, read_xml

MAX_BYTES = 4_000_000
"""The largest description that is read; urdfdom itself has no limit."""

_INTEGER = re.compile(r"[ \t\n\v\f\r]*([+-]?[0-9]+)")


def check_text(text: str, newest: Version = OLDEST) -> Report:
    """Check a robot description by the rules of an urdfdom that reads URDF up to `newest`.

    Never raises; the report of a refused description has no robot.
    """
    if len(text) > MAX_BYTES:
        return too_large(len(text))
    diagnostics = Diagnostics(text, newest)
    try:
        robot = _Model(diagnostics).read(text)
    except Refused:
        robot = None
    return Report(robot, tuple(diagnostics.all))


def check_file(path: str | os.PathLike[str], newest: Version = OLDEST) -> Report:
    """Check a file as check_urdf does: a missing or unreadable file counts as an empty description. Never raises."""
    try:
        text, size = read_description(path)
    except OSError:
        text, size = "", 0
    return too_large(size) if size > MAX_BYTES else check_text(text, newest)


def read_description(path: str | os.PathLike[str]) -> tuple[str, int]:
    """Return the text of a file (invalid UTF-8 replaced) and its size in bytes.

    A file above MAX_BYTES is not read: the text is empty, the size exceeds the limit by at least one.

    Raises:
        OSError: the file cannot be read.
    """
    with open(path, "rb") as file:
        size = os.fstat(file.fileno()).st_size
        data = b"" if size > MAX_BYTES else file.read(MAX_BYTES + 1)  # a device or a pipe reports size 0
    size = max(size, len(data))
    return ("" if size > MAX_BYTES else data.decode("utf-8", "replace")), size


def too_large(size: int) -> Report:
    """Return the report of a description of `size` bytes, which is not read."""
    text = f"The robot description is too large: {size / 1e6:.1f} MB, more than {MAX_BYTES / 1e6:.0f} MB are not read"
    return Report(None, (Diagnostic("Error", text),))


class _Model:
    """A robot while it is read: the names seen so far, in the order of the file."""

    def __init__(self, diagnostics: Diagnostics) -> None:
        self._diagnostics = diagnostics
        self._materials: dict[str, Material] = {}
        self._links: dict[str, Link] = {}
        self._joints: dict[str, Joint] = {}

    def read(self, text: str) -> Robot:
        root = self._root_element(text)
        name = root.attributes.get("name")
        if name is None:
            raise self._diagnostics.refuse("model", 119, "No name given for the robot.", root)
        try:
            self._diagnostics.version = _version(root.attributes.get("version"), self._diagnostics.newest)
        except ValueError as error:
            raise self._diagnostics.refuse("model", 135, str(error), root) from None
        for element in root.all("material"):
            self._add_material(element)
        for element in root.all("link"):
            self._add_link(element)
        if not self._links:
            raise self._diagnostics.refuse("model", 207, "No link elements found in urdf file", root)
        for element in root.all("joint"):
            self._add_joint(element)
        self._build_tree(root)
        return Robot(name, tuple(self._links.values()), tuple(self._joints.values()), tuple(self._materials.values()))

    def _root_element(self, text: str) -> Element:
        try:
            elements = read_xml(text)
        except XmlError as error:
            self._diagnostics.error("model", 101, str(error), offset=error.offset)
            raise Refused(str(error)) from error
        for element in elements:
            if element.tag == "robot":
                return element
        raise self._diagnostics.refuse("model", 110, "Could not find the 'robot' element in the xml file")

    def _add_material(self, element: Element) -> None:
        material, _ = read_material(element, self._diagnostics, only_name_is_ok=False)
        if material.name in self._materials:
            raise self._diagnostics.refuse("model", 150, f"material '{material.name}' is not unique.", element)
        # A global material is known from here on even if it defines nothing (urdfdom ignores the failure).
        if material.color is None and material.texture is None:
            material = replace(material, color=(0.0, 0.0, 0.0, 1.0))
        self._materials[material.name] = material

    def _add_link(self, element: Element) -> None:
        link, holds_first_twice = read_link(element, self._diagnostics)
        if link.name in self._links:
            raise self._diagnostics.refuse("model", 179, f"link '{link.name}' is not unique.", element)
        if holds_first_twice:  # so urdfdom assigns its material twice and warns twice
            first = link.visuals[0]
            self._assign_material(first.material_name, first.material, link.name, element)
        visuals = tuple(
            replace(visual, material=self._assign_material(visual.material_name, visual.material, link.name, element))
            for visual in link.visuals
        )
        self._links[link.name] = replace(link, visuals=visuals)

    def _assign_material(self, name: str, inline: Material | None, link: str, element: Element) -> Material | None:
        """Return the material of this name; an inline definition becomes known to the following links."""
        if not name:
            return inline
        known = self._materials.get(name)
        if known is not None:
            return known
        if inline is None:
            self._diagnostics.warning("model", 85, f"link '{link}' material '{name}' undefined.", element)
            return None
        self._materials[name] = inline
        return inline

    def _add_joint(self, element: Element) -> None:
        try:
            joint = read_joint(element, self._diagnostics)
        except Refused:
            raise self._diagnostics.refuse("model", 234, "joint xml is not initialized correctly", element) from None
        if joint.name in self._joints:
            raise self._diagnostics.refuse("model", 222, f"joint '{joint.name}' is not unique.", element)
        self._joints[joint.name] = joint

    def _build_tree(self, root: Element) -> None:
        for name in sorted(self._joints):  # urdfdom keeps joints and links in maps sorted by name
            problem = _joint_problem(self._joints[name], self._links)
            if problem:
                raise self._diagnostics.refuse("model", 253, f"Failed to build tree: {problem}", root)
        children = {joint.child for joint in self._joints.values()}
        roots = [name for name in sorted(self._links) if name not in children]
        if not roots:
            problem = "No root link found. The robot xml is not a valid tree."
        elif len(roots) > 1:
            problem = f"Two root links found: [{roots[0]}] and [{roots[1]}]"
        else:
            return
        raise self._diagnostics.refuse("model", 265, f"Failed to find root link: {problem}", root)


def _joint_problem(joint: Joint, links: dict[str, Link]) -> str:
    """Return urdf_model/model.h's error about the links a joint names, empty if there is none."""
    if not joint.parent or not joint.child:
        return f"Joint [{joint.name}] is missing a parent and/or child link specification."
    if joint.child not in links:
        return f"child link [{joint.child}] of joint [{joint.name}] not found"
    if joint.parent not in links:
        return (
            f"parent link [{joint.parent}] of joint [{joint.name}] not found.  This is not valid according to the URDF"
            " spec. Every link you refer to from a joint needs to be explicitly defined in the robot description. To"
            f" fix this problem you can either remove this joint [{joint.name}] from your urdf file, or add"
            f' "<link name="{joint.parent}" />" to your urdf file.'
        )
    return ""


def _version(text: str | None, newest: Version) -> Version:
    """Return the version that <robot version="…"> names, 1.0 if there is none. Raises ValueError with urdf_parser.h's error."""
    if text is None:
        return OLDEST
    fields = text.split(".")
    if fields[-1] == "":
        fields.pop()  # urdfdom's split returns nothing after the last separator
    if len(fields) != 2:
        raise ValueError("The version attribute should be in the form 'x.y'")
    numbers = []
    for item in fields:
        if not item:
            raise ValueError("One of the fields of the version attribute is blank")
        match = _INTEGER.match(item)
        if match is None:
            raise ValueError("Version attribute is not an integer")
        if match.end() != len(item):
            raise ValueError("Extra characters after the version number")
        if int(match.group(1)) < 0:
            raise ValueError("Version number must be positive")
        numbers.append(int(match.group(1)))
    version = numbers[0], numbers[1]
    if OLDEST <= version <= newest:
        return version
    supported = "only version 1.0 is" if newest == OLDEST else f"versions 1.0 to {newest[0]}.{newest[1]} are"
    raise ValueError(f"Invalid 'version' specified; {supported} currently supported")
