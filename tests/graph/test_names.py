"""Names: what is refused, with rcl's words and the caret where rcl puts it; expansion and remapping."""

from __future__ import annotations

from typing import Any

import pytest

from day6_core.graph import names
from tests.support.folded import folded

TOPIC_FLAWS = [
    ("", "topic name must not be empty string", 0),
    ("chatter/", "topic name must not end with a forward slash", 7),
    ("my topic", "topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'", 2),
    ("中文", "topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'", 0),
    ("1chat", "topic name token must not start with a number", 0),
    ("a/1b", "topic name token must not start with a number", 2),
    ("~/1", "topic name token must not start with a number", 2),
    ("~foo", "topic name must not have a tilde '~' that is not followed by a forward slash '/'", 1),
    ("a~b", "topic name must not have tilde '~' unless it is the first character", 1),
    ("{bad", "topic name must not have unmatched (unbalanced) curly braces '{}'", 0),
    ("bad}", "topic name must not have unmatched (unbalanced) curly braces '{}'", 3),
    ("{no de}", "substitution name must not contain characters other than alphanumerics or '_'", 3),
    ("{{a}}", "substitution name must not contain characters other than alphanumerics or '_'", 1),
    ("{1a}", "substitution name must not start with a number", 1),
]


@pytest.mark.parametrize(("name", "message", "position"), TOPIC_FLAWS)
def test_a_bad_topic_name_is_explained_with_a_caret(name: str, message: str, position: int) -> None:
    assert names.flaw_of_topic_name(name)[:2] == (message, position)


@pytest.mark.parametrize("name", ["chatter", "/a/b", "~", "~/x", "{node}/x", "{}", "a__b", "//a", "_hidden"])
def test_names_a_program_may_write_are_accepted_before_expansion(name: str) -> None:
    assert names.flaw_of_topic_name(name) is None


@pytest.mark.parametrize(
    ("name", "message", "position"),
    [
        ("", "topic name must not be empty", 0),
        ("a", "topic name must be absolute, it must lead with a '/'", 0),
        ("/a/", "topic name must not end with a '/'", 2),
        ("/a//b", "topic name must not contain repeated '/'", 3),
        ("/a-b", "topic name must not contain characters other than alphanumerics, '_', or '/'", 2),
        ("/a/1", "topic name must not have a token that starts with a number", 3),
        ("/" + "x" * 247, "topic length should not exceed '255U - 8U'", 246),
    ],
)
def test_a_bad_full_topic_name_is_explained(name: str, message: str, position: int) -> None:
    assert names.flaw_of_full_topic_name(name)[:2] == (message, position)


def test_the_longest_full_topic_name_has_247_characters() -> None:
    assert names.flaw_of_full_topic_name("/" + "x" * 246) is None


@pytest.mark.parametrize(
    ("name", "message", "position"),
    [
        ("", "node name must not be empty", 0),
        ("1x", "node name must not start with a number", 0),
        ("x/y", "node name must not contain characters other than alphanumerics or '_'", 1),
        ("é", "node name must not contain characters other than alphanumerics or '_'", 0),
        ("x" * 256, "node name length should not exceed '255'", 254),
    ],
)
def test_a_bad_node_name_is_explained(name: str, message: str, position: int) -> None:
    assert names.flaw_of_node_name(name)[:2] == (message, position)


@pytest.mark.parametrize(
    ("namespace", "message", "position"),
    [
        ("", "namespace must not be empty", 0),
        ("a", "namespace must be absolute, it must lead with a '/'", 0),
        ("/a/", "namespace must not end with a '/', unless only a '/'", 2),
        ("/a//b", "namespace must not contain repeated '/'", 3),
        ("/1a", "namespace must not have a token that starts with a number", 1),
        ("/a b", "namespace must not contain characters other than alphanumerics, '_', or '/'", 2),
    ],
)
def test_a_bad_namespace_is_explained(namespace: str, message: str, position: int) -> None:
    assert names.flaw_of_namespace(namespace)[:2] == (message, position)


@pytest.mark.parametrize(
    ("name", "namespace", "full"),
    [
        ("a", "/", "/a"),
        ("a", "/sp", "/sp/a"),
        ("/a", "/sp", "/a"),
        ("~", "/sp", "/sp/nod"),
        ("~/a", "/", "/nod/a"),
        ("{node}/x", "/sp", "/sp/nod/x"),
        ("{ns}/y", "/sp", "/sp/y"),
        ("{ns}/y", "/", "//y"),
        ("{namespace}z", "/", "/z"),
    ],
)
def test_names_expand_as_rcl_expands_them(name: str, namespace: str, full: str) -> None:
    assert names.expand(name, "nod", namespace) == full


def test_an_unknown_substitution_is_named() -> None:
    with pytest.raises(names.UnknownSubstitution, match=r"unknown substitution: \{bad\}"):
        names.expand("{bad}/x", "nod", "/")


def test_a_node_and_its_topics_are_renamed_by_rules() -> None:
    rules = [names.RemapRule.parse(text) for text in ("__node:=renamed", "__ns:=/team", "chatter:=news", "~/a:=/b")]
    assert names.remap_node("talker", "/", rules) == ("renamed", "/team")
    assert names.remap_topic("/team/chatter", "renamed", "/team", rules) == "/team/news"
    assert names.remap_topic("/team/renamed/a", "renamed", "/team", rules) == "/b"
    assert names.remap_topic("/chatter", "renamed", "/team", rules) == "/chatter"


def test_a_rule_for_one_node_leaves_the_others_alone() -> None:
    rule = names.RemapRule.parse("talker:chatter:=news")
    assert names.remap_topic("/chatter", "talker", "/", [rule]) == "/news"
    assert names.remap_topic("/chatter", "listener", "/", [rule]) == "/chatter"


@pytest.mark.parametrize("text", ["", "a", "a:=", ":=b", "a b:=c", "__node:=a/b", "__ns:=a"])
def test_something_that_is_no_rule_is_refused(text: str) -> None:
    with pytest.raises(ValueError):
        names.RemapRule.parse(text)


def test_a_leading_underscore_anywhere_hides_a_name() -> None:
    assert [names.is_hidden(name) for name in ("/a", "/_a", "/a/_b", "_a", "/a_", "")] == [
        False,
        True,
        True,
        True,
        False,
        False,
    ]


@folded(
    "check, name, flaw",
    [
        (names.flaw_of_node_name, "", (0, 1)),
        (names.flaw_of_node_name, "a-b", (1, 2)),
        (names.flaw_of_node_name, "1a", (0, 3)),
        (names.flaw_of_node_name, "a" * 255, None),
        (names.flaw_of_node_name, "a" * 256, (254, 4)),
        (names.flaw_of_namespace, "", (0, 1)),
        (names.flaw_of_namespace, "a", (0, 2)),
        (names.flaw_of_namespace, "/", None),
        (names.flaw_of_namespace, "/a/", (2, 3)),
        (names.flaw_of_namespace, "//", (1, 3)),
        (names.flaw_of_namespace, "/a-b", (2, 4)),
        (names.flaw_of_namespace, "/a//b", (3, 5)),
        (names.flaw_of_namespace, "/a/1b", (3, 6)),
        (names.flaw_of_namespace, "/a1/b2", None),
        (names.flaw_of_namespace, "/" + "a" * 244, None),
        (names.flaw_of_namespace, "/" + "a" * 245, (244, 7)),
        (names.flaw_of_full_topic_name, "", (0, 1)),
        (names.flaw_of_full_topic_name, "a", (0, 2)),
        (names.flaw_of_full_topic_name, "/a/", (2, 3)),
        (names.flaw_of_full_topic_name, "/", (0, 3)),
        (names.flaw_of_full_topic_name, "/a b", (2, 4)),
        (names.flaw_of_full_topic_name, "/a//b", (3, 5)),
        (names.flaw_of_full_topic_name, "/1b", (1, 6)),
        (names.flaw_of_full_topic_name, "/" + "a" * 246, None),
        (names.flaw_of_full_topic_name, "/" + "a" * 247, (246, 7)),
        (names.flaw_of_topic_name, "1a", (0, 0)),
        (names.flaw_of_topic_name, "{a1}/b", None),
        (names.flaw_of_topic_name, "{a_}{b}", None),
        (names.flaw_of_topic_name, "a}{", (1, 0)),
        (names.flaw_of_topic_name, "a{b", (1, 0)),
        (names.flaw_of_topic_name, "a{b/c}", (3, 0)),
        (names.flaw_of_topic_name, "~a", None),
        (names.flaw_of_topic_name, "~ab", (1, 0)),
        (names.flaw_of_topic_name, "~/", (1, 0)),
        (names.flaw_of_topic_name, "/1", (1, 0)),
        (names.flaw_of_topic_name, "a1", None),
    ],
)
def test_a_flaw_has_a_place_and_rmws_number(check: Any, name: str, flaw: tuple[int, int] | None) -> None:
    found = check(name)
    assert (None if found is None else (found.position, found.number)) == flaw


@pytest.mark.parametrize(
    ("text", "rule"),
    [
        ("a:=b", ("name", "a", "b", None)),
        ("/a/b:=~/c", ("name", "/a/b", "~/c", None)),
        ("n:a:=b", ("name", "a", "b", "n")),
        ("rostopic://a:=b", ("name", "a", "b", None)),
        ("rosservice://a:=b", ("name", "a", "b", None)),
        ("__node:=b", ("node", "__node", "b", None)),
        ("__name:=b", ("node", "__name", "b", None)),
        ("n:__node:=b", ("node", "__node", "b", "n")),
        ("__ns:=/b", ("namespace", "__ns", "/b", None)),
        ("n:__ns:=/b", ("namespace", "__ns", "/b", "n")),
    ],
)
def test_a_rule_is_read_from_a_text(text: str, rule: tuple[str, str, str, str | None]) -> None:
    found = names.RemapRule.parse(text)
    assert (found.kind, found.match, found.replacement, found.node) == rule


@pytest.mark.parametrize("text", ["a:=b c", "a b:=c", "__node:=", "__name:=1", "__ns:=", "n:__ns:=b", "a/:=b", "a:=b/"])
def test_a_rule_with_a_bad_name_is_refused(text: str) -> None:
    with pytest.raises(ValueError):
        names.RemapRule.parse(text)


@pytest.mark.parametrize(
    ("rules", "expected"),
    [
        ([], ("n", "/lab")),
        (["a:=b"], ("n", "/lab")),
        (["__node:=m", "__node:=o"], ("m", "/lab")),
        (["x:__node:=m", "n:__node:=o"], ("o", "/lab")),
        (["__ns:=/x", "__ns:=/y"], ("n", "/x")),
        (["__node:=m", "n:__ns:=/x"], ("m", "/lab")),
        (["__node:=m", "m:__ns:=/x"], ("m", "/x")),
    ],
)
def test_the_first_rule_for_a_node_counts(rules: list[str], expected: tuple[str, str]) -> None:
    assert names.remap_node("n", "/lab", [names.RemapRule.parse(each) for each in rules]) == expected


@pytest.mark.parametrize(
    ("rules", "full"),
    [
        (["a:=b", "a:=c"], "/lab/b"),
        (["__node:=b", "a:=c"], "/lab/c"),
        (["m:a:=b", "n:a:=c"], "/lab/c"),
        (["/lab/a:=/c"], "/c"),
        (["/a:=c"], "/lab/a"),
        (["a:=~"], "/lab/n"),
    ],
)
def test_the_first_rule_for_a_topic_counts(rules: list[str], full: str) -> None:
    assert names.remap_topic("/lab/a", "n", "/lab", [names.RemapRule.parse(each) for each in rules]) == full


def test_a_namespace_and_a_name_are_joined() -> None:
    assert names.full_name("/", "a") == "/a"
    assert names.full_name("/sp", "a") == "/sp/a"
