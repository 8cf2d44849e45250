"""What a teacher asks and hands out comes to the pupil, in real browsers."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.support.short_folder import make_short_folder
from tests.web.browser import scripted_page
from tests.web.serving import Serving
from tests.web.test_page_whole import shows

if TYPE_CHECKING:
    from tests.web.background import Background
    from tests.web.chromium import Chromium, Page
    from tests.web.page_server import PageServer

pytestmark = pytest.mark.browser


def test_a_pupil_answers_and_opens_what_was_handed_out(chromium: Chromium) -> None:
    folder = make_short_folder("d6h-")
    (table := Path(folder) / "pupils.csv").write_text("name\nanna\n", encoding="utf-8")
    with Serving(folder, "--class", str(table), "--isolation", "none") as serving:
        page, pupil = chromium.page(), chromium.page()
        play(serving, page, pupil)
        assert pupil.troubles == page.troubles == []
        page.close()
        pupil.close()


def play(serving: Serving, page: Page, pupil: Page) -> None:
    page.navigate(serving.link("the teacher"))
    page.wait_for("Boolean(window.classPage) && classPage._connection.isOpen")
    page.evaluate("window.confirm = () => true")
    pupil.device(1000, 600)
    pupil.navigate(serving.link("anna"))
    shows(pupil, "anna@day6")
    page.wait_for("document.querySelector('.pupil[data-key=anna]')?.dataset.state === 'here'")
    page.click_on("#say-asks")
    page.evaluate("document.getElementById('say-text').value = 'Does it turn?'")
    page.click_on("#say button")
    shows(pupil, "Does it turn?")
    pupil.press("F10")
    shows(pupil, "Y Yes")
    pupil.press("y")
    page.wait_for("document.querySelector('.pupil[data-key=anna] .reply').textContent === 'answer: Yes'")
    page.evaluate(
        "(() => { const data = new DataTransfer(); data.items.add(new File(['print(\"handed\")'], 'map.py'));"
        " const field = document.querySelector('#hand .file'); field.files = data.files;"
        " field.dispatchEvent(new Event('change')); })()"
    )
    shows(pupil, "handed/map.py")
    pupil.press("F10")
    shows(pupil, "O Open")
    pupil.press("Enter")
    shows(pupil, 'print("handed")')
    pupil.evaluate("window.open = (url) => { window.opened = url; return {}; }")
    page.evaluate(
        "document.querySelector('#hand .link input').value = 'https://docs.ros.org/'; document.getElementById('hand').open = true"
    )
    page.click_on("#hand .link button")
    shows(pupil, "docs.ros.org")
    pupil.press("F10")
    shows(pupil, "O Open")
    pupil.press("Enter")
    pupil.wait_for("window.opened === 'https://docs.ros.org/'")
    told = "[...document.querySelectorAll('.handout')].map((each) => each.querySelector('[role=status]').textContent)"
    page.wait_for(f"{told}.join() === 'opened by 1 of 1,opened by 1 of 1'")


OPENED = "window.open = (url) => { window.opened.push(url); return %s; }; window.opened = []"


@pytest.fixture
def linked(chromium: Chromium, background: Background) -> Iterator[tuple[Page, PageServer]]:
    """The page of a desktop, and the server that says what the desktop says."""
    with scripted_page(chromium, background) as made:
        yield made


def open_desk(page: Page, server: PageServer, *, returns: str, **hello: bool) -> None:
    server.hello = {"t": "hello", "name": "anna", "read_only": False, "lang": "en"} | hello
    page.navigate(f"{server.address}/desk")
    page.wait_for("Boolean(window.desk) && desk._connection.isOpen")
    page.evaluate(OPENED % returns)


def test_the_page_opens_links_for_who_types_and_nothing_else(linked: tuple[Page, PageServer]) -> None:
    page, server = linked
    open_desk(page, server, returns="{}")
    for link in (
        "javascript:alert(1)",
        "data:text/html,x",
        "file:///etc/passwd",
        "https://a@b.c/",
        "x",
        "https://docs.ros.org/",
    ):
        server.output(f"\x1b]7701;open;{link}\x07")
    page.wait_for("window.opened.length > 0")
    assert page.evaluate("window.opened") == ["https://docs.ros.org/"]
    assert page.evaluate("document.getElementById('link').hidden")
    open_desk(page, server, returns="{}", read_only=True)  # who only watches
    page.evaluate("navigator.clipboard.writeText = (text) => { window.copied = text; return Promise.resolve() }")
    server.output("\x1b]52;c;cm0gLXJmIH4=\x07\x1b]7701;open;https://docs.ros.org/\x07\x1b]2;drawn\x07watched")
    page.wait_for("desk._terminal.buffer.active.getLine(0).translateToString(true) === 'watched'")
    assert page.evaluate("window.opened") == [] and page.evaluate("window.copied ?? ''") == ""


def test_a_link_that_the_browser_blocks_is_there_to_be_clicked(linked: tuple[Page, PageServer]) -> None:
    page, server = linked
    page.device(400, 700)
    open_desk(page, server, returns="null")
    server.output("\x1b]7701;open;https://docs.ros.org/en/?a=<b>\x07")
    page.wait_for("!document.getElementById('link').hidden")
    link = "document.querySelector('#link a')"
    assert page.evaluate(f"[{link}.href, {link}.target, {link}.rel]") == [
        "https://docs.ros.org/en/?a=%3Cb%3E",
        "_blank",
        "noopener noreferrer",
    ]
    assert page.evaluate(f"document.activeElement === {link} && {link}.getBoundingClientRect().right <= innerWidth")
    page.click_on("#link button")
    assert page.evaluate("document.getElementById('link').hidden && Boolean(document.activeElement.closest('.xterm'))")
