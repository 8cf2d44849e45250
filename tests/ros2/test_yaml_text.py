"""Our quick YAML is PyYAML's, for everything a message can hold."""

from __future__ import annotations

from collections import OrderedDict

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from rosidl_runtime_py.yaml_text import dump, dump_with_pyyaml

AWKWARD = [
    *(
        "yes",
        "On",
        "null",
        "~",
        "",
        " ",
        "a b",
        "- x",
        "#",
        "a: b",
        "你好",
        "🐢",
        "12",
        "0x1",
        "1e5",
        ".5",
        "y",
        "/a/b_c",
    ),
    *("...", "=", "<<", "'", '"', "\t", "\x00", "2001-01-01", "-", "?", "a-", "a.", "%", "@", "`", "[", "{", ",", "!x"),
    *("&x", "*x", "|", ">"),
]
scalars = st.one_of(
    st.booleans(),
    st.integers(),
    st.floats(),
    st.text(max_size=12),
    st.sampled_from(AWKWARD),
)
names = st.sampled_from(["x", "y", "off", "frame_id", "no", "data", "n"])
messages = st.recursive(
    st.dictionaries(names, scalars, max_size=4).map(OrderedDict),
    lambda inner: st.dictionaries(
        names, st.one_of(scalars, inner, st.lists(scalars, max_size=4), st.lists(inner, max_size=3)), max_size=4
    ).map(OrderedDict),
    max_leaves=8,
)


@settings(max_examples=400, deadline=None)
@given(messages, st.booleans())
def test_any_message_is_written_as_pyyaml_writes_it(message, flow_style):
    assert dump(message, flow_style=flow_style) == dump_with_pyyaml(message, flow_style=flow_style)


@pytest.mark.parametrize("flow_style", [False, True])
def test_a_string_of_several_lines_deep_inside_is_indented_as_pyyaml_does(flow_style):
    message = OrderedDict(a=OrderedDict(b=["one\n\ntwo", "x"]), c=[OrderedDict(d="p\nq")])
    assert dump(message, flow_style=flow_style) == dump_with_pyyaml(message, flow_style=flow_style)
