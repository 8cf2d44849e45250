"""The recorded cases of the real `ros2`, and what is compared of them."""

from __future__ import annotations

import json
import os
import re
from dataclasses import dataclass
from pathlib import Path

GOLDEN = Path(__file__).with_name("golden")
CASES_FILE = GOLDEN / "ros2cli.jsonl"
EXCEPTIONS_FILE = Path(__file__).with_name("exceptions.json")

STEPS_BEFORE: dict[str, list[list[str]]] = {
    "lc_set_wrong": [["ros2", "lifecycle", "set", "/lc_talker", "configure"]],
    "daemon_status_debug": [["ros2", "daemon", "start", "--debug"]],
    "ts_spawn_same": [["ros2", "service", "call", "/spawn", "turtlesim/srv/Spawn", "{x: 3.0, y: 4.0, name: kame}"]],
}
"""Half of the recording is kept apart; these cases follow one of that half, which is played first."""


@dataclass(frozen=True)
class Case:
    """One recorded command. `interrupt_after` is in seconds, None where the command ended by itself."""

    name: str
    nodes: tuple[str, ...]
    daemon: bool
    argv: list[str]
    stdin: str
    stdout: str
    stderr: str
    exit_code: int
    interrupt_after: float | None


def load_cases() -> list[Case]:
    """Read all cases."""
    lines = CASES_FILE.read_text(encoding="utf-8").splitlines()
    return [_case(json.loads(line)) for line in lines]


def _case(row: dict) -> Case:
    interrupt = row.get("interrupt")
    setup = row["setup"]
    return Case(
        name=row["name"],
        nodes=tuple(each for each in setup if not each.startswith("(") and each != "daemon running"),
        daemon="daemon running" in setup,
        argv=row["argv"],
        stdin=row.get("stdin") or "",
        stdout=row["stdout"],
        stderr=row["stderr"],
        exit_code=row["exit_code"],
        # A recording that ran into its own time limit is cut short; all it says is one line again and again.
        interrupt_after=interrupt["after_s"] if interrupt else 1.5 if row.get("timed_out") else None,
    )


def load_exceptions() -> dict[str, str]:
    """Return `{case: why it differs}`."""
    return json.loads(EXCEPTIONS_FILE.read_text(encoding="utf-8"))


# -- what is masked ----------------------------------------------------------------------------------------------------

_MASKS: list[tuple[str, str]] = [
    # stamps, numbers of processes and endpoints
    (r"\[\d{9,}\.\d{9}\]", "[<TIME>]"),
    (r"_ros2cli_daemon_\d+_(<HEX>|[0-9a-f]+)", "_ros2cli_daemon_<N>_<HEX>"),
    (r"_ros2cli_\d+", "_ros2cli_<PID>"),
    (r"GID: [0-9a-f.]{20,}", "GID: <GID>"),
    (r"(accepted with ID: )[0-9a-f]{32}", r"\1<UUID>"),
    (r"((?:received|source)_timestamp: )\d+", r"\1<TIME_NS>"),
    (r"(?m)^(publication_sequence_number: |reception_sequence_number: ).*$", r"\1<N>"),
    (r"!!binary \|\n +\S+", "!!binary <GID>"),
    (r"(implementation_identifier: )\S+", r"\1<RMW>"),
    (r"sec=\d{9,}, nanosec=\d+", "sec=<TIME>, nanosec=<TIME>"),
    (r"sec: \d{9,}\n( *)nanosec: \d+", r"sec: <TIME>\n\1nanosec: <TIME>"),
    (r"'<PREFIX>'(, '<PREFIX>')+", "'<PREFIX>'"),
    # what a launch says of its processes and folders
    (r"pid \[?\d+\]?", "pid [<PID>]"),
    (r"pid \[?<PID>\]?", "pid [<PID>]"),
    (r"(log files can be found below ).+", r"\1<LOGDIR>"),
    (r"object at 0x[0-9a-f]+", "object at <ADDR>"),
    # what a publisher counts
    (r"(Hello ?World:? #?)\d+", r"\1<N>"),
    (r"(?m)(position:\n)- -?[\d.]+\n- -?[\d.]+$", r"\1<POSITIONS>"),
    # what depends on how fast things were found or came
    (r"(?m)^(Waiting for at least \d+ matching subscription\(s\)\.\.\.\n)+", "<WAITING>\n"),
    (r"(?m)^waiting for service to become available\.\.\.\n", ""),
    (r"(?s)(average rate: )[\d.]+(\n\tmin: )[\d.]+(s max: )[\d.]+(s std dev: )[\d.]+(s window: )\d+\n", r"\1N\2N\3N\4N\5N\n"),
    (r"(?m)^[\d.]+ (B|KB|MB)/s from \d+ messages\n.*\n", "<BANDWIDTH>\n"),
    (r"(?s)average delay: -?[\d.]+\n\tmin: -?[\d.]+s max: -?[\d.]+s std dev: [\d.]+s window: \d+\n", "<DELAY>\n"),
    (r"(?m)^(/\S+) +[\d.]+ +[\d.]+ +[\d.]+ +[\d.]+ +\d+ *$", r"\1 <RATES>"),
    (r"(?m)^ topic +rate +min_delta.*\n=+\n", "<TABLE>\n"),
]  # fmt: skip

_NOT_INSTALLED: list[tuple[str, str]] = [
    # Where this was recorded, rosbag2 and sros2 were not installed, and ros2action was older than its verb `echo`.
    (r"(?m)^  (bag|security) +\S.*\n", ""),
    (r"(?m)^  echo +Echo a action\n", ""),
    (r"(choose from .*)'bag', ", r"\1"),
    (r"(choose from .*)'security', ", r"\1"),
    (r"(choose from )'echo', ('find', 'info', 'list', 'send_goal')", r"\1\2"),
]
"""What of our answers only shows that more is installed here."""

_REPEATED = re.compile(
    r"(average rate: N\n\tmin: N.*\n|<BANDWIDTH>\n|<DELAY>\n|<TABLE>\n(?:/.*\n)+\n|publishing #<N>.*\n\n)\1+"
)


def masked(text: str, *, measured: bool = False, endless: bool = False) -> str:
    """Replace what depends on time. `measured`: the case measures; `endless`: the case was interrupted."""
    for pattern, token in _MASKS:
        text = re.sub(pattern, token, text)
    if measured:
        # The real hz, bw and delay do not wait for discovery: the warning comes or not by chance (golden README).
        text = re.sub(r"(?m)^WARNING: topic \[.*\] does not appear to be published yet\n", "", text)
    if endless:
        text = re.sub(r"publishing #\d+", "publishing #<N>", text)
        text = re.sub(r"(Feedback:\n    sequence:\n(- \d+\n)+\n)+", "<FEEDBACK>\n", text)
        text = re.sub(
            r"((\[[\w-]+\] )?\[(?:INFO|WARN)\] \[<TIME>\] \[\w+\]: Publishing: \"Hello World: <N>\"\n)+",
            "<PUBLISHING>\n",
            text,
        )
        # Of the two SIGINTs (the terminal's and the launch's) the second may find a node that is nearly gone.
        text = re.sub(
            r"\[(ERROR\] (.*): process has died (.*), exit code -2, cmd .*|INFO\] (.*): process has finished cleanly (.*))",
            "<ENDED>",
            text,
        )
        text = re.sub(r"(service not available, waiting again\.\.\.\n)+", "<NOT AVAILABLE>\n", text)
    return _REPEATED.sub(r"\1", text)


def without_traceback(text: str) -> str:
    """Cut a traceback down to its last line (agreed: those of the real implementation's own files need no more)."""
    if "Traceback (most recent call last):" in text or re.search(r"(?m)^[\w.]+(Error|Exception)\b", text):
        lines = [line for line in text.splitlines() if line.strip()]
        return lines[-1] + "\n"
    return text


def without_comments(text: str) -> str:
    """Drop the comments of `interface show` (agreed: our definitions have their own), and empty lines with them."""
    lines = (re.sub(r"\s*#.*", "", line).rstrip() for line in text.splitlines())
    return "".join(f"{line}\n" for line in lines if line)


def with_prefix(text: str, prefixes: list[str]) -> str:
    """Put the recording's placeholder for the prefixes of this machine."""
    for prefix in sorted(prefixes, key=len, reverse=True):
        text = re.sub(re.escape(prefix) + r"[^\s'\"]*", lambda found: found[0].replace(os.sep, "/"), text)
        text = text.replace(prefix.replace(os.sep, "/"), "<PREFIX>")
    return text


def _as_installed(text: str) -> str:
    """Take out of an answer of ours what the recorded installation did not have."""
    for pattern, token in _NOT_INSTALLED:
        text = re.sub(pattern, token, text)
    return text


def differences(case: Case, stdout: str, stderr: str, exit_code: int, prefixes: list[str]) -> str:
    """Return what differs from the recording, '' if nothing does."""
    options = {
        "measured": case.argv[1:3] in (["topic", "hz"], ["topic", "bw"], ["topic", "delay"])
        and "no_such" not in case.argv[-1],
        "endless": case.interrupt_after is not None,
    }
    expected = [masked(case.stdout, **options), without_traceback(masked(case.stderr, **options))]
    actual = [
        masked(_as_installed(with_prefix(stdout, prefixes)), **options),
        without_traceback(masked(_as_installed(with_prefix(stderr, prefixes)), **options)),
    ]
    if case.argv[1:3] == ["interface", "show"]:
        expected[0], actual[0] = map(without_comments, (expected[0], actual[0]))
    found = []
    if exit_code != case.exit_code:
        found.append(f"exit code {exit_code}, recorded {case.exit_code}")
    for stream, want, have in zip(("stdout", "stderr"), expected, actual, strict=True):
        if want != have:
            found.append(_diff(stream, want, have))
    return "\n".join(found)


def _diff(stream: str, want: str, have: str) -> str:
    import difflib

    lines = difflib.unified_diff(
        want.splitlines(), have.splitlines(), f"recorded {stream}", f"our {stream}", lineterm="", n=1
    )
    return "\n".join(lines) or f"{stream} differs in newlines: {want[-40:]!r} / {have[-40:]!r}"
