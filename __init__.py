"""ROS 2 for people who have no ROS 2, in a text terminal. In a notebook: `%load_ext day6_tui`.

Everything is in the packages below; this is imported before each of them and imports nothing.
"""

from __future__ import annotations


def load_ipython_extension(shell: object) -> None:
    """Make the cells of a notebook ROS programs (`tui/notebook.py`); called by IPython."""
    from day6_tui.tui.notebook import load

    load(shell)


def unload_ipython_extension(shell: object) -> None:
    """Stop spinning their nodes."""
    from day6_tui.tui.notebook import unload

    unload(shell)
