"""The messages of test_msgs that real ROS tests its transport with: each limit of each type, and no items, few and many."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from test_msgs.msg import (
    Arrays,
    BasicTypes,
    BoundedPlainSequences,
    BoundedSequences,
    Builtins,
    Constants,
    Defaults,
    Empty,
    MultiNested,
    Nested,
    Strings,
    UnboundedSequences,
    WStrings,
)

_FLOATS = (0.0, 1.125, -2.125, 1.0)
_BYTES = (b"\x00", b"\xff", b"\x00", b"\x01")
_MANY = 1000
_LONG = "0123456789" * 2000


def int_from_uint(value: int, nbits: int) -> int:
    """Return the integer with sign whose lowest `nbits` bits are those of `value`."""
    half = 1 << (nbits - 1)
    return (value + half) % (1 << nbits) - half


def _with_sign(bits: int) -> tuple[int, ...]:
    return 0, 2 ** (bits - 1) - 1, -(2 ** (bits - 1)), 1


def _without_sign(bits: int) -> tuple[int, ...]:
    return 0, 2**bits - 1, 0, 1


_EXTREMES: dict[str, tuple[Any, ...]] = {
    "bool": (False, True, False, True),
    "byte": _BYTES,
    "char": _without_sign(8),
    "float32": _FLOATS,
    "float64": _FLOATS,
    **{f"{u}int{bits}": (_without_sign if u else _with_sign)(bits) for bits in (8, 16, 32, 64) for u in ("", "u")},
}
"""Type -> nothing, the most, the least and one."""


def _counted(kind: str, number: int) -> Any:
    """Return the item of that number in a long sequence."""
    if kind == "bool":
        return number % 2 != 0
    if kind.startswith("float"):
        return 1.125 * number
    bits = int(kind.lstrip("uint")) if "int" in kind else 8
    if kind.startswith("int"):
        return int_from_uint(number, bits)
    return bytes([number % 256]) if kind == "byte" else number % (1 << bits)


def _collections(message: Any, items: Callable[[str], list[Any]], texts: list[str], nested: list[Any]) -> Any:
    """Fill the fields of a message that are arrays or sequences of the basic types, of texts and of messages."""
    for kind in _EXTREMES:
        setattr(message, f"{kind}_values", items(kind))
    if hasattr(message, "string_values"):
        message.string_values = texts
    message.basic_types_values = nested
    return message


def _first_three(kind: str) -> list[Any]:
    return list(_EXTREMES[kind][:3])


def _rising(kind: str) -> list[Any]:
    nothing, most, least, one = _EXTREMES[kind]
    return [nothing, most, least] if kind == "bool" or least != nothing else [nothing, one, most]


def get_msg_builtins() -> list[Builtins]:
    """Return a Builtins with a time and a duration before zero."""
    message = Builtins()
    message.duration_value.sec = message.time_value.sec = -1234567890
    message.duration_value.nanosec = 123456789
    message.time_value.nanosec = 987654321
    return [message]


def get_msg_empty() -> list[Empty]:
    """Return an Empty."""
    return [Empty()]


def get_msg_basic_types() -> list[BasicTypes]:
    """Return a BasicTypes each of zeros, the largest, the smallest values and ones."""
    return [BasicTypes(**{f"{kind}_value": values[at] for kind, values in _EXTREMES.items()}) for at in range(4)]


def get_msg_constants() -> list[Constants]:
    """Return a Constants."""
    return [Constants()]


def get_msg_defaults() -> list[Defaults]:
    """Return a Defaults with its defaults."""
    return [Defaults()]


def get_msg_strings() -> list[Strings]:
    """Return a Strings each of nothing, ASCII, umlauts and long text."""
    texts = ("", "Hello world!", "Hellö Wörld!", _LONG)
    return [Strings(string_value=text, bounded_string_value=text[:22]) for text in texts]


def get_msg_nested() -> list[Nested]:
    """Return a Nested around each of `get_msg_basic_types`."""
    return [Nested(basic_types_value=each) for each in get_msg_basic_types()]


def get_msg_arrays() -> list[Arrays]:
    """Return a full Arrays."""
    return [_collections(Arrays(), _first_three, ["", "max value", "min value"], get_msg_basic_types()[:3])]


def get_msg_unbounded_sequences() -> list[UnboundedSequences]:
    """Return an UnboundedSequences each with none, one, up to three and a thousand items, and an untouched one."""
    basic = get_msg_basic_types()
    messages = [
        _collections(UnboundedSequences(), lambda kind: [], [], []),
        _collections(UnboundedSequences(), lambda kind: [_EXTREMES[kind][1]], ["max value"], basic[:1]),
        _collections(
            UnboundedSequences(),
            lambda kind: list(dict.fromkeys(_first_three(kind))),
            ["", "max value", "optional min value"],
            basic[:3],
        ),
        _collections(
            UnboundedSequences(),
            lambda kind: [_counted(kind, number) for number in range(_MANY)],
            [str(number) for number in range(_MANY)],
            [basic[number % 4] for number in range(_MANY)],
        ),
        UnboundedSequences(),
    ]
    for number, message in enumerate(messages):
        message.alignment_check = number
    return messages


def _bounded(kind: type[Any]) -> list[Any]:
    texts = ["", "max value", "optional min value"]
    return [
        _collections(kind(alignment_check=2), _rising, texts, get_msg_basic_types()[:3]),
        kind(alignment_check=4),
    ]


def get_msg_bounded_sequences() -> list[BoundedSequences]:
    """Return a full BoundedSequences and an untouched one."""
    return _bounded(BoundedSequences)


def get_msg_bounded_plain_sequences() -> list[BoundedPlainSequences]:
    """Return a full BoundedPlainSequences and an untouched one."""
    return _bounded(BoundedPlainSequences)


def get_msg_multi_nested() -> list[MultiNested]:
    """Return a MultiNested with three of the messages above in each field."""
    inner = {
        "arrays": get_msg_arrays(),
        "bounded_sequences": get_msg_bounded_sequences(),
        "unbounded_sequences": get_msg_unbounded_sequences(),
    }
    message = MultiNested()
    for outer in ("array", "bounded_sequence", "unbounded_sequence"):
        for name, messages in inner.items():
            setattr(message, f"{outer}_of_{name}", [messages[number % len(messages)] for number in range(3)])
    return [message]


def get_msg_wstrings() -> list[WStrings]:
    """Return a WStrings with full collections, then one each of ASCII, umlauts and Japanese."""
    full = WStrings(
        array_of_wstrings=["1", "two", "三"],
        bounded_sequence_of_wstrings=["one", "二"],
        unbounded_sequence_of_wstrings=[".", "..", "...", "四"],
    )
    return [full, *(WStrings(wstring_value=text) for text in ("ascii", "Hellö Wörld!", "ハローワールド"))]


_FIXTURES: dict[str, Callable[[], list[Any]]] = {
    "Arrays": get_msg_arrays,
    "BasicTypes": get_msg_basic_types,
    "BoundedPlainSequences": get_msg_bounded_plain_sequences,
    "BoundedSequences": get_msg_bounded_sequences,
    "Builtins": get_msg_builtins,
    "Constants": get_msg_constants,
    "Defaults": get_msg_defaults,
    "Empty": get_msg_empty,
    "MultiNested": get_msg_multi_nested,
    "Nested": get_msg_nested,
    "Strings": get_msg_strings,
    "UnboundedSequences": get_msg_unbounded_sequences,
    "WStrings": get_msg_wstrings,
}


def get_test_msg(message_name: str) -> list[Any]:
    """Return the messages of `test_msgs/msg/<message_name>`; NotImplementedError for a name that isn't in test_msgs."""
    if message_name not in _FIXTURES:
        raise NotImplementedError
    return _FIXTURES[message_name]()
