"""Every combination of rqt_graph's controls shows the nodes and edges that the real one was recorded to show."""

from __future__ import annotations

import pytest

from day6_core.ros.programs.rqt_graph.model.content import GraphOptions, GraphType, select
from tests.rqt_graph.one_graph import FACTS, shown
from tests.rqt_graph.record_rqt_graph import MODES, combinations, load
from tests.support.folded import folded

TYPES = dict(zip(MODES, GraphType, strict=True))
PICTURES, NUMBERS = load()
CASES = [(mode, switches, PICTURES[number]) for (mode, switches), number in zip(combinations(), NUMBERS, strict=True)]
HIDDEN_END = "the real one joins /tf to a node that it hides as a debug node"


def name(case: tuple[str, dict[str, bool], object]) -> str:
    return "-".join((case[0], *(switch for switch, on in case[1].items() if on)))


def sensible(boxes, edges) -> set[tuple[str, ...]]:
    """The edges that end at boxes which are shown."""
    return {tuple(edge) for edge in edges if {edge[0], edge[1]} <= set(boxes)}


def ends_hidden(case) -> bool:
    """Whether the real one draws an edge to a node that it hides."""
    boxes, edges = case[2]
    return len(sensible(boxes, edges)) < len(set(map(tuple, edges)))


def ours_and_theirs(case) -> tuple[object, object]:
    mode, switches, (boxes, edges) = case
    return shown(select(FACTS, GraphOptions(TYPES[mode], **switches))), (set(boxes), sensible(boxes, edges))


@folded("case", [case for case in CASES if not ends_hidden(case)], ids=name)
def test_a_combination_of_the_controls_shows_what_the_real_one_shows(case) -> None:
    ours, theirs = ours_and_theirs(case)
    assert ours == theirs


@folded("case", filter(ends_hidden, CASES), ids=name)
def test_a_combination_with_a_hidden_end_differs_by_that_edge_only(case) -> None:
    ours, theirs = ours_and_theirs(case)
    assert ours == theirs


def test_the_real_one_shows_edges_to_a_node_that_it_hides() -> None:
    odd = [switches for _, switches, _ in filter(ends_hidden, CASES)]
    assert odd and all(switches["group_tf"] and switches["hide_debug"] for switches in odd)
    pytest.xfail(HIDDEN_END)


def test_all_combinations_are_recorded_and_the_pictures_differ() -> None:
    assert len(CASES) == 3 * 2**8
    assert len(PICTURES) > 100
