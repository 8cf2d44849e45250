"""The variables of a shell: texts and arrays with their attributes, and those whose value is worked out when it is asked for.

As a mapping it shows what `$NAME` shows: of an array the element 0.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, MutableMapping
from dataclasses import dataclass, field

from day6_core.shell.language.words import SyntaxProblem

ATTRIBUTES = "aAilnrux"
"""In the order in which `declare -p` shows them."""
_MOST_REFERENCES = 8


class ReadOnlyProblem(SyntaxProblem):
    """A variable that may not change was assigned to; it ends a shell that nobody types into, as far as bash ends it."""


@dataclass
class Cell:
    """One variable. An array has `items` by their key as a text ('0', '1', … if it is indexed), a plain one has `text`."""

    text: str | None = None
    items: dict[str, str] | None = None
    attributes: set[str] = field(default_factory=set)

    @property
    def keyed(self) -> bool:
        """Whether it was declared with -A."""
        return "A" in self.attributes

    @property
    def value(self) -> str | None:
        """What `$NAME` is."""
        return self.text if self.items is None else self.items.get("0")

    def keys(self) -> list[str]:
        """The keys of an array in the order in which it is walked through."""
        if self.items is None:
            return ["0"] if self.text is not None else []
        return hashed(self.items) if self.keyed else sorted(self.items, key=int)

    def values(self) -> list[str]:
        if self.items is None:
            return [self.text] if self.text is not None else []
        return [self.items[key] for key in self.keys()]

    def copy(self) -> Cell:
        return Cell(self.text, None if self.items is None else dict(self.items), set(self.attributes))


def hashed(items: Mapping[str, str]) -> list[str]:
    """The keys of an associative array in bash's order: by the buckets of its table, the latest first in each."""
    buckets: dict[int, list[str]] = {}
    size = _BUCKETS
    while len(items) > size * 2:  # a table is enlarged when it is twice as full as it has buckets
        size *= 4
    for key in items:
        buckets.setdefault(_hash(key) & (size - 1), []).insert(0, key)
    return [key for number in sorted(buckets) for key in buckets[number]]


_BUCKETS = 1024
"""Of a new associative array (bash's assoc.h)."""


def _hash(text: str) -> int:
    """FNV-1 of 32 bits, as bash's hashlib.c."""
    value = 0x811C9DC5
    for byte in text.encode("utf-8", "surrogateescape"):
        value = (value * 0x01000193) & 0xFFFFFFFF
        value ^= byte - 256 & 0xFFFFFFFF if byte > 127 else byte
    return value


class Variables(MutableMapping[str, str]):
    """See the module's docstring. `evaluate` works out integers, for variables with `declare -i`."""

    def __init__(self, environment: Mapping[str, str] | None = None) -> None:
        self.cells: dict[str, Cell] = {}
        self.dynamic: dict[str, Callable[[], str | list[str]]] = {}
        """Values that are worked out, until the variable is unset."""
        self.on_assignment: dict[str, Callable[[str], None]] = {}
        """What is to be done when one of them is assigned to."""
        self.evaluate: Callable[[str], int] = int
        self.adopt(environment or {})

    # -- as a mapping --------------------------------------------------------------------------------------------------

    def __getitem__(self, name: str) -> str:
        found = self.find(name)
        value = found.value if found is not None else None
        if value is None:
            raise KeyError(name)
        return value

    def __setitem__(self, name: str, value: str) -> None:
        self.assign(name, value)

    def __delitem__(self, name: str) -> None:
        if name not in self.cells and name not in self.dynamic:
            raise KeyError(name)
        self.dynamic.pop(name, None)
        self.cells.pop(name, None)

    def __iter__(self) -> Iterator[str]:
        return iter([name for name, cell in self.cells.items() if cell.value is not None])

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def __contains__(self, name: object) -> bool:
        return isinstance(name, str) and self.get(name) is not None

    # -- cells ---------------------------------------------------------------------------------------------------------

    def resolved(self, name: str) -> str:
        """The name that a reference (`declare -n`) stands for, through all of them."""
        for _ in range(_MOST_REFERENCES):
            cell = self.cells.get(name)
            if cell is None or "n" not in cell.attributes or not cell.text:
                return name
            name = cell.text
        return name

    def find(self, name: str) -> Cell | None:
        """The variable, None if there is none. One that is worked out has its value of now."""
        name = self.resolved(name)
        if name.endswith("]"):  # a reference to an element
            base, _, key = name[:-1].partition("[")
            value = self.element(base, key)
            return None if value is None else Cell(value)
        if name in self.dynamic:
            value_now = self.dynamic[name]()
            attributes = self.cells[name].attributes if name in self.cells else set()
            if isinstance(value_now, str):
                return Cell(value_now, attributes=attributes)
            return Cell(items={str(at): each for at, each in enumerate(value_now)}, attributes=attributes | {"a"})
        return self.cells.get(name)

    def element(self, name: str, key: str) -> str | None:
        cell = self.find(name)
        if cell is None:
            return None
        if cell.items is None:
            return cell.text if key == "0" else None
        return cell.items.get(key if cell.keyed else self.index(cell, key))

    def is_outside(self, name: str, key: str) -> bool:
        """Whether a key can be none: it is empty, or a negative number before the first element of an indexed array."""
        cell = self.find(name)
        if cell is not None and cell.keyed:
            return not key
        return key.startswith("-") and self.index(cell or Cell(), key).startswith("-")

    @staticmethod
    def index(cell: Cell, key: str) -> str:
        """The key of an indexed array that a number means; a negative one counts from the end."""
        number = int(key)
        if number < 0:
            number += max(map(int, cell.items or {"-1": ""}), default=-1) + 1
        return str(number)

    # -- changes -------------------------------------------------------------------------------------------------------

    def changeable(self, name: str) -> Cell:
        """The variable, made if there is none, to be changed. Raises ReadOnlyProblem."""
        name = self.resolved(name)
        cell = self.cells.get(name)
        if cell is None:
            cell = self.cells[name] = Cell()
        if "r" in cell.attributes:
            raise ReadOnlyProblem(f"{name}: readonly variable")
        return cell

    def assign(self, name: str, value: str, *, key: str | None = None, append: bool = False) -> None:
        """`name=value`, `name[key]=value`; `append`: `+=`. Raises ReadOnlyProblem."""
        name = self.resolved(name)
        if name.endswith("]") and key is None:
            name, _, key = name[:-1].partition("[")
        cell = self.changeable(name)
        if name in self.dynamic and key is None:
            on_assignment = self.on_assignment.get(name)
            if on_assignment is not None:
                on_assignment(value)
            return
        if key is not None and cell.items is None:
            self.make_array(cell)
        if cell.items is None:
            cell.text = self._adapted(cell, cell.text, value, append)
            return
        at = "0" if key is None else key if cell.keyed else self.index(cell, key)
        if not at or (at.startswith("-") and not cell.keyed):
            raise SyntaxProblem(f"{name}[{key}]: bad array subscript")
        cell.items[at] = self._adapted(cell, cell.items.get(at), value, append)

    def assign_array(self, name: str, items: list[tuple[str | None, str, bool]], *, append: bool = False) -> None:
        """`name=(…)`: an item is a key or None, a value, and whether that is appended to the element. Raises ReadOnlyProblem."""
        cell = self.changeable(name)
        self.dynamic.pop(name, None)
        if cell.items is None:
            self.make_array(cell, keep=append)
        assert cell.items is not None
        if not append:
            cell.items = {}
        following = max(map(int, cell.items), default=-1) + 1 if not cell.keyed else 0
        for key, value, extends in items:
            if key is None:
                key = str(following)
            elif not cell.keyed:
                key = self.index(cell, key)
                if key.startswith("-"):
                    raise SyntaxProblem(f"{name}[{key}]: bad array subscript")
            cell.items[key] = self._adapted(cell, cell.items.get(key), value, extends)
            if not cell.keyed:
                following = int(key) + 1

    @staticmethod
    def make_array(cell: Cell, *, keep: bool = True, keyed: bool = False) -> None:
        """Turn a plain variable into an array whose element 0 is its text."""
        cell.items = {"0": cell.text} if cell.text is not None and keep else {}
        cell.text = None
        cell.attributes.add("A" if keyed or "A" in cell.attributes else "a")

    def _adapted(self, cell: Cell, before: str | None, value: str, append: bool) -> str:
        """The text that is kept of a value: a number for `-i`, upper or lower case for `-u` and `-l`."""
        if "i" in cell.attributes:
            number = self.evaluate(value or "0") + (self.evaluate(before or "0") if append else 0)
            return str((number + 2**63) % 2**64 - 2**63)
        text = (before or "") + value if append else value
        if "u" in cell.attributes:
            return text.upper()
        return text.lower() if "l" in cell.attributes else text

    def unset(self, name: str, key: str | None = None) -> None:
        """Remove a variable or an element. Raises ReadOnlyProblem."""
        cell = self.cells.get(name)
        if cell is not None and "r" in cell.attributes:
            raise ReadOnlyProblem(f"{name}: cannot unset: readonly variable")
        if key is None:
            self.dynamic.pop(name, None)
            self.cells.pop(name, None)
        elif cell is not None and cell.items is not None:
            cell.items.pop(key if cell.keyed else self.index(cell, key), None)

    def adopt(self, environment: Mapping[str, str]) -> None:
        """Take over what a program inherits; a variable that may not change is left as it is, and IFS is never inherited."""
        for name, text in environment.items():
            if (
                name not in self.dynamic
                and name != "IFS"
                and (name not in self.cells or "r" not in self.cells[name].attributes)
            ):
                self.cells[name] = Cell(text, attributes={"x"})

    def export(self, name: str) -> None:
        self.cells.setdefault(self.resolved(name), Cell()).attributes.add("x")

    @property
    def exported(self) -> dict[str, str]:
        """What programs inherit: names and texts."""
        return {
            name: cell.text if name not in self.dynamic else self[name]
            for name, cell in self.cells.items()
            if "x" in cell.attributes and cell.text is not None and "n" not in cell.attributes
        }

    def copy_from(self, other: Variables) -> None:
        """Become what a subshell starts with."""
        self.cells = {name: cell.copy() for name, cell in other.cells.items()}
