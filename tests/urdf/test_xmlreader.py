"""The reader has TinyXML-2's habits: what it lets pass, what it names, which line it blames."""

from __future__ import annotations

import time

import pytest

from day6_urdf.xmlreader import XmlError, read_xml, write_xml

# Text, and the error with the line it blames. Each was traced through TinyXML-2's parser.
BROKEN = {
    "": "Error=XML_ERROR_EMPTY_DOCUMENT ErrorID=13 (0xd) Line number=0",
    "hello": "Error=XML_ERROR_PARSING_TEXT ErrorID=8 (0x8) Line number=1",
    "<a>\n<b>\n</a>": "Error=XML_ERROR_MISMATCHED_ELEMENT ErrorID=14 (0xe) Line number=2: XMLElement name=b",
    "<a>\n<b>": "Error=XML_ERROR_PARSING ErrorID=15 (0xf) Line number=2",
    "<a>\n<b>\n": "Error=XML_ERROR_PARSING ErrorID=15 (0xf) Line number=2",
    "<a>\n<b/>": "Error=XML_ERROR_PARSING ErrorID=15 (0xf) Line number=1",
    "<a>text": "Error=XML_ERROR_PARSING_TEXT ErrorID=8 (0x8) Line number=1",
    "\n<a x=1/>": "Error=XML_ERROR_PARSING_ATTRIBUTE ErrorID=7 (0x7) Line number=2: XMLElement name=a",
    "<a\n x='1' x='2'/>": "Error=XML_ERROR_PARSING_ATTRIBUTE ErrorID=7 (0x7) Line number=2: XMLElement name=a",
    "<a\n x='1": "Error=XML_ERROR_PARSING_ATTRIBUTE ErrorID=7 (0x7) Line number=2: XMLElement name=a",
    "<a x='1'": "Error=XML_ERROR_PARSING_ELEMENT ErrorID=6 (0x6) Line number=1: XMLElement name=a",
    "<a !/>": "Error=XML_ERROR_PARSING_ELEMENT ErrorID=6 (0x6) Line number=1",
    "<a>\n<!-- no end": "Error=XML_ERROR_PARSING_COMMENT ErrorID=10 (0xa) Line number=2",
    "<a>\n<1/></a>": "Error=XML_ERROR_PARSING ErrorID=15 (0xf) Line number=2",
    "<a/>\n<?xml?>": "Error=XML_ERROR_PARSING_DECLARATION ErrorID=11 (0xb) Line number=2: XMLDeclaration value=xml",
}


@pytest.mark.parametrize("text", BROKEN)
def test_an_error_is_named_with_its_line(text: str) -> None:
    with pytest.raises(XmlError) as caught:
        read_xml(text)
    assert str(caught.value) == BROKEN[text]


@pytest.mark.parametrize(
    "text",
    [
        "<a/><b/>",
        "before <a/>",
        "<a/></b><garbage",
        "< a ></a >",
        '<a x="1 & 2 < 3"/>',
        "<p:a/>",
        "<a><![CDATA[<b>]]></a>",
        "\ufeff<?xml version='1.0'?>\n<a/>",
        "<!DOCTYPE a SYSTEM 'a.dtd'><a/>",
    ],
)
def test_what_tinyxml_lets_pass_passes(text: str) -> None:
    assert read_xml(text)[0].tag in ("a", "p:a")


def test_the_five_entities_and_character_numbers_are_replaced_and_no_others() -> None:
    text = '<a x="&lt;&#65;&#x4e2d;&amp;&quot;&apos;&gt;" y="&nbsp;&#0;&#xD800;&#99999999999;"/>'
    attributes = read_xml(text)[0].attributes
    assert attributes == {"x": "<A中&\"'>", "y": "&nbsp;&#0;&#xD800;&#99999999999;"}


def test_a_billion_laughs_stay_a_few_words() -> None:
    levels = "".join(f'<!ENTITY l{n} "{f"&l{n - 1};" * 10}">' for n in range(1, 30))
    started = time.process_time()
    elements = read_xml(f'<!DOCTYPE r [<!ENTITY l0 "ha">{levels}]><r name="&l29;"/>')
    assert elements[-1].attributes == {"name": "&l29;"}
    assert time.process_time() - started < 1


def test_an_external_entity_opens_no_file() -> None:
    elements = read_xml('<!DOCTYPE r [<!ENTITY x SYSTEM "file:///etc/hostname">]><r name="&x;"/>')
    assert elements[-1].attributes == {"name": "&x;"}


def test_deep_nesting_is_refused_without_recursion() -> None:
    with pytest.raises(XmlError, match="Element nesting is too deep"):
        read_xml("<a>" * 100_000)
    assert len(read_xml("<a>" * 400 + "</a>" * 400)) == 1


def test_what_is_written_reads_back_the_same() -> None:
    text = "<robot name=\"a &quot;b&quot; &amp;lt; &#10; 小车\"><!-- away --><link x='1'><v/></link><link/></robot>"
    first = read_xml(text)
    again = read_xml(write_xml(first))
    assert write_xml(again) == write_xml(first)
    assert again[0].attributes == first[0].attributes
    assert "away" not in write_xml(first)
