"""Tab in the real terminal: what bash, zsh, fish and PowerShell read so that it completes `ros2`, `colcon` and `day6-tui`.

The shells run `day6-tui complete SHELL LINE`, LINE being the text before the cursor; the output has one word per line.
If there is none, the shell offers files.
"""

from __future__ import annotations

import shlex
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from day6_core.command_line.leading import DISTRIBUTION, LANGUAGE, leading
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
_FISH = """\
function _day6_complete
    set -l answers ({command} complete fish (commandline -cp | string collect) 2>/dev/null)
    if set -q answers[1]
        printf '%s\\n' $answers
    else
        __fish_complete_path (commandline -ct)
    end
end
for name in {names}
    complete -c $name -f -a '(_day6_complete)'
end
"""
_POWERSHELL = """\
Register-ArgumentCompleter -Native -CommandName {names} -ScriptBlock {{
    param($word, $typed, $cursor)
    $length = $cursor - $typed.Extent.StartOffset
    $line = "$typed".PadRight($length).Substring(0, $length)
    {command} complete powershell "$line" 2>$null | ForEach-Object {{
        [System.Management.Automation.CompletionResult]::new($_, $_, 'ParameterValue', $_)
    }}
}}
"""
_TEXTS = {"bash": _BASH, "zsh": _ZSH, "fish": _FISH, "powershell": _POWERSHELL}
_QUOTED_HERE = ("bash", "zsh")
"""Shells that insert an answer as it is; the others write it as they need it."""

SHELLS = tuple(_TEXTS)


def functions(shell: str, command: list[str], names: Iterable[str] = (*COMPLETED, "day6-tui")) -> str:
    """Return what a shell must read so that Tab asks `command` (the words that run `day6-tui`) after these names."""
    joint = ", " if shell == "powershell" else " "
    return _TEXTS[shell].format(command=shlex.join(command), names=joint.join(names))


def complete(shell: str, line: str, own: Own) -> int:
    """Print the words that could replace the one before the cursor; return the exit status."""
    words, quote = _command_in(line)
    found = _of_ros(words) if words[0] in COMPLETED else own(words[1:]) if words[0] == "day6-tui" else ()
    for word in _fitting(found, words[-1], quote if shell in _QUOTED_HERE else None):
        print(_as_bash_replaces(line, word) if shell == "bash" else word)
    return 0


async def answers(line: str, session: Session, own: Own) -> list[str]:
    """Return the sorted words, quoted as needed, that could replace the last one of `line`; none where a file is wanted."""
    words, quote = _command_in(line)
    found: Iterable[str] | None = None
    if words[0] in COMPLETED:
        found = await own_words(words, session, session.cwd, session.env)
    elif words[0] == "day6-tui":
        found = own(words[1:])
    return _fitting(found or (), words[-1], quote)


def _command_in(line: str) -> tuple[list[str], str]:
    """The words of the command that is typed, behind `day6-tui` that of ROS, and the quote in which the last one is."""
    words, _, quote = current_words(line)
    if words[0] == "day6-tui":
        _, rest = leading(words[1:], (LANGUAGE, DISTRIBUTION))
        if len(rest) > 1 and rest[0] in COMPLETED:
            return rest, quote
    return words, quote


def _fitting(offered: Iterable[str], typed: str, quote: str | None) -> list[str]:
    """Those that begin with what is typed, sorted; with a quote ('' for none) as they must be typed, else as they are."""
    found = sorted({each for each in offered if each.startswith(typed)})
    return found if quote is None else [quoted(each, quote) for each in found]


def _of_ros(words: list[str]) -> list[str]:
    """What `ros2` or `colcon` offers for the last of the words, on this machine's graph."""
    from day6_core.session.local import run_local

    found: list[str] = []

    async def ask(session: Session) -> int:
        found.extend(await own_words(words, session, session.cwd, session.env) or ())
        return 0

    run_local(ask, ["day6-tui"], one_shot=True)
    return found


def _as_bash_replaces(line: str, word: str) -> str:
    """Cut off what bash keeps: the quote that was begun, or the word up to its last `:` or `=`."""
    _, start, quote = current_words(line)
    if quote:
        return word[1:].removesuffix(quote)
    typed = line[start:]
    kept = max(typed.rfind(character) for character in _WORD_BREAKS) + 1
    return word[kept:]
