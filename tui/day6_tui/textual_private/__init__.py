"""What relies on Textual's private names: nothing else of day6-tui touches them (a test looks).

A new release of Textual may change any of them without notice. So pyproject pins the releases that this was tested with, and the
desktop refuses to start with another one rather than fail in the middle of something.
"""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

TESTED = "8.2"


def version() -> str:
    """Return the version of the installed Textual, '' if its installation does not state one."""
    # The name of the metadata folder: importlib.metadata would cost the first frame 20 ms for the same answer.
    found = find_spec("textual")
    folders = Path(found.origin).parent.parent.glob("textual-*.dist-info") if found and found.origin else ()
    return next((folder.name.split("-")[1].removesuffix(".dist") for folder in folders if folder.is_dir()), "")


def supported() -> bool:
    """Whether this was tested with the installed Textual, or nobody knows which it is."""
    return version() == "" or version().startswith(f"{TESTED}.")


def install() -> None:
    """Put in place what replaces methods of Textual."""
    from day6_tui.textual_private import output

    output.install()
