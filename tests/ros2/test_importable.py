"""What programs and other packages' extensions import of ros2cli and its sisters, and that it works in their process.

Upstream's own tests of it are played by hand (tests/conformance/upstream).
"""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from importlib import import_module

import pytest

import rclpy
from day6_core.ros.environment import activate
from day6_core.ros.ros2.cli.tree import command_names, verb_names

activate()

NAMES = {
    "ros2action.api": "get_action_names get_action_names_and_types get_action_clients_and_servers action_name_completer",
    "ros2cli.cli": "main",
    "ros2cli.command": "CommandExtension add_subparsers add_subparsers_on_demand",
    "ros2cli.entry_points": "get_entry_points load_entry_points get_first_line_doc",
    "ros2cli.helpers": "bind before_invocation collect_stdin get_ros_domain_id pretty_print_call unsigned_int wait_for",
    "ros2cli.node": "NODE_NAME_PREFIX",
    "ros2cli.node.daemon": "DaemonNode is_daemon_running shutdown_daemon spawn_daemon",
    "ros2cli.node.direct": "DEFAULT_TIMEOUT DirectNode add_arguments",
    "ros2cli.node.strategy": "DirectNode NodeStrategy add_arguments",
    "ros2cli.plugin_system": "PLUGIN_SYSTEM_VERSION PluginException instantiate_extensions satisfies_version",
    "ros2cli.qos": "add_qos_arguments profile_configure_short_keys qos_profile_from_short_keys",
    "ros2cli.verb": "VerbExtension get_verb_extensions",
    "ros2component.api": "find_container_node_names get_components_in_container get_package_component_types "
    "load_component_into_container unload_component_from_container",
    "ros2doctor.api": "DoctorCheck DoctorReport Report Result generate_reports run_checks",
    "ros2doctor.api.format": "doctor_error doctor_warn format_print",
    "ros2doctor.api.topic": "TopicCheck TopicReport",
    "ros2doctor.verb.hello": "HelloVerb SummaryTable",
    "ros2interface.api": "interface_to_yaml package_name_completer type_completer",
    "ros2lifecycle.api": "call_change_states call_get_available_transitions call_get_states get_node_names",
    "ros2multicast.api": "DEFAULT_GROUP DEFAULT_PORT receive send",
    "ros2node.api": "INFO_NONUNIQUE_WARNING_TEMPLATE NodeName NodeNameCompleter TopicInfo get_absolute_node_name "
    "get_node_names get_publisher_info get_service_server_info get_subscriber_info has_duplicates parse_node_name",
    "ros2param.api": "ParameterNameCompleter call_describe_parameters call_get_parameters call_list_parameters "
    "call_set_parameters get_parameter_type_string get_value load_parameter_file",
    "ros2pkg.api": "PackageNotFound get_executable_paths get_package_names get_prefix_path package_name_completer",
    "ros2run.api": "ExecutableNameCompleter MultipleExecutables get_executable_path run_executable",
    "ros2service.api": "ServiceNameCompleter get_service_class get_service_names get_service_names_and_types",
    "ros2topic.api": "TopicNameCompleter add_qos_arguments get_msg_class get_topic_names get_topic_names_and_types "
    "message_type_completer positive_float positive_int qos_profile_from_short_keys unsigned_int",
}


@pytest.mark.parametrize("module", NAMES)
def test_the_names_are_there(module):
    found = import_module(module)
    assert [name for name in NAMES[module].split() if not hasattr(found, name)] == []


OURS = ("bag", "launch", "security", "extension_points", "extensions")
"""Commands whose packages are not among these."""


@pytest.mark.parametrize("command", [each for each in command_names() if each not in OURS and each != "wtf"])
def test_every_verb_is_a_class_in_a_module_of_its_name(command):
    package = "ros2cli.verb.daemon" if command == "daemon" else f"ros2{command}.verb"
    for verb in verb_names(command):
        title = "".join(map(str.capitalize, verb.split("_"))) + "Verb"
        made = getattr(import_module(f"{package}.{verb}"), title)()
        parser = ArgumentParser()
        made.add_arguments(parser, f"ros2 {command} {verb}")
        assert made.__doc__
        assert type(made).__module__ == f"{package}.{verb}"


def test_there_are_no_verbs_but_the_real_ones():
    for name in ("ros2topic.verb.nothing", "ros2topic.verb._filter", "ros2topic.command.node", "ros2nothing.verb.echo"):
        with pytest.raises(ModuleNotFoundError, match=name.rpartition(".")[0].partition(".")[0]):
            import_module(name)


def test_a_verb_runs_with_what_its_caller_gives_and_returns_the_error(capsys):
    from ros2topic.verb.info import InfoVerb
    from ros2topic.verb.list import ListVerb

    assert InfoVerb().main(args=Namespace(topic_name="/nowhere")) == "Unknown topic '/nowhere'"
    assert ListVerb().main(args=Namespace(no_daemon=True)) is None
    assert capsys.readouterr().out == "/parameter_events\n/rosout\n"


def test_a_verb_sees_the_programs_own_nodes_and_leaves_them_alone(capsys):
    from ros2node.verb.list import ListVerb

    with rclpy.init(args=[]):
        node = rclpy.create_node("here", namespace="/some")
        assert ListVerb().main(args=Namespace()) is None
        assert capsys.readouterr().out == "/some/here\n"
        assert node.get_fully_qualified_name() == "/some/here", "it is still there"
        assert rclpy.ok()


def test_a_direct_node_answers_and_its_context_ends_with_it():
    from ros2cli.node.direct import DirectNode
    from ros2node.api import get_node_names, get_publisher_info
    from ros2topic.api import get_msg_class, get_topic_names

    with DirectNode(Namespace(node_name_suffix="_test")) as node:
        assert [each.full_name for each in get_node_names(node=node, include_hidden_nodes=True)] == ["/_ros2cli_test"]
        assert get_node_names(node=node) == []
        assert get_topic_names(node=node) == ["/parameter_events", "/rosout"]
        assert get_msg_class(node, "/rosout").__name__ == "Log"
        assert get_publisher_info(node=node, remote_node_name="/_ros2cli_test")[0].name == "/parameter_events"
    assert not rclpy.ok()


def test_another_packages_report_and_verb_come_from_its_entry_points(monkeypatch):
    from importlib.metadata import EntryPoint

    from ros2cli import entry_points
    from ros2doctor.api import DoctorReport, Report, generate_reports

    class Mine(DoctorReport):
        def category(self) -> str:
            return "mine"

        def report(self) -> Report:
            made = Report("MINE")
            made.add_to_report("answer", 42)
            return made

    class Point(EntryPoint):
        def load(self):
            return Mine

    monkeypatch.setattr(
        entry_points, "entry_points", lambda group: [Point("mine", "x:Mine", group)] if "report" in group else []
    )
    (found,) = generate_reports(categories=["mine"])
    assert (found.name, found.items) == ("MINE", [("answer", 42)])


def test_a_check_of_the_doctor_counts_what_it_finds(recwarn):
    from ros2doctor.api.topic import TopicCheck, TopicReport
    from std_msgs.msg import String

    with rclpy.init(args=[]):
        node = rclpy.create_node("talker")
        node.create_publisher(String, "chatter", 10)
        result = TopicCheck().check()
        assert (result.error, result.warning) == (0, 1)
        assert [str(each.message) for each in recwarn] == ["Publisher without subscriber detected on /chatter."]
        assert TopicReport().report().items == [
            ("topic", "/chatter"),
            ("publisher count", 1),
            ("subscriber count", 0),
        ]


@pytest.mark.parametrize(
    ("version", "wanted", "fits"),
    [
        ("0.1", "^0.1", True),
        ("0.2", "^0.1", False),
        ("1.4", "^1.2", True),
        ("2.0", "^1.2", False),
        ("0.1", "~1", False),
    ],
)
def test_versions_of_extension_points(version, wanted, fits):
    from ros2cli.plugin_system import PluginException, satisfies_version

    if fits:
        satisfies_version(version, wanted)
        return
    with pytest.raises(PluginException):
        satisfies_version(version, wanted)
