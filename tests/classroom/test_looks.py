"""Which names could be taken for each other, and which could not."""

from __future__ import annotations

import pytest

from day6_core.looks import looks_like, mixes_alphabets
from day6_tui.web.names import clean

ALIKE = [
    ("mallory", "m\u0430ll\u043ery"),  # Cyrillic а and о
    ("coco", "\u0441\u043e\u0441\u043e"),
    ("MAMA", "\u041c\u0410\u041c\u0410"),
    ("mama", "\u041c\u0410\u041c\u0410"),
    ("Nikita", "\u039dikita"),  # Greek
    ("Oxana", "0xana"),
    ("Anna1", "Annal"),
    ("Ian", "lan"),
    ("Marni", "Mami"),
    ("vvera", "wera"),
    ("anna", "an-na"),
    ("anna", "\uff41nn\u0251"),  # wide, and a Latin alpha
    ("bob", "\u0299ob"),  # a small capital
    ("王力", "王\u30ab"),  # カ
    ("王一", "王\u30fc"),
    ("\u0451lena", "\u00eblena"),
]
APART = [
    ("Ian", "Lan"),
    ("Clara", "Dara"),
    ("José", "Jose"),
    ("Hà", "Hạ"),
    ("Андрей", "Andrey"),
    ("王伟", "王玮"),
    ("末", "未"),
    ("李雷", "李磊"),
    ("anna 1", "anna 2"),
    ("1-11", "11-1"),
    ("group_1_11", "group_11_1"),
    ("राम", "रमा"),
    ("김민수", "김민서"),
]


@pytest.mark.parametrize(("one", "other"), ALIKE)
def test_these_look_alike(one: str, other: str) -> None:
    assert looks_like(one, ["somebody", other]) == other and looks_like(other, [one]) == one


@pytest.mark.parametrize(("one", "other"), APART)
def test_these_do_not(one: str, other: str) -> None:
    assert looks_like(one, [other]) is None and looks_like(other, [one]) is None


@pytest.mark.parametrize("name", ["m\u0430llory", "\u0420aul", "\u039dikita", "李 m\u0430llory", "ра\u1d0fl"])
def test_a_word_of_several_alphabets_is_known(name: str) -> None:
    assert mixes_alphabets(clean(name))


@pytest.mark.parametrize(
    "name",
    ["王小明", "王 Dora", "小A", "李雷3", "Дора Smith", "O’Neil", "Jean-Luc", "田中さくら", "サトー", "김민수", "राम", "佐々木",
     "Αννα", "阿爾文", "欧阳·娜娜", "mallory", "Hạ", "ｗｉｄｅ"],
)  # fmt: skip
def test_names_as_people_have_them_are_fine(name: str) -> None:
    assert not mixes_alphabets(clean(name))
