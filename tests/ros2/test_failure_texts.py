"""How exceptions become lines, and which name is guessed (as by Python 3.11)."""

from __future__ import annotations

import sys

import pytest

from day6_core.ros.ros2.cli.failure import failure_text, nearest_name


@pytest.mark.parametrize(
    ("wrong", "names", "guess"),
    [
        ("dat", ["data"], "data"),
        ("Data", ["data"], "data"),
        ("data", ["data"], None),
        ("atad", ["data"], None),
        ("x", ["y"], None),
        ("ab", ["xy"], None),
        ("lenear", ["linear", "angular"], "linear"),
        ("liner", ["linear", "lines"], "linear"),
        ("bat", ["cat", "hat"], "cat"),
        ("hidden", ["_hidden"], None),
        ("_hiden", ["_hidden"], "_hidden"),
        ("POSITION", ["position"], None),
        ("Position", ["position", "positions"], "position"),
        ("positoin", ["position"], "position"),
        ("abcdefgh", ["abcdefxyz"], "abcdefxyz"),
        ("abcdefgh", ["abcdewxyz"], None),
        ("abcdef", ["abcdxx", "abcdex"], "abcdex"),
        ("", ["a"], None),
    ],
)
def test_the_nearest_name_is_guessed_if_it_is_near_enough(wrong, names, guess):
    assert nearest_name(wrong, names) == guess


@pytest.mark.skipif(sys.version_info[:2] != (3, 11), reason="the guesses are those of Python 3.11")
def test_the_guesses_are_those_of_python_itself(capsys):
    """Names of all lengths, changed in all ways: the hint of Python's own traceback is the same."""
    import random

    chance = random.Random(5)
    for _ in range(400):
        names = ["".join(chance.choices("abAB", k=chance.randint(1, 7))) for _ in range(3)]
        wrong = "".join(chance.choices("abAB", k=chance.randint(1, 7)))
        if wrong in names:
            continue
        thing = type("Thing", (), {"__slots__": (), "__dir__": lambda self, names=names: sorted(names)})()
        try:
            getattr(thing, wrong)
        except AttributeError as error:
            sys.__excepthook__(type(error), error, None)
            hint = capsys.readouterr().err.partition("Did you mean: '")[2].rstrip("'?\n")
        assert (nearest_name(wrong, sorted(names)) or "") == hint, (wrong, names)


@pytest.mark.parametrize(
    ("error", "text"),
    [
        (ValueError("no"), "ValueError: no\n"),
        (ValueError(), "ValueError\n"),
        (KeyError("a"), "KeyError: 'a'\n"),
        (AttributeError("no name"), "AttributeError: no name\n"),
        (AttributeError("x", name="dat", obj=None), "AttributeError: x\n"),
        (AttributeError("x", name="reel", obj=1.0), "AttributeError: x. Did you mean: 'real'?\n"),
        (
            AttributeError("x. Did you mean: 'y'?", name="reel", obj=1.0),
            "AttributeError: x. Did you mean: 'y'?. Did you mean: 'real'?\n",
        ),
        (AttributeError("x", name="qqqq", obj=1.0), "AttributeError: x\n"),
    ],
)
def test_an_exception_is_its_last_lines(error, text):
    assert failure_text(error) == text
