"""The folders in which Windows searches for DLLs."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from typing import Any


@contextmanager
def add_dll_directories_from_env(env_name: str) -> Iterator[list[Any]]:
    """Let DLLs be found, inside the `with` block, in the folders of an environment variable.

    Yields the handles of the added folders; an empty list on all systems except Windows.
    """
    add: Callable[[str], Any] | None = getattr(os, "add_dll_directory", None)
    handles: list[Any] = []
    with ExitStack() as added:
        for folder in os.environ.get(env_name, "").split(os.pathsep):
            if add is not None and os.path.isabs(folder) and os.path.isdir(folder):
                handles.append(added.enter_context(add(folder)))
        yield handles
