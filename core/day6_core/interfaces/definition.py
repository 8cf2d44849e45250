"""Parses .msg, .srv and .action texts into structures, with the rules and error texts of rosidl_adapter/parser.py."""

from __future__ import annotations

from day6_core.interfaces.fields import ARRAY, BOUNDED, PRIMITIVES, SINGLE, STRINGS, UNBOUNDED, FieldType
from day6_core.interfaces.values import parse_primitive, parse_value
from day6_core.ros import differences

TYPE_CHECKING = False  # `import typing` costs more than this whole module
if TYPE_CHECKING:
    from typing import Any

PACKAGE_PATTERN = "^(?!.*__)(?!.*_$)[a-z][a-z0-9_]*$"
MESSAGE_PATTERN = "^[A-Z][A-Za-z0-9]*$"
CONSTANT_PATTERN = "^[A-Z]([A-Z0-9_]?[A-Z0-9]+)*$"

_LOWER = frozenset("abcdefghijklmnopqrstuvwxyz0123456789_")
_UPPER = frozenset("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_")
_LETTERS = frozenset("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789")


class InvalidSpecification(Exception):
    """An interface text breaks a rule; base of this module's other errors (names as in rosidl_adapter.parser)."""


class InvalidServiceSpecification(InvalidSpecification):
    """A .srv text does not have exactly one line `---`."""


class InvalidActionSpecification(InvalidSpecification):
    """An .action text does not have exactly two lines `---`."""


class InvalidResourceName(InvalidSpecification):
    """A package, message, field or constant name breaks the naming rules."""


class InvalidFieldDefinition(InvalidSpecification):
    """A line has a type but no name."""


class Field:
    """One field: its type, its name and its default (None if the text has none)."""

    __slots__ = ("default", "name", "type")

    def __init__(self, type_: FieldType, name: str, default: Any = None) -> None:
        self.type = type_
        self.name = name
        self.default = default


class Constant:
    """One constant: the .msg name of its type, its name and value (an int for `byte` and `char`)."""

    __slots__ = ("name", "type", "value")

    def __init__(self, type_: str, name: str, value: Any) -> None:
        self.type = type_
        self.name = name
        self.value = value


class Structure:
    """A message, or a message-like part of a service or action: 'std_srvs/srv/SetBool_Request'.

    `value_count` is its number of values with those of nested messages, 0 until `registry.count_values` has set it.
    """

    __slots__ = ("constants", "fields", "kind", "name", "package", "value_count")

    def __init__(self, package: str, kind: str, name: str, fields: list[Field], constants: list[Constant]) -> None:
        self.package = package
        self.kind = kind
        self.name = name
        self.fields = fields
        self.constants = constants
        self.value_count = 0

    @property
    def full_name(self) -> str:
        """The full name, like 'std_msgs/msg/String'."""
        return f"{self.package}/{self.kind}/{self.name}"


def is_package_name(name: str) -> bool:
    """Return whether a name is valid for a package; field names follow the same rule."""
    return "a" <= name[:1] <= "z" and name[-1] != "_" and "__" not in name and _LOWER.issuperset(name)


def is_message_name(name: str) -> bool:
    """Return whether a name is valid for a message, service or action (also for parts like Foo_Request)."""
    for suffix in ("_Request", "_Response", "_Goal", "_Result", "_Feedback"):
        name = name.removesuffix(suffix)
    return "A" <= name[:1] <= "Z" and _LETTERS.issuperset(name)


def is_constant_name(name: str) -> bool:
    """Return whether a name is valid for a constant."""
    return "A" <= name[:1] <= "Z" and name[-1] != "_" and "__" not in name and _UPPER.issuperset(name)


def parse_type(text: str, package: str) -> FieldType:
    """Parse 'float64', 'string<=10[<=3]', 'Point' or 'geometry_msgs/Point[]'; a bare name belongs to `package`.

    Raises:
        InvalidResourceName: the name is invalid.
        TypeError: a bound is invalid.
    """
    element, count, size = text, SINGLE, 0
    if text.endswith("]"):
        bracket = text.rfind("[")
        if bracket < 0:
            raise TypeError(f"the type {text} ends with ']' but does not contain a '['")
        element, inner = text[:bracket], text[bracket + 1 : -1]
        if not inner:
            count = UNBOUNDED
        else:
            count = BOUNDED if inner.startswith("<=") else ARRAY
            size = _positive(inner.removeprefix("<="))
            if size <= 0:
                raise TypeError(
                    f"the size of array type '{text}' must be a valid integer value > 0 optionally prefixed with '<=' "
                    "if it is only an upper bound"
                )
    base, string_bound = element, 0
    if element in PRIMITIVES or element in STRINGS:
        pass
    elif element.startswith(("string<=", "wstring<=")):
        base, _, bound = element.partition("<=")
        string_bound = _positive(bound)
        if string_bound <= 0:
            raise TypeError(f"the upper bound of the string type '{element}' must be a valid integer value > 0")
    else:
        base = _nested_name(element, package)
    return FieldType(base, string_bound, count, size)


def _positive(text: str) -> int:
    """Return the integer, or 0 for anything that isn't an integer (callers refuse 0)."""
    try:
        return int(text)
    except ValueError:
        return 0


def _nested_name(text: str, package: str) -> str:
    parts = text.split("/")
    if len(parts) > 2:
        raise InvalidResourceName(text)
    owner, name = parts if len(parts) == 2 else (package, text)
    for what, part, fits, pattern in (
        ("package", owner, is_package_name(owner), PACKAGE_PATTERN),
        ("message", name, is_message_name(name), MESSAGE_PATTERN),
    ):
        if not fits:
            raise InvalidResourceName(f"'{part}' is an invalid {what} name. It should have the pattern '{pattern}'")
    return f"{owner}/msg/{name}"


def parse_message(package: str, kind: str, name: str, text: str) -> Structure:
    """Parse the text of one message (or one part of a service or action).

    Raises:
        InvalidSpecification, InvalidValue, NameError, TypeError, ValueError: the text is invalid; messages are rosidl's.
    """
    fields: list[Field] = []
    constants: list[Constant] = []
    for raw in text.replace("\t", " ").splitlines():
        line = raw.partition("#")[0].rstrip()
        if not line.strip():
            continue
        type_text, _, rest = line.partition(" ")
        rest = rest.lstrip()
        if not rest:
            raise InvalidFieldDefinition(line)
        if "=" in rest:
            constant, _, value = rest.partition("=")
            constant = constant.rstrip()
            if type_text not in PRIMITIVES and type_text not in STRINGS:
                raise TypeError(f"the constant type '{type_text}' must be a primitive type")
            if not is_constant_name(constant):
                raise NameError(
                    f"'{constant}' is an invalid constant name. It should have the pattern '{CONSTANT_PATTERN}'"
                )
            constants.append(Constant(type_text, constant, parse_primitive(type_text, value.lstrip())))
        else:
            field, _, default = rest.partition(" ")
            type_ = parse_type(type_text, package)
            if not field or not is_package_name(field):
                raise NameError(f"'{field}' is an invalid field name. It should have the pattern '{PACKAGE_PATTERN}'")
            default = default.lstrip()
            fields.append(Field(type_, field, parse_value(type_, default) if default else None))
    _refuse_duplicates("fields", [field.name for field in fields])
    _refuse_duplicates("constants", [constant.name for constant in constants])
    return Structure(package, kind, name, fields, constants)


def _refuse_duplicates(what: str, names: list[str]) -> None:
    if len(set(names)) < len(names):
        doubled = sorted({name for name in names if names.count(name) > 1})
        raise ValueError(f"the {what} iterable contains duplicate names: {', '.join(doubled)}")


def _parts(text: str) -> list[str]:
    """Split a .srv or .action text at its lines `---`."""
    parts: list[list[str]] = [[]]
    for line in text.splitlines():
        if line == "---":
            parts.append([])
        else:
            parts[-1].append(line)
    return ["\n".join(lines) for lines in parts]


def parse_service(package: str, kind: str, name: str, text: str) -> list[Structure]:
    """Parse a .srv text; return the structures of its request, response and event (in Humble there are no events).

    Raises:
        InvalidServiceSpecification: it does not have exactly one line `---`; otherwise as `parse_message`.
    """
    parts = _parts(text)
    if len(parts) != 2:
        unique = "unique " if len(parts) > 2 else ""
        raise InvalidServiceSpecification(f"Could not find {unique}separator '---' between request and response")
    request = parse_message(package, kind, f"{name}_Request", parts[0])
    response = parse_message(package, kind, f"{name}_Response", parts[1])
    return [request, response, *_events(package, kind, name)]


def parse_action(package: str, kind: str, name: str, text: str) -> list[Structure]:
    """Parse an .action text; return the structures of its parts and of the action protocol's services and messages.

    Raises:
        InvalidActionSpecification: it does not have exactly two lines `---`; otherwise as `parse_message`.
    """
    parts = _parts(text)
    if len(parts) != 3:
        raise InvalidActionSpecification("Number of '---' separators nonconformant with action definition")
    goal_id = Field(FieldType("unique_identifier_msgs/msg/UUID"), "goal_id")
    prefix = f"{package}/{kind}/{name}"

    def wrapped(suffix: str, *fields: Field) -> Structure:
        return Structure(package, kind, name + suffix, list(fields), [])

    return [
        parse_message(package, kind, f"{name}_Goal", parts[0]),
        parse_message(package, kind, f"{name}_Result", parts[1]),
        parse_message(package, kind, f"{name}_Feedback", parts[2]),
        wrapped("_SendGoal_Request", goal_id, Field(FieldType(f"{prefix}_Goal"), "goal")),
        wrapped(
            "_SendGoal_Response",
            Field(FieldType("bool"), "accepted"),
            Field(FieldType("builtin_interfaces/msg/Time"), "stamp"),
        ),
        *_events(package, kind, f"{name}_SendGoal"),
        wrapped("_GetResult_Request", goal_id),
        wrapped(
            "_GetResult_Response", Field(FieldType("int8"), "status"), Field(FieldType(f"{prefix}_Result"), "result")
        ),
        *_events(package, kind, f"{name}_GetResult"),
        wrapped("_FeedbackMessage", goal_id, Field(FieldType(f"{prefix}_Feedback"), "feedback")),
    ]


def _events(package: str, kind: str, service: str) -> list[Structure]:
    return [_event(package, kind, service)] if differences.value("services.have_events") else []


def _event(package: str, kind: str, service: str) -> Structure:
    """Return the structure of a service's event, which service introspection publishes."""
    prefix = f"{package}/{kind}/{service}"
    return Structure(
        package,
        kind,
        f"{service}_Event",
        [
            Field(FieldType("service_msgs/msg/ServiceEventInfo"), "info"),
            Field(FieldType(f"{prefix}_Request", 0, BOUNDED, 1), "request"),
            Field(FieldType(f"{prefix}_Response", 0, BOUNDED, 1), "response"),
        ],
        [],
    )
