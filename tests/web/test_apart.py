"""Pupils of a server that is not root, in sandboxes: nothing of one can be seen by the other, and it all outlives the server."""

from __future__ import annotations

import os
import signal
from pathlib import Path

import aiohttp
import pytest

from tests.web.serving import WORD, Browser, Serving, browser, run

school = pytest.importorskip("tests.isolation.school", reason="pupils are kept apart on Linux only")


@pytest.mark.process
def test_pupils_in_sandboxes_see_nothing_of_each_other_and_outlive_the_server() -> None:
    python = school.python_for_others()
    if python is None:
        pytest.skip("no Python here that other users may run")
    if isinstance(why := school.asked("bubblewrap", "attacks"), str):
        pytest.skip(why)
    with school.folder() as top:
        folder = top / "plain" if os.geteuid() == 0 else top
        folder.chmod(0o711)
        user = {"user": school.PLAIN_USER, "group": school.PLAIN_USER, "extra_groups": []} if os.geteuid() == 0 else {}
        with Serving(folder, "--word", WORD, "--isolation", "bubblewrap", python=python, user=user) as serving:
            run(deed(serving, folder))
            serving.end(signal.SIGKILL)
            assert serving.cells()
            serving.start("--isolation", "none")  # another way, in which these desktops cannot go on
            ended = [line for line in serving.said if "was ended: it was isolated by --isolation bubblewrap" in line]
            assert len(ended) == 2 and serving.cells() == [], serving.said
            assert serving.end() == 0
            serving.start("--isolation", "auto")
            assert any("--isolation none, as before in this folder" in line for line in serving.said), serving.said
            assert serving.end() == 0
            assert serving.cells() == []


async def deed(serving: Serving, folder: Path) -> None:
    async with browser(serving.base) as hers, browser(serving.base) as his:
        for door, name in ((hers, "anna"), (his, "bert")):
            assert (await door.post("enter", word=WORD, name=name))[0] == 303
        one, other = await hers.tab(), await his.tab()
        await one.see("anna@day6:~$")
        await other.see("bert@day6:~$")
        await one.type("echo secret-$((40+2)) > mine.txt; cat mine.txt\r")
        await one.see("secret-42")
        await other.type(f"cat {folder}/class/homes/anna/mine.txt; ls {folder}/class/server; echo tried-$((1+1))\r")
        text = await other.see("tried-2")
        assert "secret-42" not in text and "tokens.json" not in text
        cookies = hers.session.cookie_jar
        serving.end(signal.SIGKILL)
        serving.start()
        assert any("2 desktops of the last server are still running" in line for line in serving.said), serving.said
        async with aiohttp.ClientSession(cookie_jar=cookies) as session:
            await (await Browser(session, serving.base).tab()).see("secret-42")
