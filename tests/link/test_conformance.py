"""What holds for two participants however far apart they are: in one graph, in one process, in two processes."""

from __future__ import annotations

from typing import Any

import pytest

from tests.support.waiting import until

Pair = tuple[Any, Any]


def acquaint(near: Any, far: Any) -> None:
    """Have both know the way to each other, and what the other listens to.

    Until then Zenoh sends everything everywhere: a message would be on its way to one who begins to listen later.
    """
    for one, other in ((near, far), (far, near)):
        publisher = one.publisher(one.node("guide"), "/acquainted")
        subscription = other.subscription(other.node("guest"), "/acquainted")
        assert until(lambda one=one, publisher=publisher: one.matched(publisher))
        until(
            lambda other=other, subscription=subscription: other.length(subscription),
            meanwhile=lambda one=one, publisher=publisher: one.publish(publisher, data="hello"),
        )


def talker_and_listener(pair: Pair, **settings: Any) -> tuple[int, int]:
    """A publisher at the first, a subscription at the second, matched."""
    near, far = pair
    publisher = near.publisher(near.node("talker"), "/chatter", **settings)
    subscription = far.subscription(far.node("listener"), "/chatter", **settings)
    assert until(lambda: near.matched(publisher) == 1 and far.matched(subscription) == 1)
    return publisher, subscription


def all_messages(peer: Any, subscription: int, count: int) -> list[str]:
    """Poll until `count` messages have come, then return them with what came too much."""
    until(lambda: peer.length(subscription) >= count)
    return list(peer.messages(subscription))


@pytest.mark.parametrize("turned", [False, True], ids=["forth", "back"])
def test_what_is_published_arrives_in_order_and_once(pair: Pair, turned: bool) -> None:
    near, far = reversed(pair) if turned else pair
    publisher, subscription = talker_and_listener((near, far))
    near.publish_numbers(publisher, 0, 8)
    assert all_messages(far, subscription, 8) == [str(number) for number in range(8)]
    near.publish(publisher, data="after them")
    assert all_messages(far, subscription, 1) == ["after them"]


@pytest.mark.parametrize("settings", [{}, {"best_effort": True}, {"latched": True}, {"keep_all": True}])
def test_every_profile_carries_messages(pair: Pair, settings: dict[str, Any]) -> None:
    publisher, subscription = talker_and_listener(pair, **settings)
    near, far = pair
    near.publish(publisher, data="你好")
    assert all_messages(far, subscription, 1) == ["你好"]


def test_a_message_says_who_sent_it_and_when(pair: Pair) -> None:
    near, far = pair
    publisher, subscription = talker_and_listener(pair)
    near.publish_numbers(publisher, 0, 2)
    assert until(lambda: far.length(subscription) == 2)
    first, second = far.samples(subscription)
    assert (first["number"], second["number"]) == (1, 2)
    assert first["gid"] == second["gid"] == near.gid(publisher)
    assert len(bytes.fromhex(first["gid"])) == 16
    assert 0 < first["source"] <= second["source"]
    assert first["intra"] is (near is far)


def test_a_long_message_arrives_whole(pair: Pair) -> None:
    near, far = pair
    publisher, subscription = talker_and_listener(pair)
    text = "0123456789" * 300_000
    near.publish(publisher, data=text)
    assert all_messages(far, subscription, 1) == [text]


def test_a_full_queue_drops_its_oldest(pair: Pair) -> None:
    near, far = pair
    publisher = near.publisher(near.node("talker"), "/chatter", keep_all=True)
    node = far.node("listener")
    subscription, everything = far.subscription(node, "/chatter", depth=3), far.subscription(node, "/chatter", depth=50)
    assert until(lambda: near.matched(publisher) == 2)
    near.publish_numbers(publisher, 0, 20)
    assert until(lambda: far.length(everything) == 20)
    assert far.messages(subscription) == ["17", "18", "19"]


def test_who_asks_for_reliable_gets_nothing_from_best_effort_and_both_are_told(pair: Pair) -> None:
    near, far = pair
    publisher = near.publisher(near.node("talker"), "/chatter", best_effort=True)
    node = far.node("listener")
    reliable, willing = far.subscription(node, "/chatter"), far.subscription(node, "/chatter", best_effort=True)
    assert until(lambda: near.matched(publisher) == 1 and far.matched(willing) == 1)
    near.publish(publisher, data="x")
    assert all_messages(far, willing, 1) == ["x"]
    assert far.messages(reliable) == []
    assert far.matched(reliable) == 0
    assert until(lambda: near.incompatible(publisher) == 1 and far.incompatible(reliable) == 1)


def test_late_joiners_get_what_a_latched_publisher_keeps_and_volatile_ones_do_not(pair: Pair) -> None:
    near, far = pair
    acquaint(near, far)
    publisher = near.publisher(near.node("describer"), "/robot_description", latched=True, depth=2)
    near.publish_numbers(publisher, 0, 5)
    node = far.node("viewer")
    first = far.subscription(node, "/robot_description", latched=True)
    assert all_messages(far, first, 2) == ["3", "4"]
    volatile = far.subscription(node, "/robot_description")
    second = far.subscription(node, "/robot_description", latched=True)
    only_last = far.subscription(node, "/robot_description", latched=True, depth=1)
    assert all_messages(far, second, 2) == ["3", "4"]
    assert all_messages(far, only_last, 1) == ["4"]
    assert until(lambda: near.matched(publisher) == 4)
    near.publish(publisher, data="live")
    for subscription in (volatile, first, second, only_last):
        assert all_messages(far, subscription, 1) == ["live"]


def test_a_latched_subscription_gets_what_a_publisher_that_comes_later_said_first(pair: Pair) -> None:
    near, far = pair
    subscription = far.subscription(far.node("viewer"), "/robot_description", latched=True)
    publisher = near.publisher(near.node("describer"), "/robot_description", latched=True, depth=1)
    near.publish(publisher, data="<robot/>")
    assert all_messages(far, subscription, 1) == ["<robot/>"]
    assert far.messages(subscription) == []


def test_two_latched_publishers_are_both_heard(pair: Pair) -> None:
    near, far = pair
    node = near.node("statics")
    for text in ("a", "b"):
        near.publish(near.publisher(node, "/tf_static", latched=True, depth=1), data=text)
    subscription = far.subscription(far.node("viewer"), "/tf_static", latched=True, depth=100)
    assert sorted(all_messages(far, subscription, 2)) == ["a", "b"]


def test_a_service_answers_every_call_with_its_number(pair: Pair) -> None:
    near, far = pair
    far.service(far.node("server"), "/add")
    client = near.client(near.node("asker"), "/add")
    assert until(lambda: near.matched(client))
    numbers = [near.call(client, a, 100) for a in range(5)]
    answers: list[Any] = []
    until(lambda: (answers.extend(near.responses(client)), len(answers) == 5)[1])
    assert sorted(answers) == [[number, 100 + a] for a, number in enumerate(numbers)]


def test_two_clients_get_their_own_answers(pair: Pair) -> None:
    near, far = pair
    far.service(far.node("server"), "/add")
    clients = [near.client(near.node("one"), "/add"), near.client(near.node("two"), "/add")]
    assert until(lambda: all(near.matched(client) for client in clients))
    numbers = [near.call(client, 10 * client, 1) for client in clients]
    for client, number in zip(clients, numbers, strict=True):
        assert until(lambda client=client: near.responses(client)) == [[number, 10 * client + 1]]


def test_two_servers_both_answer_a_call(pair: Pair) -> None:
    near, far = pair
    far.service(far.node("first"), "/add")
    far.service(far.node("second"), "/add", offset=1000)
    client = near.client(near.node("asker"), "/add")
    assert until(lambda: near.matched(client) == 2)
    number = near.call(client, 1, 2)
    answers: list[Any] = []
    until(lambda: (answers.extend(near.responses(client)), len(answers) == 2)[1])
    assert sorted(answers) == [[number, 3], [number, 1003]]


def test_an_answer_may_take_its_time(pair: Pair) -> None:
    near, far = pair
    server = far.service(far.node("server"), "/add", hold=True)
    client = near.client(near.node("asker"), "/add")
    assert until(lambda: near.matched(client))
    numbers = [near.call(client, a, 0) for a in (7, 8)]
    assert until(lambda: far.holding(server) == 2)
    assert near.responses(client) == []
    assert far.answer(server) == 2
    answers: list[Any] = []
    until(lambda: (answers.extend(near.responses(client)), len(answers) == 2)[1])
    assert answers == [[numbers[0], 7], [numbers[1], 8]]


def test_a_client_that_leaves_without_its_answer_disturbs_nobody(pair: Pair) -> None:
    near, far = pair
    server = far.service(far.node("server"), "/add", hold=True)
    gone = near.client(near.node("gone"), "/add")
    stays = near.client(near.node("stays"), "/add")
    assert until(lambda: near.matched(gone) and near.matched(stays))
    near.call(gone, 1, 1)
    number = near.call(stays, 2, 2)
    assert until(lambda: far.holding(server) == 2)
    near.destroy(gone)
    assert until(lambda: far.matched(server) == 1)
    far.answer(server)
    assert until(lambda: near.responses(stays)) == [[number, 4]]
    assert far.problems() == near.problems() == []


def test_nodes_and_endpoints_are_the_same_seen_from_both_sides(pair: Pair) -> None:
    near, far = pair
    talker = near.node("talker", "/team/a")
    listener = far.node("listener")
    near.publisher(talker, "/team/chatter", latched=True, depth=3, lifespan=1_500_000_000, deadline=20)
    far.subscription(listener, "/team/chatter", best_effort=True, keep_all=True)
    far.subscription(listener, "/team/chatter", "geometry_msgs/msg/Twist")
    near.service(talker, "/team/add")
    far.client(listener, "/team/add")
    assert until(lambda: near.nodes() == far.nodes() == ["/listener", "/team/a/talker"])
    assert until(lambda: len(near.endpoints("/team/chatter")) == len(far.endpoints("/team/chatter")) == 3)
    assert near.endpoints("/team/chatter") == far.endpoints("/team/chatter")
    assert until(lambda: len(near.endpoints("/team/add")) == len(far.endpoints("/team/add")) == 2)
    assert near.endpoints("/team/add") == far.endpoints("/team/add")
    assert near.endpoints("/team/chatter")[0][:6] == [
        "MP",
        "/team/a/talker",
        "/team/chatter",
        "std_msgs/msg/String",
        "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18",
        ":1:,3:0,20:1,500000000:,,",
    ]


def test_two_nodes_of_one_name_are_two(pair: Pair) -> None:
    near, far = pair
    near.node("twin")
    far.node("twin")
    assert until(lambda: near.nodes() == far.nodes() == ["/twin", "/twin"])


def test_an_endpoint_of_a_type_nobody_here_knows_is_listed(pair: Pair) -> None:
    near, far = pair
    near.publisher(near.node("stranger"), "/things", "nowhere_msgs/msg/Thing")
    assert until(lambda: far.endpoints("/things"))
    assert far.endpoints("/things")[0][3] == "nowhere_msgs/msg/Thing"


def test_what_is_destroyed_disappears(pair: Pair) -> None:
    near, far = pair
    publisher, subscription = talker_and_listener(pair)
    far.destroy(subscription)
    assert until(lambda: near.matched(publisher) == 0)
    assert [each[0] for each in near.endpoints("/chatter")] == ["MP"]
    near.publish(publisher, data="to nobody")
    node = near.node("short")
    near.publisher(node, "/brief")
    assert until(lambda: far.endpoints("/brief"))
    near.destroy(node)
    assert until(lambda: "/short" not in far.nodes())
    assert far.endpoints("/brief") == []


def test_a_publisher_made_again_under_its_old_name_is_heard(pair: Pair) -> None:
    near, far = pair
    publisher, subscription = talker_and_listener(pair)
    near.destroy(publisher)
    assert until(lambda: far.matched(subscription) == 0)
    again = near.publisher(near.node("talker"), "/chatter")
    assert until(lambda: near.matched(again) == 1 and far.matched(subscription) == 1)
    near.publish(again, data="again")
    assert all_messages(far, subscription, 1) == ["again"]
