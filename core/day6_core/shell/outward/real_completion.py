"""Tab in the real terminal: the completions of `ros2`, `colcon` and `day6-tui` for bash and zsh in `day6-tui shell`.

The shells run `day6-tui complete SHELL LINE`, LINE being the text before the cursor; the output has one word per line.
If there is none, the shell offers files.
"""

from __future__ import annotations

import argparse
import shlex
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from day6_core.shell.line.completion import COMPLETED, current_words, own_words, quoted

if TYPE_CHECKING:
    from day6_core.session.session import Session

Own = Callable[[list[str]], Iterable[str]]
"""Returns the completions of `day6-tui` itself for the last of the words after it."""

_WORD_BREAKS = ":="
"""Characters at which bash begins a new word to complete, although they do not begin a new argument."""

_BASH = """\
_day6_complete() {{
    local answer
    COMPREPLY=()
    while IFS= read -r answer; do COMPREPLY+=("$answer"); done \\
        < <({command} complete bash "${{COMP_LINE:0:COMP_POINT}}" 2>/dev/null)
    [[ ${{#COMPREPLY[@]}} == 1 && ${{COMPREPLY[0]}} == *[/=] ]] && compopt -o nospace 2>/dev/null
    return 0
}}
complete -o default -F _day6_complete {names}
"""
_ZSH = """\
(( $+functions[compdef] )) || {{ autoload -Uz compinit && compinit -u -D; }}
_day6_complete() {{
    local -a answers
    answers=("${{(@f)$({command} complete zsh "$LBUFFER" 2>/dev/null)}}")
    answers=(${{answers:#}})
    (( $#answers )) || {{ _files; return }}
    compadd -Q -U -S '' -- ${{(M)answers:#*[/=]}}
    compadd -Q -U -- ${{answers:#*[/=]}}
}}
compdef _day6_complete {names}
"""
_TEXTS = {"bash": _BASH, "zsh": _ZSH}


def functions(shell: str, command: list[str]) -> str:
    """Return what bash or zsh must read so that Tab asks `command` (the words that run `day6-tui`)."""
    return _TEXTS[shell].format(command=shlex.join(command), names=" ".join([*COMPLETED, "day6-tui"]))


def main(arguments: list[str], own: Own) -> int:
    """`day6-tui complete SHELL LINE`: print the words that could replace the one before the cursor."""
    from day6_core.session.local import run_local

    parser = argparse.ArgumentParser(prog="day6-tui complete", description=__doc__.partition("\n")[0])
    parser.add_argument("shell", choices=sorted(_TEXTS))
    parser.add_argument("line", help="what stands before the cursor")
    options = parser.parse_args(arguments)

    async def answer(session: Session) -> int:
        for word in await answers(options.line, session, own):
            session.print(_as_bash_replaces(options.line, word) if options.shell == "bash" else word)
        return 0

    return run_local(answer, ["day6-tui"], one_shot=True)


async def answers(line: str, session: Session, own: Own) -> list[str]:
    """Return the sorted words, quoted as needed, that could replace the last one of `line`; none where a file is wanted."""
    words, _, quote = current_words(line)
    typed = words[-1]
    offered: Iterable[str] | None = None
    if words[0] == "day6-tui":
        if len(words) > 2 and words[1] in COMPLETED:
            words = words[1:]
        else:
            offered = own(words[1:])
    if words[0] in COMPLETED:
        offered = await own_words(words, session, session.cwd, session.env)
    return sorted({quoted(each, quote) for each in offered or () if each.startswith(typed)})


def _as_bash_replaces(line: str, word: str) -> str:
    """Cut off what bash keeps: the quote that was begun, or the word up to its last `:` or `=`."""
    _, start, quote = current_words(line)
    if quote:
        return word[1:].removesuffix(quote)
    typed = line[start:]
    kept = max(typed.rfind(character) for character in _WORD_BREAKS) + 1
    return word[kept:]
