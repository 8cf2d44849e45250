"""Plays a page as its reader does: types its commands, opens terminals where it says so, presses keys, writes its files."""

from __future__ import annotations

import re
import shlex
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

from day6_core.shell.runs import Run
from day6_core.shell.terminal import Terminal
from tests.conformance.tutorial_pages.commands import SHELLS, is_form, opens_window, runs_on, split
from tests.conformance.tutorial_pages.documentation import CPLUSPLUS, Block, Documentation, as_of_today
from tests.conformance.tutorial_pages.files import Workspace
from tests.conformance.tutorial_pages.judge import Verdict, compare
from tests.conformance.tutorial_pages.pages import HANDS, Hand, Page
from tests.conformance.tutorial_pages.reader_machine import LEFT, UP, Machine

ENDS_S = 180.0
"""Seconds that a command which ends by itself may take."""
GOES_ON_S = 12.0
"""Seconds in which a program that goes on has to show what its page shows."""
QUIET_S = 1.2
"""A program that goes on, and has been quiet for so long, has said what it says at its start."""
STARTS_S = 6.0
OPENS_S = 20.0
"""Seconds that a window may take."""

_NEW_TERMINAL = re.compile(
    r"(new|another|second|third|fourth|different|separate|other|two|one) (new )?(terminal|console|shell|command window|tab)"
    r"|open a terminal|from a terminal|terminal \d|shell \d",
    re.IGNORECASE,
)
_CTRL_C = re.compile(r"[^.\n]*(?:Ctrl ?[-+] ?C|CTRL ?[-+] ?C|\^C)\b[^.\n]*", re.IGNORECASE)
_ARROWS = re.compile(r"arrow|move (the|your) turtle|drive (the|your)", re.IGNORECASE)
_CODE = re.compile(r"``([^`]+)``")
_MOVES = re.compile(
    r"(?:navigate|go|move|return|cd|change|back|inside|into|in the|in your|root of your workspace)\b"
    r"[^.`]*``((?:~/)?\w*(?:_ws|/|src)[~\w./-]*)``",
    re.IGNORECASE,
)
_FAILED = re.compile(
    r"process has died \[pid|Could not load display config|Parameter file path is not a file"
    r"|Traceback \(most recent call last\)|: command not found|: error: |^Package '.*' not found|No executable found",
    re.M,
)
_TOO_EARLY = re.compile(r"^WARNING: topic \[.*\] does not appear to be published yet", re.M)
"""What a program says that a slower reader would not have seen."""
_WORKSPACE = re.compile(r"mkdir -p (~/|\./)?(?P<name>[\w/]+)/src\b")
_DOWNLOAD = re.compile(r":download:`[^`<]*<([^>]+)>`[^`]*``([^`]+)``")
_IS_FILE = re.compile(r"\.(py|cfg|txt|xml|ya?ml|h|hpp|cpp)$")
_NO_COMPILER = re.compile(r"no C\+\+ compiler|is a C\+\+ program")
_OTHER_SYSTEM = re.compile(r"\bon (windows|macos)\W*$|^(macos users:|if you are on macos\b)", re.IGNORECASE | re.M)
_TREE = re.compile(r"[├└]──|^\w+/\n +\w+/", re.M)
"""A picture of folders."""
_CPP_NAME = re.compile(r"Cpp|CPP|Pluginlib|Composable|Custom-Display")


@dataclass
class Row:
    """A command of a page: what became of it."""

    command: str
    line: int
    heading: str = ""
    verdict: str = "run"
    """run; window (it runs, and opened one); failed; form (it shows only how such commands look); left out."""
    reason: str = ""
    output: str = ""
    listing: str | None = None
    kind: str = ""
    """How the output compares with the page's listing, '' where the page shows none."""
    difference: list[str] = field(default_factory=list)
    run: Run | None = None
    interrupted: bool = False
    """Whether the reader ended it by Ctrl-C."""
    before_ctrl_c: str = ""
    """Its output until then: a terminal forgets most of what an older command printed."""
    opened: bool = False
    """Whether a window came while it started."""

    @property
    def by_itself(self) -> str:
        """What it printed before the reader ended it."""
        if not self.interrupted:
            return self.output
        return self.before_ctrl_c or self.output.partition("^C")[0]


class Player:
    """One reader with one page; `rows` and `files` are filled by `play`."""

    def __init__(self, documentation: Documentation, page: Page, machine: Machine, mirror: Path | None) -> None:
        self._documentation = documentation
        self._page = page
        self._machine = machine
        self._mirror = mirror
        self._hands = HANDS.get(page.name, ())
        self._terminal: Terminal | None = None
        self._workspace = Workspace(machine.home)
        if mirror is not None:
            serve_clones(mirror, machine.home)
        self._wants_new = True
        self._into = ""
        self._sourced: dict[int, float] = {}
        self._unbuilt = False
        self.rows: list[Row] = []
        self.files: list[str] = []

    def play(self) -> None:
        """Play the whole page; what still runs at its end is interrupted."""
        for block in self._documentation.blocks(self._page.path):
            hand = next((each for each in self._hands if each.fits(block)), None)
            self._play_block(block, hand)
        silent = [row.run for row in self.rows if row.run is not None and row.command.startswith("python3 ")]
        # A page's program has something to say, sooner or later.
        self._machine.wait(lambda: all(run.written or run.status is not None for run in silent), GOES_ON_S)
        for terminal in self._machine.terminals:
            if terminal.busy:
                self._interrupt(terminal)
        for row in self.rows:
            self._finish(row)

    # -- a block -------------------------------------------------------------------------------------------------------

    def _play_block(self, block: Block, hand: Hand | None) -> None:
        self._heed(block)
        if _OTHER_SYSTEM.search(block.before):
            return
        if hand is not None and hand.skip:
            if parts := split(block.text):
                self.rows += [Row(command, block.line, block.heading, "left out", hand.skip) for command, _ in parts]
            return
        if hand is not None and hand.file:
            self.files += self._workspace.write(
                hand.file, _body(block.text) if " " in hand.how else block.text, hand.how
            )
            self._unbuilt = True
            return
        parts = split(block.text) if block.language in SHELLS else None
        if parts is not None:
            for command, output in parts:
                self._command(command, block, hand)
                if output and self.rows:
                    self._judge(self.rows[-1], output)
            return
        if block.tab.lower() == CPLUSPLUS or block.language in ("c++", "cpp", "c"):
            return
        if _TREE.search(block.text):
            return
        written = self._workspace.heed(block)
        self.files += written
        self._unbuilt = self._unbuilt or bool(written)
        if not written and block.language in SHELLS:
            said = hand.of if hand is not None and hand.of else self._said(block)
            if said and (not self.rows or said != self.rows[-1].command):
                self._command(said, block, hand)
            self._listing(block)

    def _said(self, block: Block) -> str:
        """Return the command that only the sentence before a listing names, '' for none."""
        sentence = re.split(r"\n\s*\n", block.before)[-1]
        inline = [code for code in _CODE.findall(sentence) if re.match(r"ros2 \w+ \w+|ros2 doctor|printenv", code)]
        return inline[-1] if inline and not is_form(inline[-1]) else ""

    def _heed(self, block: Block) -> None:
        """Do what the words before a block tell."""
        words = block.since
        if words:
            self._wants_new = False
            self._into = ""
        for sentence in _CTRL_C.findall(words):
            self._press_ctrl_c(sentence)
        if _ARROWS.search(words):
            for terminal in self._machine.terminals:
                run = terminal.runs.running
                if run is not None and terminal.reading_keys and takes_arrows(run.source):
                    for key in (UP, UP, LEFT, UP):
                        terminal.send(key)
                        self._machine.wait(lambda: False, 0.3)
        if _NEW_TERMINAL.search(words):
            self._wants_new = True
        self._workspace.hear(block.before)
        for source, name in _DOWNLOAD.findall(words):
            self.files += self._workspace.write(name, self._documentation.read_beside(self._page.path, source), "whole")
            self._unbuilt = True
        for path in _MOVES.findall(words):
            if self._workspace.folder(path) is not None:
                self._into = path

    def _press_ctrl_c(self, sentence: str) -> None:
        busy = [terminal for terminal in self._machine.terminals if terminal.busy]
        if re.search(r"\b(each|all|both|every)\b", sentence):
            chosen = busy
        else:
            named = [
                terminal
                for terminal in busy
                if any(word in terminal.title for word in _CODE.findall(sentence) if "ctrl" not in word.lower())
            ]
            chosen = named or ([self._terminal] if self._terminal in busy else busy[-1:])
        for terminal in chosen:
            self._interrupt(terminal)

    def _interrupt(self, terminal: Terminal) -> None:
        for row in self.rows:
            if row.run is not None and row.run is terminal.runs.running:
                row.interrupted, row.before_ctrl_c = True, row.run.output
        self._machine.interrupt(terminal)

    # -- a command -----------------------------------------------------------------------------------------------------

    def _command(self, command: str, block: Block, hand: Hand | None) -> None:
        row = Row(command, block.line, block.heading)
        self.rows.append(row)
        if hand is not None:
            for pattern, text in hand.instead:
                command = re.sub(pattern, text.replace("<BAG>", self._newest_bag()), command)
        if is_form(command):
            row.verdict = "form"
            return
        if "c++" in block.tab.lower():
            row.reason = "C++"
        if self._workspace.has_package(command):
            row.verdict, row.reason = "left out", "another tab has made a package of this name"
            return
        terminal = self._choose(command, block, hand)
        self._go(terminal, command, hand)
        if workspace := _WORKSPACE.search(command):
            self._workspace.root = self._machine.home / workspace["name"]
        self._build(terminal, command, block)
        for line in hand.before if hand is not None else ():
            self._machine.settle(terminal, line)
        self._source(terminal, command)
        if given := self._given(command, terminal):
            row.verdict, row.reason = given
            self.files += [command.rpartition("/")[2]] if row.verdict == "run" else []
            return
        windows = len(self._machine.windows())
        row.run = self._machine.type(terminal, command)
        self._until_settled(row, terminal, windows)
        if hand is not None and hand.lasts:
            self._machine.wait(lambda: False, hand.lasts)
        if row.run.status and _TOO_EARLY.search(row.run.output):
            self._machine.wait(lambda: False, GOES_ON_S / 2)
            row.run = self._machine.type(terminal, command)
            self._until_settled(row, terminal, windows)
        if right := put_right(command, row.run.output):
            self._until_settled(Row(right, block.line, run=self._machine.type(terminal, right)), terminal, windows)
        self._workspace.ran(command, terminal.shell.cwd)
        if command.startswith("colcon build"):
            self._unbuilt = False

    def _choose(self, command: str, block: Block, hand: Hand | None) -> Terminal:
        for other in self._machine.terminals:
            if other.busy and starts_the_same(other.title, command):
                self._interrupt(other)
                self._terminal, self._wants_new = other, False
        if hand is not None and hand.interrupt:
            for other in self._machine.terminals:
                if other.busy and re.search(hand.interrupt, other.title):
                    self._interrupt(other)
        if self._terminal is None or self._wants_new or self._terminal.busy or self._terminal.closed:
            self._terminal = self._machine.open()
            if (self._workspace.root / "install/setup.bash").exists():
                self._machine.settle(self._terminal, f"cd {self._workspace.root}")
        self._wants_new = False
        return self._terminal

    def _build(self, terminal: Terminal, command: str, block: Block) -> None:
        """Build a package whose files were changed since, where the sentence before says so without a listing."""
        package = re.match(r"ros2 (?:run|launch) (\w+)", command)
        if package is None or not self._unbuilt or not re.search(r"\bbuild\b", block.before):
            return
        if (self._workspace.root / "src" / package[1]).is_dir():
            self._machine.settle(terminal, f"cd {self._workspace.root}")
            self._machine.settle(terminal, f"colcon build --packages-select {package[1]}")
            self._unbuilt = False

    def _source(self, terminal: Terminal, command: str) -> None:
        """Source the workspace, as pages remind their reader to do in every terminal after a build."""
        setup = self._workspace.root / "install/setup.bash"
        if re.match(r"(ros2 |rviz2|python3)", command) and setup.is_file():
            built = max(path.stat().st_mtime for path in (self._workspace.root / "install").iterdir())
            if self._sourced.get(id(terminal)) != built:
                self._machine.settle(terminal, f"source {setup}")
                self._sourced[id(terminal)] = built

    def _go(self, terminal: Terminal, command: str, hand: Hand | None) -> None:
        """Go to the folder in which a command belongs."""
        into: Path | None = None
        if hand is not None and hand.at:
            into = self._workspace.folder(hand.at)
        elif command.startswith("ros2 pkg create"):
            into = self._workspace.root / "src"
        elif re.match(r"(colcon|rosdep install|source install|\. install|source \./install)", command):
            into = self._workspace.root
        elif (place := re.match(r"cd ([\w/]+)$", command)) and not (terminal.shell.cwd / place[1]).is_dir():
            into = self._machine.home
        elif (script := re.match(r"python3 ([\w.]+\.py)", command)) and (place := self._workspace.where(script[1])):
            into = place
        elif self._into:
            into = self._workspace.folder(self._into)
        elif is_from_home(command, terminal.shell.cwd, self._machine.home):
            into = self._machine.home
        if into is not None and into.is_dir() and into != terminal.shell.cwd:
            self._machine.settle(terminal, f"cd {shlex.quote(str(into))}")

    def _until_settled(self, row: Row, terminal: Terminal, windows: int) -> None:
        run = row.run
        assert run is not None
        ended = lambda: run.status is not None  # noqa: E731
        if not runs_on(row.command):
            self._machine.wait(lambda: ended() and terminal.idle, ENDS_S if "colcon" in row.command else 25.0)
            return
        seen = [run.written]
        if opens_window(row.command):
            self._machine.wait(lambda: ended() or len(self._machine.windows()) > windows, OPENS_S)
            row.opened = len(self._machine.windows()) > windows
            self._machine.wait(ended, QUIET_S)  # what it says once it is there
            return
        self._machine.wait(lambda: ended() or run.written > 0, STARTS_S)
        while not ended():
            seen.append(run.written)
            if not self._machine.wait(lambda: ended() or run.written > seen[-1], QUIET_S) or len(seen) > 3:
                break

    def _given(self, command: str, terminal: Terminal) -> tuple[str, str] | None:
        """Serve a wget from the mirror; return a verdict, None if it is none."""
        match = re.match(
            r"wget (?:-O (?P<name>\S+) )?https://raw\.githubusercontent\.com/([\w.-]+)/([\w.-]+)/([\w.-]+)/(\S+)",
            command,
        )
        if match is None:
            return None
        name, owner, repository, branch, path = match.groups()
        if self._mirror is None:
            return "failed", "network"
        done = subprocess.run(
            ["git", "-C", str(self._mirror / f"{owner}+{repository}" / "repo"), "show", f"{branch}:{path}"],
            capture_output=True,
        )
        if done.returncode:
            return "failed", "network: not in the mirror"
        (terminal.shell.cwd / (name or path.rpartition("/")[2])).write_text(
            as_of_today(done.stdout.decode()), encoding="utf-8"
        )
        return "run", "given from the mirror"

    def _newest_bag(self) -> str:
        bags = sorted(self._machine.home.rglob("metadata.yaml"), key=lambda path: path.stat().st_mtime)
        return str(bags[-1].parent) if bags else "no_bag"

    # -- judging -------------------------------------------------------------------------------------------------------

    def _listing(self, block: Block) -> None:
        """A text that is shown: of the last command, or of one that still runs."""
        rows = [row for row in self.rows if row.run is not None]
        if not rows:
            return
        last = rows[-1]
        near = last.heading == block.heading and not any(_IS_FILE.search(code) for code in _CODE.findall(block.before))
        if last.listing is None and near:
            self._judge(last, block.text)
            if last.kind != Verdict.DIFFERS:
                return
        self._machine.wait(lambda: self._shown_by_one_of(rows, block.text), GOES_ON_S / 2)

    def _shown_by_one_of(self, rows: list[Row], listing: str) -> bool:
        """Look whether a command that was run before has shown a listing, and note it there."""
        for row in reversed(rows):
            assert row.run is not None
            verdict, difference = compare(listing, row.run.output, goes_on=True, home=str(self._machine.home))
            if verdict is Verdict.DIFFERS:
                continue
            last = rows[-1]
            if row is not last and last.listing == listing:
                last.listing, last.kind, last.difference = None, "", []
            if row.kind in ("", Verdict.DIFFERS.value):
                row.listing, row.kind, row.difference = listing, verdict.value, difference
            return True
        return False

    def _judge(self, row: Row, listing: str) -> None:
        run = row.run
        if run is None:
            return
        row.listing = listing
        goes_on = run.status is None or runs_on(row.command)

        def differs() -> bool:
            verdict, row.difference = compare(listing, run.output, goes_on=goes_on, home=str(self._machine.home))
            row.kind = verdict.value
            return verdict is Verdict.DIFFERS

        self._machine.wait(lambda: not differs(), GOES_ON_S if run.status is None else 0.0)

    def _finish(self, row: Row) -> None:
        if row.run is None:
            return
        row.output = row.run.output
        status = row.run.status
        shown = row.kind not in ("", Verdict.DIFFERS.value)
        hangs = row.interrupted and not runs_on(row.command)
        if opens_window(row.command):
            row.verdict, hangs = "window", not row.opened
        if ((status not in (0, None) and not row.interrupted) or hangs or _FAILED.search(row.by_itself)) and not shown:
            row.verdict = "failed"
        if row.verdict == "failed" and not row.reason and _CPP_NAME.search(self._page.name):
            row.reason = "C++"
        if row.verdict == "failed" and not row.reason and _NO_COMPILER.search(row.output):
            row.reason = "C++"


def takes_arrows(command: str) -> bool:
    """Return whether the arrow keys that a page speaks of are for this program."""
    return "teleop" in command


def put_right(command: str, output: str) -> str:
    """Return what a reader types after a command that today's tool refuses, so that the page goes on; '' for nothing."""
    refused = re.search(r"unrecognized arguments: (/.*)", output)
    if refused is None or not command.startswith("ros2 bag record "):
        return ""
    topics = refused[1].split()
    return " ".join([*(word for word in command.split() if word not in topics), "--topics", *topics])


def starts_the_same(running: str, command: str) -> bool:
    """Say whether a reader ends a running program before this command: it is the same, or launches it with other arguments."""
    if "turtle_teleop_key" in command:
        return False
    words, others = command.split(), running.split()
    return words == others or (words[:2] == ["ros2", "launch"] and words[:4] == others[:4])


def is_from_home(command: str, cwd: Path, home: Path) -> bool:
    """Say whether a command names a path that is not there where it is typed, but is from the home folder."""
    words = [word for word in command.split() if "/" in word and not word.startswith(("/", "~", "'", '"', "$"))]
    return any((home / word).exists() and not (cwd / word).exists() for word in words)


def _body(text: str) -> str:
    """Return the lines that a listing adds: those after its first `...`, which stands for what is there already."""
    _, dots, rest = text.partition("...\n")
    lines = (rest if dots else text).strip("\n").split("\n")
    return "\n".join(lines)


def serve_clones(mirror: Path, home: Path) -> None:
    """Let git take the public repositories of the mirror from there, by the settings of a home."""
    settings = []
    for place in sorted(mirror.glob("*+*/repo")):
        owner, _, name = place.parent.name.partition("+")
        for end in ("", ".git"):
            settings.append(f'[url "{place}"]\n\tinsteadOf = https://github.com/{owner}/{name}{end}\n')
    (home / ".gitconfig").write_text(
        "".join(settings) + "[advice]\n\tdetachedHead = false\n[safe]\n\tdirectory = *\n", encoding="utf-8"
    )
