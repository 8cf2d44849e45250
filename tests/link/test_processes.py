"""Processes that come, die and fork: who sees whom, and how soon."""

from __future__ import annotations

import os
import signal
import subprocess
import sys

import pytest

from tests.link.link_harness import HOUR_OF_LEASE, World
from tests.support.waiting import communicate, run, until

needs_kill = pytest.mark.skipif(sys.platform == "win32", reason="no SIGKILL")


@pytest.fixture(params=["on", "local"], ids=["Zenoh", "our engine"])
def any_engine(request: pytest.FixtureRequest, world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    """What is tested holds for either engine."""
    monkeypatch.setenv("DAY6_LINK", request.param)


def sockets(world: World, domain: str = "0") -> list[str]:
    return sorted(path.name for path in (world.runtime / domain).iterdir() if path.name.startswith("p-"))


def run_python(world: World, source: str, **environment: str) -> subprocess.CompletedProcess[str]:
    """Run a student's program to its end."""
    settings = {
        "DAY6_RUNTIME_DIR": str(world.runtime),
        "DAY6_LINK": os.environ["DAY6_LINK"],
        "PYTHONPATH": os.pathsep.join(sys.path),
    }
    return run([sys.executable, "-c", source], env={**os.environ, **settings, **environment})


@pytest.mark.process
@needs_kill
@pytest.mark.usefixtures("hour_of_lease")
@pytest.mark.usefixtures("any_engine")
def test_a_killed_process_is_gone_at_once(world: World) -> None:
    stays, victim = world.here(), world.process()
    node = victim.node("victim")
    victim.publisher(node, "/chatter")
    victim.service(node, "/add")
    assert until(lambda: stays.endpoints("/add") and stays.endpoints("/chatter"))
    victim.kill()
    assert until(lambda: stays.nodes() == [])
    assert stays.endpoints("/chatter") == stays.endpoints("/add") == []


@pytest.mark.process
@needs_kill
@pytest.mark.usefixtures("hour_of_lease")
def test_when_the_keeper_of_the_meeting_point_is_killed_the_others_go_on(world: World) -> None:
    keeper = world.process()
    keeper.node("keeper")
    talker, listener = world.process(), world.process()
    publisher = talker.publisher(talker.node("talker"), "/chatter", depth=100)
    subscription = listener.subscription(listener.node("listener"), "/chatter", depth=100)
    assert until(lambda: talker.matched(publisher) == 1 and listener.matched(subscription) == 1)
    assert keeper.keeps_meeting_point() and not talker.keeps_meeting_point()
    assert until(lambda: talker.nodes() == listener.nodes() == ["/keeper", "/listener", "/talker"])
    keeper.kill()
    talker.publish_numbers(publisher, 0, 50)
    assert until(lambda: talker.nodes() == listener.nodes() == ["/listener", "/talker"])
    assert until(lambda: listener.length(subscription) == 50)
    assert listener.messages(subscription) == [str(number) for number in range(50)]
    assert until(lambda: talker.keeps_meeting_point() or listener.keeps_meeting_point())

    newcomer = world.process()
    newcomer.node("newcomer")
    everybody = ["/listener", "/newcomer", "/talker"]
    assert until(lambda: talker.nodes() == listener.nodes() == newcomer.nodes() == everybody)


@pytest.mark.process
@needs_kill
@pytest.mark.parametrize("oldest_first", [True, False])
def test_without_zenoh_nobody_is_needed_by_the_others(
    world: World, monkeypatch: pytest.MonkeyPatch, oldest_first: bool
) -> None:
    monkeypatch.setenv("DAY6_LINK", "local")
    peers = {f"/n{number}": world.process() for number in range(4)}
    for name, peer in peers.items():
        peer.node(name[1:])
    while len(peers) > 1:
        assert until(lambda: all(peer.nodes() == sorted(peers) for peer in peers.values()))
        peers.pop(min(peers) if oldest_first else max(peers)).kill()
    newcomer = peers["/new"] = world.process()
    newcomer.node("new")
    assert until(lambda: all(peer.nodes() == sorted(peers) for peer in peers.values()))
    assert len(sockets(world, "local/0")) == 2, "those of killed processes were cleared away"


@pytest.mark.process
@needs_kill
@pytest.mark.usefixtures("hour_of_lease")
def test_keepers_may_die_one_after_another(world: World) -> None:
    peers = {f"/n{number}": world.process() for number in range(4)}
    for name, peer in peers.items():
        peer.node(name[1:])
    while len(peers) > 1:
        assert until(lambda: all(peer.nodes() == sorted(peers) for peer in peers.values()))
        (keeper,) = until(lambda: [name for name, peer in peers.items() if peer.keeps_meeting_point()])
        peers.pop(keeper).kill()
    assert until(lambda: all(peer.nodes() == sorted(peers) for peer in peers.values()))


@pytest.mark.process
def test_a_process_that_ends_leaves_nothing_behind(world: World) -> None:
    keeper = world.here()
    leaver = world.process()
    leaver.node("leaver")
    assert until(lambda: keeper.nodes() == ["/leaver"])
    assert len(sockets(world)) == 4
    assert leaver.end() == 0
    assert until(lambda: keeper.nodes() == [])
    assert len(sockets(world)) == 2
    assert world.stderr.read_text(encoding="utf-8") == ""


@pytest.mark.process
def test_a_program_that_is_done_with_ros_still_lets_the_others_find_each_other(world: World) -> None:
    keeper = world.process()
    keeper.node("keeper")
    assert keeper.keeps_meeting_point()
    one = world.process()
    one.node("one")
    assert until(lambda: one.nodes() == ["/keeper", "/one"])
    keeper.leave(ending=True)
    other = world.process()
    other.node("other")
    assert until(lambda: one.nodes() == other.nodes() == ["/one", "/other"])
    assert not one.keeps_meeting_point() and not other.keeps_meeting_point()
    assert keeper.end() == 0
    assert until(lambda: one.keeps_meeting_point() or other.keeps_meeting_point())
    assert until(lambda: one.nodes() == other.nodes() == ["/one", "/other"])
    assert world.stderr.read_text(encoding="utf-8") == ""


@pytest.mark.process
@needs_kill
def test_the_next_process_clears_away_the_sockets_of_killed_ones(world: World) -> None:
    victims = [world.process() for _ in range(3)]
    for victim in victims:
        victim.kill()
    assert len(sockets(world)) == 6
    world.here()
    assert len(sockets(world)) == 2


@pytest.mark.process
@pytest.mark.usefixtures("any_engine")
def test_three_processes_hear_each_message_once(world: World) -> None:
    peers = [world.here(), world.process(), world.process()]
    publishers, subscriptions = [], []
    for number, peer in enumerate(peers):
        node = peer.node(f"n{number}")
        publishers.append(peer.publisher(node, "/chatter", depth=100))
        subscriptions.append(peer.subscription(node, "/chatter", depth=100))
    assert until(
        lambda: all(
            peer.matched(publisher) == peer.matched(subscription) == 3
            for peer, publisher, subscription in zip(peers, publishers, subscriptions, strict=True)
        )
    )
    for number, (peer, publisher) in enumerate(zip(peers, publishers, strict=True)):
        peer.publish_numbers(publisher, 100 * number, 10)
    wanted = sorted(str(100 * number + count) for number in range(3) for count in range(10))
    for peer, subscription in zip(peers, subscriptions, strict=True):
        assert until(lambda peer=peer, subscription=subscription: peer.length(subscription) >= 30)
        assert sorted(peer.messages(subscription)) == wanted
    assert all(peer.nodes() == ["/n0", "/n1", "/n2"] for peer in peers)


@pytest.mark.process
@pytest.mark.usefixtures("any_engine")
def test_two_domains_never_meet(world: World) -> None:
    zero, seven = world.here(), world.process(ROS_DOMAIN_ID="7")
    publisher = zero.publisher(zero.node("zero"), "/chatter")
    subscription = seven.subscription(seven.node("seven"), "/chatter")
    also_zero = world.process()
    heard = also_zero.subscription(also_zero.node("also_zero"), "/chatter")
    assert until(lambda: zero.matched(publisher) == 1)
    zero.publish(publisher, data="for domain 0")
    assert until(lambda: also_zero.length(heard) == 1)
    assert seven.nodes() == ["/seven"]
    assert seven.matched(subscription) == 0
    assert zero.nodes() == ["/also_zero", "/zero"]


@pytest.mark.process
@pytest.mark.usefixtures("any_engine")
def test_a_one_shot_command_sees_every_node_of_the_machine_before_it_answers(world: World) -> None:
    peers = [world.process() for _ in range(4)]
    for number, peer in enumerate(peers):
        for letter in "abc":
            peer.publisher(peer.node(f"{letter}{number}"), f"/topic_{letter}{number}")
    source = """
from day6_core.graph import Graph
from day6_core.link import join
graph = Graph()
link = join(graph, one_shot=True)
print(link.wait_settled(60.0), sorted(node.name for node in graph.nodes), len(graph.endpoints(*__import__(
    "day6_core.graph", fromlist=["EndpointKind"]).EndpointKind)))
"""
    names = sorted(f"{letter}{number}" for letter in "abc" for number in range(4))
    for _ in range(3):
        done = run_python(world, source)
        assert (done.stdout, done.stderr) == (f"True {names} 12\n", "")


@pytest.mark.skipif(sys.platform == "win32", reason="without Unix sockets a command has to ask the port")
def test_a_one_shot_command_alone_answers_at_once(world: World) -> None:
    from day6_core.graph import Graph
    from day6_core.link import join, leave

    graph = Graph()
    link = join(graph, one_shot=True)
    assert link.wait_settled(0.0), "there was nothing to wait for"
    leave(graph)


@pytest.mark.process
@pytest.mark.usefixtures("any_engine")
def test_a_one_shot_command_that_waits_finds_a_process_that_starts_later(world: World) -> None:
    command = world.here(one_shot=True)
    client = command.client(command.node("asker"), "/add")
    server = world.process()
    server.service(server.node("server"), "/add")
    assert until(lambda: command.matched(client))
    number = command.call(client, 20, 22)
    assert until(lambda: command.responses(client)) == [[number, 42]]


@pytest.mark.process
@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
@pytest.mark.parametrize("way_out", ["os._exit(0)", "sys.exit(0)", "raise SystemExit"])
@pytest.mark.usefixtures("any_engine")
def test_a_program_that_forks_goes_on_and_its_child_ends(world: World, way_out: str) -> None:
    keeper = world.here()
    source = f"""
import os, sys
from day6_core.graph import Graph, QoS
from day6_core.interfaces import copy_message, get_message, type_hash
from day6_core.link import join
graph = Graph()
link = join(graph)
String = get_message("std_msgs/msg/String")
node = graph.create_node("parent")
publisher = node.create_publisher("/chatter", "std_msgs/msg/String", type_hash(String), QoS(), copy_message)
link.wait_settled(5.0)
child = os.fork()
if child == 0:
    publisher.publish(String(data="from the child: goes nowhere"))
    graph.create_node("child")
    print(join(graph).problem, flush=True)
    {way_out}
_, status = os.waitpid(child, 0)
print("child", os.waitstatus_to_exitcode(status), flush=True)
sys.stdin.readline()
"""
    settings = {
        "DAY6_RUNTIME_DIR": str(world.runtime),
        "DAY6_LINK": os.environ["DAY6_LINK"],
        "PYTHONPATH": os.pathsep.join(sys.path),
    }
    with subprocess.Popen(
        [sys.executable, "-c", source],
        env={**os.environ, **settings},
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        encoding="utf-8",
    ) as program:
        assert program.stdout is not None
        assert program.stdout.readline() == "this process was forked from one that had joined already\n"
        assert program.stdout.readline() == "child 0\n"
        assert until(lambda: keeper.nodes() == ["/parent"])
        communicate(program, "\n")
        assert program.returncode == 0
    assert until(lambda: keeper.nodes() == [])


@pytest.mark.process
@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
@pytest.mark.usefixtures("hour_of_lease")
@pytest.mark.usefixtures("any_engine")
def test_a_killed_program_is_gone_although_its_forked_child_lives(world: World) -> None:
    keeper = world.here()
    source = f"""{HOUR_OF_LEASE}
import os, time
from day6_core.graph import Graph
from day6_core.link import join
graph = Graph()
link = join(graph)
graph.create_node("parent")
link.wait_settled(5.0)
os.write(1, f"{{os.fork()}}\\n".encode())  # two processes, each line in one piece
time.sleep(3600)
"""
    settings = {
        "DAY6_RUNTIME_DIR": str(world.runtime),
        "DAY6_LINK": os.environ["DAY6_LINK"],
        "PYTHONPATH": os.pathsep.join(sys.path),
    }
    with subprocess.Popen(
        [sys.executable, "-c", source],
        env={**os.environ, **settings},
        stdout=subprocess.PIPE,
        text=True,
        encoding="utf-8",
    ) as program:
        assert program.stdout is not None
        child = max(int(program.stdout.readline()), int(program.stdout.readline()))
        try:
            assert until(lambda: keeper.nodes() == ["/parent"])
            program.kill()
            assert until(lambda: keeper.nodes() == [])
        finally:
            os.kill(child, signal.SIGKILL)


@pytest.mark.process
def test_the_engine_never_writes_to_the_students_terminal(world: World) -> None:
    source = """
from day6_core.graph import Graph
from day6_core.link import join
graph = Graph()
link = join(graph)
graph.create_node("quiet")
link.wait_settled(2.0)
"""
    done = run_python(world, source, RUST_LOG="trace", ZENOH_LOG="trace")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


@pytest.mark.process
@pytest.mark.parametrize("ending", ["", "raise KeyboardInterrupt", "import sys; sys.exit(3)", "1/0"])
@pytest.mark.usefixtures("any_engine")
def test_a_program_ends_as_python_ends_it_and_its_last_words_arrive(world: World, ending: str) -> None:
    keeper = world.here()
    subscription = keeper.subscription(keeper.node("listener"), "/chatter", depth=1000, latched=True)
    source = f"""
import time
from day6_core.graph import Graph, QoS
from day6_core.graph.qos import Durability
from day6_core.interfaces import copy_message, get_message, type_hash
from day6_core.link import join
graph = Graph()
join(graph)
String = get_message("std_msgs/msg/String")
node = graph.create_node("parent")
publisher = node.create_publisher(
    "/chatter", "std_msgs/msg/String", type_hash(String), QoS(durability=Durability.TRANSIENT_LOCAL), copy_message)
while not publisher.remote_matched:
    time.sleep(0.001)
for number in range(500):
    publisher.publish(String(data=str(number)))
{ending}
"""
    plain = run_python(world, ending, DAY6_LINK="off")
    done = run_python(world, source)
    assert done.returncode == plain.returncode
    assert done.stderr.splitlines()[-1:] == plain.stderr.splitlines()[-1:]
    assert until(lambda: keeper.length(subscription) == 500)
    assert keeper.messages(subscription)[-1] == "499"


@pytest.mark.process
def test_importing_the_link_costs_nothing_and_nothing_heavy_comes_with_joining(world: World) -> None:
    source = """
import sys
before = set(sys.modules)
import day6_core.link
new = set(sys.modules) - before
ours = [name for name in new if name.startswith("day6_tui")]
print(sorted(name for name in new if name.split(".")[0] in ("zenoh", "json", "socket")), len(ours) < 20)
from day6_core.graph import Graph
day6_core.link.join(Graph())
print("zenoh" in sys.modules, sorted({"numpy", "asyncio", "yaml", "textual", "rich"} & set(sys.modules)))
"""
    done = run_python(world, source)
    assert (done.stdout, done.stderr) == ("[] True\nTrue []\n", "")
