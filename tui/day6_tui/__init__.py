"""The desktop in the terminal: panes for terminals and windows, drawn from the models that `day6_core` owns.

Everything here may import `day6_core` and Textual; nothing outside may import this. A pane owns no state of its
model: it reads a snapshot on the one frame timer (`frames`) and refreshes the cells that changed. This module imports nothing.

In a notebook: `%load_ext day6_tui`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_tui.notebook.shell import InteractiveShell


def load_ipython_extension(shell: InteractiveShell) -> None:
    """Make the cells of a notebook ROS programs (`notebook`); called by IPython."""
    from day6_tui.notebook.extension import load

    load(shell)


def unload_ipython_extension(shell: InteractiveShell) -> None:
    """Stop spinning their nodes."""
    from day6_tui.notebook.extension import unload

    unload(shell)
