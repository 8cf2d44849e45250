"""The kinds of values that options take; what is wrong with one is said in the user's language, before anything has begun."""

from __future__ import annotations

import os
from argparse import ArgumentTypeError
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.command_line.texts import Wording
from day6_core.reason import reason
from day6_core.whole_file import open_at_once

if TYPE_CHECKING:
    from day6_core.link.unusable import Unusable


class Values:
    """Each method is a `type` of an argument, or makes one. All raise ArgumentTypeError with the reason."""

    def __init__(self, texts: Wording) -> None:
        self._texts = texts

    def wrong(self, kind: str, **values: object) -> ArgumentTypeError:
        """The error for a value, to be raised."""
        return ArgumentTypeError(self._texts(f"cli.wrong.{kind}", **values))

    def folder(self, text: str) -> Path:
        """A folder that exists, by its whole path."""
        path = Path(text).expanduser()
        if not path.is_dir():
            raise self.wrong("folder", text=text)
        return path.resolve()

    def home(self, text: str) -> Path:
        """A folder, or what can become one: nothing above it is a file."""
        path = Path(text)
        above = path.expanduser().absolute()
        while not os.path.lexists(above) and above != above.parent:
            above = above.parent
        if not above.is_dir():
            raise self.wrong("home", text=text)
        return path

    def file(self, text: str) -> str:
        """A file that can be read."""
        try:
            if os.path.isdir(text):
                raise self.wrong("file.folder", text=text)
            with open(text, "rb", opener=open_at_once):
                return text
        except FileNotFoundError:
            raise self.wrong("file.missing", text=text) from None
        except (OSError, ValueError) as error:
            raise self.wrong("file", text=text, reason=reason(error)) from None

    def whole(self, least: int, most: int) -> Callable[[str], int]:
        """Whole numbers."""

        def read(text: str) -> int:
            if not (text.isascii() and text.isdigit() and len(text) < 10 and least <= int(text) <= most):
                raise self.wrong("number", text=text, least=least, most=most)
            return int(text)

        return read

    def number(self, least: float, most: float) -> Callable[[str], float]:
        """Numbers."""
        return lambda text: self._float(text, least, most, "number")

    def seconds(self, text: str) -> float:
        """A time, or how long something may take."""
        return self._float(text, 0, 1e9, "seconds")

    def minutes(self, text: str) -> float:
        """How long something may take."""
        return self._float(text, 0, 1e6, "minutes")

    def address(self, text: str) -> str:
        """A path (`/user/anna/day6/`) or a whole address of the web; it ends with a slash."""
        from urllib.parse import urlsplit

        parts = urlsplit(text)
        if not (parts.scheme in ("http", "https") and parts.netloc) and not text.startswith("/"):
            raise self.wrong("address", text=text)
        return text if text.endswith("/") else f"{text}/"

    def endpoint(self, *, listening: bool, port: int | None = None) -> Callable[[str], str]:
        """Endpoints of Zenoh, to listen on or to connect to; HOST:PORT means TCP, and so does HOST where a port is usual."""

        def read(text: str) -> str:
            from day6_core.link.addresses import address_of, meant
            from day6_core.link.engine import why_no_zenoh
            from day6_core.link.unusable import Unusable

            if why := why_no_zenoh(self._texts.language):
                raise ArgumentTypeError(why)

            try:
                address_of(endpoint := meant(text, port), listening=listening)
            except Unusable as error:
                raise self.unusable(error) from None
            return endpoint

        return read

    def secret(self, text: str) -> str:
        """A secret, or a file with one."""
        from day6_core.link.secret import secret_of
        from day6_core.link.unusable import Unusable

        try:
            return secret_of(text)
        except Unusable as error:
            raise self.unusable(error) from None

    def unusable(self, error: Unusable) -> ArgumentTypeError:
        """The error for an endpoint or a secret that cannot be used, to be raised."""
        return ArgumentTypeError(error.said(self._texts.language))

    def _float(self, text: str, least: float, most: float, kind: str) -> float:
        try:
            value = float(text)
        except ValueError:
            value = least - 1
        if not least <= value <= most:
            raise self.wrong(kind, text=text, least=least, most=most)
        return value
