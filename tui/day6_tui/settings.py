"""What the user chose in the desktop and wants to find again: a small file in the user's data folder.

A file that cannot be understood is left as it is until the user chooses something.
"""

from __future__ import annotations

from pathlib import Path

from day6_core.places import data_folder
from day6_core.reason import reason
from day6_core.whole_file import write_private
from day6_tui.json_file import read_object

LARGEST = 64_000
"""More bytes than settings can have: the file is something else."""


class Settings:
    """Names and values, as JSON."""

    def __init__(self, path: Path | None = None) -> None:
        self.path = data_folder() / "settings.json" if path is None else path
        self.fault = ""
        """Why the file could not be read, '' if it could."""
        self._values: dict[str, object] = {}
        try:
            self._values = read_object(self.path, LARGEST)
        except FileNotFoundError:
            pass
        except OSError as error:
            self.fault = reason(error)
        except ValueError as error:
            self.fault = str(error).partition("\n")[0] or type(error).__name__

    def text(self, name: str) -> str:
        """The value of a setting, '' if it has none or it is no text."""
        value = self._values.get(name)
        return value if isinstance(value, str) else ""

    def set(self, name: str, value: str) -> None:
        """Remember a value. Raises OSError if the file cannot be written; the value holds until the end then."""
        import json

        self._values[name] = value
        write_private(self.path, json.dumps(self._values, ensure_ascii=False, indent=1).encode() + b"\n")
