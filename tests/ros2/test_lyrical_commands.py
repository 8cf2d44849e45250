"""What came to the commands with Kilted and Lyrical, and that Jazzy refuses it."""

from __future__ import annotations

import pytest
from example_interfaces.srv import AddTwoInts
from geometry_msgs.msg import Point32, Polygon, Twist
from std_msgs.msg import Int32MultiArray, String

from day6_core.graph import EndpointKind
from day6_core.ros import ros2
from day6_core.ros.ros2.cli.choice import matching
from day6_core.session.program import Program
from day6_core.session.streams import Captured, TextInput


def published(machine, kind, *messages):
    """A node that publishes messages in turn, ten times a second."""

    def build(node):
        publisher = node.create_publisher(kind, "/news", 10)
        queue = list(messages)
        node.create_timer(0.1, lambda: publisher.publish(queue.pop(0) if len(queue) > 1 else queue[0]))

    return machine.node("talker", build)


# -- topic echo --------------------------------------------------------------------------------------------------------


def test_several_fields_are_printed_in_their_order(machine, in_distribution):
    in_distribution("kilted")
    twist = Twist()
    twist.linear.x, twist.angular.z = 1.5, 0.25
    published(machine, Twist, twist)
    result = machine.ros2("topic", "echo", "/news", "--once", "--field", "angular.z", "--field", "linear.x")
    assert result.stdout == "0.25\n---\n1.5\n---\n"


def test_in_jazzy_the_last_field_counts(machine):
    published(machine, Twist, Twist())
    result = machine.ros2("topic", "echo", "/news", "--once", "--field", "angular", "--field", "linear.x")
    assert result.stdout == "0.0\n---\n"


@pytest.mark.parametrize(("field", "said"), [("data[1]", "5\n---\n"), ("data[7]", ""), ("layout[0]", "")])
def test_an_entry_of_an_array_is_a_field(machine, in_distribution, field, said):
    in_distribution("kilted")
    published(machine, Int32MultiArray, Int32MultiArray(data=[4, 5]))
    result = machine.ros2("topic", "echo", "/news", "--once", "--field", field)
    assert result.stdout == said
    assert said or result.stderr.startswith(f"Invalid field '{field}': ")


def test_fields_go_on_after_an_entry(machine, in_distribution):
    in_distribution("kilted")
    shape = Polygon()
    shape.points = [Point32(x=2.0)]
    published(machine, Polygon, shape)
    assert machine.ros2("topic", "echo", "/news", "--once", "--field", "points[0].x").stdout == "2.0\n---\n"


def test_in_jazzy_an_entry_is_no_field(machine):
    published(machine, Int32MultiArray, Int32MultiArray(data=[4, 5]))
    result = machine.ros2("topic", "echo", "/news", "--once", "--field", "data[1]")
    assert result.stderr.startswith("Invalid field 'data[1]': 'Int32MultiArray' object has no attribute 'data[1]'")


# -- topic pub ---------------------------------------------------------------------------------------------------------


def test_messages_come_from_a_file_one_after_the_other(machine, in_distribution):
    in_distribution("kilted")
    (machine.cwd / "said.yaml").write_text("---\ndata: one\n---\n---\ndata: two\n---\nthree\n", encoding="utf-8")
    result = machine.ros2("topic", "pub", "/news", "std_msgs/msg/String", "--yaml-file", "said.yaml")
    assert result.stdout == (
        "publisher: beginning loop\npublishing #1: std_msgs.msg.String(data='one')\n\n"
        "publishing #2: std_msgs.msg.String(data='two')\n\n"
    )
    assert (result.stderr, result.status) == ("The contents in YAML file need to be a YAML format\n", 0)


def test_what_echo_prints_can_be_published_again(machine, in_distribution):
    in_distribution("lyrical")
    published(machine, String, String(data="hello"))
    said = machine.ros2("topic", "echo", "/news", "--once").stdout
    (machine.cwd / "said.yaml").write_text(said, encoding="utf-8")
    result = machine.ros2("topic", "pub", "/again", "std_msgs/msg/String", "--yaml-file", "said.yaml")
    assert "publishing #1: std_msgs.msg.String(data='hello')\n" in result.stdout
    assert "#2" not in result.stdout


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--yaml-file", "missing.yaml"), ": 'missing.yaml'\n"),
        (("--yaml-file", "x", "--stdin"), "not allowed with argument"),
    ],
)
def test_a_file_that_is_not_there_is_named(machine, in_distribution, words, said):
    in_distribution("kilted")
    assert said in machine.ros2("topic", "pub", "/news", "std_msgs/msg/String", *words).stderr


# -- QoS ---------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("verb", "name"), [("hz", "kilted"), ("bw", "lyrical"), ("delay", "kilted")])
def test_what_measures_listens_with_the_profile_that_is_asked_for(machine, in_distribution, verb, name):
    in_distribution(name)
    published(machine, String, String())
    command = machine.start("topic", verb, "/news", "--qos-reliability", "reliable", "--qos-depth", "3")
    machine.step(0.05)
    (info,) = machine.graph.endpoints(EndpointKind.SUBSCRIPTION, topic="/news")
    assert (info.qos.reliability.name, info.qos.depth) == ("RELIABLE", 3)
    command.interrupt()


# -- timeouts ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("service call /none std_srvs/srv/Empty --timeout 2", "Service is not available after waiting 2.0 seconds.\n"),
        (
            "action send_goal /none example_interfaces/action/Fibonacci {} --timeout 2",
            "Action server is not available after waiting 2.0 seconds.\n",
        ),
    ],
)
def test_a_server_is_not_waited_for_longer_than_allowed(machine, in_distribution, words, said):
    in_distribution("lyrical")
    result = machine.ros2(*words.split(), seconds=4)
    assert (result.stderr, result.status) == (said, 1)


def test_nor_is_a_response(machine, in_distribution):
    in_distribution("lyrical")

    async def idle(session):
        node = session.create_node("idle", cli_args=[])
        node.create_service(AddTwoInts, "add", lambda request, response: response)
        await session.sleep(1000)

    machine.program(idle)
    result = machine.ros2("service", "call", "/add", "example_interfaces/srv/AddTwoInts", "--timeout", "2", seconds=4)
    assert (result.stderr, result.status) == ("Timed out waiting for service response (timeout: 2.0s)\n", 1)
    for words in ("get /idle use_sim_time", "describe /idle use_sim_time", "set /idle use_sim_time true", "dump /idle"):
        result = machine.ros2("param", *words.split(), "--service-timeout", "1", seconds=4)
        assert "Timed out waiting for " in result.stderr and "from node /idle (timeout: 1.0s)\n" in result.stderr, words


# -- doctor ------------------------------------------------------------------------------------------------------------


def test_the_doctor_reports_actions_services_and_the_environment(machine, in_distribution):
    machine.env.update({"ROS_DOMAIN_ID": "7", "RCUTILS_COLORIZED_OUTPUT": "0", "HOME": "/h"})
    machine.node("server", lambda node: node.create_service(AddTwoInts, "add", lambda request, response: response))
    before = machine.ros2("doctor", "--report").stdout
    in_distribution("lyrical")
    after = machine.ros2("doctor", "--report").stdout
    for title in ("ACTION LIST", "ROS ENVIRONMENT", "SERVICE LIST"):
        assert f"\n   {title}\n" in after and f"\n   {title}\n" not in before
    assert "ROS environment variables        : ROS_DOMAIN_ID=7\n" in after
    assert "rcutils environment variables    : RCUTILS_COLORIZED_OUTPUT=0\n" in after
    assert "action                 : none\naction server count    : 0\naction client count    : 0\n" in after
    assert "service          : /add\nservice count    : 1\nclient count     : 0\n" in after


# -- the choice of a name ----------------------------------------------------------------------------------------------


class Typed(TextInput):
    """A terminal at which keys are typed."""

    def __init__(self, *keys: str) -> None:
        super().__init__("")
        self._keys = list(keys)

    def isatty(self) -> bool:
        return True

    async def read_key(self) -> str:
        return self._keys.pop(0) if self._keys else ""


class Screen(Captured):
    def isatty(self) -> bool:
        return True


def chosen(machine, words, *keys):
    """Run a command in a terminal at which keys are typed; what was printed below the choice, and its status."""
    session = machine.session(["ros2", *words.split()])
    session.stdin, session.stdout = Typed(*keys), Screen()
    program = Program(session, ros2.main)
    for _ in range(40):
        machine.step(0.05)
    return session.stdout.text.rpartition("\x1b[J")[2], session.stderr.text, program.status


@pytest.fixture
def busy(machine, in_distribution):
    in_distribution("lyrical")
    machine.node("talker", lambda node: node.create_publisher(String, "/chatter", 10))
    machine.node("driver", lambda node: node.create_publisher(Twist, "/turtle1/cmd_vel", 10))
    return machine


@pytest.mark.parametrize(
    ("words", "keys", "said"),
    [
        ("topic type", "cmd\r", "geometry_msgs/msg/Twist\n"),
        ("topic type", "\r", "std_msgs/msg/String\n"),
        ("topic type", "zz\x7f\x7fturtle\r", "geometry_msgs/msg/Twist\n"),
        ("topic type", "zz\x15cmd\r", "geometry_msgs/msg/Twist\n"),
        ("topic info", "cha\r", "Type: std_msgs/msg/String\nPublisher count: 1\nSubscription count: 0\n"),
        ("interface show", "turtle srv Kill\r", "# Removes a turtle.\nstring name\n---\n"),
        ("param get", "driver\rsim\r", "Boolean value is: False\n"),
    ],
)
def test_a_name_that_was_left_out_is_chosen(busy, words, keys, said):
    out, err, status = chosen(busy, words, *keys)
    assert (out, err, status) == (said, "", 0)


def test_the_arrows_move_the_mark(busy):
    assert chosen(busy, "topic type", "\x1b[B", "\x1b[B", "\x1b[B", "\r")[0] == "geometry_msgs/msg/Twist\n"
    assert chosen(busy, "topic type", "\x1b[B", "\x1b[A", "\x1b[A", "\r")[0] == "std_msgs/msg/String\n"


@pytest.mark.parametrize("key", ["\x1b", "\x03", ""])
@pytest.mark.parametrize(
    ("words", "said", "status"),
    [
        ("topic echo", "", 0),
        ("node info", "", 0),
        ("run", "No package selected\n", 1),
        ("param get", "No node selected\n", 1),
    ],
)
def test_leaving_the_choice_does_nothing(busy, words, said, status, key):
    assert chosen(busy, words, "c", key) == ("", said, status)


def test_the_programs_of_a_package_are_chosen_from(busy):
    assert chosen(busy, "run", *"turtlesim\r", "\x1b")[1:] == ("No executable selected\n", 1)
    result = busy.ros2("run", "nothing_here")
    assert (result.stderr, result.status) == ("Package 'nothing_here' not found\n", 1)


@pytest.mark.parametrize("words", ["topic hz", "topic bw", "topic info", "node info", "interface show"])
def test_without_a_terminal_nothing_is_asked(busy, words):
    result = busy.ros2(*words.split())
    assert (result.stdout, result.stderr) == ("", "Error: Interactive selection requires a TTY terminal.\n")
    assert result.status == 0, "as real ros2cli ends"


@pytest.mark.parametrize("words", ["topic echo", "topic info", "node info", "interface show", "run"])
def test_before_lyrical_the_name_is_required(machine, words):
    result = machine.ros2(*words.split())
    assert result.status == 2
    assert f"ros2 {words}: error: the following arguments are required: " in result.stderr


@pytest.mark.parametrize("verb", ["hz", "bw"])
def test_all_topics_or_some(busy, verb):
    result = busy.ros2("topic", verb, "/chatter", "--all")
    assert (result.stderr, result.status) == ("Cannot specify both --all/-a and topic names\n", 1)
    command = busy.start("topic", verb, "--all")
    busy.step(0.1)
    assert command.stdout.startswith("Subscribing to all 4 available topics...\n")
    command.interrupt()


@pytest.mark.parametrize(
    ("query", "found"),
    [
        ("", ["/tf", "/tf_static", "/turtle1/cmd_vel", "/Turtle"]),
        ("tf", ["/tf", "/tf_static"]),
        ("tc", ["/tf_static", "/turtle1/cmd_vel"]),
        ("T", ["/Turtle"]),
        ("vel tur", ["/turtle1/cmd_vel"]),
        ("x", []),
    ],
)
def test_letters_in_their_order_choose(query, found):
    assert matching(["/tf", "/tf_static", "/turtle1/cmd_vel", "/Turtle"], query) == found
