"""What the pupil's own line shows: cards with `- line`, names that are used wrongly, programs that never begin."""

from __future__ import annotations

from pathlib import Path

import pytest

from day6_core.advice.card_files import CardError, read_topic
from day6_core.advice.explain import scene_of
from day6_core.advice.fault import fault_in
from day6_core.advice.matching import cards_in
from day6_core.advice.own_names import cause_of_name, never_begun
from day6_core.advice.rules import Surroundings, hint_about_silence, hint_below
from tests.advice.test_cards import CARD
from tests.support.folded import folded


def report(line: int, source: str, error: str, *more: str) -> str:
    """A traceback that ends in a line of the pupil's, or in what that had called."""
    places = [f'  File "a.py", line {line}, in f\n    {source}\n']
    places += [f'  File "{place}", line 7, in g\n    theirs()\n' for place in more]
    return f"Traceback (most recent call last):\n{''.join(places)}{error}\n"


def test_a_card_with_line_is_only_for_a_line_that_looks_so(tmp_path: Path) -> None:
    path = tmp_path / "x.md"
    text = CARD.replace("- same", "- line: `publish\\((?P<what>\\w+)\\)`\n- same").replace("no {name}.", "no {what}.")
    path.write_text(text, encoding="utf-8")
    (card,) = read_topic(path)[1]
    lines = ("publish(msg)", "publish()", "x = publish(msg)")
    assert [card.seen_in(fault_in(report(3, line, "E: x"))) for line in lines] == [{"what": "msg"}, None, None]
    assert card.seen_in(None) is None
    for wrong in (text.replace("publish\\((", "publish(("), text.replace("{what}", "{which}")):
        path.write_text(wrong, encoding="utf-8")
        with pytest.raises(CardError):
            read_topic(path)


def test_the_number_of_a_line_is_told_where_the_line_is_what_is_wrong() -> None:
    import rclpy

    spins = report(9, "rclpy.spin()", "TypeError: spin() missing 1 required positional argument: 'node'")
    assert "line 9" in hint_below(spins, Surroundings({}, Path("/nowhere")))
    turns = report(9, "rclpy.spin(node)", "KeyError: 'x'", str(Path(rclpy.__file__)))
    fault = fault_in(turns)
    assert fault is not None and (fault.line, fault.number, fault.source) == (0, 9, "rclpy.spin(node)")


def test_what_was_explained_is_not_explained_itself() -> None:
    said = "KeyError: 'x'"
    for ours in (
        "hint: line 3: there is no such file: No such file or directory",
        "意思：KeyError: 'y'",
        "提示：KeyError: 'y'",
    ):
        assert [match.line for match in cards_in(f"{said}\n\x1b[90m{ours}\x1b[0m\n")] == [said]


CLASS = "class A(Node):\n    def __init__(self):\n        {0}\n        self.x = 1\n    def go(self):\n        {1}\n"

NAMES = {
    # Program, line, error -> the key of what is told and what it fills in; None: nothing is certain.
    (CLASS.format("pass", "go"), 6, "NameError: name 'go' is not defined"): ("self.lacks", {"right": "self.go"}),
    (CLASS.format("pass", "x"), 6, "NameError: name 'x' is not defined"): ("self.lacks", {"right": "self.x"}),
    (CLASS.format("pass", "y"), 6, "NameError: name 'y' is not defined"): None,
    (CLASS.format("self.x", "pass"), 3, "AttributeError: 'A' object has no attribute 'x'"): (
        "self.later",
        {"later": 4},
    ),
    (CLASS.format("self.y", "pass"), 3, "AttributeError: 'A' object has no attribute 'y'"): None,
    (CLASS.format("self.x", "pass"), 3, "AttributeError: 'B' object has no attribute 'x'"): None,
    ("n = 0\ndef f():\n    n = n + 1\n", 3, "UnboundLocalError: cannot access local variable 'n' where"): (
        "local.outside",
        {"name": "n"},
    ),
    ("def f():\n    print(n)\n    n = 1\n", 2, "UnboundLocalError: local variable 'n' referenced before assignment"): (
        "local.later",
        {"later": 3},
    ),
    (
        "def f():\n    if 0:\n        n = 1\n    print(n)\n",
        4,
        "UnboundLocalError: cannot access local variable 'n' where",
    ): None,
    ("from m import T\nt = T\nt.x = 1\n", 3, "AttributeError: 'property' object has no attribute 'x'"): (
        "class.no_brackets",
        {"line": 2, "right": "t = T()"},
    ),
    ("from m import T\nt = T()\nt.x = 1\n", 3, "AttributeError: 'property' object has no attribute 'x'"): None,
    ("n.declare_parameter('speed', 1)\n", 2, "ParameterNotDeclaredException: undeclared parameter(s): sped"): (
        "parameter.near",
        {"near": "speed"},
    ),
    ("n.declare_parameter(name, 1)\n", 2, "ParameterNotDeclaredException: undeclared parameter(s): sped"): None,
    ("def f(:\n", 1, "NameError: name 'x' is not defined"): None,
}


@folded("case, wanted", NAMES.items())
def test_what_is_wrong_with_a_name_is_read_in_the_program(
    tmp_path_factory: pytest.TempPathFactory, case: tuple[str, int, str], wanted: tuple[str, dict[str, object]] | None
) -> None:
    program, line, error = case
    folder = tmp_path_factory.mktemp("p")
    (folder / "a.py").write_text(program, encoding="utf-8")
    source = program.split("\n")[line - 1].strip() if line <= program.count("\n") else ""
    fault = fault_in(report(line, source, error))
    assert fault is not None
    found = cause_of_name(fault, folder)
    assert (found is None) == (wanted is None), found
    if found is not None and wanted is not None:
        assert found[0] == wanted[0] and wanted[1].items() <= dict(found[1]).items()


BEGINNINGS = {
    # The end of a program that has a function main -> the key of why it did nothing.
    "if __name__ == 'main':\n    main()\n": "main.other_name",
    "main\n": "main.never_called",
    "": "main.never_called",
    "if __name__ == '__main__':\n    main()\n": None,
    "main()\n": None,
    "def go():\n    main()\ngo()\n": None,
    "open('x', 'w').close()\n": None,  # it did something
    "for i in range(3):\n    pass\n": None,
}


@folded("end, key", BEGINNINGS.items())
def test_a_program_that_does_nothing_is_told_why(
    tmp_path_factory: pytest.TempPathFactory, end: str, key: str | None
) -> None:
    path = tmp_path_factory.mktemp("p") / "a.py"
    path.write_text(f"def main():\n    print(1)\n\n{end}", encoding="utf-8")
    found = never_begun(path)
    assert (found[0] if found is not None else None) == key
    said = hint_about_silence(Path("a.py"), Surroundings({}, path.parent))
    assert bool(said) == (key is not None)
    assert hint_about_silence(Path("a.py"), Surroundings({"DAY6_HINTS": "off"}, path.parent)) == ""
    assert never_begun(path.with_name("gone.py")) is None


def test_a_scene_knows_the_fault_of_its_line(tmp_path: Path) -> None:
    match = next(cards_in(report(4, "x = d['k']", "KeyError: 'k'")))
    scene = scene_of(match, Surroundings({}, tmp_path))
    assert scene.fault is not None and (scene.fault.number, scene.fault.source) == (4, "x = d['k']")
