"""ROS 2 for people who have no ROS 2, in a text terminal. In a notebook: `%load_ext day6_tui`.

Everything is in the packages below; this is imported before each of them and imports nothing.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_tui.tui.notebook.shell import Shell


def load_ipython_extension(shell: Shell) -> None:
    """Make the cells of a notebook ROS programs (`tui/notebook`); called by IPython."""
    from day6_tui.tui.notebook.extension import load

    load(shell)


def unload_ipython_extension(shell: Shell) -> None:
    """Stop spinning their nodes."""
    from day6_tui.tui.notebook.extension import unload

    unload(shell)
