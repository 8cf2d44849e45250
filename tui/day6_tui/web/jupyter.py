"""The tile "ROS 2" in JupyterLab's launcher, by jupyter-server-proxy (its entry point `jupyter_serverproxy_servers`).

The Jupyter server starts `day6-tui serve` on a socket that only its user reaches, and lets nobody else through: one desktop, that
goes on when the tab is closed and ends with the Jupyter server. Its ~ is a folder that JupyterLab's file browser shows, and its
graph is that of the user's other programs: cells of a notebook and the desktop see each other.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

FOLDER = "day6"
"""In the user's home folder: what is ~ on the desktop."""
START_SECONDS = 60
"""What the first desktop may take on a machine that many pupils enter at the same time; the default is 5."""


def server() -> dict[str, Any]:
    """Return what jupyter-server-proxy has to know; it fills the braces."""
    serve = [sys.executable, "-m", "day6_tui.main", "serve", "--proxied", "--home", str(Path.home() / FOLDER)]
    return {
        "command": [*serve, "--unix", "{unix_socket}", "--base-url", "{base_url}"],
        "unix_socket": True,
        "timeout": START_SECONDS,
        "new_browser_tab": True,
        "launcher_entry": {
            "title": "ROS 2",
            "icon_path": str(Path(__file__).with_name("static") / "icon.svg"),
        },
    }
