"""`ros2 topic …` on a stepped machine."""

from __future__ import annotations

import time

import pytest
from std_msgs.msg import Header, Int32, String

from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy


def talker(node):
    """Publishes 'hi 0', 'hi 1', … on /chatter, ten a second."""
    node.publisher = node.create_publisher(String, "chatter", 10)
    node.count = 0

    def tick():
        node.publisher.publish(String(data=f"hi {node.count}"))
        node.count += 1

    node.create_timer(0.1, tick)


# -- list, info, type, find --------------------------------------------------------------------------------------------


def test_the_list_has_every_topic_and_hides_those_with_an_underscore(machine):
    machine.node("talker", talker)
    machine.node("shy", lambda node: node.create_publisher(String, "_secret", 10))
    assert machine.ros2("topic", "list").stdout == "/chatter\n/parameter_events\n/rosout\n"
    assert "/_secret [std_msgs/msg/String]\n" in machine.ros2("topic", "list", "-t", "--include-hidden-topics").stdout
    assert machine.ros2("topic", "list", "-c").stdout == "3\n"


def test_the_verbose_list_counts_publishers_and_subscribers(machine):
    machine.node("talker", talker)
    machine.node("one", lambda node: node.create_subscription(String, "chatter", print, 10))
    machine.node("two", lambda node: node.create_subscription(String, "chatter", print, 10))
    lines = machine.ros2("topic", "list", "-v").stdout.split("\n\n")
    assert lines[0].startswith("Published topics:\n * /chatter [std_msgs/msg/String] 1 publisher\n")
    assert lines[1] == "Subscribed topics:\n * /chatter [std_msgs/msg/String] 2 subscribers"


def test_info_shows_both_types_of_a_topic_that_has_two(machine):
    machine.node("one", lambda node: node.create_publisher(String, "mixed", 10))
    machine.node("two", lambda node: node.create_subscription(Int32, "mixed", print, 10))
    result = machine.ros2("topic", "info", "/mixed", "-v")
    assert result.stdout.startswith(
        "Type: ['std_msgs/msg/Int32', 'std_msgs/msg/String']\n\nPublisher count: 1\n\nNode name: one\n"
    )
    assert "Endpoint type: SUBSCRIPTION" in result.stdout
    assert machine.ros2("topic", "type", "/mixed").stdout == "std_msgs/msg/Int32\nstd_msgs/msg/String\n"


def test_unknown_topics_are_an_error_of_one_line_or_none(machine):
    assert machine.ros2("topic", "info", "/nope") == ("", "Unknown topic '/nope'\n", 1)
    assert machine.ros2("topic", "type", "/nope") == ("", "", 1)
    assert machine.ros2("topic", "find", "std_msgs/msg/Nope") == ("", "", 0)


# -- echo --------------------------------------------------------------------------------------------------------------


def test_echo_prints_messages_until_it_is_interrupted(machine):
    machine.node("talker", talker)
    echo = machine.start("topic", "echo", "/chatter")
    echo.step(0.25)
    assert echo.stdout == "data: hi 0\n---\ndata: hi 1\n---\n"
    echo.interrupt()
    assert echo.status == 2
    machine.step(1.0)
    assert echo.stdout.count("---") == 2


def test_echo_once_ends_after_one_message_even_if_several_are_waiting(machine):
    def burst(node):
        publisher = node.create_publisher(
            String, "burst", QoSProfile(depth=5, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        )
        for number in range(5):
            publisher.publish(String(data=str(number)))
        node.publisher = publisher

    machine.node("burst", burst)
    assert machine.ros2("topic", "echo", "--once", "/burst") == ("data: '0'\n---\n", "", 0)


def test_echo_is_a_hidden_node_with_a_subscription(machine):
    machine.node("talker", talker)
    echo = machine.start("topic", "echo", "/chatter")
    names = machine.ros2("node", "list", "-a").stdout
    assert f"/_ros2cli_{echo.session.pid}\n" in names
    assert "_ros2cli" not in machine.ros2("node", "list").stdout
    assert machine.ros2("topic", "info", "/chatter").stdout.endswith("Subscription count: 1\n")
    echo.interrupt()
    assert machine.ros2("topic", "info", "/chatter").stdout.endswith("Subscription count: 0\n")


def test_echo_adapts_to_best_effort_and_to_latched_publishers(machine):
    best_effort = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)

    def build(node):
        node.latched = node.create_publisher(String, "latched", latched)
        node.latched.publish(String(data="old"))
        node.fast = node.create_publisher(String, "fast", best_effort)
        node.create_timer(0.1, lambda: node.fast.publish(String(data="q")))

    machine.node("maker", build)
    assert machine.ros2("topic", "echo", "--once", "/latched").stdout == "data: old\n---\n"
    assert machine.ros2("topic", "echo", "--once", "/fast").stdout == "data: q\n---\n"
    assert machine.ros2("topic", "echo", "--timeout", "1", "--qos-durability", "volatile", "/latched") == ("", "", 0)


def test_echo_says_which_policy_it_falls_back_to(machine):
    machine.node("one", lambda node: node.create_publisher(String, "x", 10))
    machine.node(
        "two",
        lambda node: node.create_publisher(String, "x", QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)),
    )
    result = machine.ros2("topic", "echo", "--timeout", "1", "/x")
    assert result.stdout == (
        "Some, but not all, publishers are offering QoSReliabilityPolicy.RELIABLE. Falling back to "
        "QoSReliabilityPolicy.BEST_EFFORT as it will connect to all publishers\n"
    )


def test_an_unknown_topic_is_warned_of_and_is_an_error_without_a_type(machine):
    assert machine.ros2("topic", "echo", "/nope") == (
        "WARNING: topic [/nope] does not appear to be published yet\n",
        "Could not determine the type for the passed topic\n",
        1,
    )


def test_echo_may_be_launched_together_with_the_node_that_publishes(machine):
    echo = machine.start("topic", "echo", "--once", "/latched")
    echo.step(0.5)
    assert (echo.status, echo.stdout) == (None, "")
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)

    def build(node):
        node.latched = node.create_publisher(String, "latched", latched)
        node.latched.publish(String(data="here"))

    machine.node("maker", build)
    echo.step(1.0)
    assert (echo.status, echo.stdout) == (0, "data: here\n---\n")


def test_with_a_type_echo_waits_for_the_publisher_to_come(machine):
    echo = machine.start("topic", "echo", "--once", "/chatter", "std_msgs/msg/String")
    echo.step(1.0)
    assert echo.status is None
    machine.node("talker", talker)
    echo.step(0.2)
    assert (echo.stdout, echo.status) == ("data: hi 0\n---\n", 0)


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        (["--field", "data"], "hi 0\n---\n"),
        (["--csv"], "hi 0\n"),
        (["--raw"], "b'\\x00\\x01\\x00\\x00\\x05\\x00\\x00\\x00hi 0\\x00\\x00\\x00\\x00'\n---\n"),
        (["--clear"], "\x1b[H\x1b[2J\ndata: hi 0\n---\n"),
        (["--filter", "m.data.endswith('3')"], "data: hi 3\n---\n"),
        (["-l", "1"], "data: h...\n---\n"),
        (["--no-str"], "data: '<string length: <4>>'\n---\n"),
    ],
)
def test_options_of_echo(machine, options, expected):
    machine.node("talker", talker)
    assert machine.ros2("topic", "echo", "--once", *options, "/chatter") == (expected, "", 0)


@pytest.mark.parametrize(
    ("options", "error"),
    [
        (["--field", "dat"], "Invalid field 'dat': 'String' object has no attribute 'dat'\n"),
        (["--field", "."], "Invalid field value '.'\n"),
        (["--filter", "m.dat"], "AttributeError: 'String' object has no attribute 'dat'. Did you mean: 'data'?\n"),
        (["--filter", "open('x')"], "NameError: name 'open' is not defined\n"),
        (["--filter", "m.__class__"], "a filter cannot use .__class__\n"),
    ],
)
def test_wrong_fields_and_filters_are_errors_not_tracebacks(machine, options, error):
    machine.node("talker", talker)
    result = machine.ros2("topic", "echo", "--once", *options, "/chatter")
    assert (result.stdout, result.stderr, result.status) == ("", error, 1)


def test_the_presets_of_the_process_stay_as_they_are(machine):
    from rclpy.qos import qos_profile_sensor_data

    before = repr(qos_profile_sensor_data)
    machine.node("talker", talker)
    machine.ros2("topic", "echo", "--once", "/chatter")
    machine.ros2("topic", "echo", "--once", "--qos-depth", "3", "/chatter")
    assert repr(qos_profile_sensor_data) == before


# -- pub ---------------------------------------------------------------------------------------------------------------


def listener(heard):
    return lambda node: node.create_subscription(String, "chatter", lambda message: heard.append(message.data), 10)


def test_pub_once_waits_for_a_subscription_and_sends_one_message(machine):
    heard = []
    pub = machine.start("topic", "pub", "--once", "/chatter", "std_msgs/msg/String", "data: hi")
    pub.step(1.05)
    assert pub.stdout == "Waiting for at least 1 matching subscription(s)...\n" * 2
    machine.node("listener", listener(heard))
    pub.step(0.5)
    assert pub.stdout.endswith("...\npublisher: beginning loop\npublishing #1: std_msgs.msg.String(data='hi')\n\n")
    assert (pub.status, heard) == (0, ["hi"])


def test_pub_sends_at_its_rate_and_stops_after_the_number_asked_for(machine):
    heard = []
    machine.node("listener", listener(heard))
    pub = machine.start("topic", "pub", "-t", "3", "-r", "2", "-w", "0", "/chatter", "std_msgs/String", "{data: x}")
    assert heard == ["x"]
    pub.step(0.99)
    assert heard == ["x", "x"]
    pub.step(0.2)
    assert (heard, pub.status) == (["x"] * 3, 0)
    assert "publishing #3: std_msgs.msg.String(data='x')\n\n" in pub.stdout


def test_pub_without_end_prints_every_nth_message_until_ctrl_c(machine):
    pub = machine.start("topic", "pub", "-r", "10", "-p", "5", "/x", "std_msgs/msg/String", "data: 你好")
    pub.step(1.0)
    pub.interrupt()
    assert pub.status == 2
    assert pub.stdout == (
        "publisher: beginning loop\npublishing #5: std_msgs.msg.String(data='你好')\n\n"
        "publishing #10: std_msgs.msg.String(data='你好')\n\n"
    )


def test_a_rate_beyond_the_machine_leaves_the_world_its_time(machine):
    pub = machine.start("topic", "pub", "-r", "1e9", "-p", "0", "/x", "std_msgs/msg/String")
    began = time.process_time()
    pub.step(0.2)
    # Without a limit this would be 200 million publications.
    assert time.process_time() - began < 5.0
    pub.interrupt()
    assert pub.status == 2


def test_pub_stamps_every_message_anew(machine):
    stamps = []
    machine.node("l", lambda node: node.create_subscription(Header, "h", lambda m: stamps.append(m.stamp.sec), 10))
    pub = machine.start("topic", "pub", "-t", "2", "-w", "0", "/h", "std_msgs/msg/Header", "stamp: now")
    pub.step(1.2)
    assert stamps[1] == stamps[0] + 1


def test_pub_reads_values_from_standard_input(machine):
    result = machine.ros2(
        "topic", "pub", "--once", "-w", "0", "--stdin", "/x", "std_msgs/msg/String", stdin="data: in\n"
    )
    assert "String(data='in')" in result.stdout


@pytest.mark.parametrize(
    ("type_name", "values", "error"),
    [
        ("std_msgs/msg/Strng", "data: hi", "The passed message type is invalid\n"),
        ("std_srvs/srv/Empty", "{}", "The passed message type is invalid\n"),
        ("std_msgs/msg/String", "null", "The passed value needs to be a dictionary in YAML format\n"),
        ("std_msgs/msg/String", "{dat: hi}", "Failed to populate field: 'String' object has no attribute 'dat'\n"),
        (
            "geometry_msgs/msg/Twist",
            "{linear: 2.0}",
            "Failed to populate field: Value '2.0' is expected to be a dictionary but is a float\n",
        ),
        (
            "std_msgs/msg/Int8",
            "data: 300",
            "Failed to populate field: The 'data' field must be an integer in [-128, 127]\n",
        ),
    ],
)
def test_wrong_types_and_values_of_pub(machine, type_name, values, error):
    assert machine.ros2("topic", "pub", "--once", "-w", "0", "/x", type_name, values)[1:] == (error, 1)


def test_malformed_yaml_is_shown_with_its_place_and_no_traceback(machine):
    result = machine.ros2("topic", "pub", "--once", "-w", "0", "/x", "geometry_msgs/msg/Twist", "{linear: {x: 2.0}")
    assert result.status == 1
    assert result.stderr.startswith("yaml.parser.ParserError: while parsing a flow mapping\n")
    assert result.stderr.endswith("    {linear: {x: 2.0}\n                     ^\n")


def test_a_bad_topic_name_is_shown_with_a_caret(machine):
    result = machine.ros2("topic", "pub", "--once", "-w", "0", "/1abc", "std_msgs/msg/String")
    assert result.stderr == (
        "rclpy.exceptions.InvalidTopicNameException: Invalid topic name: topic name token must not start with a number:\n"
        "  '/1abc'\n    ^\n"
    )


# -- hz, bw, delay -----------------------------------------------------------------------------------------------------


def test_hz_measures_the_rate_in_world_time(machine):
    machine.node("talker", talker)
    hz = machine.start("topic", "hz", "/chatter")
    hz.step(2.05)
    lines = hz.stdout.splitlines()
    assert lines[0] == "average rate: 10.000"
    assert lines[1].startswith("\tmin: 0.100s max: 0.100s std dev: 0.00000s window: ")
    hz.interrupt()
    assert hz.status == 0


def test_hz_of_several_topics_is_a_table(machine):
    machine.node("talker", talker)

    def slow(node):
        publisher = node.create_publisher(Int32, "slow", 10)
        node.create_timer(0.5, lambda: publisher.publish(Int32()))

    machine.node("slow", slow)
    hz = machine.start("topic", "hz", "/chatter", "/slow")
    hz.step(2.0)
    lines = hz.stdout.splitlines()
    assert lines[:2] == ["Subscribed to [/chatter]", "Subscribed to [/slow]"]
    header = lines.index(" topic      rate    min_delta   max_delta   std_dev   window")
    assert lines[header + 1] == "=" * len(lines[header])
    assert lines[header + 2].startswith("/chatter   10.000   0.100       0.100       0.00000   ")


def test_hz_waits_for_a_topic_and_ctrl_c_while_waiting_is_2(machine):
    hz = machine.start("topic", "hz", "/chatter")
    hz.step(0.5)
    assert hz.stdout == "WARNING: topic [/chatter] does not appear to be published yet\n"
    machine.node("talker", talker)
    hz.step(2.0)
    assert "average rate: 10.000" in hz.stdout
    other = machine.start("topic", "hz", "/nope")
    other.interrupt()
    assert other.status == 2


def test_hz_counts_only_what_passes_the_filter(machine):
    machine.node("talker", talker)
    hz = machine.start("topic", "hz", "--filter", "int(m.data[3:]) % 2 == 0", "/chatter")
    hz.step(2.05)
    assert hz.stdout.startswith("average rate: 5.000\n")


def test_bw_counts_the_bytes_of_the_wire(machine):
    machine.node("talker", talker)
    bw = machine.start("topic", "bw", "/chatter")
    bw.step(1.05)
    first, second = bw.stdout.splitlines()[1:3]
    assert first == "160 B/s from 9 messages"
    assert second == "\tMessage size mean: 16 B min: 16 B max: 16 B"
    bw.interrupt()
    assert bw.status == 2


def test_delay_is_the_age_of_the_stamp_and_needs_a_header(machine):
    def late(node):
        publisher = node.create_publisher(StampedPoint, "p", 10)

        def tick():
            message = StampedPoint()
            now = node.get_clock().now().nanoseconds - 20_000_000
            message.header.stamp.sec, message.header.stamp.nanosec = divmod(now, 1_000_000_000)
            publisher.publish(message)

        node.create_timer(0.1, tick)

    from geometry_msgs.msg import PointStamped as StampedPoint

    machine.node("late", late)
    delay = machine.start("topic", "delay", "/p")
    delay.step(1.05)
    assert delay.stdout.startswith("average delay: 0.020\n\tmin: 0.020s max: 0.020s std dev: 0.00000s window: ")
    machine.node("talker", talker)
    assert machine.ros2("topic", "delay", "/chatter")[1:] == ("msg does not have header\n", 1)
