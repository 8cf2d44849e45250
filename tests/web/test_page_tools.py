"""The teacher's page in a real browser: whom the tools are for, who asks first, what pupils answer, what is handed out."""

from __future__ import annotations

from typing import Any

import pytest

from tests.web.test_page_class import LESSON, ClassPage, classroom, row, tab  # noqa: F401

pytestmark = pytest.mark.browser

EVIL = "<img src=x onerror=window.hit=1>\u202e\x1b[31m"
LONG = "Wolfeschlegelsteinhausenbergerdorff"


def choose(page: Any, name: str, *held: str) -> None:
    box = page.evaluate(f"document.querySelector('.pupil[data-key={name}] .choose').getBoundingClientRect().toJSON()")
    page.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2, "left", *held)


def chosen(classroom: ClassPage) -> list[str]:  # noqa: F811
    found: list[str] = classroom.page.evaluate("classPage._chosen.names ?? []")
    return sorted(found)


def test_many_are_chosen_at_once_and_escape_chooses_nobody(classroom: ClassPage) -> None:  # noqa: F811
    page = classroom.page
    classroom.show(*(row(name) for name in ("anna", "ben", "carl", "dora", "eva")), row("fred", state="absent"))
    choose(page, "ben")
    choose(page, "dora", "shift")
    assert chosen(classroom) == ["ben", "carl", "dora"]
    page.click_on("#groups .others")
    assert chosen(classroom) == ["anna", "eva", "fred"]
    assert classroom.text("#chosen > span") == "3 chosen, 1 of them not here"
    page.click_on("#say-text")
    page.press("x")
    page.press("Escape")  # of a sentence that is being written
    assert len(chosen(classroom)) == 3
    page.click_on("h1")
    page.press("Escape")
    assert chosen(classroom) == []
    page.click_on("#groups .all")
    assert len(chosen(classroom)) == 6


def test_a_group_is_kept_chosen_by_a_click_and_dropped(classroom: ClassPage) -> None:  # noqa: F811
    page, server = classroom.page, classroom.server
    rows = (row("anna"), row("ben"), row("carl", state="absent"))
    classroom.show(*rows)
    assert not page.evaluate("document.querySelector('#groups form').checkVisibility()")
    choose(page, "anna")
    choose(page, "carl")
    page.evaluate("document.querySelector('#groups form input').value = ' 3A '")
    page.click_on("#groups form button")
    kept = {"t": "group", "do": "keep", "name": "3A", "names": ["anna", "carl"]}
    server.wait_for(lambda: server.of_kind("group") == [kept])
    classroom.show(*rows, groups=[{"name": "3A", "names": ["anna", "carl", "gone"]}, {"name": EVIL, "names": ["ben"]}])
    assert page.evaluate("document.querySelector('.group .pick').textContent") == "3A 1/2"
    assert page.evaluate("document.querySelector('.group .pick').getAttribute('aria-pressed')") == "true"
    page.click_on(".group:nth-child(2) .pick")
    assert chosen(classroom) == ["ben"] and page.evaluate("window.hit === undefined")
    page.click_on(".group .pick")
    assert chosen(classroom) == ["anna", "carl"]
    page.click_on("#freeze")
    server.wait_for(lambda: classroom.orders("carl") == [{"do": "freeze", "on": True}])  # frozen when carl comes
    page.click_on(".group .pick")
    assert chosen(classroom) == []
    page.click_on(".group .drop")
    server.wait_for(lambda: server.of_kind("group")[-1] == {"t": "group", "do": "drop", "name": "3A"})


def test_the_order_of_the_list_is_chosen_and_remembered(classroom: ClassPage) -> None:  # noqa: F811
    def at_step(step: int, solved: bool = False) -> dict[str, Any]:
        return {**LESSON, "step": step, "solved": solved}

    rows = [
        row("zoe", place=0, lesson=at_step(9), hand=True, raised=5),
        row("ben", place=1, lesson=at_step(3, True)),
        row("anna", place=2, lesson=at_step(3)),
        row("carl", place=3),
        row("dora", place=4, state="absent"),
    ]
    page = classroom.page
    classroom.show(*reversed(rows))
    assert classroom.names() == ["zoe", "carl", "anna", "ben", "dora"]
    wanted = {"list": ["zoe", "ben", "anna", "carl", "dora"], "step": ["carl", "anna", "ben", "zoe", "dora"]}
    for order, names in wanted.items():
        page.evaluate(f"document.getElementById('order').value = '{order}'")
        page.evaluate("document.getElementById('order').dispatchEvent(new Event('change'))")
        assert classroom.names() == names
    page.reload()
    page.wait_for("Boolean(window.classPage) && classPage._connection.isOpen")
    classroom.show(*reversed(rows))
    assert classroom.names() == wanted["step"]
    page.evaluate("localStorage.clear()")


def test_hands_stand_in_the_order_of_asking_and_a_click_answers(classroom: ClassPage) -> None:  # noqa: F811
    page = classroom.page
    classroom.show(
        row("ben", hand=True, raised=65, on_step=600, lesson=LESSON),
        row("anna", hand=True, raised=200, on_step=370, lesson=LESSON),
        row(EVIL, hand=True, raised=1),
        row("carl"),
    )
    found = page.evaluate("[...document.querySelectorAll('#queue li')].map(e => e.innerText.replace(/\\s+/g, ' '))")
    assert found[0] == "1. anna hand up for 3 min · for 6 min on step 3/12 Lower"
    assert found[1].startswith("2. ben hand up for 1 min · for 10 min on step 3/12")
    assert page.evaluate("window.hit === undefined && !document.querySelector('#queue img')")
    page.click_on("#queue li:nth-child(2) .lower")
    classroom.server.wait_for(lambda: classroom.orders("ben") == [{"do": "lower_hand"}])
    assert page.evaluate("classPage._panes.length") == 0
    page.click_on("#queue .answer")
    classroom.server.wait_for(lambda: classroom.orders("anna")[:1] == [{"do": "lower_hand"}])
    assert page.evaluate("classPage._panes.map(pane => pane.name)") == ["anna"]
    classroom.show(row("ben"), row("anna"))
    assert not page.evaluate("document.getElementById('queue').checkVisibility()")


QUESTION = {
    "number": 7,
    "text": "Done? " + EVIL,
    "asked": ["anna", "ben", "carl", "dora"],
    "replies": {
        "anna": {"kind": "yes", "text": ""},
        "ben": {"kind": "words", "text": "almost " + EVIL},
        "carl": {"kind": "evil", "text": ""},
        "stranger": {"kind": "no", "text": ""},
    },
}


def test_a_question_is_asked_and_its_answers_are_counted_and_on_the_cards(classroom: ClassPage) -> None:  # noqa: F811
    page, server = classroom.page, classroom.server
    rows = [row(name) for name in ("anna", "ben", "carl", "dora", "eva")]
    classroom.show(*rows)
    page.click_on("#say-asks")
    page.evaluate("document.getElementById('say-text').value = 'Done?'")
    page.click_on("#say button")
    server.wait_for(lambda: server.of_kind("ask") == [{"t": "ask", "names": "*", "text": "Done?"}])
    classroom.answer("say", 4, "eva")
    classroom.becomes("#notice", "Sent to 4. Not reached: eva.")
    classroom.show(*rows, questions=[QUESTION])
    counts = page.evaluate("[...document.querySelectorAll('.question > button')].map(e => e.textContent)")
    assert counts == ["Yes 1", "No 0", "Done 0", "In words 1", "Not yet 2", "✕"]
    assert "ben: almost <img" in classroom.text(".question ul")
    replies = page.evaluate("[...document.querySelectorAll('.pupil .reply')].map(e => e.textContent)")
    assert replies[0] == "answer: Yes" and replies[1].startswith("answer: almost <img")
    assert replies[2:] == ["no answer yet", "no answer yet", ""]
    assert page.evaluate("window.hit === undefined && !document.querySelector('.question img')")
    page.click_on('.question [data-key="7 none"]')
    assert chosen(classroom) == ["carl", "dora"]  # to be reminded
    page.click_on('.question [data-key="7 close"]')
    server.wait_for(lambda: server.of_kind("settle") == [{"t": "settle", "number": 7}])
    page.evaluate("localStorage.clear()")


def test_who_has_opened_what_was_handed_out_is_spoken_once(classroom: ClassPage) -> None:  # noqa: F811
    page = classroom.page
    rows = [row(name) for name in ("anna", "ben", "carl")]
    link, file = "https://docs.ros.org/", f"map{EVIL}.py"

    def show(*opened: str) -> None:
        handouts = [
            {"number": 3, "text": link, "given": ["anna", "ben", "carl"], "opened": list(opened)},
            {"number": 4, "text": file, "given": ["anna"], "opened": ["anna"]},
        ]
        classroom.show(*rows, handouts=handouts)

    show()
    told = "[...document.querySelectorAll('.handout [role=status]')].map((each) => each.textContent)"
    page.wait_for(f"{told}[1] === 'opened by 0 of 3, not yet: anna, ben, carl'")
    assert page.evaluate(told)[0] == "opened by 1 of 1" and "<img" in classroom.text(".handout b")
    page.evaluate(
        "window.spoken = []; new MutationObserver((all) => spoken.push(...all.map(({ target }) => target.textContent)))"
        ".observe(document.getElementById('handouts'), { childList: true, subtree: true })"
    )
    show("ben", "stranger")
    page.wait_for(f"{told}[1] === 'opened by 1 of 3, not yet: anna, carl'")
    show("ben")
    show("ben", "anna", "carl")
    page.wait_for(f"{told}[1] === 'opened by 3 of 3'")
    assert page.evaluate("spoken") == ["opened by 1 of 3, not yet: anna, carl", "opened by 3 of 3"]
    page.click_on(".handout button")  # the latest
    show("ben")
    page.wait_for(f"{told}.join() === 'opened by 1 of 3, not yet: anna, carl'")


def test_a_link_is_handed_out_and_no_script(classroom: ClassPage) -> None:  # noqa: F811
    page = classroom.page
    classroom.show(row("anna"), row("ben"))
    page.click_on("#hand summary")
    for typed in ("javascript:alert(1)", "data:text/html,x", "file:///etc/passwd", "https://a@b.c/", "https://", ""):
        page.evaluate(f"document.querySelector('#hand .link input').value = {typed!r}")
        page.click_on("#hand .link button")
        assert classroom.text("#notice") == "A link begins with http:// or https://.", typed
    for typed, sent in (("docs.ros.org", "https://docs.ros.org"), ("http://10.0.0.5:8000/a?b#c", None)):
        page.evaluate("document.getElementById('hand').open = true")
        page.evaluate(f"document.querySelector('#hand .link input').value = {typed!r}")
        page.click_on("#hand .link button")
        classroom.server.wait_for(lambda sent=sent or typed: {"do": "link", "text": sent} in classroom.orders("*"))


def test_a_file_goes_to_the_server_and_then_to_those_who_are_chosen(classroom: ClassPage) -> None:  # noqa: F811
    page, server = classroom.page, classroom.server
    rows = (row("anna"), row("ben"))
    classroom.show(*rows)
    choose(page, "ben")
    page.evaluate("window.fetched = []; window.fetch = async (address, how) => {"
                  " fetched.push([String(address), await how.body.text()]);"
                  " return { ok: true, json: async () => ({ id: 3, name: 'map.py' }) }; }")  # fmt: skip
    page.evaluate("(async () => { const data = new DataTransfer(); data.items.add(new File(['print()'], 'a/地图.py'));"
                  " const field = document.querySelector('#hand .file'); field.files = data.files;"
                  " field.dispatchEvent(new Event('change')); })()")  # fmt: skip
    server.wait_for(lambda: server.of_kind("hand") == [{"t": "hand", "names": ["ben"], "id": 3}])
    (address, body), = page.evaluate("fetched")  # fmt: skip
    assert address.startswith("class/hand?name=") and body == "print()"
    server.say({"t": "handing", "id": 9})
    handed = {"id": 9, "name": "map.py", "all": 2, "count": 0, "failed": []}
    classroom.show(*rows, handed=[handed])
    assert classroom.text("#notice") == ""
    classroom.show(*rows, handed=[{**handed, "count": 1, "failed": [["ben", "No space left on device"]]}])
    classroom.becomes(
        "#notice", "map.py is in the folder “handed” of 1. Not possible for ben (No space left on device)."
    )


@pytest.mark.parametrize("width", [1280, 400])
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_nothing_of_the_tools_is_cut(classroom: ClassPage, width: int, lang: str) -> None:  # noqa: F811
    page = classroom.page
    page.device(width, 800)
    page.evaluate(f"classPage._hello({{lang: {lang!r}}})")
    names = ["安娜", LONG, *(f"pupil {number}" for number in range(10))]
    rows = [row(name, hand=True, raised=100, on_step=400, lesson=LESSON) for name in names[:4]]
    question = {**QUESTION, "asked": names, "replies": {names[0]: {"kind": "words", "text": "x" * 80}}}
    groups = [{"name": "3A", "names": names[:3]}, {"name": "W" * 32, "names": names}]
    classroom.show(*rows, *(row(name) for name in names[4:]), groups=groups, questions=[question, QUESTION])
    page.evaluate("classPage._chosen.set(['安娜'])")
    page.evaluate("document.getElementById('hand').open = true")
    page.evaluate(
        "window.isCut = (e, box = e.getBoundingClientRect()) => e.checkVisibility() && !e.closest('.pick') &&"
        " (box.right > innerWidth + 1 || box.left < 0 || (e.matches('button') && e.scrollWidth > e.clientWidth + 1))"
    )
    cut = "[...document.querySelectorAll('body *')].filter(e => isCut(e)).map(e => e.outerHTML.slice(0, 80))"
    assert page.evaluate(cut) == []
    page.device(1280, 800)
