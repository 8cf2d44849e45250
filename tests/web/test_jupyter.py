"""The tile in JupyterLab; `try_jupyter.py` opens it in a real one."""

from __future__ import annotations

import json
import subprocess
import sys
from importlib.metadata import entry_points
from pathlib import Path

import pytest

pytest.importorskip("aiohttp", reason="needs the extra: pip install 'day6-tui[serve]'")


@pytest.mark.process
def test_jupyter_finds_the_tile_without_loading_a_desktop() -> None:
    code = """
import json, sys
from day6_tui.web.jupyter import server
print(json.dumps([server(), sorted({"textual", "aiohttp", "rich", "numpy"} & set(sys.modules))]))
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, encoding="utf-8", check=True, cwd="/")
    told, loaded = json.loads(done.stdout)
    assert loaded == []
    assert Path(told["launcher_entry"]["icon_path"]).read_bytes().lstrip().startswith(b"<svg")
    assert told["unix_socket"] is True


def test_what_jupyter_starts_is_a_command_line_of_ours() -> None:
    from day6_tui.web.jupyter import server
    from day6_tui.web.options import parse

    command = [word.format(unix_socket="/run/s", base_url="/user/anna/day6/", port=0) for word in server()["command"]]
    settings = parse(command[command.index("serve") + 1 :], "en")
    assert settings.home == Path.home() / "day6"  # which the file browser shows
    assert settings.proxied and settings.unix == Path("/run/s") and settings.base_url == "/user/anna/day6/"


def test_the_entry_point_is_declared() -> None:
    (found,) = entry_points(group="jupyter_serverproxy_servers", name="day6")
    assert found.load().__name__ == "server"
