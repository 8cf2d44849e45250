"""Sessions of our engine: who sees whom, who gets what, and what a stranger can do."""

from __future__ import annotations

import os
import random
import socket
from pathlib import Path

import pytest

from day6_core.link.local import CancellationToken, Config, Session, ZError
from day6_core.link.local.frames import VERSION, Kind, packed
from day6_core.link.paths import password
from tests.link.local.sessions import KEY, Heard, Sessions, publisher
from tests.support.waiting import until

FOREVER = 1e9


def test_everybody_sees_the_tokens_of_all_others_as_long_as_they_live(sessions: Sessions) -> None:
    first = sessions.one()
    heard = Heard()
    early = first.liveliness().declare_token("t/early")
    first.liveliness().declare_subscriber("t/**", heard.handler, history=True)
    second = sessions.one()
    second.liveliness().declare_token("t/late")
    second.liveliness().declare_token("elsewhere/late")
    seen = Heard()
    second.liveliness().declare_subscriber("t/**", seen.handler, history=True)
    assert until(lambda: heard.tokens == [("t/late", "put")] and seen.tokens == [("t/early", "put")])
    early.undeclare()
    assert until(lambda: seen.tokens[1:] == [("t/early", "delete")])
    second.close()
    assert until(lambda: heard.tokens[1:] == [("t/late", "delete")])


def test_tokens_can_be_read_at_any_time(sessions: Sessions) -> None:
    first, second = sessions.one(), sessions.one()
    watched, read = Heard(), Heard()
    first.liveliness().declare_subscriber("t/**", watched.handler, history=True)
    second.liveliness().declare_token("t/there")
    assert until(lambda: watched)
    first.liveliness().get("t/**", read.handler, timeout=1.0)
    assert until(lambda: read.ended)
    assert [each.ok.key_expr for each in read] == ["t/there"]


@pytest.mark.parametrize("order", ["ab", "ba"])
def test_of_two_that_start_at_once_each_has_one_connection(
    sessions: Sessions, order: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    import day6_core.link.local.mesh as mesh

    made: list[Session] = []
    connect = mesh.connect

    def connect_late(config: Config) -> object:  # the second one begins while the first is about to look around
        monkeypatch.setattr(mesh, "connect", connect)
        made.append(sessions.one(order[1]))
        return connect(config)

    monkeypatch.setattr(mesh, "connect", connect_late)
    first = sessions.one(order[0])
    assert until(lambda: made)
    second = made[0]
    heard, seen = Heard(), Heard()
    first.liveliness().declare_subscriber("t/**", heard.handler, history=True)
    second.liveliness().declare_subscriber("t/**", seen.handler, history=True)
    first.liveliness().declare_token("t/first")
    second.liveliness().declare_token("t/second")
    assert until(lambda: heard.tokens == [("t/second", "put")] and seen.tokens == [("t/first", "put")])
    assert until(lambda: len(first._mesh.connections) == len(second._mesh.connections) == 1)


def test_a_message_reaches_every_subscriber_elsewhere_once(sessions: Sessions) -> None:
    talker, listener = sessions.one(), sessions.one()
    one, other, own = Heard(), Heard(), Heard()
    listener.declare_subscriber(KEY, one.handler)
    taken_back = listener.declare_subscriber(KEY, other.handler)
    talker.declare_subscriber(KEY, own.handler)
    sender = publisher(talker)
    assert until(lambda: sender.matching_status.matching)
    sender.put(b"1", attachment=b"who")
    assert until(lambda: one.texts == other.texts == [b"1"])
    assert one[0].attachment.to_bytes() == b"who" and one[0].key_expr == KEY
    taken_back.undeclare()
    sender.put(bytes(3_000_000), attachment=b"who")
    assert until(lambda: len(one) == 2)
    sender.put(b"2", attachment=b"who")
    assert until(lambda: one.texts[2:] == [b"2"])
    assert one.texts[1] == bytes(3_000_000) and other.texts == [b"1"] and own.texts == []


def test_what_a_publisher_kept_is_sent_once_to_each_who_asks_for_it(sessions: Sessions) -> None:
    talker = sessions.one()
    sender = publisher(talker, keeps=3)
    for number in range(5):
        sender.put(b"%d" % number, attachment=b"who")
    listener = sessions.one()
    everything, last, nothing = Heard(), Heard(), Heard()
    listener.declare_subscriber(KEY, nothing.handler)
    listener.declare_subscriber(KEY, everything.handler, wants=10)
    listener.declare_subscriber(KEY, last.handler, wants=1)
    assert until(lambda: last.texts)
    sender.put(b"new", attachment=b"who")
    assert until(lambda: last.texts == [b"4", b"new"])
    assert everything.texts == [b"2", b"3", b"4", b"new"] and nothing.texts == [b"new"]
    sender.undeclare()
    later = Heard()
    listener.declare_subscriber(KEY, later.handler, wants=10)
    listener.liveliness().declare_token("t/after")
    seen = Heard()
    talker.liveliness().declare_subscriber("t/after", seen.handler, history=True)
    assert until(lambda: seen)
    assert later.texts == []


def test_a_question_ends_when_all_have_answered_or_are_gone(sessions: Sessions) -> None:
    asking, answering, dying = sessions.one(), sessions.one(), sessions.one()
    asked, held = Heard(), Heard()
    answering.declare_queryable("q/one", asked.handler)
    dying.declare_queryable("q/two", held.handler)
    assert until(lambda: len(asking._others.to_all(Kind.QUERYABLE, "q/*")) == 2)
    answers = Heard()
    asking.get("q/*", answers.handler, payload=b"?", attachment=b"who", timeout=FOREVER)
    assert until(lambda: asked and held)
    with asked[0] as query:
        assert (query.payload.to_bytes(), query.attachment.to_bytes()) == (b"?", b"who")
        query.reply("q/one", b"!", attachment=b"me")
    assert until(lambda: answers)
    assert answers[0].ok.payload.to_bytes() == b"!" and answers[0].ok.attachment.to_bytes() == b"me"
    assert not answers.ended, "one answer is missing"
    dying.close()
    assert until(lambda: answers.ended)


def test_a_question_ends_without_anybody_and_when_it_is_taken_back_or_takes_too_long(sessions: Sessions) -> None:
    asking, silent = sessions.one(), sessions.one()
    nobody, cancelled, late = Heard(), Heard(), Heard()
    asking.get("q/none", nobody.handler, timeout=FOREVER)
    assert until(lambda: nobody.ended)
    silent.declare_queryable("q/one", Heard().handler)
    assert until(lambda: asking._others.to(Kind.QUERYABLE, "q/one"))
    token = CancellationToken()
    asking.get("q/one", cancelled.handler, timeout=FOREVER, cancellation_token=token)
    asking.get("q/one", late.handler, timeout=0.01)
    assert until(lambda: late.ended)
    assert not cancelled.ended
    token.cancel()
    assert until(lambda: cancelled.ended)
    assert not token.open and not asking._asked


def test_after_closing_nothing_is_left_and_nothing_can_be_declared(sessions: Sessions) -> None:
    session = sessions.one()
    sender = publisher(session)
    assert len(list(sessions.place.folder.glob("p-*"))) == 1
    session.close()
    session.close()
    for call in (
        lambda: sender.put(b"", attachment=b"x"),
        lambda: session.declare_subscriber(KEY, Heard().handler),
        lambda: session.liveliness().declare_token("t"),
        lambda: session.get("q", Heard().handler, timeout=1.0),
    ):
        with pytest.raises(ZError):
            call()
    assert sessions.place.tcp or not list(sessions.place.folder.glob("p-*"))


def stranger(sessions: Sessions) -> socket.socket:
    """Connect to the first session as any program may that knows where it is."""
    (path,) = sessions.place.folder.glob("p-a-*")
    if sessions.place.tcp:
        return socket.create_connection(("127.0.0.1", int(path.read_text(encoding="ascii"))))
    made = socket.socket(socket.AF_UNIX)
    made.connect(os.fspath(path))
    return made


def answer_to(sessions: Sessions, *frames: bytes) -> bytes:
    """Send frames as a stranger; returns what comes until the connection is closed."""
    with stranger(sessions) as end:
        end.settimeout(20.0)
        for frame in frames:
            end.sendall(frame)
        received = b""
        try:
            while piece := end.recv(65536):
                received += piece
        except ConnectionError:
            pass
        return received


HELLO = packed(Kind.HELLO, VERSION, b"stranger", bytes(16))


def test_without_the_password_nobody_hears_or_says_anything(short_folder: Path) -> None:
    sessions = Sessions(short_folder / "0", tcp=True)
    try:
        session = sessions.one()
        session.liveliness().declare_token("t/secret")
        heard = Heard()
        session.liveliness().declare_subscriber("t/**", heard.handler, history=True)
        forged = packed(Kind.PROOF, 0, attachment=bytes(32)), packed(Kind.TOKEN, 1, b"t/forged", payload=bytes(4))
        for frames in ((HELLO, *forged), forged, (HELLO, forged[1])):
            answer = answer_to(sessions, *frames)
            assert b"t/secret" not in answer and password(sessions.place).encode() not in answer
        friend = sessions.one()
        friend.liveliness().declare_token("t/friend")
        assert until(lambda: heard.tokens == [("t/friend", "put")])
    finally:
        sessions.close()


BAD = (
    packed(Kind.TOKEN, 0, b"t/x", payload=bytes(4)),
    packed(Kind.TOKEN, 2, b"t/x", payload=b""),
    packed(Kind.TOKEN, 2, b"t/x", payload=bytes(4)) * 2,
    packed(Kind.UNDECLARE, 77),
    packed(Kind.HELLO, VERSION, b"stranger", bytes(16)),
    b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n",
)


def test_a_malformed_frame_closes_its_connection_and_no_other(short_folder: Path) -> None:
    sessions = Sessions(short_folder / "0")
    try:
        session, friend = sessions.one(), sessions.one()
        heard = Heard()
        session.declare_subscriber(KEY, heard.handler)
        sender = publisher(friend)
        assert until(lambda: sender.matching_status.matching)
        for number, bad in enumerate(BAD):
            answer_to(sessions, HELLO, bad)
            sender.put(b"%d" % number, attachment=b"x")
            assert until(lambda number=number: len(heard) == number + 1)
        assert until(lambda: len(session._mesh.connections) == 1)
        assert session._others.tokens() == []
    finally:
        sessions.close()


def test_random_frames_from_one_process_disturb_no_other(short_folder: Path) -> None:
    random_ = random.Random(7)
    sessions = Sessions(short_folder / "0")
    try:
        session, friend = sessions.one(), sessions.one()
        heard, asked = Heard(), Heard()
        session.declare_subscriber(KEY, heard.handler)
        session.declare_queryable("q/one", asked.handler)
        sender = publisher(friend)
        assert until(lambda: sender.matching_status.matching)
        keys = (KEY.encode(), b"q/one", b"q/*", b"**", b"", "五".encode())
        for _ in range(200):
            frames = [HELLO]
            for _ in range(random_.randint(1, 12)):
                kind, number = random_.choice(list(Kind)[2:]), random_.choice((0, 1, 2, 2**64 - 1))
                payload = random_.choice((bytes(4), b"", random_.randbytes(20)))
                frame = packed(kind, number, random_.choice(keys), random_.randbytes(random_.choice((0, 33))), payload)
                if random_.random() < 0.2:
                    frame = frame[: random_.randrange(len(frame))]
                frames.append(frame)
            with stranger(sessions) as end:
                end.sendall(b"".join(frames))
        sender.put(b"end", attachment=b"x")
        assert until(lambda: b"end" in heard.texts)
        assert until(lambda: len(session._mesh.connections) == 1)
        assert session._others.tokens() == []
    finally:
        sessions.close()
