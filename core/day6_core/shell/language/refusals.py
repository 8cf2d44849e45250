"""What bash has and this shell does not: it is refused, with a sentence that says so, before anything of its line runs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import is_dataclass

from day6_core.language import language_of
from day6_core.shell.language import syntax
from day6_core.shell.language.words import ProcessSubstitution, Substitution, SyntaxProblem, Variable

_TEXT = {
    "en": "{what}: bash has this, the shell of day6-tui does not",
    "zh": "{what}：bash 有这个功能，day6-tui 的 shell 没有",
}
_NOTHING_RUN = {"en": "; nothing of this line was run", "zh": "；这一行什么都没有执行"}


class Refused(SyntaxProblem):
    """Something of bash's language that is not there."""

    def __init__(self, what: str) -> None:
        super().__init__(what)
        self.what = what

    def told(self, variables: Mapping[str, str], *, before_the_line: bool = False) -> str:
        """The sentence; `before_the_line`: it was seen before anything of the line ran."""
        language = language_of(variables)
        return _TEXT[language].format(what=self.what) + _NOTHING_RUN[language] * before_the_line


_REFUSED = {
    "read": "ei", "mapfile": "Cc", "readarray": "Cc", "declare": "It", "typeset": "It", "local": "fFItp", "wait": "fnp",
    "history": "dps", "hash": "dlpt", "exec": "cl", "cd": "e", "pushd": "n",
}  # fmt: skip
"""Options of built-ins that are bash's alone; any other is obeyed here, too, or wrong in bash's own words."""
_TAKES_A_VALUE = {"read": "pdnNuta", "mapfile": "ndOsu", "readarray": "ndOsu", "exec": "a"}
_UNTRAPPED = frozenset({"DEBUG", "RETURN"})


def check(tree: syntax.Sequence, functions: Mapping[str, object]) -> None:
    """Look for what is not there, and for wrong syntax in a line's `$( )`, as bash reads them with it. Raises SyntaxProblem."""
    for node in _walk(tree):
        if isinstance(node, syntax.SimpleCommand):
            words = [word.plain for word in node.words]
            if words and words[0] is not None and words[0] not in functions:
                check_words(words[0], words[1:])
            for part in (part for word in node.words for part in word.parts):
                if isinstance(part, ProcessSubstitution) and part.writes:
                    raise Refused(f">({part.source})")
        elif isinstance(node, Variable) and node.operator == "@" and node.argument == "P":
            raise Refused("${" + node.name + "@P}")
        elif isinstance(node, (Substitution, ProcessSubstitution)) and not (
            isinstance(node, Substitution) and node.unread
        ):
            from day6_core.shell.language.parser import parse

            check(parse(node.source), functions)


def check_words(name: str, words: list[str | None]) -> None:
    """Check the arguments of one built-in; those that are None are not known yet. Raises Refused."""
    if name == "trap":
        for word in words[1:]:
            if word is not None and word.upper().removeprefix("SIG") in _UNTRAPPED:
                raise Refused(f"trap … {word}")
        return
    if name == "set":
        for word in words:
            if word is None or word == "--" or word[:1] not in ("-", "+"):
                return
            for letter in word[1:]:
                if letter in "nkptr" or letter == "b":
                    raise Refused(f"set {word[0]}{letter}")
        return
    refused, valued = _REFUSED.get(name, ""), _TAKES_A_VALUE.get(name, "")
    skip = False
    for word in words:
        if skip:
            skip = False
            continue
        if word is None or word == "--" or not word.startswith(("-", "+")) or len(word) < 2 or word[1].isdigit():
            return
        for at, letter in enumerate(word[1:], 1):
            if letter in valued:
                skip = at == len(word) - 1
                break
            if letter in refused:
                raise Refused(f"{name} {word[0]}{letter}")


def _walk(node: object) -> Iterator[object]:
    """Walk through everything in a tree: commands, words and their parts."""
    if isinstance(node, (list, tuple)):
        for each in node:
            yield from _walk(each)
    elif is_dataclass(node):
        yield node
        for each in vars(node).values():
            if not isinstance(each, (str, int)):
                yield from _walk(each)
