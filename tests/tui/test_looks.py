"""What the terminal can show decides glyphs, colours and language; every text exists in both languages."""

from __future__ import annotations

import itertools
import os
import string
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest
from rich.cells import cell_len
from rich.segment import Segment
from rich.style import Style
from textual.color import Color
from textual.strip import Strip

from day6_core.language import LANGUAGES, language_of
from day6_tui import actions, locale
from day6_tui.app import Day6App, make_look
from day6_tui.appearance import glyphs
from day6_tui.appearance.colours import colours
from day6_tui.appearance.themes import NAMES, make_theme, palette
from day6_tui.options import Options
from day6_tui.panes.cells import clip, fit, wrap
from day6_tui.screen.poor_terminals import filters_for
from tests.support.window_kinds import window_kinds
from tests.tui.screens import is_drawn_in_ascii, opened, screen_lines, screen_text, step

ROOT = Path(__file__).resolve().parents[2]
EN, ZH = locale.catalogue("en"), locale.catalogue("zh")


@pytest.mark.parametrize(
    ("environ", "name"),
    [
        ({"LANG": "zh_CN.UTF-8", "TERM": "xterm-256color"}, "half"),
        ({"LANG": "en_US.utf8", "TERM": "screen"}, "half"),
        ({"LANG": "C.UTF-8", "TERM": "linux"}, "cell"),
        ({"LANG": "C.UTF-8", "TERM": "linux", "NO_COLOR": "1"}, "ascii"),
        ({"LANG": "C", "TERM": "xterm"}, "ascii"),
        ({"LANG": "en_US.UTF-8", "LC_ALL": "POSIX", "TERM": "xterm"}, "ascii"),
        ({"LANG": "C.UTF-8", "TERM": "vt100"}, "ascii"),
        ({"LANG": "C.UTF-8", "TERM": "dumb"}, "ascii"),
    ],
)
def test_glyphs_follow_the_terminal(environ, name) -> None:
    assert glyphs.detect(environ, "linux") == name


@pytest.mark.process
def test_what_python_adds_to_the_environment_is_not_taken_for_the_terminals_word() -> None:
    """In the C locale Python sets LC_CTYPE=C.UTF-8 for itself (PEP 538)."""
    code = "import os; from day6_tui.appearance.glyphs import detect; print(os.environ.get('LC_CTYPE'), detect())"
    keep = {name: os.environ[name] for name in ("PATH", "PYTHONPATH", "HOME") if name in os.environ}
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={**keep, "LANG": "C", "TERM": "xterm"},
        capture_output=True,
        text=True,
        cwd=ROOT,
    )
    assert done.stdout.split()[-1] == "ascii", done.stderr


def test_windows_terminals_get_half_blocks_whatever_the_code_page() -> None:
    assert glyphs.detect({}, "win32") == "half"


def test_the_option_overrides_the_terminal_and_a_wrong_name_is_an_error() -> None:
    assert glyphs.choose("braille", {"LANG": "C"}).name == "braille"
    with pytest.raises(KeyError):
        glyphs.choose("teletext")


@pytest.mark.parametrize("name", ["cell", "ascii"])
def test_the_poorer_sets_use_no_character_their_terminals_lack(name) -> None:
    found = glyphs.GLYPH_SETS[name]
    symbols = "".join(
        [
            *vars(found.border).values(),
            *vars(found.strong_border).values(),
            found.news,
            found.chevron,
            found.running,
            found.paused,
            found.warning,
            found.dot,
            found.ellipsis,
            found.marker,
            found.close,
            found.bars,
        ]
    )
    if name == "ascii":
        assert symbols.isascii()
    else:
        assert not set(symbols) & set("╭╮╰╯▸▀▄▁▂▃▅▆▇…")


@pytest.mark.parametrize("found", glyphs.GLYPH_SETS.values(), ids=lambda found: found.name)
def test_every_symbol_is_one_cell(found) -> None:
    symbols = [
        found.news,
        found.chevron,
        found.running,
        found.paused,
        found.warning,
        found.dot,
        found.marker,
        found.close,
    ]
    assert [symbol for symbol in (*symbols, *found.bars, found.ellipsis) if cell_len(symbol) != 1] == []


def test_the_language_is_that_of_the_locale_unless_the_terminal_has_no_chinese() -> None:
    chinese = {"LANG": "zh_CN.UTF-8"}
    assert language_of(chinese) == "zh"
    assert language_of({**chinese, "LC_ALL": "en_US.UTF-8"}) == "en"
    assert language_of({"LANG": "de_DE.UTF-8"}) == language_of({}, platform="linux") == "en"
    assert language_of(chinese, wide_glyphs=False) == "en"
    assert make_look(Options(), {**chinese, "TERM": "linux"}).texts.language == "en"


@pytest.mark.parametrize("chosen", [{"lang": "zh"}, {}], ids=["option", "locale"])
async def test_the_set_ascii_draws_in_ascii_and_says_in_chinese_what_it_says(desk, chosen: dict[str, str]) -> None:
    environ = {"LANG": "C.UTF-8" if chosen else "zh_CN.UTF-8", "TERM": "xterm-256color"}
    async with opened(desk, 80, 24, environ=environ, glyphs="ascii", **chosen) as (app, pilot):
        text = screen_text(app)
        assert ZH["welcome.question"] in text and ZH["action.quit"] in text and ZH["bar.language"] in text
        assert is_drawn_in_ascii(text)
        app.actions["language"]()
        await step(app, pilot)
        assert EN["welcome.question"] in screen_text(app)
        assert [char for char in screen_text(app) if not char.isascii()] == [*EN["bar.language"]]


@pytest.mark.parametrize(
    ("environ", "options"),
    [
        ({"LANG": "C"}, {"lang": "zh"}),
        ({"LANG": "C"}, {"lang": "zh", "glyphs": "ascii"}),
        ({"LANG": "C", "DAY6_LANG": "zh"}, {}),
        ({"LANG": "zh_CN.GBK"}, {}),
    ],
)
async def test_where_chinese_cannot_be_written_one_line_says_why_it_is_english(
    desk, environ: dict[str, str], options: dict[str, str]
) -> None:
    async with opened(desk, 80, 24, environ={**environ, "TERM": "xterm"}, **options) as (app, _):
        assert EN["glyphs.no_chinese"] in screen_lines(app)[-1]
        assert screen_text(app).isascii()


async def test_nothing_is_said_of_a_language_that_nobody_asked_for(desk) -> None:
    async with opened(desk, 80, 24, environ={"LANG": "C", "TERM": "xterm"}) as (app, _):
        assert app.notices.text == ""


def test_what_is_chosen_is_stronger_than_the_locale_and_an_option_than_a_variable() -> None:
    environ = {"LANG": "zh_CN.UTF-8", "DAY6_LANG": "en"}
    assert language_of(environ) == "en"
    assert language_of(environ, ["--lang", "zh"]) == language_of(environ, ["--lang=zh"]) == "zh"
    assert language_of({**environ, "DAY6_LANG": "fr"}, ["--lang", "it"]) == "zh"
    assert make_look(Options(), environ).texts.language == "en"
    assert make_look(Options(lang="zh"), environ).texts.language == "zh"
    assert make_look(Options(), {"DAY6_LANG": "zh", "TERM": "linux", "LANG": "C.UTF-8"}).texts.language == "zh"


def test_every_language_has_a_folder_with_the_same_parts_and_in_them_the_same_keys() -> None:
    here = Path(locale.__file__).parent
    assert sorted(LANGUAGES) == sorted(each.name for each in here.iterdir() if (each / "__init__.py").is_file())
    first, *others = (
        {part: [*import_module(f"{locale.__name__}.{language}.{part}").TEXTS] for part in locale.parts(language)}
        for language in LANGUAGES
    )
    for other in others:
        assert first.keys() == other.keys()
        assert {part: {*keys} for part, keys in first.items()} == {part: {*keys} for part, keys in other.items()}
    keys = [key for part in first.values() for key in part]
    assert sorted({key for key in keys if keys.count(key) > 1}) == []


def test_both_catalogues_have_the_same_keys_and_fields() -> None:
    assert EN.keys() == ZH.keys()
    for key in EN:
        fields = [{name for _, name, _, _ in string.Formatter().parse(table[key]) if name} for table in (EN, ZH)]
        assert fields[0] == fields[1], key


def test_chinese_texts_use_chinese_punctuation() -> None:
    wrong = [
        key
        for key, text in ZH.items()
        for a, b in itertools.pairwise(text)
        if "\u4e00" <= a <= "\u9fff" and b in ",;?!("
    ]
    assert wrong == []


def test_every_action_has_a_name_a_help_text_and_somebody_who_does_it() -> None:
    for action in actions.ACTIONS:
        assert f"action.{action.id}" in EN and f"help.action.{action.id}" in EN, action.id
    assert Day6App(Options(lang="en")).actions.missing() == set()


def test_no_action_is_offered_twice_and_nothing_that_is_no_action() -> None:
    registry = actions.Actions()
    registry.offer({"help": print})
    for wrong in ("help", "dance"):
        with pytest.raises(ValueError, match=wrong):
            registry.offer({wrong: print})


def test_no_two_actions_share_a_key_and_every_key_of_the_bar_is_bound() -> None:
    keys = [action.key for action in actions.ACTIONS if action.key]
    assert len(keys) == len(set(keys))
    assert all(action.key and action.label for action in actions.bar_actions())


def test_every_kind_of_window_has_a_help_page() -> None:
    from day6_tui.overlays.manual import pages

    assert {*window_kinds(), "terminal", "welcome", "guide", "desk", "classroom_pupil"} == {*pages()}
    assert [page for page in pages() if f"help.{page}" not in EN] == []


def test_the_windows_say_remarks_in_the_words_of_the_programs() -> None:
    from day6_core.ros.remark_texts import TEXTS

    assert {key: EN[key] for key in TEXTS} == TEXTS


def test_an_unknown_language_is_an_error_and_switching_goes_round() -> None:
    with pytest.raises(ValueError, match="'fr'"):
        locale.Texts("fr")
    texts = locale.Texts("zh")
    assert texts("action.quit") == "退出"
    texts.switch()
    assert texts("bar.nodes", count=3) == "nodes 3"
    texts.switch()
    assert texts.language == "zh"


def test_text_is_measured_in_cells() -> None:
    assert clip("海龟海龟", 5) == "海龟…"
    assert fit("海龟", 5) == "海龟 "
    assert clip("turtle", 3, "~") == "tu~"
    assert clip("海", 1) == ""


@pytest.mark.parametrize("width", [2, 5, 11, 40])
@pytest.mark.parametrize("text", [ZH["help.turtlesim"], EN["help.turtlesim"], "averyveryverylongword " * 3])
def test_wrapped_lines_fit_and_lose_nothing(text, width) -> None:
    lines = wrap(text, width)
    # A closing mark may hang over by one character: it must not begin a line.
    assert max(cell_len(line) for line in lines) <= width + 2
    assert "".join("".join(lines).split()) == "".join(text.split())


def test_without_colour_no_style_has_one() -> None:
    plain = colours(colourless=True)
    styles = [value for value in vars(plain).values() if hasattr(value, "color")]
    assert styles and all(style.color is None and style.bgcolor is None for style in styles)


@pytest.mark.parametrize("theme", NAMES)
def test_text_is_readable_on_its_background(theme) -> None:
    """WCAG contrast of at least 4.5 for what is to be read, 3 for what is large or secondary."""
    table = colours(theme)
    for name in (
        "text",
        "strong",
        "bar",
        "bar_strong",
        "key",
        "choice",
        "title_focus",
        "hint",
        "error",
        "terminal",
    ):
        assert _contrast(getattr(table, name)) >= 4.5, name
    for name in ("muted", "title", "node", "topic", "publisher", "warning", "accent", "bar_muted"):
        assert _contrast(getattr(table, name)) >= 3.0, name

    found = palette(theme)
    for text, ground in (
        ("panel-text", "panel"),
        ("panel-strong", "panel"),
        ("panel-key", "panel"),
        ("key-text", "key"),
    ):
        assert _contrast(Style(color=found[text], bgcolor=found[ground])) >= 4.5, text
    assert _contrast(Style(color=found["panel-muted"], bgcolor=found["panel"])) >= 3.0


def test_high_contrast_is_high() -> None:
    found = palette("contrast")
    for text in ("foreground", "muted", "title", "node", "topic", "publisher", "warning", "bar-text", "panel-muted"):
        assert _contrast(Style(color=found[text], bgcolor=found["background"])) >= 7.0, text


@pytest.mark.parametrize("name", [*NAMES, "sixteen", "plain"])
def test_every_theme_has_every_colour_and_a_name_to_choose_it_by(name) -> None:
    assert palette(name).keys() == palette("dark").keys()
    assert make_theme(name).name == name
    assert name not in NAMES or f"theme.{name}" in EN


def _contrast(style) -> float:
    def luminance(colour) -> float:
        parts = [value / 255 for value in colour.get_truecolor()]
        red, green, blue = (part / 12.92 if part <= 0.03928 else ((part + 0.055) / 1.055) ** 2.4 for part in parts)
        return 0.2126 * red + 0.7152 * green + 0.0722 * blue

    light, dark = sorted((luminance(style.color), luminance(style.bgcolor)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


@pytest.mark.parametrize("environ", [{"TERM": "dumb"}, {"TERM": "dumb", "COLORTERM": "truecolor"}])
def test_a_terminal_that_knows_nothing_gets_no_colours(environ: dict[str, str]) -> None:
    look = make_look(Options(), {"LANG": "C.UTF-8", **environ})
    assert look.colours.colourless and not look.has_shades
    line = Strip([Segment("text", Style(color="red", bgcolor="blue", bold=True))])
    for each in filters_for(look):
        line = line.apply_filter(each, Color(0, 0, 0))
    assert {(segment.style.color.name, segment.style.bgcolor.name) for segment in line} == {("default", "default")}
