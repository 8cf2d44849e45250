"""The order of the console's table, against sorting everything anew each time."""

from __future__ import annotations

import random

import pytest

from day6_core.ros.programs.rqt_console.model import FilterChoice, Record
from day6_tui.windows.console.order import COLUMNS, FEW, Order, SortedRecords

RULES = {
    "number": lambda record: record.number,
    "message": lambda record: (record.text.casefold(), record.number),
    "severity": lambda record: (record.level, record.number),
    "node": lambda record: (record.node, record.number),
    "stamp": lambda record: (record.stamp_ns, record.number),
    "location": lambda record: (record.location, record.number),
}


def some(chance, first, count):
    return [
        Record(
            number,
            chance.choice("aBcD") + str(chance.random()),
            chance.choice((10, 20, 30, 40, 50)),
            chance.choice(("talker", "listener")),
            chance.randrange(100),
            chance.choice(("a.py:1", "b.py:2")),
        )
        for number in range(first, first + count)
    ]


@pytest.mark.parametrize("descending", [False, True])
@pytest.mark.parametrize("column", COLUMNS)
def test_it_stays_sorted_while_messages_come_and_go(column, descending):
    chance = random.Random(f"{column}{descending}")
    records, number, choice = [], 1, FilterChoice()
    table = SortedRecords()
    table.sort(Order(column, descending))
    for come, go in ((3, 0), (40, 0), (1, 1), (5, 20), (0, 0), (FEW + 9, 0), (2, FEW), (0, 10**6), (4, 0), (9, 10**6)):
        records = records[go:] + some(chance, number, come)
        number += come
        table.update(records, choice)
        expected = sorted(records, key=RULES[column], reverse=descending)
        assert [table[at] for at in range(len(table))] == expected
        assert [table.index(record) for record in expected] == list(range(len(expected)))


@pytest.mark.parametrize("column", COLUMNS)
def test_a_list_that_grows_behind_its_back_is_read_when_it_is_told(column):
    """The console's model adds to the list that it has handed out."""
    chance = random.Random(column)
    records = some(chance, 1, 20)
    table = SortedRecords()
    table.sort(Order(column))
    table.update(records, choice := FilterChoice())
    before = [table[at] for at in range(20)]
    records += some(chance, 21, 5)
    assert len(table) == 20 and [table[at] for at in range(20)] == before
    table.update(records, choice)
    assert [table[at] for at in range(len(table))] == sorted(records, key=RULES[column])


@pytest.mark.parametrize("column", COLUMNS)
def test_what_is_left_out_is_gone_and_what_is_shown_again_is_back(column):
    records = some(random.Random(column), 1, 50)
    table = SortedRecords()
    table.sort(Order(column))
    for shown in (records, records[::3], records[1::2], [], records):
        table.update(shown, FilterChoice())
        assert [table[at] for at in range(len(table))] == sorted(shown, key=RULES[column])


def test_a_message_that_is_not_shown_has_its_place_beside_its_neighbours():
    records = some(random.Random(1), 1, 9)
    table = SortedRecords()
    table.update(records[:3] + records[4:], FilterChoice())
    assert table[table.index(records[3])] is records[4]
    table.update(records[:8], FilterChoice())
    assert table[table.index(records[8])] is records[7]
    table.update([], FilterChoice())
    assert table.index(records[0]) == -1
