"""Everything together: the installed command, a real browser, a real desktop."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.support.short_folder import make_short_folder
from tests.web.serving import Serving

if TYPE_CHECKING:
    from tests.web.chromium import Chromium, Page

pytestmark = pytest.mark.browser

SCREEN = (
    "[...Array(desk._terminal.rows).keys()]"
    ".map(row => desk._terminal.buffer.active.getLine(row).translateToString(true)).join('\\n')"
)
PICTURE = (
    "(c => Boolean(c) && [...c.getContext('2d').getImageData(0, 0, c.width, c.height).data]"
    ".some((part, at) => at % 4 === 3 && part))(document.querySelector('.xterm-image-layer'))"
)


@pytest.fixture(scope="module")
def serving(chromium: Chromium) -> Iterator[Serving]:
    folder = make_short_folder("d6p-")
    table = Path(folder) / "pupils.csv"
    table.write_text("name\nanna\nben\n", encoding="utf-8")
    with Serving(folder, "--class", str(table), "--isolation", "none") as made:
        yield made


@pytest.fixture
def page(chromium: Chromium) -> Iterator[Page]:
    made = chromium.page()
    made.device(1000, 600)
    yield made
    made.close()


def shows(page: Page, text: str) -> None:
    page.wait_for(f"Boolean(window.desk) && ({SCREEN}).includes({text!r})")


def test_a_pupil_opens_a_link_types_sees_pixels_and_finds_everything_again(serving: Serving, page: Page) -> None:
    page.navigate(serving.link("anna"))
    shows(page, "What would you like")
    page.press("5")
    page.wait_for(f"!({SCREEN}).includes('What would you like')")
    page.compose("n", "ni", result="echo 你好; ros2 run turtlesim turtlesim_node")
    shows(page, "你好")
    page.press("Enter")
    page.wait_for(f"({SCREEN}).split('你好').length > 2")  # as it was typed, and as it was printed
    shows(page, "Spawning")
    page.wait_for(PICTURE)
    page.reload()
    shows(page, "Spawning")
    page.wait_for(PICTURE)
    assert page.evaluate("document.getElementById('strip').hidden")
    assert page.troubles == []
    assert all(serving.base.split("//")[1].split("/")[0] in address for address in page.requests)


def test_a_pupil_who_detaches_is_told_that_the_desktop_goes_on_and_opens_it_again(serving: Serving, page: Page) -> None:
    page.navigate(serving.link("ben"))
    shows(page, "What would you like")
    page.press("5")
    page.wait_for(f"!({SCREEN}).includes('What would you like')")
    page.compose("s", result="sleep 600")
    shows(page, "sleep 600")
    page.press("Enter")
    shows(page, "1 sleep 600")  # the title: it runs
    page.press("q", "ctrl")
    shows(page, "Detach")
    page.press("d")
    page.wait_for("document.getElementById('strip').dataset.state === 'left'")
    page.click_on("#strip button")
    shows(page, "sleep 600")


def test_a_pupil_who_follows_a_link_to_watch_sees_the_other_ones_screen_and_cannot_type(
    serving: Serving, page: Page
) -> None:
    page.navigate(serving.link("anna"))
    shows(page, "anna@day6")
    page.navigate(serving.link("the teacher"))
    page.wait_for("location.pathname.endsWith('/class')")
    page.navigate(f"{serving.base}links")
    ben = "[...document.querySelectorAll('section')].find(each => each.innerText.startsWith('ben'))"
    page.evaluate(f"{ben}.querySelector('input[value=watch]').form.submit()")
    link = page.wait_for(f"[...{ben}.querySelectorAll('code')][1]?.textContent")
    page.navigate(link)
    shows(page, "ben@day6")
    assert page.evaluate("document.body.classList.contains('watching')")
    page.compose("x", result="nobody types here")
    page.navigate(f"{serving.base}desk")
    shows(page, "anna@day6")
    page.navigate(f"{serving.base}watch")
    shows(page, "ben@day6")
    assert "nobody types here" not in page.evaluate(SCREEN)


def test_two_pupils_in_one_browser_are_asked_and_both_keep_their_tabs(serving: Serving, page: Page) -> None:
    page.navigate(serving.link("anna"))
    shows(page, "anna@day6")
    second = page.beside()
    second.navigate(serving.link("ben"))
    second.wait_for("document.body.innerText.includes('anna is at work in this browser.')")
    assert serving.link("ben").rpartition("/")[2] not in second.evaluate("location.href")
    second.click_on("a.go")
    shows(second, "ben@day6")
    for _ in range(2):
        page.reload()
        shows(page, "anna@day6")
        second.reload()
        shows(second, "ben@day6")
    page.navigate(f"{serving.base}desk")  # whose?
    page.wait_for("['Continue as anna', 'Continue as ben'].every(text => document.body.innerText.includes(text))")
    assert page.troubles == second.troubles == []
    second.navigate(serving.base)
    second.click_on("form.plain:nth-of-type(2) button")
    second.wait_for("!document.body.innerText.includes('Continue as ben')")
    second.close()


def test_on_paper_there_are_names_pictures_and_addresses_and_nothing_else(serving: Serving, page: Page) -> None:
    page.navigate(serving.link("the teacher"))
    page.wait_for("location.pathname.endsWith('/class')")
    page.navigate(f"{serving.base}links")
    assert "New links for all…" in page.evaluate("document.body.innerText")
    page.ask("Emulation.setEmulatedMedia", media="print")
    names = page.evaluate("[...document.querySelectorAll('section')].map(e => e.querySelector('h2').innerText)")
    links = page.evaluate("[...document.querySelectorAll('section > p:not(.screen) code')].map(e => e.innerText)")
    printed = page.evaluate("document.body.innerText").split()
    assert sorted(printed) == sorted([*names, *links]) and len(links) == 2
    assert page.evaluate("[...document.querySelectorAll('svg')].every(e => e.checkVisibility())")
    assert not page.evaluate("[...document.querySelectorAll('summary, button, a')].some(e => e.checkVisibility())")


@pytest.fixture
def asked(chromium: Chromium) -> Iterator[Serving]:
    with Serving(make_short_folder("d6p-"), "--word", "蓝色海龟", "--unasked", "0", "--isolation", "none") as made:
        yield made


def enter(page: Page) -> None:
    """Type the class word and a name, both with an input method, which browsers keep off in a field for a password."""
    page.wait_for("document.activeElement.name === 'word' && document.activeElement.type === 'text'")
    page.compose("l", "lan", result="蓝色海龟")
    page.press("Tab")
    page.compose("an", result="安娜")
    page.press("Enter")


def test_a_newcomer_waits_until_the_teacher_lets_them_in_and_goes_when_removed(
    asked: Serving, chromium: Chromium, page: Page
) -> None:
    page.navigate(asked.link("the teacher"))
    page.wait_for("Boolean(window.classPage) && classPage._connection.isOpen")
    page.evaluate("window.confirm = () => true")
    pupil = chromium.page()
    pupil.device(390, 700)
    pupil.navigate(asked.base)
    enter(pupil)
    pupil.wait_for("location.pathname.endsWith('/lobby') && document.body.innerText.includes('安娜, please wait')")
    page.wait_for("document.querySelector('#lobby li .name')?.textContent === '安娜'")
    pupil.wait_for("document.readyState === 'complete'")  # its script has come, too
    pupil.offline(True)
    pupil.wait_for("document.body.innerText.includes('The server does not answer')")
    pupil.offline(False)
    pupil.wait_for("!document.body.innerText.includes('The server does not answer')")
    pupil.troubles.clear()  # what the browser says of the network
    page.click_on("#lobby .in")
    pupil.wait_for("location.pathname.endsWith('/desk')")
    shows(pupil, "What would you like")
    page.wait_for("document.querySelector('.pupil .address')?.textContent === 'from 127.0.0.1'")
    page.wait_for("document.querySelector('.pupil')?.dataset.state === 'here'")
    other = chromium.page()
    other.navigate(asked.base)
    enter(other)  # she moves to another machine
    other.wait_for("document.body.innerText.includes('There is a 安娜 in this class')")
    page.wait_for(
        "document.querySelector('#lobby li .why')?.textContent.includes('安娜 is here right now, from 127.0.0.1')"
    )
    page.click_on("#lobby .in")
    shows(other, "What would you like")
    pupil.wait_for("document.getElementById('strip').dataset.state === 'taken'")
    pupil.click_on("#strip button")
    other.wait_for("document.getElementById('strip').dataset.state === 'taken'")
    other.close()
    page.click_on(".pupil .open")
    page.click_on(".pane .remove")
    pupil.wait_for("document.getElementById('strip').dataset.state === 'removed'")
    page.wait_for("document.querySelectorAll('.pupil').length === 0")
    pupil.navigate(asked.base)
    pupil.wait_for("document.querySelector('input[name=word]') !== null")
    assert pupil.troubles == page.troubles == []
    pupil.close()
