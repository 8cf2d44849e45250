"""`day6-tui serve` on the command line: what it refuses, and how else it can be reached."""

from __future__ import annotations

import asyncio
import os
import sys
from pathlib import Path

import aiohttp
import pytest

from tests.support import waiting
from tests.support.short_folder import make_short_folder
from tests.web.serving import Browser, Serving, run

pytestmark = pytest.mark.process


def refused(*words: str, folder: Path | None = None) -> tuple[int, str]:
    data = make_short_folder("d6w-") if folder is None else folder
    done = waiting.run([sys.executable, "-m", "day6_tui.main", "serve", "--lang", "en", "--data", str(data), *words])
    assert "Traceback" not in done.stderr
    return done.returncode, done.stderr.strip().splitlines()[-1]


@pytest.mark.parametrize(
    ("words", "status", "reason"),
    [
        (["--host", "0.0.0.0", "--isolation", "none"], 2, "--host 0.0.0.0: pupils are not kept apart here"),
        (["--word", "abc"], 2, "too easy to guess"),
        (["--word", "/nowhere/word"], 2, "/nowhere/word: No such file or directory"),
        (["--unasked", "-1"], 2, "isn't a number from 0 to"),
        (["--port", "70000"], 2, "isn't a number from 0 to 65535"),
        (["--memory", "1"], 2, "argument --memory: '1' isn't a number from 16"),
        (["--disk", "lots"], 2, "argument --disk"),
        (["--cpu-weight", "0"], 2, "argument --cpu-weight"),
        (["--idle", "soon"], 2, "isn't a number of minutes"),
        (["--key", "key.pem"], 2, "needs --cert"),
        (["--proxied", "--host", "0.0.0.0"], 2, "needs --unix"),
        (["--class", "/nowhere.csv", "--isolation", "none"], 1, "/nowhere.csv: No such file"),
        (["--cert", "/nowhere.pem", "--isolation", "none", "--port", "0"], 1, "/nowhere.pem: No such file"),
    ],
)
def test_what_cannot_be_is_told_in_a_line(words: list[str], status: int, reason: str) -> None:
    found, said = refused(*words)
    assert found == status and reason in said


def test_a_folder_has_one_server_and_files_of_others_stay(class_server: Serving) -> None:
    status, said = refused("--isolation", "none", "--port", "0", folder=class_server.folder / "class")
    assert status == 2 and "in use by another server" in said
    folder = make_short_folder("d6w-")
    (folder / "server").mkdir()
    (folder / "server" / "tokens.json").write_text("my own text")
    status, said = refused("--isolation", "none", "--port", "0", folder=folder)
    assert status == 2 and "not written by this program" in said
    assert (folder / "server" / "tokens.json").read_text() == "my own text"
    (folder / "socket").write_text("no socket")
    status, said = refused("--isolation", "none", "--unix", str(folder / "socket"))
    assert status == 1 and (folder / "socket").read_text() == "no socket"


def test_behind_a_proxy_on_a_unix_socket_the_user_needs_no_link_and_has_one_graph(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    folder = make_short_folder("d6w-")
    path, home = str(folder / "socket"), folder / "mine"
    monkeypatch.setenv("ROS_DOMAIN_ID", "7")
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(folder / "run"))
    monkeypatch.setenv("JUPYTERHUB_USER", "anna")
    words = ("--unix", path, "--proxied", "--home", str(home), "--base-url", "http://hub.example/user/me/day6")
    with Serving(folder, *words) as serving:

        async def deed() -> None:
            connector = aiohttp.UnixConnector(path)
            async with aiohttp.ClientSession(connector=connector) as session:
                door = Browser(session, "http://hub.example/")
                assert (await door.get(""))[0] == 303  # straight to the desktop
                assert (await door.get("desk"))[0] == 200
                tab = await door.tab()
                await tab.see("anna@day6:~$")
                await tab.type('echo seen > mine.txt; ros2 topic pub -r 5 /told std_msgs/msg/String "{data: hi}"\r')
                await tab.see("publishing #1")
                echo = [sys.executable, "-m", "day6_tui.main", "ros2", "topic", "echo", "--once", "/told"]
                echo += ["std_msgs/msg/String"]  # without it, a topic has to be known within a second or two
                env = {name: value for name, value in os.environ.items() if name != "DAY6_LINK"}
                heard = await asyncio.to_thread(waiting.run, echo, env=env)
                assert heard.stdout == "data: hi\n---\n", heard  # another program of the same user

        run(deed())
        assert serving.end() == 0 and serving.cells() == [] and not Path(path).exists()
    assert (home / "mine.txt").read_text() == "seen\n"
