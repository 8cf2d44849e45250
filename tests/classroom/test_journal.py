"""The log of a class: it is on the disk at once, survives whatever happens to it, and nobody can fill the disk with it."""

from __future__ import annotations

import errno
import stat
import sys
from datetime import date, datetime
from pathlib import Path

import pytest

from day6_core.classroom import journal
from day6_core.classroom.journal import BURST, KINDS, LARGEST, OF_ORDER, SECONDS_EACH, ClassEvent, Journal
from day6_core.classroom.order import ORDERS

MONDAY = datetime(2026, 3, 2, 10).timestamp()
DAY = 86400.0


class Clock:
    now = MONDAY

    def __call__(self) -> float:
        return self.now


def of(folder: Path, clock: Clock, told: list[OSError] | None = None) -> Journal:
    return Journal(folder / "log", (told if told is not None else []).append, wall=clock, clock=clock)


def whats(events: list[ClassEvent]) -> list[str]:
    return [event.what for event in events]


def test_each_event_is_on_the_disk_when_it_was_noted_and_each_day_has_a_file(tmp_path: Path) -> None:
    clock = Clock()
    made = of(tmp_path, clock)
    made.note("came", "王小明")
    made.note("said", text="两行\n第二行 \u2028 \ud800")
    clock.now += DAY
    made.note("left", "王小明")
    again = of(tmp_path, clock)  # nothing was closed: as after kill -9
    again.note("began")
    assert again.days() == [date(2026, 3, 3), date(2026, 3, 2)]
    assert whats(again.events()) == ["left", "began"]
    came, said = again.events(date(2026, 3, 2))
    assert came == (MONDAY, "王小明", "came", "") and (said.by, said.text[:6]) == ("teacher", "两行\n第二行")
    assert again.events(date(2026, 3, 1)) == []


@pytest.mark.skipif(sys.platform == "win32", reason="files have no modes there")
def test_nobody_else_can_read_it(tmp_path: Path) -> None:
    of(tmp_path, Clock()).note("began")
    (file,) = (tmp_path / "log").iterdir()
    assert [stat.S_IMODE(path.stat().st_mode) for path in (file, file.parent)] == [0o600, 0o700]


def test_at_whatever_byte_writing_was_cut_whole_lines_stay_and_the_next_event_is_one(tmp_path: Path) -> None:
    clock = Clock()
    made = of(tmp_path, clock)
    for text in ("a", "b" * 900):
        made.note("said", "anna", text)
    (file,) = (tmp_path / "log").iterdir()
    whole = file.read_bytes()
    first = whole.index(b"\n") + 1
    for cut in (0, 1, first - 1, first, first + 1, len(whole) - 1, len(whole)):
        file.write_bytes(whole[:cut])
        again = of(tmp_path, clock)
        kept = whole[:cut].count(b"\n")
        assert len(again.events()) == kept
        again.note("began")
        assert whats(again.events()) == ["said"] * kept + ["began"]


def test_lines_that_are_none_of_ours_are_passed_over(tmp_path: Path) -> None:
    clock = Clock()
    made = of(tmp_path, clock)
    made.note("came", "anna")
    (file,) = (tmp_path / "log").iterdir()
    strange = [
        *(b"[]", b"{}", b"\xff\xfe", b"[" * 50_000, b"1" * 9000, b'{"time": 1e300, "name": "a", "what": "came"}'),
        *(b'{"time": "x", "name": "a", "what": "came"}', b'{"time": NaN, "name": "a", "what": "came"}'),
        b'{"time": 1.0, "name": "a", "what": "of a newer version"}',
    ]
    file.write_bytes(b"\n".join([*strange, file.read_bytes()]))
    made.note("left", "anna")
    assert whats(made.events()) == ["came", "left"]
    for name in ("notes.txt", "2026-13-01.jsonl", "2026-02-30.jsonl", "x.jsonl"):
        (tmp_path / "log" / name).write_text("")
    assert made.days() == [date(2026, 3, 2)]


def test_a_full_disk_is_told_once_and_what_it_did_not_take_is_written_later(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(path: Path, data: bytes) -> None:
        raise OSError(errno.ENOSPC, "No space left on device", str(path))

    clock, told = Clock(), list[OSError]()
    made = of(tmp_path, clock, told)
    made.note("began")
    with monkeypatch.context() as patched:
        patched.setattr(journal, "append_private", full)
        made.note("came", "anna")
        made.note("said", text="go on")
        assert len(told) == 1 and whats(made.events()) == ["began", "came", "said"]
    made.note("left", "anna")
    assert len(told) == 1 and whats(of(tmp_path, clock).events()) == ["began", "came", "said", "left"]


def test_who_flaps_fills_no_disk_and_hides_nobody_elses_events(tmp_path: Path) -> None:
    clock = Clock()
    made = of(tmp_path, clock)
    for _ in range(BURST * 5):
        made.note("hand", "mallory")
    made.note("step", "anna", "day1 2/7")
    made.note("said", "mallory", "stop")
    clock.now += SECONDS_EACH
    made.note("step", "mallory", "day1 3/7")
    events = made.events()
    assert whats(events[BURST:]) == ["step", "said", "left_out", "step"]
    assert events[-2] == (clock.now, "mallory", "left_out", str(BURST * 4)) and events[-2].by == "server"


def test_a_day_has_a_largest_size_of_which_pupils_cannot_take_all(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(journal, "LARGEST", 4000)
    monkeypatch.setattr(journal, "BURST", 10_000)
    made = of(tmp_path, Clock())
    for number in range(100):
        made.note("error", f"pupil {number}", "x" * 200)
    made.note("said", text="we go on")
    assert whats(made.events())[-1] == "said"
    for _ in range(100):
        made.note("said", text="x" * 1000)
    (file,) = (tmp_path / "log").iterdir()
    assert 4000 <= file.stat().st_size < 4000 + 1200 and LARGEST > 4000


def test_every_kind_is_somebodys_and_the_orders_are_real_ones() -> None:
    assert all(kind.by in ("pupil", "teacher", "server") and all(kind.text) for kind in KINDS.values())
    assert set(OF_ORDER) <= set(ORDERS)
    for language in (0, 1):
        texts = [kind.text[language] for kind in KINDS.values()]
        assert len(set(texts)) == len(texts)
