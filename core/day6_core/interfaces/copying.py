"""Deep copies of messages, with one function per class, generated on first use."""

from __future__ import annotations

from array import array

from day6_core.interfaces import checks
from day6_core.interfaces.definition import Structure
from day6_core.interfaces.fields import ARRAY, SINGLE
from day6_core.interfaces.registry import find_class, is_light, message_class, type_name

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any


def copy_message(message: Any) -> Any:
    """Return a message that shares nothing mutable with the given one.

    This is the object a subscription receives of a published message: of the generated class even if the program derived one,
    with lists in place of tuples, and `_check_fields` as in a new message.

    Raises:
        TypeError: `message` is not a message.
        AttributeError: a program stored something else in place of a nested message.
    """
    return _copiers[message.__class__](message)


class _Copiers(dict[type, "Callable[[Any], Any]"]):
    """The copy functions by class; missing ones are generated."""

    def __missing__(self, cls: Any) -> Callable[[Any], Any]:
        self[cls] = copier = _build(message_class(cls))
        return copier


_copiers = _Copiers()


def _build(cls: Any) -> Callable[[Any], Any]:
    names: dict[str, Any] = {"new": object.__new__, "check": checks.CHECK_FIELDS, "C": cls, "copiers": _copiers}
    writer = _Writer(names)
    writer.copy("C", "message", "made", cls._structure)
    source = ["def copy(message):", *writer.lines, "    return made"]
    exec(compile("\n".join(source), f"<copy {type_name(cls)}>", "exec"), names)
    copier: Callable[[Any], Any] = names["copy"]
    return copier


class _Writer:
    """Writes the body of a copy function; single nested messages are copied inline."""

    def __init__(self, names: dict[str, Any]) -> None:
        self.names = names
        self.lines: list[str] = []
        self.count = 0

    def copy(self, class_name: str, source: str, target: str, structure: Structure) -> None:
        """Append statements that create `target`, an object of the class, from the variable `source`."""
        lines = self.lines
        lines += [f"    {target} = new({class_name})", *checks.slot_lines(f"    {target}")]
        for field in structure.fields:
            old, new = f"{source}._{field.name}", f"{target}._{field.name}"
            type_ = field.type
            if type_.nested:
                self.count += 1
                name = f"C{self.count}"
                nested = self.names[name] = find_class(type_.base)
                if type_.count == SINGLE and is_light(type_.base):
                    inner, made = f"s{self.count}", f"t{self.count}"
                    lines.append(f"    {inner} = {old}")
                    self.copy(name, inner, made, nested._structure)
                    lines.append(f"    {new} = {made}")
                else:
                    self.names[name] = _copiers[nested]
                    one = type_.count == SINGLE
                    lines.append(
                        f"    {new} = {name}({old})" if one else f"    {new} = [{name}(item) for item in {old}]"
                    )
            elif type_.count == SINGLE and type_.base == "float32":
                # A float32 has a 24-bit significand on the wire; a subscription in the same process must not get more.
                self.names["single"] = array
                lines.append(f"    {new} = single('f', ({old},))[0] if {old}.__class__ is float else {old}")
            elif type_.count == SINGLE:
                lines.append(f"    {new} = {old}")
            elif type_.is_numeric_array():
                lines.append(f"    {new} = {old}.copy()" if type_.count == ARRAY else f"    {new} = {old}[:]")
            else:
                lines.append(f"    {new} = [*{old}]")
