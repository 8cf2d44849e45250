"""ROS names: validation, expansion to full names, remapping.

The rules and messages are those of rcl (validate_topic_name.c, expand_topic_name.c, remap.c) and rmw
(validate_*_name.c), observed on rclpy 9.1.2. A validator returns None for a valid name, else a `Flaw` with the message
and the invalid index.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Literal, NamedTuple

MAX_NODE_NAME = 255
MAX_TOPIC_NAME = 247
"""The 255 characters of a DDS topic name less the 8 that rmw reserves for prefix and suffix."""
MAX_NAMESPACE = 245

OBSERVER_PREFIX = "_day6_observer"
"""Nodes whose names begin like this look on: they receive messages and are in no list, no count and no event of this graph.

To a real ROS 2 on the link they are hidden nodes, as those of `ros2` are.
"""

_ALNUM_ = frozenset("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_")
_DIGITS = frozenset("0123456789")
_SUBSTITUTION = re.compile(r"\{([^{}]*)\}")


class Flaw(NamedTuple):
    """The violated rule of a name: rcl's message, the index of the invalid character, rmw's number of the rule.

    Only the validators of node names, namespaces and full topic names have numbers: rmw/validate_namespace.h.
    """

    message: str
    position: int
    number: int = 0


class UnknownSubstitution(ValueError):
    """A `{word}` in a name that is not node, ns or namespace."""


def _token_starting_with_digit(name: str) -> int | None:
    for index, character in enumerate(name):
        if character in _DIGITS and index and name[index - 1] == "/":
            return index
    return None


def _flaw_of_absolute_name(subject: str, name: str) -> Flaw | None:
    """Check the common rules of full topic names and namespaces (after those for empty names and outer slashes)."""
    for index, character in enumerate(name):
        if character not in _ALNUM_ and character != "/":
            return Flaw(f"{subject} must not contain characters other than alphanumerics, '_', or '/'", index, 4)
    repeated = name.find("//")
    if repeated >= 0:
        return Flaw(f"{subject} must not contain repeated '/'", repeated + 1, 5)
    digit = _token_starting_with_digit(name)
    if digit is not None:
        return Flaw(f"{subject} must not have a token that starts with a number", digit, 6)
    return None


def flaw_of_node_name(name: str) -> Flaw | None:
    """Validate a node name without namespace (rmw/validate_node_name.c)."""
    if not name:
        return Flaw("node name must not be empty", 0, 1)
    for index, character in enumerate(name):
        if character not in _ALNUM_:
            return Flaw("node name must not contain characters other than alphanumerics or '_'", index, 2)
    if name[0] in _DIGITS:
        return Flaw("node name must not start with a number", 0, 3)
    if len(name) > MAX_NODE_NAME:
        return Flaw(f"node name length should not exceed '{MAX_NODE_NAME}'", MAX_NODE_NAME - 1, 4)
    return None


def flaw_of_namespace(namespace: str) -> Flaw | None:
    """Validate a node's namespace, which is absolute, `/` for none (rmw/validate_namespace.c)."""
    if not namespace:
        return Flaw("namespace must not be empty", 0, 1)
    if namespace == "/":
        return None
    if namespace[0] != "/":
        return Flaw("namespace must be absolute, it must lead with a '/'", 0, 2)
    if namespace[-1] == "/":
        return Flaw("namespace must not end with a '/', unless only a '/'", len(namespace) - 1, 3)
    flaw = _flaw_of_absolute_name("namespace", namespace)
    if flaw is None and len(namespace) > MAX_NAMESPACE:
        return Flaw("namespace should not exceed 'RMW_NAMESPACE_MAX_NAME_LENGTH'", MAX_NAMESPACE - 1, 7)
    return flaw


def flaw_of_full_topic_name(name: str) -> Flaw | None:
    """Validate a topic or service name after expansion (rmw/validate_full_topic_name.c)."""
    if not name:
        return Flaw("topic name must not be empty", 0, 1)
    if name[0] != "/":
        return Flaw("topic name must be absolute, it must lead with a '/'", 0, 2)
    if name[-1] == "/":
        return Flaw("topic name must not end with a '/'", len(name) - 1, 3)
    flaw = _flaw_of_absolute_name("topic name", name)
    if flaw is None and len(name) > MAX_TOPIC_NAME:
        return Flaw("topic length should not exceed '255U - 8U'", MAX_TOPIC_NAME - 1, 7)
    return flaw


def flaw_of_topic_name(name: str) -> Flaw | None:
    """Validate a topic or service name as written in a program (rcl/validate_topic_name.c).

    It may be relative, absolute or private, with substitutions.
    """
    if not name:
        return Flaw("topic name must not be empty string", 0)
    if name[-1] == "/":
        return Flaw("topic name must not end with a forward slash", len(name) - 1)
    opened: int | None = None
    for index, character in enumerate(name):
        if character == "{":
            if opened is not None:
                return Flaw("substitution name must not contain characters other than alphanumerics or '_'", index)
            opened = index
        elif character == "}":
            if opened is None:
                return Flaw("topic name must not have unmatched (unbalanced) curly braces '{}'", index)
            opened = None
        elif character == "~":
            if index:
                return Flaw("topic name must not have tilde '~' unless it is the first character", index)
        elif character in _ALNUM_:
            if character in _DIGITS and opened is not None and index == opened + 1:
                return Flaw("substitution name must not start with a number", index)
        elif opened is not None:
            return Flaw("substitution name must not contain characters other than alphanumerics or '_'", index)
        elif character != "/":
            message = "topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'"
            return Flaw(message, index)
    if opened is not None:
        return Flaw("topic name must not have unmatched (unbalanced) curly braces '{}'", opened)
    if name[0] in _DIGITS:
        return Flaw("topic name token must not start with a number", 0)
    digit = _token_starting_with_digit(name)
    if digit is not None:
        return Flaw("topic name token must not start with a number", digit)
    if name[0] == "~" and len(name) > 2 and name[1] != "/":  # rcl checks this only in names of three or more characters
        return Flaw("topic name must not have a tilde '~' that is not followed by a forward slash '/'", 1)
    return None


def full_name(namespace: str, name: str) -> str:
    """Join a namespace and a name: `("/", "a")` → `/a`, `("/sp", "a")` → `/sp/a`."""
    return f"/{name}" if namespace == "/" else f"{namespace}/{name}"


def expand(name: str, node_name: str, namespace: str) -> str:
    """Return the full form of a topic or service name, without remapping (rcl/expand_topic_name.c).

    Raises:
        UnknownSubstitution: for `{word}` other than node, ns and namespace.
    """
    if name.startswith("~"):
        name = full_name(namespace, node_name) + name[1:]
    if "{" in name:
        values = {"node": node_name, "ns": namespace, "namespace": namespace}

        def value(match: re.Match[str]) -> str:
            if match[1] not in values:
                raise UnknownSubstitution(f"unknown substitution: {match[0]}")
            return values[match[1]]

        name = _SUBSTITUTION.sub(value, name)
    return name if name.startswith("/") else full_name(namespace, name)


def is_observer(node_name: str) -> bool:
    """Return whether a node of that name (without namespace) only looks on."""
    return node_name.startswith(OBSERVER_PREFIX)


def is_hidden(name: str) -> bool:
    """Return whether any part of a topic, service or node name starts with an underscore."""
    return any(part.startswith("_") for part in name.split("/"))


class RemapRule(NamedTuple):
    """One `-r match:=replacement`; `node` limits it to nodes of that name."""

    kind: Literal["name", "node", "namespace"]
    match: str
    replacement: str
    node: str | None = None

    @staticmethod
    def parse(text: str) -> RemapRule:
        """Parse `[node:]match:=replacement`, `__node:=name` (or `__name:=`), `__ns:=namespace` (rcl/arguments.c).

        Raises:
            ValueError: `text` is not such a rule.
        """
        left, separator, replacement = text.partition(":=")
        if not separator or not left or not replacement:
            raise ValueError(text)
        node: str | None = None
        if ":" in left and "://" not in left:
            node, _, left = left.partition(":")
        if left.startswith("rostopic://"):
            left = left[len("rostopic://") :]
        elif left.startswith("rosservice://"):
            left = left[len("rosservice://") :]
        if left in ("__node", "__name"):
            flaw = flaw_of_node_name(replacement)
            if flaw:
                raise ValueError(text)
            return RemapRule("node", left, replacement, node)
        if left == "__ns":
            if flaw_of_namespace(replacement):
                raise ValueError(text)
            return RemapRule("namespace", left, replacement, node)
        if flaw_of_topic_name(left) or flaw_of_topic_name(replacement):
            raise ValueError(text)
        return RemapRule("name", left, replacement, node)


def remap_node(name: str, namespace: str, rules: Iterable[RemapRule]) -> tuple[str, str]:
    """Return node name and namespace after the first matching `__node` and the first matching `__ns` rule.

    A `__ns` rule for one node names it by its new name (rcl/node.c).
    """
    rules = list(rules)
    new_name = next((r.replacement for r in rules if r.kind == "node" and r.node in (None, name)), name)
    new_namespace = next(
        (r.replacement for r in rules if r.kind == "namespace" and r.node in (None, new_name)), namespace
    )
    return new_name, new_namespace


def remap_topic(full: str, node_name: str, namespace: str, rules: Iterable[RemapRule]) -> str:
    """Return a full topic or service name after the first rule whose expanded left side equals it."""
    for rule in rules:
        if rule.kind == "name" and rule.node in (None, node_name) and expand(rule.match, node_name, namespace) == full:
            return expand(rule.replacement, node_name, namespace)
    return full
