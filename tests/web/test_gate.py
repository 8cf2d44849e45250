"""Who gets in: by a link, or by the class word; nobody else sees anything."""

from __future__ import annotations

import json
import re
import stat
from collections.abc import Iterator
from pathlib import Path

import aiohttp
import pytest

from day6_tui.web.links import Links
from day6_tui.web.names import who_is
from day6_tui.web.tokens import Tokens
from day6_tui.web.tries import MOST_OF_ONE
from tests.support.short_folder import make_short_folder
from tests.web.serving import WORD, Browser, Serving, browser, run


async def status_of_socket(door: Browser, **headers: str) -> int:
    try:
        tab = await door.tab(**headers)
    except aiohttp.WSServerHandshakeError as error:
        return error.status
    await tab.ws.close()
    return 101


@pytest.mark.process
def test_without_a_token_there_is_the_start_page_and_nothing_else(class_server: Serving) -> None:
    async def deed() -> None:
        async with browser(class_server.base) as door:
            status, page = await door.get("")
            assert status == 200 and "You all share one account here" in page
            for path in ("desk", "watch", "class", "links"):
                status, page = await door.get(path)
                assert status == 403 and "needs a link" in page
            assert await status_of_socket(door) == 403
            assert (await door.post("links/new", kind="pupil", name="anna"))[0] == 403
            assert (await door.get("static/../tokens.py"))[0] == 404

    run(deed())


@pytest.mark.process
def test_a_page_of_another_site_opens_no_socket_and_sends_no_form(class_server: Serving) -> None:
    async def deed() -> None:
        async with browser(class_server.base) as door:
            await door.get(class_server.link("anna"))
            for origin in ("http://evil.example", "null", class_server.base.rstrip("/") + "1", ""):
                assert await status_of_socket(door, Origin=origin) == 403
                assert (await door.post("enter", origin=origin, word=WORD, name="eva"))[0] == 403
            assert await status_of_socket(door) == 101
            for words in ("Open the address your teacher gave you.", "请打开老师给你的地址。"):
                lang = "zh" if words.startswith("请") else "en"
                status, page = await door.get("", **{"Host": "evil.example:8006", "Accept-Language": lang})
                assert status == 421 and words in page

    run(deed())


@pytest.mark.process
def test_every_answer_forbids_what_our_pages_never_do(class_server: Serving) -> None:
    async def deed() -> None:
        async with browser(class_server.base) as door:
            for path in ("", "desk", "static/pages.css", "nothing"):
                async with door.session.get(door.base + path) as answer:
                    assert "script-src 'self' 'wasm-unsafe-eval';" in answer.headers["Content-Security-Policy"]
                    assert answer.headers["X-Content-Type-Options"] == "nosniff"
                    assert answer.headers["Referrer-Policy"] == "same-origin"
            async with door.session.get(class_server.link("anna")) as answer:
                cookie = answer.headers["Set-Cookie"]
                assert "HttpOnly" in cookie and "SameSite=Strict" in cookie and "Path=/" in cookie

    run(deed())


@pytest.mark.process
@pytest.mark.parametrize(("path", "up"), [("nothing", ""), ("no/such/page", "../../"), ("enter", ""), ("p/", "../")])
def test_an_address_without_a_page_says_so_in_words_and_leads_back(class_server: Serving, path: str, up: str) -> None:
    async def deed() -> None:
        async with browser(class_server.base) as door:
            status, page = await door.get(path)
            assert status in (404, 405) and "There is no page at this address." in page
            assert f'href="{up}static/pages.css"' in page and f'href="{up}./"' in page
            status, page = await door.get(path, **{"Accept-Language": "zh-CN"})
            assert "这个地址没有页面。" in page

    run(deed())


@pytest.mark.process
def test_tokens_are_hashed_on_the_disk(class_server: Serving) -> None:
    file = class_server.folder / "class" / "server" / "tokens.json"
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    text = file.read_text(encoding="utf-8")
    for name in ("anna", "李雷", "the teacher"):
        assert class_server.link(name).rpartition("/")[2] not in text
    assert {each["name"] for each in json.loads(text)["tickets"]} >= {"anna", "李雷", "bert", ""}


@pytest.mark.process
def test_the_list_gave_each_pupil_a_link_and_its_bad_lines_are_named(class_server: Serving) -> None:
    said = "\n".join(class_server.said)
    assert "pupils.csv, line 4 “,2”: no name" in said
    assert "pupils.csv, line 5 “ANNA,2”: this name appears twice" in said
    assert len({class_server.link(name) for name in ("anna", "李雷", "bert")}) == 3


@pytest.mark.process
def test_the_teacher_gets_links_to_print_and_makes_new_ones(class_server: Serving) -> None:
    async def deed() -> None:
        async with browser(class_server.base) as door:
            await door.get(class_server.link("the teacher"))
            _, page = await door.get("links")
            old = class_server.link("bert")
            assert f"<code>{old}</code>" in page and page.count("<svg") >= 3
            assert '<a href="class">Back to the class</a>' in page and "not on other devices" in page
            for button in re.findall("<button>[^<]*", page):
                before = page.partition(button)[0]
                assert before.rpartition("<summary>")[2].count("</details>") == 0, button
            assert (await door.post("links/new", kind="pupil", name="bert"))[0] == 303
            assert (await door.post("links/new", kind="teacher", name=""))[0] == 303
            _, page = await door.get("links")
            assert old not in page
            assert (await door.get(old))[0] == 403
            new = page.partition("bert</h2>")[2].partition("<code>")[2].partition("<")[0]
            assert (await door.get(new))[0] == 200
            class_server.said = [line.replace(old, new) for line in class_server.said]

    run(deed())


@pytest.fixture
def listed(class_server: Serving) -> Serving:
    """A server of its own, to be started twice."""
    folder = make_short_folder("d6w-")
    (folder / "pupils.csv").write_text("anna\nbert\n", encoding="utf-8")
    return Serving(folder, "--class", str(folder / "pupils.csv"), "--word", WORD, "--isolation", "none")


@pytest.mark.process
def test_after_a_restart_links_still_work_and_the_class_can_be_printed_anew(listed: Serving) -> None:
    async def deed() -> None:
        async with browser(listed.base) as door, browser(listed.base) as dora, browser(listed.base) as anna:
            assert (await dora.post("enter", word=WORD, name="dora"))[0] == 303
            old = listed.link("anna").removeprefix(listed.base)
            listed.end()
            listed.start()
            door.base = dora.base = anna.base = listed.base
            assert (await anna.get(old))[0] == 200 and await anna.opens()
            await door.get(listed.link("the teacher"))
            _, page = await door.get("links")
            assert "<svg" not in page and page.count("The link you gave out before still works.") == 2
            assert page.count("need no link") == 1 and "need no link" in page.partition("dora</h2>")[2]
            assert "All 2 pupils on the list get new links" in page
            assert (await anna.post("links/new", kind="all"))[0] == 403
            assert (await door.post("links/new", kind="all"))[0] == 303
            _, page = await door.get("links")
            assert page.count("<svg") == 2 and old not in page
            assert (await door.get(old))[0] == (await anna.get("desk"))[0] == 403
            assert await dora.opens()

    with listed:
        run(deed())


@pytest.mark.parametrize(
    ("base", "local"),
    [
        ("http://127.0.0.1:8006/", True),
        ("https://localhost/", True),
        ("http://[::1]:8006/", True),
        ("http://192.168.1.5:8006/", False),
        ("/user/anna/", False),
    ],
)
def test_links_that_only_this_machine_can_use_are_known(tmp_path: Path, base: str, local: bool) -> None:
    assert Links(Tokens(tmp_path / "tokens.json"), base).are_local is local


@pytest.mark.process
def test_a_list_without_names_is_told(tmp_path: Path) -> None:
    (tmp_path / "pupils.csv").write_text("name\n", encoding="utf-8")
    with Serving(tmp_path, "--class", str(tmp_path / "pupils.csv"), "--isolation", "none") as serving:
        assert f"day6-tui: {tmp_path / 'pupils.csv'}: no names" in serving.said


@pytest.mark.process
def test_who_knows_the_word_chooses_a_name_that_nobody_has(class_server: Serving) -> None:
    async def deed() -> None:
        async with browser(class_server.base) as door, browser(class_server.base) as other:
            status, page = await door.post("enter", word="wrong", name='dora"> <b>')
            assert status == 403 and 'name="name" required' in page and "wrong" not in page.partition("<form")[2]
            assert 'value="dora&quot;&gt; &lt;b&gt;"' in page
            status, page = await door.post("enter", word=WORD, name="<script>")
            assert status == 400 and 'value="&lt;script&gt;"' in page and WORD not in page
            assert (await door.post("enter", word=WORD, name="d" * 33))[0] == 400
            assert (await door.post("enter", word=WORD, name="Dora 王"))[0] == 303
            assert "Continue as Dora 王" in (await door.get(""))[1]
            for taken in ("Dora 王", "dora  王", "ANNA"):
                status, page = await other.post("enter", word=WORD, name=taken)
                assert status == 303 and (await other.get("desk"))[0] == 403
                assert "There is a " in (await other.get("lobby"))[1]
            assert await door.opens()
            assert (await door.post("leave", who=who_is("Dora 王")))[0] == 303
            assert (await door.get("desk"))[0] == 403

    run(deed())


@pytest.fixture
def tried() -> Iterator[Serving]:
    """A server of its own: its address is shut out afterwards."""
    with Serving(make_short_folder("d6w-"), "--word", WORD, "--isolation", "none") as serving:
        yield serving


@pytest.mark.process
def test_tries_by_the_thousand_are_refused_and_a_right_link_is_not(tried: Serving) -> None:
    async def deed() -> None:
        async with browser(tried.base) as door:
            link = tried.link("the teacher")
            assert any("--word: every user of this machine can read the word" in line for line in tried.said)
            found = [(await door.get(f"p/{number:022}"))[0] for number in range(MOST_OF_ONE + 5)]
            assert found == [403] * MOST_OF_ONE + [429] * 5
            assert (await door.post("enter", word=WORD, name="anna"))[0] == 429
            assert (await door.get(link))[0] == 200

    with tried:
        run(deed())


FORM = "application/x-www-form-urlencoded"


@pytest.mark.process
@pytest.mark.parametrize(
    ("headers", "body", "status"),
    [
        ({"Content-Type": FORM}, b"word=\xff\xfe&name=\xff", 400),
        ({"Content-Type": f"{FORM}; charset=no-such"}, b"word=a", 403),
        ({"Content-Type": "multipart/form-data"}, b"word=a", 400),
        ({"Content-Type": "multipart/form-data; boundary=x"}, b"--x\r\nnonsense", 400),
        ({"Content-Type": FORM}, b"a&" * 1000, 400),
        ({"Content-Type": FORM}, b"a" * 100_000, 413),
        ({"Content-Type": "text/plain"}, b"word=a", 400),
        ({"Origin": "http://["}, b"word=a", 403),
        ({"Host": "["}, b"word=a", 421),
    ],
)
def test_forms_that_are_none_are_refused_and_leave_no_trace_of_ours(
    class_server: Serving, headers: dict[str, str], body: bytes, status: int
) -> None:
    async def deed() -> None:
        async with (
            browser(class_server.base) as door,
            door.session.post(door.base + "enter", data=body, headers=door.origin | headers) as answer,
        ):
            assert answer.status == status
            assert "Traceback" not in await answer.text()

    run(deed())
