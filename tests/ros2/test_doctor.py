"""`ros2 doctor` and `ros2 doctor hello`: what is complained of, what is reported, who is heard."""

from __future__ import annotations

import socket

import pytest
from std_msgs.msg import String

from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

BEST_EFFORT = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


@pytest.fixture(autouse=True)
def a_link_that_nobody_switched_off(monkeypatch):
    monkeypatch.delenv("DAY6_LINK", raising=False)


def talks(machine, qos=10, name="talker", topic="chatter"):
    machine.node(name, lambda node: node.create_publisher(String, topic, qos))


def listens(machine, qos=10, name="listener", topic="chatter"):
    machine.node(name, lambda node: node.create_subscription(String, topic, print, qos))


def warned(result):
    """The warnings, without the place in our source that comes first in each."""
    return [line.partition("UserWarning: ")[2] for line in result.stderr.splitlines() if "UserWarning" in line]


def block(report, title):
    """The rows of one report, as pairs."""
    rows = report.partition(f"\n   {title}\n")[2].split("\n   ", 1)[0].splitlines()
    return [tuple(part.strip() for part in row.split(":", 1)) for row in rows if row]


INCOMPATIBLE = (
    "ERROR: QoS compatibility error found on topic '/chatter': Best effort publisher and reliable subscription;"
)


def test_all_is_well_where_everybody_is_heard(machine):
    talks(machine)
    listens(machine)
    assert machine.ros2("doctor") == ("\nAll 3 checks passed\n\n", "", 0)


def test_profiles_that_do_not_fit_are_an_error(machine):
    talks(machine, BEST_EFFORT)
    listens(machine)
    result = machine.ros2("doctor")
    assert result.stdout == "\n1/3 check(s) failed\n\nFailed modules: middleware\n"
    assert warned(result) == [INCOMPATIBLE] and result.status == 0


def test_two_things_that_fail_are_both_named(machine):
    talks(machine, BEST_EFFORT)
    listens(machine)
    talks(machine, name="lonely", topic="alone")
    result = machine.ros2("doctor", "--include-warnings")
    assert "2/3 check(s) failed\n\nFailed modules: middleware topic\n" in result.stdout
    assert warned(result) == [INCOMPATIBLE, "Publisher without subscriber detected on /alone."]
    assert "1/3 check(s) failed\n\nFailed modules: middleware\n" in machine.ros2("doctor").stdout


@pytest.mark.parametrize(
    ("who", "text"),
    [
        (talks, "Publisher without subscriber detected on /chatter."),
        (listens, "Subscriber without publisher detected on /chatter."),
    ],
)
def test_who_is_alone_on_a_topic_is_warned_of_and_fails_only_when_asked_for(machine, who, text):
    who(machine)
    result = machine.ros2("doctor")
    assert result.stdout == "\nAll 3 checks passed\n\n" and warned(result) == [text]
    strict = machine.ros2("doctor", "-iw")
    assert "1/3 check(s) failed\n\nFailed modules: topic\n" in strict.stdout and warned(strict) == [text]


@pytest.mark.parametrize("reason", ["maybe", "WARNING: maybe", "Warning: maybe"])
def test_a_profile_that_may_not_fit_is_a_warning(machine, monkeypatch, reason):
    import rclpy.qos

    answer = (rclpy.qos.QoSCompatibility.WARNING, reason)
    monkeypatch.setattr(rclpy.qos, "qos_check_compatible", lambda *_: answer)
    talks(machine)
    listens(machine)
    result = machine.ros2("doctor")
    assert warned(result)[0] == "QoS compatibility warning found on topic '/chatter': maybe"
    assert "All 3 checks passed" in result.stdout
    assert "Failed modules: middleware\n" in machine.ros2("doctor", "-iw").stdout
    assert ("compatibility status", reason) in block(machine.ros2("doctor", "-r").stdout, "QOS COMPATIBILITY LIST")


def test_no_line_names_a_file_of_ours(machine):
    talks(machine)
    result = machine.ros2("doctor")
    assert result.stderr.startswith("UserWarning: Publisher without subscriber detected on ")
    assert ".py" not in result.stdout + result.stderr + machine.ros2("doctor", "--report").stdout


def test_only_the_reports_of_what_failed_are_printed_when_asked_for(machine):
    talks(machine, BEST_EFFORT)
    listens(machine)
    text = machine.ros2("doctor", "--report-failed").stdout
    titles = [line.strip() for line in text.splitlines() if line.startswith("   ")]
    assert titles == ["QOS COMPATIBILITY LIST", "RMW MIDDLEWARE"]
    assert machine.ros2("doctor", "-rf", "-ep").stdout == text
    machine_of_nobody = machine.ros2("doctor", "--report", "-ep").stdout
    assert "PACKAGE VERSIONS" not in machine_of_nobody and "PLATFORM INFORMATION" in machine_of_nobody


def test_the_report_lists_pairs_and_counts(machine):
    talks(machine, LATCHED)
    listens(machine)
    listens(machine, LATCHED, name="second")
    report = machine.ros2("doctor", "--report").stdout
    pairs = block(report, "QOS COMPATIBILITY LIST")
    chatter = [pairs[at : at + 4] for at in range(0, len(pairs), 4) if pairs[at][1].startswith("/chatter ")]
    assert [[value for _, value in pair] for pair in chatter] == [
        ["/chatter [std_msgs/msg/String]", "talker", name, "OK"] for name in ("listener", "second")
    ]
    assert [name for name, _ in pairs[:4]] == [
        "topic [type]",
        "publisher node",
        "subscriber node",
        "compatibility status",
    ]
    topics = block(report, "TOPIC LIST")
    assert topics == [("topic", "/chatter"), ("publisher count", "1"), ("subscriber count", "2")]


def test_the_report_of_an_empty_graph_says_none(machine):
    report = machine.ros2("doctor", "--report").stdout
    assert block(report, "TOPIC LIST") == [("topic", "none"), ("publisher count", "0"), ("subscriber count", "0")]
    assert "compatibility status" in report
    assert block(report, "RMW MIDDLEWARE")[0][0] == "middleware name"


def test_rows_are_as_wide_as_the_longest_name_and_four(machine):
    report = machine.ros2("doctor", "--report").stdout
    rows = report.partition("\n   TOPIC LIST\n")[2].splitlines()
    assert rows[0] == f"{'topic':20}: none", "subscriber count has 16 letters"


@pytest.mark.parametrize(
    ("env", "rows"),
    [
        ({}, []),
        ({"ROS_DISTRO": "Jazzy"}, [("distribution name", "jazzy"), ("distribution type", "ros2")]),
        ({"ROS_DISTRO": "x", "ROS_VERSION": "1"}, [("distribution name", "x"), ("distribution type", "ros1")]),
    ],
)
def test_the_distribution_is_that_of_the_environment(machine, env, rows):
    machine.env.update(env)
    assert block(machine.ros2("doctor", "--report").stdout, "ROS 2 INFORMATION") == rows


def test_versions_are_those_of_the_manifests(machine):
    share = machine.cwd / "install" / "share"
    for name, manifest in (("lab", "<package><version> 1.2.3\n</version></package>"), ("bad", "<pack"), ("no", None)):
        marker = share / "ament_index" / "resource_index" / "packages" / name
        marker.parent.mkdir(parents=True, exist_ok=True)
        marker.touch()
        (share / name).mkdir()
        if manifest:
            (share / name / "package.xml").write_text(manifest)
    machine.env["AMENT_PREFIX_PATH"] = str(machine.cwd / "install")
    rows = dict(block(machine.ros2("doctor", "--report").stdout, "PACKAGE VERSIONS"))
    assert rows["lab"] == "latest=N/A, local=1.2.3"
    assert rows["bad"] == rows["no"] == "latest=N/A, local="


def test_a_link_that_is_switched_off_is_warned_of(machine, monkeypatch):
    monkeypatch.setenv("DAY6_LINK", "off")
    assert warned(machine.ros2("doctor")) == ["The link to other programs is switched off (DAY6_LINK=off)."]
    assert "Failed modules: network\n" in machine.ros2("doctor", "-iw").stdout


# -- hello -------------------------------------------------------------------------------------------------------------


class Network:
    """Multicast that goes to the test instead: keeps what was sent, gives what `arrives`."""

    def __init__(self, monkeypatch):
        from day6_core.ros.ros2.doctor import hello

        self.sent = []
        self.arrives = []
        monkeypatch.setattr(hello, "send", lambda *words: self.sent.append(words))
        monkeypatch.setattr(hello, "member", lambda *words: self)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        pass

    def recvfrom(self, size):
        if not self.arrives:
            raise BlockingIOError
        return self.arrives.pop(0)[:size], ("1.2.3.4", 5)


@pytest.fixture
def network(monkeypatch):
    return Network(monkeypatch)


def table(emitted, heard=(), received=(), topic="/canyouhearme", period="1.0"):
    def rows(counts):
        return "".join(
            f"{'':15} {name:<20} {count:<10}\n" for name, count in [("Hostname", f"Msg Count /{period}s"), *counts]
        )

    return (
        f"MULTIMACHINE COMMUNICATION SUMMARY\nTopic: {topic}, Published Msg Count: {emitted}\nSubscribed from:\n"
        f"{rows(heard)}Multicast Group/Port: 225.0.0.1/49150, Sent Msg Count: {emitted}\nReceived from:\n"
        f"{rows(received)}{'-' * 60}\n"
    )


def test_hello_counts_other_machines_on_both_ways(machine, network):
    host = socket.gethostname()
    network.arrives += [b"hello, it's me far", b"hello, it's me far", f"hello, it's me {host}".encode(), b"", b"\xff"]
    said = [""]

    def neighbour(node):
        node.publisher = node.create_publisher(String, "/canyouhearme", 10)
        node.create_timer(0.05, lambda: node.publisher.publish(String(data=said[0])))

    machine.node("neighbour", neighbour)
    hello = machine.start("doctor", "hello", "-pp", "0.65")
    for said[0] in ("hello, it's me near", f"hello, it's me {host}", " "):
        hello.step(0.2)
    hello.step(0.12)
    near = next(line for line in hello.stdout.splitlines() if " near " in line)
    assert near.split()[1] in ("2", "3")
    assert hello.stdout.endswith(f"{'':15} {'far':<20} {2:<10}\n{'':15} {chr(0xFFFD):<20} {1:<10}\n{'-' * 60}\n")
    assert f" {host} " not in hello.stdout
    assert network.sent[0] == (f"hello, it's me {host}".encode(), "225.0.0.1", 49150, None)
    hello.interrupt()


def test_hello_once_ends_after_one_period(machine, network):
    hello = machine.start("doctor", "hello", "--once", "-ep", "0.5")
    hello.step(0.49)
    assert (hello.status, hello.stdout) == (None, "")
    hello.step(0.02)
    assert (hello.status, hello.stdout) == (0, table(1))


def test_hello_goes_on_at_its_periods_and_counts_anew_after_each_table(machine, network):
    hello = machine.start("doctor", "hello", "-ep", "0.25", "-pp", "2", "-t", "/here", "--ttl", "3")
    hello.step(1.9)
    assert hello.stdout == ""
    hello.step(0.5)
    assert hello.stdout == table(9, topic="/here", period="2.0")
    hello.step(2.25)
    assert hello.stdout == table(9, topic="/here", period="2.0") * 2
    assert {words[3] for words in network.sent} == {3}
    assert "/here\n" in machine.ros2("topic", "list").stdout
    hello.interrupt()
    assert hello.status == 0


@pytest.mark.parametrize(
    "words", [["-ep", "0"], ["-pp", "x"], ["--emit-period=-1"], ["--ttl", "0"], ["--ttl", "1.5"], ["--ttl", "x"]]
)
def test_periods_and_ttl_must_be_positive(machine, words):
    result = machine.ros2("doctor", "hello", *words)
    assert result.status == 2
    assert result.stderr.endswith(": value must be a positive {type_.__name__}\n")


def test_the_node_that_says_hello_is_named_after_this_machine(machine, network):
    import re

    hello = machine.start("doctor", "hello")
    host = re.sub("[^0-9a-zA-Z_]", "_", socket.gethostname())
    assert f"/ros2doctor_{host}_{hello.session.pid}_node\n" in machine.ros2("node", "list").stdout
    hello.interrupt()


def test_what_is_wrong_with_the_link_is_complained_of_and_reported(machine, monkeypatch):
    from types import SimpleNamespace

    from day6_core.ros.programs.day6_inspector import rules

    found = [SimpleNamespace(level="warning", text="a door is shut"), SimpleNamespace(level="error", text="no link")]
    monkeypatch.setattr(rules, "link_findings", lambda state: found)
    result = machine.ros2("doctor")
    assert warned(result) == ["a door is shut", "ERROR: no link"]
    assert "Failed modules: network\n" in result.stdout
    rows = block(machine.ros2("doctor", "--report").stdout, "NETWORK CONFIGURATION")
    assert rows[:2] == [("link", "a door is shut"), ("link", "no link")]
    del found[1]
    assert "All 3 checks passed" in machine.ros2("doctor").stdout
