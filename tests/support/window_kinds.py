"""The kinds of windows: the modules in the rooms of `day6_tui.windows` that define one."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from day6_tui import windows


@cache
def window_kinds() -> tuple[str, ...]:
    found = []
    for module in sorted(Path(windows.__file__).parent.glob("*/*.py")):
        if module.stem != "__init__" and "Pane(" in module.read_text(encoding="utf-8") and _is_one(module.stem):
            found.append(module.stem)
    return tuple(found)


def _is_one(kind: str) -> bool:
    try:
        windows.pane_class(kind)
    except LookupError:
        return False
    return True
