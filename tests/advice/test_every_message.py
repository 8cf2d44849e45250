"""Every error and warning that our own commands, programs and windows can print has a card, but for a short list with reasons."""

from __future__ import annotations

import re

import pytest

from day6_core.advice.matching import card_for
from day6_core.command_line.texts import texts_in
from day6_core.language import LANGUAGES
from tests.advice.emitted import Emitted, emitted

EXEMPT: dict[str, str] = {
    # Place, how and text of what needs none -> why.
    r"launch/_process/__main__|joint_state_publisher\.py.*Exception: word|listening\.py|bag/_options\.py.*print_error": (
        "carries a text that another place makes, and that is enumerated there"
    ),
    r"packages\.py.*WARNING: word|colcon\.py:\d+: warn: colcon[. ]|results\.py|interpreter\.py.*word: word": "the same",
    r"param/get\.py.*word: Error: word": "the same, after the name of the node",
    r"workspace/(events|handlers)\.py|print_error: \[word\] \[7\.7\] \[word\]: word$": "the same",
    r"rviz2/model/config\.py": "the same: RViz prints it after the path of the file, and so it has a card",
    r"collada\.py|meshes\.py": "reaches the screen as `could not load` of a mesh",
    r"raise BadValue|raise NoField": "shown beside the line in which the value is typed, in the catalogue's words",
    r"rqt_reconfigure/(model|values)\.py|rqt_image_view/model\.py": "shown below the line in which the value or file is typed",
    r"rqt_topic/fields\.py": "a type without fields is told by having none",
    r"rqt_gui/perspectives\.py|rqt_console/files\.py": "shown on the frame of the window, about the file just named",
    r"rqt_py_common/expressions\.py": "the reason within the texts of `rqt-expression`",
    r"decoding\.py.*(wordxword pixels|too large)": "the reason within `an exception was thrown`, or it says all itself",
    r"raise NotImplementedError|no shell$|urdf/__init__|properties\.py.*KeyError": "a mistake of ours",
    r"raise Refused": "the reason within `bash has this, the shell of day6-tui does not`",
    r"line editing not enabled|ignored null byte|no completion specification": "it says all itself, and nothing is to be done",
    r"pipelines\.py.*\twordmword|state\.py.*write: exit|tf2_monitor\.py|: \n- ": "a time, a farewell, a heading, a list",
    r"run_tests\.py:\d+: err: day6-tui test: 7": "carries a text that another place makes, and that is enumerated there",
    r"(print_error|error|write|err|exit): [Uu]sage: ": "a usage says itself what to write; --help prints the same line",
    r"state\.py.*day6-tui: word": "another distribution was sourced: it says itself what happens now",
    r"ide\.py.*(it isn't an object|it has no configuration)|jsonc\.py": "the reason within `is not understood and was left`",
    r"packages\.py:\d+: print_error: word: , ": "in the list below `could not have their rosdep keys resolved`",
}

REFUSALS = ("no_workspace", "no_package", "no_package.there", "empty", "nowhere", "not_zip", "exists", "inside", "gone", "large",
            "encoding", "link")  # fmt: skip
"""Of `day6-tui export`."""

CARRIER = re.compile(r"(?:word|\d|[:/ (),\n])*\Z")
"""A text that is nothing but what is filled in: what it carries is enumerated where it is made."""


def exempt(message: Emitted) -> bool:
    printed = message.text.removeprefix("bash: ")
    return CARRIER.match(printed) is not None or any(
        re.search(pattern, f"{message.place}: {message.how}: {message.text}") for pattern in EXEMPT
    )


def test_every_text_has_a_card() -> None:
    without = [
        f"{message.place}: {message.how}: {message.text!r}"
        for message in emitted()
        if not exempt(message) and not any(map(card_for, message.text.split("\n")))
    ]
    assert not without, "\n".join([f"{len(without)} texts have no card:", *without])


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("key", REFUSALS)
def test_every_refusal_of_export_has_a_card(key: str, language: str) -> None:
    text = texts_in(language)[f"cli.export.{key}"]
    words = dict.fromkeys(re.findall(r"{(\w+)}", text), "word") | {"size": "7", "most": "7"}
    card = card_for(f"day6-tui export: {text.format(**words)}")
    assert card is not None and card.card.id == "export-refused"


@pytest.mark.long
def test_the_enumeration_sees_what_is_printed() -> None:
    """What is known to be there is found: one of each way to say something."""
    texts = {message.text for message in emitted()}
    for known in (
        "Package 'word' not found",  # raised
        "Node not found",  # returned
        "No packages found\n",  # written
        "URDF is empty",  # a status
        "link 'word' is not unique.",  # urdfdom
        "bash: word: too many arguments",  # a built-in
    ):
        assert known in texts, known
    assert len(texts) > 500


def test_no_exemption_is_left_over() -> None:
    told = [f"{message.place}: {message.how}: {message.text}" for message in emitted()]
    for pattern in EXEMPT:
        assert any(re.search(pattern, each) for each in told), pattern
