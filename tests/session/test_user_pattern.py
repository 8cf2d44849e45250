"""A user's regular expression finds what `re` finds, and none stops the program."""

from __future__ import annotations

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from day6_core.user_pattern import TooComplex, UserPattern

_ATOMS = st.sampled_from(["a", "b", ".", "[ab]", "[^a]", r"\w", r"\b", "^", "$", "(?i:A)", "", r"\Z"])
_EXPRESSIONS = st.recursive(
    _ATOMS,
    lambda inner: st.one_of(
        st.tuples(inner, inner).map("".join),
        st.tuples(inner, inner).map("(?:{0[0]}|{0[1]})".format),
        inner.map("({})".format),
        st.tuples(inner, st.sampled_from(["*", "+", "?", "*?", "+?", "??", "{2}", "{1,2}", "{,2}?", "{2,}"])).map(
            "(?:{0[0]}){0[1]}".format
        ),
    ),
    max_leaves=8,
)
_TEXTS = st.text("abA \n", max_size=7)


@settings(max_examples=150, deadline=None)
@given(_EXPRESSIONS, _TEXTS)
def test_the_linear_matcher_finds_what_re_finds(expression: str, text: str) -> None:
    matcher = UserPattern(expression)
    matcher._is_quick = lambda text: False  # type: ignore[method-assign]
    compiled = re.compile(expression)
    for theirs, ours in (
        (compiled.search(text), matcher.search(text)),
        (compiled.match(text), matcher.match(text)),
        (compiled.fullmatch(text), matcher.fullmatch(text)),
    ):
        assert (theirs and theirs.span()) == (ours and ours.span())
    assert [match.span() for match in compiled.finditer(text)] == [found.span() for found in matcher.finditer(text)]


@pytest.mark.parametrize(
    ("expression", "text"),
    [
        (r"(a+)+$", "a" * 5000 + "b"),
        (r"(a|a)*c", "a" * 5000),
        (r"(a|b|ab)*c", "ab" * 2500),
        (r"(.*)*x", "a" * 5000),
        (r"^(([a-z])+.)+[A-Z]([a-z])+$", "a" * 5000),
        (r"(a?){30}a{30}", "a" * 29),
        (r".*.*.*.*=.*", "x" * 2000),
        ("a?" * 40 + "a" * 40, "a" * 39),
        ("(?i)(a|A)*b", "a" * 5000),
        ("(x|x)" * 40 + "y", "x" * 100),
        (r"(x+x+)+y", "x" * 2000),
    ],
)
def test_no_expression_takes_for_ever(expression: str, text: str) -> None:
    assert UserPattern(expression).search(text) is None


def test_groups_are_those_of_re() -> None:
    for expression, text in ((r"((\w+)=(\d+|\w)+;?)+", "a=1;bc=23;d=x"), (r"(?:(a)|b)*(c+)?", "abbb")):
        theirs = re.compile(expression).search(text)
        ours = UserPattern(expression)
        ours._is_quick = lambda text: False  # type: ignore[method-assign]
        assert theirs is not None
        assert (found := ours.search(text)) is not None
        assert [found[group] for group in range(ours.groups + 1)] == [theirs[0], *theirs.groups()]


def test_usual_expressions_are_left_to_re() -> None:
    for expression in (r"^\[INFO\].*x=", r"(talker|listener)", r"\d+\.\d+", r"(foo|bar)+", r"a{3,5}b*", "(ab)+"):
        assert UserPattern(expression)._is_quick("x" * 300)


def test_what_cannot_be_matched_in_time_is_refused() -> None:
    with pytest.raises(TooComplex):
        UserPattern(r"(a+)+\1$").search("a" * 40 + "b")
    with pytest.raises(re.error, match="too big"):
        UserPattern("(" * 20000 + ")" * 20000)
    with pytest.raises(TooComplex):
        UserPattern("((a{1,99}){1,99}){1,99}b").search("a" * 300)
    assert UserPattern(r"(.*)\1$").search("abab") is not None
