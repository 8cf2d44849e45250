"""Cards: files are read strictly, healthy output has none, and what is filled in cannot become a command."""

from __future__ import annotations

import json
import re
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from day6_core.advice.card_files import (
    FOLDER,
    TOPICS,
    CardError,
    all_cards,
    finding_cards,
    read_topic,
    topics,
)
from day6_core.advice.explain import LOOKERS, as_text, explain, explanation_of_card, scene_of, wrapped
from day6_core.advice.matching import Match, card_for, cards_in, forms, plain_lines, sightings
from day6_core.advice.rules import Surroundings
from day6_core.facts.graph import GraphFacts
from day6_core.language import LANGUAGES
from day6_core.ros.distribution import NAMES
from day6_core.width import text_width
from tests.support.folded import folded

GOLDEN = Path(__file__).parents[1] / "conformance" / "golden"
HERE = Surroundings({"HOME": "/nowhere"}, Path("/nowhere"))

CARD = """# 主题 | Topic

## a-card
- says: `no {name} here`
- same

**zh** 没有 {name}。

**en** There is no {name}.
"""


def test_every_file_is_a_topic_and_every_topic_a_file() -> None:
    assert {path.stem for path in FOLDER.iterdir()} == set(TOPICS) == topics().keys()


def test_cards_have_names_of_their_own_and_lookers_that_exist() -> None:
    cards = list(all_cards())
    names = [card.id for card in cards]
    assert sorted(names) == sorted(set(names)) and len(names) > 150
    used = {name for card in cards for name in card.look}
    assert used <= LOOKERS.keys(), used - LOOKERS.keys()
    assert LOOKERS.keys() <= used, "a looker that no card asks"


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_card_can_be_shown_by_itself_in_any_width(language: str) -> None:
    for card in all_cards():
        text = as_text(explanation_of_card(card, language), language, 60)
        assert max(map(text_width, text.split("\n"))) <= 60, card.id
        assert "{" not in re.sub(r"\{[^}]*:[^}]*\}|\$\{\S*|\{ \}|\{\{", "", text).replace("{x}", ""), card.id
        chinese = re.search(r"[\u4e00-\u9fff]", card.words[language].first)
        assert (chinese is not None) == (language == "zh"), card.id
        assert "\u3002" not in card.words["en"].first


@pytest.mark.parametrize(
    ("text", "line", "reason"),
    [
        ("no title", 1, "the first line has to be"),
        (CARD.replace("## a-card", "## A Card"), 3, "a card begins with"),
        (CARD.replace("- says: `no {name} here`\n", ""), 3, "matches nothing"),
        (CARD.replace("`no {name} here`", "no {name} here"), 4, "stands between `"),
        (CARD.replace("- says", "- match").replace("no {name} here", "no ("), 4, "not a regular expression"),
        (CARD.replace("- same\n", ""), 3, "about a real robot"),
        (CARD.replace("**en** There is no {name}.", ""), 3, "says nothing in 'en'"),
        (CARD.replace("no {name}.\n", "no {nmae}.\n"), 3, "fills in nmae"),
        (CARD.replace("**en** There", "**en** {There"), 3, "a brace is written twice"),
        (CARD + "1. check\n", 3, "says less in one language"),
        (CARD + "2. check\n", 10, "the next check has the number 1"),
        (CARD.replace("- same", "- smae"), 5, "expected says, match"),
        (CARD.replace("- same", "- same\n- look: package"), 3, "needs checks"),
        (CARD + "\n**en** Again.\n", 11, "once"),
        (CARD.replace("- same", "- same\n- finding: no_name"), 6, "a level and a key"),
        (CARD.replace("- same", "- same\n- finds: `no (`"), 6, "not a regular expression"),
        (CARD + "! {name}: wrong\n", 3, "says less in one language"),
        (CARD + "! {name}: wrong\nmore\n", 11, "nothing comes after the finding"),
        (CARD.replace("## a-card", "stray"), 3, "text before the first card"),
    ],
)
def test_a_card_that_is_not_right_is_refused_with_its_line(tmp_path: Path, text: str, line: int, reason: str) -> None:
    path = tmp_path / "x.md"
    path.write_text(CARD, encoding="utf-8")
    assert [card.id for card in read_topic(path)[1]] == ["a-card"]
    path.write_text(text, encoding="utf-8")
    with pytest.raises(CardError, match=re.escape(reason)) as caught:
        read_topic(path)
    assert caught.value.line == line and f"x.md, line {line}:" in str(caught.value)


FAULTS = {
    # The texts of beginner-faults.md that have one -> the card. The others make no sound: the inspector names them.
    "Package 'x' not found": "package-not-found",
    "ros2: command not found": "ros-command-not-found",
    "bash: ros2: command not found": "ros-command-not-found",
    "bash: mkdri: command not found": "command-not-found",
    "No executable found": "executable-not-found",
    "file 'x.launch.py' was not found in the share directory of package 'y' which is at '/w/share/y'": "launch-file-not-found",
    "ModuleNotFoundError: No module named 'rclpy._rclpy_pybind11'": "rclpy-other-python",
    "The C extension '/opt/ros/_rclpy_pybind11.so' isn't present on the system. Please refer to": "rclpy-other-python",
    "ModuleNotFoundError: No module named 'rclpy'": "rclpy-missing",
    "/usr/lib/x.py:34: SetuptoolsDeprecationWarning: setup.py install is deprecated.": "setup-install-deprecated",
    "[0.4s] ERROR:colcon:colcon build: Duplicate package names not supported:": "duplicate-package-names",
    "[0.368s] WARNING:colcon.colcon_ros.prefix_path.ament:The path '/w/install/x' in the environment variable "
    "AMENT_PREFIX_PATH doesn't exist": "prefix-path-missing",
    "[WARN] [1.2] [n]: New publisher discovered on topic '/x', offering incompatible QoS. No messages will be received from it. "
    "Last incompatible policy: RELIABILITY": "qos-incompatible",
    "Cannot echo topic '/x', as it contains more than one type: [a/msg/B, c/msg/D]": "topic-two-types",
    "The passed message type is invalid": "message-type-invalid",
    "The message type 'p/msg/T' is invalid": "message-type-invalid",
    "Failed to populate field: 'Twist' object has no attribute 'x'": "field-not-populated",
    "The passed value needs to be a dictionary in YAML format": "value-no-dictionary",
    "AttributeError: 'Talker' object has no attribute '_Node__logger'": "super-init-missing",
    "rclpy.exceptions.NotInitializedException: ('rclpy.init() has not been called', 'x')": "rclpy-not-initialised",
    "AttributeError: module 'rclpy' has no attribute 'node'": "part-of-rclpy-not-imported",
    "TypeError: Node.create_publisher() missing 1 required positional argument: 'qos_profile'": "queue-length-missing",
    "TypeError: Expected <class 'std_msgs.msg._string.String'>, got <class 'str'>": "not-a-message",
    "AssertionError: The 'x' field must be of type 'float'": "field-must-be-float",
    "AttributeError: 'Twist' object has no attribute 'liner'": "attribute-missing",
    "RuntimeError: Subscription.__init__(): callback should be either be callable with one argument(to get": "callback-called",
    "KeyboardInterrupt": "ctrl-c",
    "rclpy._rclpy_pybind11.RCLError: failed to shutdown: rcl_shutdown already called on the given context": "shutdown-twice",
    "[WARN] [1.2] [rcl.logging_rosout]: Publisher already registered for node name: 'a'. If this is due to": "node-name-shared",
    "WARNING: Be aware that there are nodes in the graph that share an exact name, which can have": "node-name-shared",
    "rclpy.exceptions.ParameterNotDeclaredException: ('Invalid access to undeclared parameter(s)'): x": "parameter-not-declared",
    "rclpy.exceptions.InvalidParameterTypeException: Trying to set parameter 'x': Wrong parameter type, expected "
    "'Type.DOUBLE' got 'Type.INTEGER'": "parameter-type-wrong",
    "Setting parameter failed: Wrong parameter type, expected 'Type.DOUBLE' got 'Type.INTEGER'": "parameter-not-set",
    "waiting for service to become available...": "service-waiting",
    "Waiting for an action server to become available...": "action-waiting",
    "Goal was rejected.": "goal-rejected",
    '"X" passed to lookupTransform argument target_frame does not exist. ': "tf-frame-unknown",
    "Lookup would require extrapolation into the future.  Requested time 2 but the latest data is at time 1": "tf-extrapolation",
    "Frame [map] does not exist": "tf-frame-unknown",
    "No transform from [wheel] to [base_link]": "rviz-no-transform",
    "[WARN] [1.2] [rmw_zenoh_cpp]: Unable to connect to a Zenoh router. Have you started a router with `ros2 run": "zenoh-router",
}  # fmt: skip


@folded("line, card", FAULTS.items())
def test_the_texts_of_the_beginner_faults_have_their_cards(line: str, card: str) -> None:
    match = card_for(line)
    assert match is not None and match.card.id == card
    assert explain(match, scene_of(match, HERE), "zh").means


def test_a_package_that_python_does_not_find_is_named_and_not_its_message() -> None:
    match = card_for("importlib.metadata.PackageNotFoundError: No package metadata was found for day6_publisher")
    assert match is not None
    shown = explain(match, scene_of(match, HERE), "zh")
    assert "没有叫 day6_publisher 的包" in as_text(shown, "zh", 200)
    assert match.values["name"] == "day6_publisher"


def test_a_line_is_known_with_anything_before_it() -> None:
    plain = "ModuleNotFoundError: No module named 'rclpy'"
    for line in (
        plain,
        f"[talker-1] {plain}",
        f" - {plain}",
        f"\x1b[31m{plain}\x1b[0m\r",
        f"[talker-1] [ERROR] [1.5] [n]: {plain}",
    ):
        [match] = list(cards_in(line + "\n"))
        assert match.card.id == "rclpy-missing", line
    assert forms("[ERROR] [launch]: Caught exception in launch (see debug for traceback): x")[-1] == "x"


def recorded(file: str) -> list[tuple[str, str, int]]:
    """Name, standard error and status of what was recorded from the real tools."""
    found = []
    for line in (GOLDEN / file).read_text(encoding="utf-8").splitlines():
        case = json.loads(line)
        status = case.get("exit_code", case.get("returncode", 0))
        text = re.sub(r"<(?:TIME|SECS|PID)>", "1.5", case.get("stderr") or "").replace("[1.5] WARN", "[1.5s] WARN")
        found.append((case.get("name", ""), re.sub(r"\[1\.5\] ERROR", "[1.5s] ERROR", text), status))
    return found


@pytest.mark.parametrize("file", ["ros2cli.jsonl", "colcon.jsonl", "check_urdf.jsonl", "rclpy_behaviour.jsonl"])
def test_what_the_real_tools_say_when_they_fail_has_a_card(file: str) -> None:
    failed = [(name, text) for name, text, status in recorded(file) if status not in (0, 130) and text.strip()]
    assert failed
    without = [(name, text) for name, text in failed if not any(map(card_for, plain_lines(text)))]
    assert not without, without


def test_output_that_tells_of_no_trouble_has_no_card() -> None:
    healthy = [
        case["stdout"]
        for file in ("ros2cli.jsonl", "colcon.jsonl")
        for case in map(json.loads, (GOLDEN / file).read_text(encoding="utf-8").splitlines())
        if case.get("exit_code", case.get("returncode", 0)) == 0 and not (case.get("stderr") or "").strip()
    ]
    lines = {line for text in healthy for line in plain_lines(text)}
    assert len(lines) > 1000
    said_on_purpose = (
        "does not appear to be published",
        "Waiting",
        "Unknown license",
        "Goal was rejected",
        "daemon",
        "waiting",
        "has died",
        " 0 packages finished",
    )
    lines = {line for line in lines if not any(each in line for each in said_on_purpose)}
    told = {line: match.card.id for line in lines if (match := card_for(line)) is not None}
    assert told == {}, list(told.items())


def test_what_is_filled_in_cannot_become_a_command_or_a_control_character() -> None:
    match = card_for("Unknown topic '/a; rm -rf ~ $(x)'") or card_for("x")
    assert match is not None
    two = card_for("Cannot echo topic '/a; rm -rf ~ $(x)', as it contains more than one type: [a, b]")
    assert two is not None
    shown = explain(two, scene_of(two, HERE), "en")
    assert shown.next == "ros2 topic info -v '/a; rm -rf ~ $(x)'"
    evil = card_for("Package 'a\x1b]0;x\x07\u202eb' not found")
    assert evil is not None
    text = as_text(explain(evil, scene_of(evil, HERE), "zh"), "zh", 80)
    assert all(line.isprintable() for line in text.split("\n")) and "^[" in text
    newline = card_for("Cannot echo topic '/a\x0b/b', as it contains more than one type: [a, b]")
    assert newline is not None and explain(newline, scene_of(newline, HERE), "en").next == ""


@pytest.mark.parametrize("name", NAMES)
def test_topics_to_record_are_put_behind_their_option_where_it_is_needed(
    name: str, in_distribution: Callable[[str], None]
) -> None:
    in_distribution(name)
    match = card_for("ros2: error: unrecognized arguments: /a /b")
    assert match is not None
    shown = explain(match, scene_of(match, HERE, command="ros2 bag record -o mine /a /b"), "en")
    right = "ros2 bag record -o mine --topics /a /b"
    assert (shown.here, shown.next) == (
        ("Since Lyrical, the topics to record come after --topics", right)
        if name in ("lyrical", "rolling")
        else ("", "")
    )


@pytest.mark.parametrize(
    ("typed", "right"),
    [
        ("/a --on-change", "ros2 topic echo /a --csv | uniq"),
        (
            "--csv /a std_msgs/msg/Int32 --field data --on-changes",
            "ros2 topic echo /a std_msgs/msg/Int32 --field data --csv | uniq",
        ),
        ("/a --on-chance", ""),
    ],
)
def test_who_wants_changes_only_gets_a_line_that_shows_them(typed: str, right: str) -> None:
    match = card_for(f"ros2: error: unrecognized arguments: {typed.split()[-1]}")
    assert match is not None
    shown = explain(match, scene_of(match, HERE, command=f"ros2 topic echo {typed}"), "en")
    assert shown.next == right and ("uniq" in shown.here) == bool(right)


def test_nobody_says_to_know_a_cause_that_was_not_found(tmp_path: Path) -> None:
    around = Surroundings({"HOME": str(tmp_path), "ROS_DISTRO": "jazzy"}, tmp_path)
    match = card_for("Package 'zzqy' not found")
    assert match is not None
    shown = explain(match, scene_of(match, around), "en")
    assert shown.here == "" and len(shown.checks) == 3
    text = as_text(shown, "en", 80)
    assert "I could not find the cause here; check in this order:\n  1. Is the name right?" in text
    assert "我在这里没有找到原因，请按顺序检查：" in as_text(explain(match, scene_of(match, around), "zh"), "zh", 80)


@pytest.mark.parametrize(
    "odd", ["\0", "a" * 5000, "/root/x/y", "[*", "\ud800", "..", "/", "~nobody", "a/b/c", "'", "\u202e", "%s{x}"]
)
def test_no_looker_stumbles_over_an_odd_name(tmp_path: Path, odd: str) -> None:
    names = ("name", "package", "share", "type", "path", "variable", "fixed")
    for card in all_cards():
        if not card.look:
            continue
        match = Match("Error: x", card, dict.fromkeys((*names, *map(str, range(4))), odd))
        for graph in (None, GraphFacts(nodes=("/a", "/a"))):
            around = Surroundings({"HOME": str(tmp_path), "ROS_DISTRO": "jazzy"}, tmp_path)
            scene = scene_of(match, around, command=f"ros2 run {odd} {odd} {odd}", graph=graph, commands=["ls", odd])
            for language in LANGUAGES:
                shown = explain(match, scene, language)
                assert shown.next.isprintable()
                assert all(line.isprintable() for line in as_text(shown, language, 40).split("\n")), card.id


def test_a_text_is_broken_between_words_and_chinese_characters() -> None:
    assert wrapped("one two three", 8) == ["one two", "three"]
    assert (
        wrapped("包名，拼对了吗？", 6) == ["包名，", "拼对了", "吗？"] or wrapped("包名，拼对了吗？", 6)[0] == "包名，"
    )
    assert all(text_width(line) <= 10 for line in wrapped("a" * 35 + "中" * 9 + "（括号里面）", 10))
    assert (
        "".join(wrapped("在 ROS 2 里，`ros2 topic list` 列出话题", 12)).replace(" ", "")
        == "在ROS2里，`ros2topiclist`列出话题"
    )


def test_ten_times_as_long_a_word_takes_ten_times_as_long() -> None:
    match = Match("x", next(iter(all_cards())), {})

    def time_of(length: int) -> float:
        scene = scene_of(match, HERE, command="a" * length)
        times = []
        for _ in range(5):
            start = time.thread_time()
            assert LOOKERS["unquoted"](scene) is None
            times.append(time.thread_time() - start)
        return min(times)

    assert time_of(20_000) < max(40 * time_of(2_000), 0.02)  # the tick of this clock on Windows


def test_a_finding_has_one_sentence_and_is_seen_anywhere_in_a_line(tmp_path: Path) -> None:
    said = {card.finding for card in all_cards() if card.finding}
    assert said == finding_cards().keys() and len(said) > 30
    path = tmp_path / "x.md"
    finds = "- same\n- finding: error no_name\n- finds: `no (?P<name>\\w+) at`"
    path.write_text(CARD.replace("- same", finds) + "! {name}: {first}\n", encoding="utf-8")
    with pytest.raises(CardError, match="says less"):
        read_topic(path)
    text = CARD.replace("- same", finds).replace("\n\n**en**", "\n! {name}：{first}\n\n**en**") + "! {name}: {first}\n"
    path.write_text(text, encoding="utf-8")
    (card,) = read_topic(path)[1]
    assert (card.level, card.finding, card.finding_next) == ("error", "no_name", "")
    assert card.words["en"].finding == "{name}: There is no {name}."
    assert [(seen.values["name"], seen.rest) for seen in sightings(card, "x: no sun at all\nmore\nno moon at\n")] == [
        ("sun", "more\nno moon at\n"),
        ("moon", ""),
    ]
    card.finds = ()
    assert [seen.line for seen in sightings(card, "[a-1] no sun here\nx no moon here")] == ["[a-1] no sun here"]
