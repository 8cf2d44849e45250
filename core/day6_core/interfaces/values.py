"""Parses the values in interface texts, with the rules and error texts of rosidl_adapter/parser.py."""

from __future__ import annotations

from day6_core.interfaces.fields import ARRAY, BOUNDED, PRIMITIVES, SINGLE, STRINGS, FieldType

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class InvalidValue(Exception):
    """A default or constant does not fit its type (the same name as in rosidl_adapter.parser)."""

    def __init__(self, type_name: str, value: str, reason: str) -> None:
        super().__init__(f"value '{value}' can not be converted to type '{type_name}': {reason}")


def parse_value(type_: FieldType, text: str) -> Any:
    """Parse a field's default value; a list for arrays and sequences.

    Raises:
        InvalidValue, ValueError: the text is not a value of the type.
        NotImplementedError: the type is a message.
    """
    if type_.nested:
        raise NotImplementedError(f"parsing string values into type '{type_.msg_name()}' is not supported")
    if type_.count == SINGLE:
        return parse_primitive(type_.base, text, type_.string_bound)
    if not (text.startswith("[") and text.endswith("]")):
        raise InvalidValue(type_.msg_name(), text, "array value must start with '[' and end with ']'")
    inner = text[1:-1]
    texts = _split_strings(inner) if type_.base in STRINGS else (inner.split(",") if inner else [])
    if type_.count == ARRAY and len(texts) != type_.size:
        reason = f"array must have exactly {type_.size} elements, not {len(texts)}"
        raise InvalidValue(type_.msg_name(), text, reason)
    if type_.count == BOUNDED and len(texts) > type_.size:
        reason = f"array must have not more than {type_.size} elements, not {len(texts)}"
        raise InvalidValue(type_.msg_name(), text, reason)
    values = []
    for index, element in enumerate(texts):
        try:
            values.append(parse_primitive(type_.base, element.strip(), type_.string_bound))
        except InvalidValue as error:
            raise InvalidValue(type_.msg_name(), text, f"element {index} with {error}") from None
    return values


def parse_primitive(name: str, text: str, string_bound: int = 0) -> Any:
    """Parse one value of the primitive type `name` (.msg name); an int for `byte` and `char`.

    Raises:
        InvalidValue: the text is not a value of the type.
    """
    if name in STRINGS:
        return _parse_string(name, text, string_bound)
    if name == "bool":
        lowered = text.lower()
        if lowered not in ("true", "1", "false", "0"):
            raise InvalidValue(name, text, "must be either 'true' / '1' or 'false' / '0'")
        return lowered in ("true", "1")
    primitive = PRIMITIVES[name]
    if primitive.python is float:
        try:
            return float(text)
        except ValueError:
            reason = "must be a floating point number using '.' as the separator"
            raise InvalidValue(name, text, reason) from None
    low, high = (0, 255) if name == "byte" else (primitive.low, primitive.high)
    value = _integer(text)
    if value is None or not low <= value <= high:
        raise InvalidValue(name, text, f"must be a valid integer value >= {low} and <= {high}")
    return value


def _integer(text: str) -> int | None:
    """Return a decimal, 0x, 0o or 0b integer; None for anything else."""
    for base in (10, 0):
        try:
            return int(text, base)
        except ValueError:
            continue
    return None


def _parse_string(name: str, text: str, bound: int) -> str:
    for quote in "\"'":
        if text.startswith(quote) and text.endswith(quote):
            text = text[1:-1]
            if _has_bare(text, quote):
                raise InvalidValue(name, text, "string inner quotes not properly escaped")
            text = text.replace("\\" + quote, quote)
            break
    if bound and len(text) > bound:
        reason = f"string must not exceed the maximum length of {bound} characters"
        raise InvalidValue(f"{name}<={bound}", text, reason)
    return text


def _has_bare(text: str, quote: str) -> bool:
    """Return whether the text contains a quote without a backslash before it."""
    return any(char == quote and text[max(index - 1, 0) : index] != "\\" for index, char in enumerate(text))


def _split_strings(text: str) -> list[str]:
    """Split the inside of a list of strings and unquote its elements; a comma inside quotes is not a separator."""
    found: list[str] = []
    text = text.lstrip(" ")
    while text:
        if text[0] == ",":
            raise ValueError(f"unxepected ',' at beginning of [{text}]")
        quote = text[0] if text[0] in "\"'" else ""
        if quote:
            end = _closing_quote(text, quote)
            if end < 0:
                raise ValueError(f"string [{text}] incorrectly quoted\n{found}")
            found.append(text[1:end].replace("\\" + quote, quote))
            text = text[end + 1 :]
        else:
            element, comma, rest = text.partition(",")
            found.append(element)
            text = comma + rest
        text = text.lstrip(" ").removeprefix(",").lstrip(" ")
    return found


def _closing_quote(text: str, quote: str) -> int:
    """Return the index of the quote that ends the string beginning at index 0, -1 if there is none."""
    index = text.find(quote, 1)
    while index > 0 and text[index - 1] == "\\":
        index = text.find(quote, index + 1)
    return index
