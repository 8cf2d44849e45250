"""why, explain: the card of a message: of what this terminal printed last, of a text, of what is piped in."""

from __future__ import annotations

import os
import re
import shutil
from collections import deque
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import partial
from itertools import islice
from typing import TYPE_CHECKING

from day6_core.language import language_of
from day6_core.ros.executables import are_on, ros_commands
from day6_core.session.session import Session
from day6_core.session.streams import InputStream
from day6_core.session.threads import in_thread
from day6_core.shell.language.interpreter import shell_of

if TYPE_CHECKING:
    from day6_core.advice.card_files import Card
    from day6_core.advice.matching import Match
    from day6_core.graph.graph import Graph
    from day6_core.shell.runs import Run, Runs

_REAL = "day6-tui why"
"""The one command in a real terminal: it lists, explains, and shows the cards of a topic."""

_BETWEEN = re.compile(r"(\s*(?:;|&&|\|\|?)\s*)")
_SOURCED = re.compile(r"(?:source|\.) (/opt/ros/\S+)")

_OWN = re.compile(r"(?:^|[;&|({\n]|\b(?:then|do|else))\s*(?:why|explain)\b")


def is_own(source: str) -> bool:
    """Return whether a line that was run explains others, and so is not to be explained when it has ended."""
    return _OWN.search(source) is not None


def _refused(session: Session) -> bool:
    """Say that there are no cards in an exam, if this is one."""
    if session.overview is None or session.overview.searching != "exam":
        return False
    session.print_error(_say(session, "card.exam"))
    return True


async def why(session: Session) -> int:
    """`why` explains the last line with a card that this terminal printed, `why 2` the one before; `A 2>&1 | why` what A said."""
    if _refused(session):
        return 1
    words = session.argv[1:]
    number = int(words[0]) if len(words) == 1 and words[0].isdecimal() and len(words[0]) < 4 else 1
    if words and not (len(words) == 1 and words[0].isdecimal()):
        return await explain(session)
    runs = _runs_of(session)
    if runs is None:
        if session.stdin.isatty():
            return await _list(session, "")
        return await _explain_text(session, await _read(session), number)
    match, run = await in_thread(partial(_nth, runs, max(number, 1)))
    if match is None or run is None:
        session.print_error(_say(session, "card.nothing"))
        return 1
    status = await _show(session, match, run.output, run.source)
    if runs.running is not None:
        runs.running.explained()
    return status


async def explain(session: Session) -> int:
    """`explain 'TEXT'` explains a message, `explain WORD` shows a card or the cards of a topic, `explain` the topics."""
    if _refused(session):
        return 1
    text = " ".join(session.argv[1:]).strip()
    if not text and not session.stdin.isatty() and session.name == "explain" and _runs_of(session) is None:
        text = await _read(session)
    if not text.strip():
        return await _list(session, "")
    return await _explain_text(session, text, 1, also_list=True)


async def _explain_text(session: Session, text: str, number: int, *, also_list: bool = False) -> int:
    match = await in_thread(partial(_match_in, text, number))
    if match is None and also_list:
        return await _list(session, text)
    if match is None:
        session.print_error(_say(session, "card.none"))
        return 1
    return await _show(session, match, text, "")


async def _read(session: Session) -> str:
    """The end of standard input."""
    from day6_core.advice.matching import LONGEST_LINE, MOST_LINES

    kept: deque[str] = deque(maxlen=MOST_LINES)
    while line := await session.stdin.read_line():
        kept.append(line[:LONGEST_LINE])
        await session.stdout.drain()
    return "".join(kept)


def _runs_of(session: Session) -> Runs | None:
    """What was run before in the terminal of the desktop in which this was typed, or in the script of `exec` that this is in.

    None in a pipe, in a real terminal, and in a script that has run nothing yet: it is asked about its input.
    """
    from day6_core.session.real_streams import RealInput
    from day6_core.shell.terminal import Terminal

    terminal = session.stdin.terminal_of()
    if isinstance(terminal, Terminal):
        return terminal.runs
    own_input = isinstance(session.stdin, RealInput) or type(session.stdin) is InputStream
    runs = shell_of(session).runs if session.host is not None and own_input else None
    return runs if runs is not None and runs.running is not None and runs.running.written else None


def _nth(runs: Runs, number: int) -> tuple[Match | None, Run | None]:
    return next(islice(explained_lines(runs), number - 1, None), (None, None))


def explained_lines(runs: Runs) -> Iterator[tuple[Match, Run]]:
    """Yield the lines with a card that were printed, the last first, each with what was run."""
    from day6_core.advice.matching import cards_in

    for run in reversed(runs.all):
        if run is runs.running or not is_own(run.source):
            yield from ((match, run) for match in cards_in(run.unexplained if run is runs.running else run.output))


def _match_in(text: str, number: int) -> Match | None:
    from day6_core.advice.matching import cards_in

    return next(islice(cards_in(text), number - 1, None), None)


async def _show(session: Session, match: Match, output: str, command: str) -> int:
    from day6_core.advice.explain import as_text, explain, scene_of
    from day6_core.advice.rules import Surroundings
    from day6_core.facts.graph import facts_of, nodes_by_domain
    from day6_core.shell.commands import command_names
    from day6_core.shell.language.hints import letters_awaited

    language = language_of(session.env)
    columns = session.stdout.columns
    graph, others = _graphs(session, match.card)
    inside = session.host is not None
    letters = letters_awaited(shell_of(session).desk) if inside else ""

    def text() -> str:
        around = Surroundings(session.env, session.cwd, launch=command.startswith("ros2 launch"))
        seen = facts_of(graph, nodes_by_domain(others)) if graph is not None else None
        scene = scene_of(
            match, around, output=output, command=command, graph=seen, commands=command_names(), letters=letters
        )
        shown = explain(match, scene, language)
        return as_text(
            shown if inside else replace(shown, next=for_real_terminal(shown.next, session.env)), language, columns
        )

    lines = (await in_thread(text)).split("\n")
    if session.stdout.isatty():
        lines = [f"\x1b[1m{line}\x1b[0m" if line and not line.startswith(" ") else line for line in lines]
        lines = with_colour("\n".join(lines))
    session.print("\n".join(lines))
    return 0


def for_real_terminal(line: str, env: Mapping[str, str]) -> str:
    """A command line as it is typed in a real terminal, which may have neither `ros2` nor /opt/ros."""
    path = env.get("PATH", os.defpath)
    if are_on(path):
        return line
    pieces = _BETWEEN.split(line)
    for number in range(0, len(pieces), 2):
        word, _, rest = pieces[number].partition(" ")
        sourced = _SOURCED.fullmatch(pieces[number])
        if sourced is not None and not os.path.exists(sourced[1]):
            pieces[number] = "day6-tui shell"
        elif word in ros_commands() and shutil.which(word, path=path) is None:
            pieces[number] = f"day6-tui {pieces[number]}"
        elif word == "python3" and rest and not rest.startswith("-"):
            pieces[number] = f"day6-tui python {rest}"
    return "".join(pieces)


def with_colour(text: str) -> list[str]:
    """Return the lines of a card with what stands between ` in a colour; one may go on in the next line."""
    parts = text.split("`")
    for number in range(1, len(parts) - 1, 2):
        parts[number] = "\n".join(
            line[: len(line) - len(line.lstrip())] + f"\x1b[36m{line.lstrip()}\x1b[39m"
            for line in parts[number].split("\n")
        )
    return "".join(parts[: len(parts) - 1 + len(parts) % 2]).split("\n") if len(parts) % 2 else text.split("\n")


def _graphs(session: Session, card: Card) -> tuple[Graph | None, list[Graph]]:
    """The live graph, joined only where a looker of this card asks for it, and those of all domains."""
    from day6_core.advice.explain import asks_graph

    graph = session.graph if asks_graph(card) else None
    others = list(shell_of(session).desk.graphs.values()) if graph is not None and session.host is not None else []
    return graph, others


async def _list(session: Session, word: str) -> int:
    """The topics; with a word the cards of that topic, or those whose names or words contain it."""
    from day6_core.advice.explain import topic_list

    language = language_of(session.env)
    topics = await in_thread(lambda: topic_list(language))
    if not word:
        session.print(_say(session, "card.topics").partition(": ")[2])
        for name, title, cards in topics:
            session.print(f"  {name:<12}{title} ({len(cards)})")
        return 0
    for _, _, cards in topics:
        for card in cards:
            if card.id == word:
                _print_card(session, card, language)
                return 0
    wanted = word.casefold()
    for name, title, cards in topics:
        whole = wanted in (name, title.casefold())
        chosen = [
            card for card in cards if whole or wanted in card.id or wanted in card.words[language].first.casefold()
        ]
        if chosen:
            session.print(title)
            for card in chosen:
                session.print(f"  {card.id:<28}{_shown(card, language)}")
                await session.stdout.drain()
    if any(wanted in (name, title.casefold()) or _has(cards, wanted, language) for name, title, cards in topics):
        return 0
    session.print_error(_say(session, "card.none"))
    return 1


def _has(cards: list[Card], wanted: str, language: str) -> bool:
    return any(wanted in card.id or wanted in card.words[language].first.casefold() for card in cards)


def _shown(card: Card, language: str) -> str:
    from day6_core.advice.wording import with_gaps

    return with_gaps(card.words[language].first)


def _print_card(session: Session, card: Card, language: str) -> None:
    """A card without a message: what it means, what to check, what differs on a real robot."""
    from day6_core.advice.explain import as_text, explanation_of_card

    text = as_text(explanation_of_card(card, language), language, session.stdout.columns)
    session.print("\n".join(with_colour(text)) if session.stdout.isatty() else text)


def _say(session: Session, key: str) -> str:
    from day6_core.advice.texts import TEXTS

    name, explaining = (session.name, "explain") if session.host is not None else (_REAL, _REAL)
    return f"{name}: {TEXTS[key][language_of(session.env) == 'zh'].format(explain=explaining)}"
