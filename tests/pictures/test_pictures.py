"""The documentation's pictures: each has a script and both languages, and two of them are played again and look the same."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import pytest
from PIL import Image

from tests.pictures import __main__ as command
from tests.pictures import playing
from tests.pictures.script import FOLDER, LANGUAGES, names, picture_of, script
from tests.support.folded import folded

ALL = [(name, lang) for name in names() for lang in LANGUAGES]
LARGEST, LARGEST_FILM = 60_000, 300_000


def test_there_is_a_script_for_every_picture_and_a_picture_for_every_script() -> None:
    assert {path.name for path in FOLDER.glob("*.svg")} == {picture_of(*each).name for each in ALL}
    assert {path.suffix for path in FOLDER.iterdir()} == {".svg", ".yaml"}


@folded("name, lang", ALL)
def test_a_picture_is_whole_small_and_told_in_words(name: str, lang: str) -> None:
    text, told = picture_of(name, lang).read_text(encoding="utf-8"), script(name, lang)
    title = ElementTree.fromstring(text).find("{http://www.w3.org/2000/svg}title")
    assert title is not None and title.text == told.title
    assert told.title != script(name, "zh" if lang == "en" else "en").title
    assert len(text.encode()) < (LARGEST_FILM if told.films else LARGEST)
    assert not re.search(r"/d6-|/tmp/|/home/\w|href=\"(?!data:)|@import|<script", text), (
        "nothing of this machine or of others"
    )


def test_a_script_says_only_what_can_be_done(monkeypatch, tmp_path) -> None:
    monkeypatch.setattr("tests.pictures.script.FOLDER", tmp_path)
    (tmp_path / "odd.yaml").write_text("title: x\nsteps:\n- wait: a\n- dance: b\n", encoding="utf-8")
    with pytest.raises(ValueError, match="dance"):
        script("odd", "en")


def test_a_script_that_does_not_reach_its_screen_fails_the_command_and_leaves_the_picture(monkeypatch, capsys) -> None:
    def lost(name: str, lang: str) -> str:
        raise AssertionError("waited for ['a']")

    before = picture_of("welcome", "en").read_bytes()
    monkeypatch.setattr(command, "drawn", lost)
    monkeypatch.setattr(command.surroundings, "set_environment", lambda variables: None)
    assert command.main(["welcome", "--lang", "en"]) == 1
    assert "welcome.en.svg: waited for ['a']" in capsys.readouterr().err
    assert picture_of("welcome", "en").read_bytes() == before


def test_of_a_film_only_what_has_changed_is_drawn_again() -> None:
    first = Image.new("RGBA", (320, 320), (0, 0, 200, 255))
    second = first.copy()
    second.paste((1, 0, 200, 255), (22, 42, 78, 118))
    elements = list(playing._elements([first, second, second, Image.new("RGBA", (320, 320))]))
    places = [re.findall(r'x="(\d+)" y="(\d+)" width="(\d+)" height="(\d+)"', "".join(each)) for each in elements]
    whole, patch = ("0", "0", "128", "128"), ("8", "16", "24", "32")
    assert places == [[whole], [whole, patch], [whole, patch], []]


@pytest.mark.person
@pytest.mark.parametrize(("name", "lang"), [("welcome", "zh"), ("why", "en")])
def test_what_is_seen_now_is_what_the_picture_shows(name: str, lang: str) -> None:
    pytest.importorskip("termios", reason="this system has no pseudo-terminals to try the screen in")
    told = "python -m tests.pictures makes it again"
    assert playing.drawn(name, lang) == picture_of(name, lang).read_text(encoding="utf-8"), told
