"""The queue of typed text gives back what was put in, in its order, however it is taken."""

from __future__ import annotations

import random

from day6_core.session.typed_text import TypedText


def test_keys_are_put_together_from_what_came_in_pieces() -> None:
    typed = TypedText("a\x1b[A\x1b")
    typed.add("[Bc")
    assert [typed.take_key() for _ in range(5)] == ["a", "\x1b[A", "\x1b[B", "c", None]


def test_a_line_ends_with_enter_or_with_the_end_of_the_file() -> None:
    typed = TypedText("one\rtwo\nthr\x04\x04ee")
    assert [typed.take_line() for _ in range(5)] == ["one\n", "two\n", "thr", "", None] and typed.take_all() == "ee"


def test_what_stands_behind_the_last_line_can_be_taken_alone() -> None:
    typed = TypedText("one\rtwo\nthree")
    assert typed.take_line() == "one\n"
    assert (typed.take_unfinished(), typed.take_unfinished(), typed.take_all()) == ("three", "", "two\n")


def test_a_mark_is_found_wherever_it_is_cut() -> None:
    for cut in range(8):
        typed = TypedText()
        text, mark = "so\x1b[20x\x1b[201~\x1b[A", "\x1b[201~"
        at = text.index(mark) + cut
        typed.add(text[:at])
        before, found = typed.take_up_to(mark)
        typed.add(text[at:])
        if not found:
            rest, found = typed.take_up_to(mark)
            before += rest
        assert (before, found, typed.take_all()) == ("so\x1b[20x", True, "\x1b[A")


def test_nothing_is_lost_or_moved_when_adding_and_taking_alternate() -> None:
    chosen = random.Random(9)
    for _ in range(300):
        typed, put, got = TypedText(), "", ""
        for _ in range(chosen.randint(1, 30)):
            piece = "".join(chosen.choices("ab中\n\x1b[A\x7f", k=chosen.randint(0, 6)))
            typed.add(piece)
            put += piece
            take = chosen.choice([typed.take_key, typed.take_line, typed.take_plain])
            before = len(typed)
            part = take() or ""
            taken = put[len(got) :][: before - len(typed)]
            assert taken == part
            got += taken
        assert got + typed.take_all() == put and not typed


def test_an_escape_that_never_ends_is_only_looked_at_as_far_as_one_can_be_long() -> None:
    typed = TypedText("\x1b[" + "1" * 100_000)
    assert [typed.take_key() for _ in range(3)] == ["\x1b", "[", "1"]
