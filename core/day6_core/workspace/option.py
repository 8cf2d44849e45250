"""What an option of colcon is, and what becomes of it here; the table of all options is `options`."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from enum import Enum
from typing import Any

from day6_core.workspace.events import LOG_LEVELS


class Treated(Enum):
    """What an option does here."""

    OBEYED = "as in colcon"
    SAID = "accepted; that it has no effect is said"
    REFUSED = "the call ends with a reason"


@dataclass(frozen=True)
class Option:
    """An option or argument. `names` may have a short one: '--names-only -n'; `keywords` are those of `add_argument`.

    `why` is the reason, in English and Chinese, if it isn't obeyed; `obeyed(value)` is whether a value is obeyed nevertheless.
    """

    names: str
    help: str
    keywords: dict[str, Any] = field(default_factory=dict)
    treated: Treated = Treated.OBEYED
    why: tuple[str, str] = ("", "")
    obeyed: Callable[[Any], bool] = lambda value: False
    apart: str = ""
    """Of the options of a group with the same word here, only one may be given."""

    @property
    def name(self) -> str:
        """The long name."""
        return self.names.split()[0]

    def has_effect(self, value: Any) -> bool:
        """Return whether this value, given on the command line, does what it does in colcon."""
        return (
            self.treated is Treated.OBEYED or value in (None, False, self.keywords.get("default")) or self.obeyed(value)
        )

    @property
    def destination(self) -> str:
        """The attribute of the namespace."""
        return self.name.lstrip("-").replace("-", "_")


@dataclass(frozen=True)
class Group:
    """Options that stand together in the help."""

    options: tuple[Option, ...]
    title: str = ""


def counting_number(text: str) -> int:
    """Return a number that isn't negative; argparse prints this function's name."""
    number = int(text)
    if number < 0:
        raise ValueError
    return number


def cmake_definitions(words: list[str] | None) -> tuple[dict[str, str], list[str]]:
    """Return the variables that arguments of CMake define (`-DNAME=VALUE`, `-D NAME:TYPE=VALUE`), and the other arguments."""
    defined: dict[str, str] = {}
    others: list[str] = []
    waiting = list(words or ())
    while waiting:
        word = waiting.pop(0)
        if word == "-D" and waiting:
            word += waiting.pop(0)
        name, equals, value = word.removeprefix("-D").partition("=")
        if word.startswith("-D") and equals:
            defined[name.partition(":")[0]] = value
        else:
            others.append(word)
    return defined, others


def definitions_only(words: list[str] | None) -> bool:
    return not cmake_definitions(words)[1]


def no_more_than_warnings(level: str) -> bool:
    return LOG_LEVELS.get(level.upper(), 0) >= LOG_LEVELS["WARNING"] or (
        level.isdigit() and int(level) >= LOG_LEVELS["WARNING"]
    )
