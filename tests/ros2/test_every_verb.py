"""What the small options of the verbs do: counts, hidden things, types, quiet output, and what each says when it cannot."""

from __future__ import annotations

import re
import sys

import pytest
from rcl_interfaces.msg import ParameterDescriptor
from std_msgs.msg import Int32, String
from std_srvs.srv import Empty, SetBool
from turtlesim.action import RotateAbsolute

from day6_core.graph import EndpointKind, QoS
from rclpy.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy

TURN = "turtlesim/action/RotateAbsolute"


def everything(node):
    """A node with one hidden and one open topic, service and action."""
    from rclpy.action import ActionServer

    def turn(handle):
        handle.succeed()
        return RotateAbsolute.Result(delta=0.5)

    for name in ("open", "_hidden"):
        node.create_publisher(String, name, 10)
        node.create_service(SetBool, f"{name}_service", lambda request, response: response)
    node.server = ActionServer(node, RotateAbsolute, "turn", execute_callback=turn)
    node.declare_parameter("speed", 3, ParameterDescriptor())


@pytest.fixture
def robot(machine):
    machine.node("robot", everything)
    machine.node("_shy")
    return machine


# -- counts, hidden things, types --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("words", "stdout"),
    [
        ("topic list -c", "3\n"),
        ("topic list -c --include-hidden-topics", "6\n"),
        ("topic find -c std_msgs/msg/String", "1\n"),
        ("topic find -c std_msgs/msg/String --include-hidden-topics", "2\n"),
        ("topic find std_msgs/msg/String --include-hidden-topics", "/_hidden\n/open\n"),
        ("topic find std_msgs/msg/Str", ""),
        ("topic type /open", "std_msgs/msg/String\n"),
        ("topic --include-hidden-topics type /_hidden", "std_msgs/msg/String\n"),
        ("service find std_srvs/srv/SetBool", "/open_service\n"),
        ("service find -c std_srvs/srv/SetBool", "1\n"),
        ("service find -c std_srvs/srv/SetBool --include-hidden-services", "2\n"),
        ("service find std_srvs/srv/Set", ""),
        ("action list", "/turn\n"),
        ("action list -c", "1\n"),
        ("action list -t", f"/turn [{TURN}]\n"),
        ("action find -c turtlesim/action/RotateAbsolute", "1\n"),
        ("action find turtlesim/action/Nope", ""),
        ("action type /turn", f"{TURN}\n"),
        ("action info -t /turn", f"Action: /turn\nAction clients: 0\nAction servers: 1\n    /robot [{TURN}]\n"),
        ("node list", "/robot\n"),
        ("node list -c", "1\n"),
        ("node list -a -c", "3\n"),
        ("service info /open_service", "Type: std_srvs/srv/SetBool\nClients count: 0\nServices count: 1\n"),
    ],
)
def test_what_is_listed_and_counted(robot, words, stdout):
    result = robot.ros2(*words.split())
    assert (re.sub(r"/_ros2cli\S+\n", "", result.stdout), result.stderr, result.status) == (stdout, "", 0)


def test_the_count_of_services_is_that_of_the_list(robot):
    for option in ([], ["--include-hidden-services"]):
        listed = robot.ros2("service", "list", *option).stdout.splitlines()
        assert robot.ros2("service", "list", "-c", *option).stdout == f"{len(listed)}\n"
        assert ("/_hidden_service" in listed) == bool(option)
        assert "/open_service" in listed
    typed = robot.ros2("service", "list", "-t").stdout.splitlines()
    assert all(re.fullmatch(r"/\S+ \[\S+\]", line) for line in typed)


@pytest.mark.parametrize(
    ("words", "answer"),
    [
        ("topic type /nope", ("", "", 1)),
        ("action type /nope", None),
        ("service type /nope", None),
        ("service info /nope", None),
        ("node info /nope", ("", "Unable to find node '/nope'\n", 1)),
        ("node info /_shy", ("", "Unable to find node '/_shy'\n", 1)),
        ("action echo /nope", ("", "Cannot find type for '/nope'\n", 1)),
        ("action echo /turn nope/action/No", ("", "The service type 'nope/action/No' is invalid\n", 1)),
        ("action echo /turn --interfaces=", ("", "Input action interface name is empty.\n", 1)),
        ("service echo /nope", ("", "Cannot find type for '/nope'\n", 1)),
        ("service echo /s nope/srv/No", ("", "The service type 'nope/srv/No' is invalid\n", 1)),
        ("component load /x a b", ("", "Unable to find container node '/x'\n", 1)),
        ("component unload /x 1", ("", "Unable to find container node '/x'\n", 1)),
        ("component list /x", ("", "Unable to find container node '/x'\n", 1)),
        ("lifecycle get /x", ("", "Node not found\n", 1)),
        ("interface package std_srvs -m", ("", "", 0)),
        ("interface show nope", ("", "Invalid name 'nope'. Expected three parts separated by '/'\n", 1)),
        ("topic pub -w 0 --max-wait-time-secs 1 /x std_msgs/msg/String", ("",
         "--max-wait-time-secs option is only effective with --wait-matching-subscriptions, --once or --times\n", 1)),
    ],
)  # fmt: skip
def test_what_is_not_there_is_told(robot, words, answer):
    result = robot.ros2(*words.split())
    assert (result == answer) if answer else result.status == 1


def test_a_node_shows_hidden_things_when_asked_to(robot):
    shown = robot.ros2("node", "info", "/robot").stdout
    assert "/open: std_msgs/msg/String" in shown and "_hidden" not in shown and "/_action/" not in shown
    assert f"  Action Servers:\n    /turn: {TURN}\n" in shown
    everything_shown = robot.ros2("node", "info", "/robot", "--include-hidden").stdout
    assert "/_hidden: std_msgs/msg/String" in everything_shown and "/turn/_action/feedback" in everything_shown
    assert robot.ros2("node", "info", "/_shy", "--include-hidden").stdout.startswith("/_shy\n")


@pytest.mark.parametrize("verb", ["echo", "hz", "bw", "delay"])
def test_a_topic_of_two_types_or_of_an_unknown_one_is_refused(machine, verb):
    machine.node("one", lambda node: node.create_publisher(String, "mixed", 10))
    machine.node("two", lambda node: node.create_publisher(Int32, "mixed", 10))
    assert machine.ros2("topic", verb, "/mixed")[1:] == (
        "Cannot echo topic '/mixed', as it contains more than one type: [std_msgs/msg/Int32, std_msgs/msg/String]\n", 1,
    )  # fmt: skip
    stranger = machine.graph.create_node("stranger", "/")
    stranger.create_publisher("/odd", "my_msgs/msg/Thing", "", QoS(), list)
    assert machine.ros2("topic", verb, "/odd")[1:] == ("The message type 'my_msgs/msg/Thing' is invalid\n", 1)


@pytest.mark.parametrize("verb", ["echo", "hz", "bw", "delay"])
def test_a_name_that_cannot_be_is_told(machine, verb):
    result = machine.ros2("topic", verb, "/1x")
    assert result.status == 1 and "/1x" in result.stderr


# -- topic echo --------------------------------------------------------------------------------------------------------


def talks(machine, qos=10, kind=String, **fields):
    def build(node):
        publisher = node.create_publisher(kind, "said", qos)
        node.create_timer(0.1, lambda: publisher.publish(kind(**fields)))

    machine.node("talker", build)


def test_with_each_message_comes_its_info(machine):
    talks(machine, data="hi")
    text = machine.ros2("topic", "echo", "--once", "-i", "/said").stdout
    info, _, message = text.partition("---\n")
    keys = [line.partition(":")[0] for line in info.splitlines() if line[0].isalpha()]
    assert keys == [
        *("publication_sequence_number", "publisher_gid", "received_timestamp"),
        *("reception_sequence_number", "source_timestamp"),
    ]
    assert message == "data: hi\n---\n"
    line = machine.ros2("topic", "echo", "--once", "-i", "--csv", "/said").stdout
    assert re.fullmatch(r"\d+,\d+,\d+,.*,hi\n", line)
    bare = machine.ros2("topic", "echo", "--once", "-i", "--field", "data", "/said").stdout
    assert bare.startswith("---Got new message, message info:---\n{") and bare.endswith(
        "---Message data:---\nhi\n---\n"
    )


def test_lost_messages_are_told_unless_nobody_wants_to_know(machine):
    talks(machine, data="hi")
    told, silent = (
        machine.start("topic", "echo", "/said"),
        machine.start("topic", "echo", "--no-lost-messages", "/said"),
    )
    machine.step(0.2)
    assert told.stdout == silent.stdout == "data: hi\n---\n" * told.stdout.count("---")


@pytest.mark.parametrize(
    ("options", "text"),
    [
        ([], f"data: {'x' * 128}...\n---\n"),
        (["-f"], f"data: {'x' * 200}\n---\n"),
        (["-l", "3"], "data: xxx...\n---\n"),
        (["-l", "0"], None),
        (["--no-str"], "data: '<string length: <200>>'\n---\n"),
        (["--flow-style", "-l", "2"], "data: xx...\n---\n"),
    ],
)
def test_how_much_of_a_message_is_printed(machine, options, text):
    talks(machine, data="x" * 200)
    result = machine.ros2("topic", "echo", "--once", *options, "/said")
    assert result.status == 0 and (text is None or result.stdout == text)


def test_echo_may_have_a_name_and_a_timeout(machine):
    echo = machine.start("topic", "echo", "-n", "ear", "--timeout", "2", "/said", "std_msgs/msg/String")
    assert "/ear\n" in machine.ros2("node", "list").stdout
    echo.step(1.9)
    assert echo.status is None
    echo.step(0.2)
    assert (echo.stdout, echo.status) == ("", 0)


def test_a_topic_gets_a_second_to_appear(machine):
    echo = machine.start("topic", "echo", "/late")
    echo.step(0.95)
    assert echo.status is None
    echo.step(0.2)
    assert echo.status == 1


LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
FAST = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)


@pytest.mark.parametrize(
    ("offered", "options", "expected"),
    [
        ([], [], ("BEST_EFFORT", "VOLATILE", 5)),
        ([10], [], ("RELIABLE", "VOLATILE", 5)),
        ([LATCHED], [], ("RELIABLE", "TRANSIENT_LOCAL", 5)),
        ([FAST], [], ("BEST_EFFORT", "VOLATILE", 5)),
        ([LATCHED, 10], [], ("RELIABLE", "VOLATILE", 5)),
        ([10, FAST], [], ("BEST_EFFORT", "VOLATILE", 5)),
        ([10], ["--qos-depth", "3"], ("BEST_EFFORT", "VOLATILE", 3)),
        ([FAST], ["--qos-reliability", "reliable"], ("RELIABLE", "VOLATILE", 5)),
        ([10], ["--qos-durability", "transient_local"], ("BEST_EFFORT", "TRANSIENT_LOCAL", 5)),
        ([LATCHED], ["--qos-profile", "services_default"], ("RELIABLE", "TRANSIENT_LOCAL", 10)),
        ([], ["--qos-profile", "services_default"], ("RELIABLE", "VOLATILE", 10)),
        ([10], ["--qos-depth", "0"], ("BEST_EFFORT", "VOLATILE", 5)),
    ],
)  # fmt: skip
def test_echo_subscribes_with_what_fits_or_with_what_is_asked_for(machine, offered, options, expected):
    for number, qos in enumerate(offered):
        machine.node(f"n{number}", lambda node, qos=qos: node.create_publisher(String, "said", qos))
    echo = machine.start("topic", "echo", *options, "/said", "std_msgs/msg/String")
    (subscription,) = machine.graph.endpoints(EndpointKind.SUBSCRIPTION, topic="/said")
    qos = subscription.qos
    assert (qos.reliability.name, qos.durability.name, qos.depth) == expected
    echo.interrupt()


@pytest.mark.parametrize(
    ("options", "wanted"),
    [
        ([], QoSProfile(depth=10)),
        (["--qos-profile", "sensor_data"], QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)),
        (["--qos-history", "keep_all"], QoSProfile(depth=10, history=HistoryPolicy.KEEP_ALL)),
        (["--qos-reliability", "best_effort"], QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT)),
        (["--qos-durability", "transient_local"], QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)),
        (["--qos-depth", "7"], QoSProfile(depth=7)),
        (["--qos-liveliness", "manual_by_topic"], QoSProfile(depth=10, liveliness=LivelinessPolicy.MANUAL_BY_TOPIC)),
    ],
)
def test_pub_offers_what_its_options_say(machine, options, wanted):
    pub = machine.start("topic", "pub", *options, "/x", "std_msgs/msg/String")
    (publisher,) = machine.graph.endpoints(EndpointKind.PUBLISHER, topic="/x")
    for policy in ("history", "reliability", "durability", "liveliness"):
        name = getattr(wanted, policy).name.replace("SYSTEM_DEFAULT", "AUTOMATIC")
        assert getattr(publisher.qos, policy).name == name, policy
    assert publisher.qos.depth == wanted.depth
    pub.interrupt()


def test_pub_may_have_a_lease(machine):
    pub = machine.start("topic", "pub", "--qos-liveliness-lease-duration-seconds", "1.5", "/x", "std_msgs/msg/String")
    (info,) = machine.node("watcher").get_publishers_info_by_topic("/x")
    assert info.qos_profile.liveliness_lease_duration.nanoseconds == 1_500_000_000
    pub.interrupt()


# -- topic pub ---------------------------------------------------------------------------------------------------------


def test_pub_waits_as_long_as_it_may_for_as_many_as_it_was_told(machine):
    machine.node("one", lambda node: node.create_subscription(String, "x", print, 10))
    words = ("topic", "pub", "-w", "2", "--max-wait-time-secs", "1.5", "/x", "std_msgs/msg/String")
    pub = machine.start(*words)
    pub.step(1.45)
    assert pub.status is None
    pub.step(0.2)
    assert pub.stdout == "Waiting for at least 2 matching subscription(s)...\n" * 2
    assert (pub.stderr, pub.status) == (
        "Timed out waiting for subscribers: Expected 2 subcribers but only got 1 subscribers\n",
        1,
    )


def test_pub_lives_on_for_a_moment_after_the_last_message(machine):
    for options, seconds in (([], 0.1), (["--keep-alive", "2"], 2.0)):
        pub = machine.start("topic", "pub", "-1", "-w", "0", *options, "/x", "std_msgs/msg/String")
        pub.step(seconds - 0.02)
        assert pub.status is None
        pub.step(0.04)
        assert pub.status == 0


def test_pub_may_have_a_name_and_a_rate_and_prints_every_message(machine):
    pub = machine.start("topic", "pub", "-n", "mouth", "/x", "std_msgs/msg/Int32", "data: 5")
    assert "/mouth\n" in machine.ros2("node", "list").stdout
    pub.step(2.5)
    assert pub.stdout == "publisher: beginning loop\n" + "".join(
        f"publishing #{number}: std_msgs.msg.Int32(data=5)\n\n" for number in (1, 2, 3)
    )
    pub.interrupt()


@pytest.mark.parametrize("option", ["--rate", "--max-wait-time-secs", "--keep-alive"])
@pytest.mark.parametrize(("value", "why"), [("0", "Value must be positive"), ("-1", "Value must be positive"),
                                            ("x", "Expects a floating point number")])  # fmt: skip
def test_rates_and_times_of_pub_are_positive(machine, option, value, why):
    result = machine.ros2("topic", "pub", f"{option}={value}", "/x", "std_msgs/msg/String")
    assert result.status == 2 and result.stderr.endswith(f": {why}\n")


@pytest.mark.parametrize("option", ["--times", "--wait-matching-subscriptions"])
def test_counts_of_pub_are_not_negative(machine, option):
    result = machine.ros2("topic", "pub", f"{option}=-1", "/x", "std_msgs/msg/String")
    assert result.status == 2 and result.stderr.endswith(": invalid nonnegative_int value: '-1'\n")


@pytest.mark.parametrize("value", ["-1", "x", "1.5"])
def test_a_length_is_not_negative(machine, value):
    result = machine.ros2("topic", "echo", f"-l={value}", "/x")
    assert result.status == 2 and result.stderr.endswith("value must be non-negative integer\n")


# -- services, actions -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("type_name", "error"),
    [
        ("std_srvs/SetBool", ""),
        ("std_srvs/srv/SetBool", ""),
        ("std_srvs/srv/Nope", "The passed service type is invalid\n"),
        ("std_srvs/srv", "The passed service type is invalid\n"),
        ("no-such/srv/X", "The passed service type is invalid\n"),
        ("std_srvs/s-v/SetBool", "The passed service type is invalid\n"),
        ("/srv/X", "TypeError: the 'package' argument is required to perform a relative import for '.srv'\n"),
    ],
)
def test_the_type_of_a_call(robot, type_name, error):
    result = robot.ros2("service", "call", "/open_service", type_name)
    assert (result.stderr, result.status) == (error, 1 if error else 0)


def test_a_call_reads_its_request_from_standard_input(robot):
    result = robot.ros2("service", "call", "/open_service", "std_srvs/srv/SetBool", "--stdin", stdin="data: true\n")
    assert "SetBool_Request(data=True)" in result.stdout


def test_calls_are_repeated_until_ctrl_c_at_their_rate_and_one_only_once(robot):
    call = robot.start("service", "call", "-r", "4", "/open_service", "std_srvs/srv/SetBool")
    call.step(1.1)
    assert call.stdout.count("response:\n") == 5
    call.interrupt()
    assert call.status == 2
    assert robot.ros2("service", "call", "/open_service", "std_srvs/SetBool").stdout.count("response:\n") == 1


def test_services_of_two_types_are_not_echoed(machine):
    machine.node("one", lambda node: node.create_service(SetBool, "s", print))
    machine.node("two", lambda node: node.create_service(Empty, "s", print))
    assert machine.ros2("service", "echo", "/s")[1:] == ("More than one type associated with service '/s'\n", 1)


def test_a_goal_may_come_from_standard_input_and_may_be_refused(machine):
    from rclpy.action import ActionServer, GoalResponse

    def turn(handle):
        handle.abort()
        return RotateAbsolute.Result(delta=handle.request.theta)

    def build(node):
        node.server = ActionServer(
            node, RotateAbsolute, "turn", execute_callback=turn,
            goal_callback=lambda goal: GoalResponse.ACCEPT if goal.theta > 0 else GoalResponse.REJECT,
        )  # fmt: skip

    machine.node("turner", build)
    result = machine.ros2("action", "send_goal", "/turn", TURN, "--stdin", stdin="theta: 2.5\n")
    assert result.stdout.endswith("Result:\n    delta: 2.5\n\nGoal finished with status: ABORTED\n")
    refused = machine.ros2("action", "send_goal", "/turn", TURN)
    assert refused.stdout.endswith("Goal was rejected.\n") and refused.status == 0


def test_an_action_is_echoed_from_all_its_interfaces_or_some(machine):
    machine.run("action_tutorials_py", "fibonacci_action_server")
    fibonacci = "example_interfaces/action/Fibonacci"
    everything_heard = machine.start("action", "echo", "/fibonacci")
    status = machine.start("action", "echo", "/fibonacci", fibonacci, "-i", " status_topic | FEEDBACK_TOPIC", "--csv")
    machine.ros2("action", "send_goal", "/fibonacci", fibonacci, "{order: 3}")
    assert "interface: STATUS_TOPIC\n" in everything_heard.stdout
    assert "interface: FEEDBACK_TOPIC\n" in everything_heard.stdout
    assert re.search(r"interface: STATUS_TOPIC\n[\d,]+\n", status.stdout)
    for echo in (everything_heard, status):
        echo.interrupt()
        assert echo.status == 0


def test_an_event_of_a_service_is_one_line_of_csv(machine):
    machine.run("demo_nodes_py", "introspection")
    machine.ros2("param", "set", "/introspection_service", "service_configure_introspection", "metadata")
    echo = machine.start("service", "echo", "--csv", "/add_two_ints", "example_interfaces/srv/AddTwoInts")
    echo.step(2.5)
    assert re.match(r"\d,\d+,\d+,", echo.stdout) and "event_type" not in echo.stdout


# -- components, lifecycle ---------------------------------------------------------------------------------------------


def test_components_are_loaded_quietly_with_rules_parameters_and_levels(machine):
    container = machine.run("rclcpp_components", "component_container")
    load = ("component", "load", "/ComponentManager", "composition", "composition::Talker")
    assert machine.ros2(*load, "-q", "-r", "chatter:=told", "-n", "a").stdout == "1  /a\n"
    machine.ros2(*load, "-n", "b", "-p", "use_sim_time:=true", "--node-namespace", "/x")
    assert "/told\n" in machine.ros2("topic", "list").stdout
    assert machine.ros2("param", "get", "/x/b", "use_sim_time").stdout == "Boolean value is: True\n"
    assert machine.ros2("component", "list", "/ComponentManager").stdout == "1  /a\n2  /x/b\n"
    assert machine.ros2("component", "list", "--containers-only").stdout == "/ComponentManager\n"
    assert machine.ros2("component", "list", "/ComponentManager", "--containers-only") == ("", "", 0)
    assert machine.ros2("component", "unload", "-q", "/ComponentManager", "2", "1").stdout == "2\n1\n"
    assert machine.ros2("component", "list", "/ComponentManager").stdout == ""
    assert container.stderr.text


def test_tab_knows_containers_packages_and_their_components(machine):
    machine.run("rclcpp_components", "component_container")
    assert machine.complete("component", "list", "") == ["/ComponentManager"]
    assert "composition" in machine.complete("component", "load", "/ComponentManager", "")
    offered = machine.complete("component", "load", "/ComponentManager", "composition", "composition::T")
    assert offered == ["composition::Talker"]
    assert machine.complete("component", "load", "/ComponentManager", "nope", "") == []


def test_a_standalone_component_that_does_not_exist_ends(machine):
    result = machine.ros2("component", "standalone", "composition", "composition::Nope")
    assert result.stdout == (
        "Failed to load component: Failed to find class with the requested plugin name., interrupting container node\n"
    )
    assert result.status == 0


def test_a_container_that_does_not_answer_is_told(machine):
    from composition_interfaces.srv import ListNodes, LoadNode, UnloadNode

    def build(node):
        for kind, name in ((LoadNode, "load_node"), (UnloadNode, "unload_node"), (ListNodes, "list_nodes")):
            node.create_service(kind, f"~/_container/{name}", lambda request, response: response)

    box = machine.node("box", build)
    box.executor.remove_node(box)
    assert machine.ros2("component", "list", "/box").stderr == (
        "No 'list_nodes' service response when listing components in /box\n"
    )
    assert (
        machine.ros2("component", "list").stdout == "/box\nNo 'list_nodes' service response when listing components\n"
    )


def test_every_lifecycle_node_is_asked_or_one(machine):
    for name in ("a", "_b"):
        machine.run("lifecycle", "lifecycle_talker", "--ros-args", "-r", f"__node:={name}")
    assert machine.ros2("lifecycle", "get").stdout == "/a: unconfigured [1]\n"
    assert machine.ros2("lifecycle", "get", "--include-hidden-nodes").stdout == (
        "/_b: unconfigured [1]\n/a: unconfigured [1]\n"
    )
    assert machine.ros2("lifecycle", "nodes", "-c").stdout == "1\n"
    assert machine.ros2("lifecycle", "nodes", "-a").stdout == "/_b\n/a\n"
    assert machine.ros2("lifecycle", "set", "/_b", "configure").stderr == "Node not found\n"
    assert machine.complete("lifecycle", "set", "/nope", "") == []


# -- packages, interfaces ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("option", "has", "lacks"),
    [("-m", "Messages:", ("Services:", "Actions:")), ("-s", "Services:", ("Messages:", "Actions:")),
     ("-a", "Actions:", ("Messages:", "Services:"))],
)  # fmt: skip
def test_kinds_of_interfaces_can_be_chosen(machine, option, has, lacks):
    listed = machine.ros2("interface", "list", option).stdout
    assert listed.startswith(f"{has}\n    ") and not any(title in listed for title in lacks)
    packages = machine.ros2("interface", "packages", option).stdout.splitlines()
    assert packages == sorted({line.split("/")[0].strip() for line in listed.splitlines()[1:]})
    of_one = machine.ros2("interface", "package", option, "turtlesim").stdout.splitlines()
    assert of_one == [line.strip() for line in listed.splitlines() if line.startswith("    turtlesim/")]


def test_all_packages_with_interfaces_and_all_kinds_in_their_order(machine):
    everything_listed = machine.ros2("interface", "list").stdout
    assert [line for line in everything_listed.splitlines() if not line.startswith(" ")] == [
        "Messages:",
        "Services:",
        "Actions:",
    ]
    packages = machine.ros2("interface", "packages").stdout.splitlines()
    assert packages == sorted(packages) and {"std_msgs", "std_srvs", "turtlesim"} <= set(packages)
    kinds = [line.split("/")[1] for line in machine.ros2("interface", "package", "turtlesim").stdout.splitlines()]
    assert kinds == sorted(kinds, key=("msg", "srv", "action").index)


def test_show_reads_a_pipe_and_no_terminal(machine, monkeypatch):
    from day6_core.session.streams import TextInput

    monkeypatch.setattr(TextInput, "isatty", lambda self: True)
    result = machine.ros2("interface", "show", "-", stdin="std_msgs/msg/Bool\n")
    assert result.status == 2 and result.stderr.endswith("ros2 interface show: error: expected stdin pipe\n")


def test_a_manifest_that_is_missing_is_told(machine):
    index = machine.cwd / "install" / "share" / "ament_index" / "resource_index" / "packages"
    index.mkdir(parents=True)
    (index / "bare").touch()
    machine.env["AMENT_PREFIX_PATH"] = str(machine.cwd / "install")
    assert machine.ros2("pkg", "xml", "bare") == ("", "Package XML manifest not found\n", 1)
    share = machine.cwd / "install" / "share" / "bare"
    share.mkdir()
    (share / "package.xml").write_text("<package><depend>a</depend><depend>b</depend></package>")
    assert machine.ros2("pkg", "xml", "bare", "-t", "depend").stdout == "a\nb\n"


@pytest.mark.parametrize("words", [["extensions"], ["extension_points"]])
def test_extensions_tell_more_when_asked_to(machine, words):
    plain, verbose = machine.ros2(*words).stdout, machine.ros2(*words, "-v").stdout
    more = [line for line in verbose.splitlines() if line not in plain.splitlines()]
    kind = "     module_name: " if words == ["extensions"] else "   version: "
    assert more and all(line.startswith(kind) for line in more)
    assert "".join(f"{line}\n" for line in verbose.splitlines() if not line.startswith(kind)) == plain


# -- Tab ---------------------------------------------------------------------------------------------------------------


def test_options_are_offered_long_and_after_one_dash_short_too(machine):
    short = machine.complete("topic", "list", "-")
    assert {"-t", "-c", "-v", "--show-types"} <= set(short)
    long = machine.complete("topic", "list", "--")
    assert "--show-types" in long and "-t" not in long


@pytest.mark.parametrize(
    ("words", "offered"),
    [
        (["topic", "echo", "/"], ["/open"]),
        (["topic", "echo", "/_"], ["/_hidden"]),
        (["topic", "echo", "-l", ""], []),
        (["topic", "pub", "/open", ""], ["std_msgs/msg/String"]),
        (["topic", "pub", "/new", "std_msgs/msg/Stri"], ["std_msgs/msg/String"]),
        (["service", "call", "/open"], ["/open_service"]),
        (["service", "call", "/new", "std_srvs/srv/E"], ["std_srvs/srv/Empty"]),
        (["service", "call", "/open_service", "std_srvs/srv/SetBool", ""], ["{data: false}"]),
        (["service", "call", "/open_service", "nope/srv/No", ""], []),
        (["action", "send_goal", ""], ["/turn"]),
        (["action", "send_goal", "/turn", ""], [TURN]),
        (["action", "send_goal", "/new", "turtlesim/action/R"], [TURN]),
        (["action", "send_goal", "/turn", TURN, ""], ["{theta: 0.0}"]),
        (["node", "info", "/"], ["/robot"]),
        (["topic", "echo", "--field", ""], []),
        (["topic", "echo", "/open", "--field", "d"], ["data"]),
        (["topic", "echo", "/new", "geometry_msgs/msg/Twist", "--field", "linear."],
         ["linear.x", "linear.y", "linear.z"]),
        (["topic", "echo", "--once", "/o"], ["/open"]),
        (["topic", "echo", "--qos-depth", "5", "/o"], ["/open"]),
        (["topic", "find", "std_msgs/msg/Stri"], ["std_msgs/msg/String"]),
        (["service", "find", "std_srvs/srv/Trig"], ["std_srvs/srv/Trigger"]),
        (["interface", "proto", "turtlesim/action/"], [TURN]),
        (["pkg", "xml", "turtlesi"], ["turtlesim"]),
        (["topic", "echo", "/open", "std_msgs/msg/String", "more", ""], []),
    ],
)  # fmt: skip
def test_what_tab_offers(robot, words, offered):
    found = robot.complete(*words)
    assert [word for word in found if word not in ("/rosout", "/parameter_events")] == offered


def test_a_short_option_that_is_typed_needs_no_completion(machine):
    assert machine.complete("topic", "list", "-t") == []


def test_tab_is_silent_about_a_package_without_a_share_folder(machine, capsys):
    index = machine.cwd / "install" / "share" / "ament_index" / "resource_index" / "packages"
    index.mkdir(parents=True)
    (index / "bare").touch()
    machine.env["AMENT_PREFIX_PATH"] = str(machine.cwd / "install")
    assert machine.complete("launch", "bare", "") == []
    assert capsys.readouterr() == ("", "")


@pytest.mark.skipif(sys.platform == "win32", reason="the scripts of Windows have such names")
def test_an_executable_is_called_as_its_file(machine):
    index = machine.cwd / "install" / "share" / "ament_index" / "resource_index" / "packages"
    index.mkdir(parents=True)
    (index / "mine").touch()
    folder = machine.cwd / "install" / "lib" / "mine"
    (folder / ".hidden").mkdir(parents=True)
    for name, mode in (("b-script.py", 0o755), ("a", 0o755), ("no", 0o644), (".hidden/x", 0o755), ("c.exe", 0o755)):
        (folder / name).touch()
        (folder / name).chmod(mode)
    machine.env["AMENT_PREFIX_PATH"] = str(machine.cwd / "install")
    assert machine.ros2("pkg", "executables", "mine").stdout == "mine a\nmine b-script.py\nmine c.exe\n"


def test_only_packages_are_imported_for_a_service_type(machine):
    result = machine.ros2("service", "call", "/s", "xml.dom/minidom/Document")
    assert result.stderr == "The passed service type is invalid\n"


@pytest.mark.parametrize("answers", [True, False])
def test_a_service_that_fails_is_told_and_the_others_are_asked(machine, monkeypatch, answers):
    from day6_core.ros.ros2.lifecycle._services import LifecycleServices

    machine.run("lifecycle", "lifecycle_talker", "--ros-args", "-r", "__node:=a")
    machine.run("lifecycle", "lifecycle_talker", "--ros-args", "-r", "__node:=b")
    call = LifecycleServices.call

    async def failing(self, remote, service, kind, **fields):
        if remote == "/a" and (service != "get_available_transitions" or not answers):
            raise RuntimeError("broken")
        return await call(self, remote, service, kind, **fields)

    monkeypatch.setattr(LifecycleServices, "call", failing)
    told = "Exception while calling service of node '/a': broken\n"
    assert machine.ros2("lifecycle", "get") == ("/b: unconfigured [1]\n", told, 0)
    assert machine.ros2("lifecycle", "get", "/a") == ("", told, 1)
    assert machine.ros2("lifecycle", "set", "/a", "configure") == ("", told, 0 if answers else 1)
