"""What is used of IPython's shell, whose own types differ from version to version."""

from __future__ import annotations

from collections.abc import Callable
from types import TracebackType
from typing import Protocol


class Events(Protocol):
    """What happens to cells."""

    def register(self, event: str, function: Callable[..., None]) -> None:
        """Call a function at every event of this name, such as "post_run_cell"."""

    def unregister(self, event: str, function: Callable[..., None]) -> None:
        """Stop calling it."""


class Magics(Protocol):
    """The commands that begin with %."""

    magics: dict[str, dict[str, object]]
    """By kind, "line" or "cell", and name."""


class Tracebacks(Protocol):
    """How an exception is shown in this notebook."""

    def structured_traceback(
        self, kind: type[BaseException], error: BaseException, trace: TracebackType | None, tb_offset: int
    ) -> list[str]:
        """Return the parts of its picture, after `tb_offset` frames are left out."""

    def stb2text(self, parts: list[str]) -> str:
        """Return them as one text."""


class Compiler(Protocol):
    """What compiles cells."""

    def format_code_name(self, name: str) -> tuple[str, str] | None:
        """Return how to call the file of a cell, such as ("Cell", "In[3]"); None for any other file."""


class InteractiveShell(Protocol):
    """IPython.core.interactiveshell.InteractiveShell, as far as it is used here."""

    @property
    def events(self) -> Events:
        """What happens to cells."""

    @property
    def magics_manager(self) -> Magics:
        """The commands that begin with %."""

    @property
    def InteractiveTB(self) -> Tracebacks:
        """How an exception is shown."""

    @property
    def compile(self) -> Compiler:
        """What compiles cells."""

    @property
    def user_ns(self) -> dict[str, object]:
        """The variables of the cells."""

    def register_magic_function(self, function: Callable[[str], None], magic_kind: str, magic_name: str) -> None:
        """Add a command that begins with %."""

    @property
    def custom_exceptions(self) -> tuple[type[BaseException], ...]:
        """The exceptions that are shown in a way of their own."""

    def set_custom_exc(self, kinds: tuple[type[BaseException], ...], handler: Callable[..., None] | None) -> None:
        """Show these exceptions by a function of shell, kind, exception, traceback and the number of frames to leave out."""

    def showtraceback(
        self, error: tuple[type[BaseException], BaseException, TracebackType | None], *, tb_offset: int | None
    ) -> None:
        """Show an exception of a cell, after `tb_offset` frames are left out."""
