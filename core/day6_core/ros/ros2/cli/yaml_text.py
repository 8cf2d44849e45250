"""Reads the YAML of a command line or a file without blocking other programs."""

from __future__ import annotations

import io
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, TypeVar

from day6_core.session.threads import in_thread

if TYPE_CHECKING:
    from typing import TextIO

    from day6_core.session.session import Session

_Result = TypeVar("_Result")

SHORT = 1000
"""Characters that are read at once; longer texts may take seconds (PyYAML takes five for 100,000 `[`)."""


def load(text: str | bytes | TextIO, abandoned: threading.Event) -> Any:
    """Like `yaml.safe_load`, but stops once `abandoned` is set. Raises yaml.YAMLError, RecursionError."""
    with _loader(text, abandoned) as loader:
        return loader.get_single_data()


def load_all(text: str | bytes | TextIO, abandoned: threading.Event) -> list[Any]:
    """Return the documents of a text, as `load` does its only one; those with nothing in them are left out."""
    found = []
    with _loader(text, abandoned) as loader:
        while loader.check_data():
            found.append(loader.get_data())
    return [each for each in found if each is not None]


@contextmanager
def _loader(text: str | bytes | TextIO, abandoned: threading.Event) -> Iterator[Any]:
    import yaml

    class Loader(yaml.SafeLoader):
        def fetch_more_tokens(self) -> Any:
            if abandoned.is_set():
                raise KeyboardInterrupt
            return super().fetch_more_tokens()

    loader = Loader(text)
    try:
        yield loader
    finally:
        loader.dispose()


async def in_turns_with_others(read: Callable[[threading.Event], _Result]) -> _Result:
    """Run `read` in its own thread; its event is set when Ctrl-C has ended the command."""
    abandoned = threading.Event()
    try:
        return await in_thread(lambda: read(abandoned))
    finally:
        abandoned.set()


async def safe_load(text: str | bytes) -> Any:
    """Return the value of a YAML text. Raises yaml.YAMLError, RecursionError."""
    if len(text) <= SHORT:
        return load(text, threading.Event())
    return await in_turns_with_others(lambda abandoned: load(text, abandoned))


def file_text(session: Session, name: str) -> TextIO:
    """Return the text of a file that the user named; YAML's errors then name it as the user did. Raises OSError."""
    from day6_core.session.blocking_files import refuse

    try:
        path = session.cwd / name
        refuse(str(path), path.stat().st_mode, writing=False)  # a pipe waits for its writer, a device has no end
        stream = io.StringIO(path.read_text(encoding="utf-8"))
    except OSError as error:
        error.filename = name
        raise
    stream.name = name
    return stream
