"""Interprets a CMakeLists.txt as far as packages without a compiler need it: which commands are called, with which arguments.

Variables, conditions, loops, functions, `include` and `add_subdirectory` are evaluated; every other command is returned
unchanged. Sources: cmake-language(7) and the manual pages of the commands.
"""

from __future__ import annotations

import os
import re
import textwrap
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from day6_core.workspace.cmake_condition import evaluate
from day6_core.workspace.cmake_values import VALUE_COMMANDS, items_of

_COMMAND = re.compile(r"(?m)^[ \t]*([A-Za-z_]\w*)[ \t]*\(")
_WIDTH = 77
"""Characters at which CMake wraps the paragraphs of an error."""
_WORD = re.compile(r'\s*(?:"((?:[^"\\]|\\.)*)"|([^\s"()#]+)|(\()|(\))|(#[^\n]*))')
_REFERENCE = re.compile(r"\$(ENV)?\{([^${}]*)\}")
_ESCAPE = re.compile(r"\\([^A-Za-z0-9;\n\x80-\U0010ffff]|[ntr])")
_CONTROLS = {"n": "\n", "t": "\t", "r": "\r"}
_HIDDEN = 0xF0000
"""Added to the code of an escaped character while variables are expanded: a private place of Unicode."""
LISTS = "CMakeLists.txt"

_BLOCKS = {"if": "endif", "foreach": "endforeach", "while": "endwhile", "function": "endfunction", "macro": "endmacro"}
_MOST_CALLS = 100_000
"""Commands run for one package: no hand-written file has this many, but an endless loop has."""
_MOST_TEXT = 1_000_000
"""Characters of one variable; appending a list to itself doubles it."""
_DEEPEST = 100
"""Nested function calls; CMake itself stops at a thousand."""


class CMakeError(ValueError):
    """A command that CMake refuses; `line` is where it begins, `command` its name ('' for a syntax error)."""

    def __init__(self, text: str, line: int, command: str, file: str = LISTS) -> None:
        super().__init__(text)
        self.line = line
        self.command = command
        self.file = file

    def __str__(self) -> str:
        where = f" ({self.command})" if self.command else ""
        body = "\n".join(_set(line) for line in self.args[0].splitlines())
        return f"CMake Error at {self.file}:{self.line}{where}:\n{body}\n\n\n"


def _set(paragraph: str) -> str:
    """Wrap a paragraph as CMake does; one that begins with a space is kept as it is."""
    if paragraph.startswith(" "):
        return f"  {paragraph}"
    indent = "  "
    return textwrap.fill(
        paragraph.replace(".  ", ".\0 "),  # two spaces after a sentence are kept
        _WIDTH,
        initial_indent=indent,
        subsequent_indent=indent,
        break_long_words=False,
        break_on_hyphens=False,
    ).replace("\0", " ")


@dataclass(frozen=True)
class Command:
    """One call. `words` are its arguments with variables expanded; relative paths in them are relative to `folder`."""

    name: str
    words: list[str]
    line: int
    folder: Path = Path()
    file: str = LISTS

    def after(self, keyword: str, *ends: str) -> list[str]:
        """Return the arguments after a keyword, up to one of `ends`."""
        if keyword not in self.words:
            return []
        found = []
        for word in self.words[self.words.index(keyword) + 1 :]:
            if word in ends:
                break
            found.append(word)
        return found

    @property
    def stops(self) -> bool:
        """Whether CMake stops here, because the project says so."""
        return self.name == "message" and self.words[:1] in (["FATAL_ERROR"], ["SEND_ERROR"])

    def error(self, text: str) -> CMakeError:
        """Return the error with which CMake stops at this command."""
        return CMakeError(text, self.line, self.name, self.file)


Find = Callable[[Command], Iterable[str]]
"""Called at each `find_package` (and ament_auto_find_build_dependencies); returns the names whose `_FOUND` becomes true."""


def read_commands(text: str, variables: Mapping[str, str], find: Find = lambda command: ()) -> list[Command]:
    """Return the commands that are run, in order; those after `message(FATAL_ERROR …)`, which stops CMake, too.

    `variables` are set from the start, those of the environment as `ENV{NAME}`; CMAKE_CURRENT_SOURCE_DIR is the text's folder.

    Raises:
        CMakeError: the text is malformed.
    """
    run = _Run(find, Path(variables.get("CMAKE_CURRENT_SOURCE_DIR", ".")))
    run.file(_calls(text, LISTS), _Scope(dict(variables), run.top, LISTS))
    return run.commands


@dataclass(frozen=True)
class _Call:
    """A command as written. A quoted word begins with a quotation mark."""

    name: str
    words: list[str]
    line: int


@dataclass
class _Scope:
    """The scope of a command: its variables, its folder and file, and the variables PARENT_SCOPE sets."""

    variables: dict[str, str]
    folder: Path
    file: str
    parent: dict[str, str] | None = None
    depth: int = 0


@dataclass(frozen=True)
class _Function:
    parameters: list[str]
    body: list[_Call]
    is_macro: bool


class _Leave(Exception):
    """`break`, `continue` or `return`: leaves the enclosing blocks."""


class _Run:
    """One pass over the files of a package."""

    def __init__(self, find: Find, top: Path) -> None:
        self.commands: list[Command] = []
        self.top = top
        self._find = find
        self._functions: dict[str, _Function] = {}
        self._left = _MOST_CALLS

    def block(self, calls: list[_Call], scope: _Scope) -> None:
        """Run commands in order. Raises _Leave for a `return`."""
        at = 0
        while at < len(calls):
            call = calls[at]
            self._count(call, scope)
            if call.name in _BLOCKS:
                end = _end_of(calls, at, scope.file)
                self._run_block(calls[at : end + 1], scope)
                at = end + 1
                continue
            at += 1
            if call.name in ("break", "continue", "return"):
                raise _Leave(call.name)
            self._run(call, scope)

    def _count(self, call: _Call, scope: _Scope) -> None:
        self._left -= 1
        if self._left < 0:
            text = f"day6-tui runs at most {_MOST_CALLS} commands of one package."
            raise CMakeError(text, call.line, call.name, scope.file)

    # -- blocks --------------------------------------------------------------------------------------------------------

    def _run_block(self, calls: list[_Call], scope: _Scope) -> None:
        first, body = calls[0], calls[1:-1]
        if first.name == "if":
            self._if(calls, scope)
        elif first.name in ("function", "macro"):
            words = _all_expanded(first.words, scope.variables)
            if words:
                self._functions[words[0].lower()] = _Function(words[1:], body, first.name == "macro")
        elif first.name == "foreach":
            self._foreach(first, body, scope)
        else:
            while self._is_true(first, scope) and self._run_iteration(body, scope):
                self._count(first, scope)

    def _if(self, calls: list[_Call], scope: _Scope) -> None:
        depth, start, chosen = 0, 0, self._is_true(calls[0], scope)
        for at, call in enumerate(calls):
            depth += (call.name in _BLOCKS) - (call.name in _BLOCKS.values())
            if at == len(calls) - 1 or (depth == 1 and call.name in ("else", "elseif")):
                if chosen:
                    self.block(calls[start + 1 : at], scope)
                    return
                start, chosen = at, call.name == "else" or (call.name == "elseif" and self._is_true(call, scope))

    def _is_true(self, call: _Call, scope: _Scope) -> bool:
        words: list[str] = []
        for word in call.words:
            expanded = _expanded(word, scope.variables)
            words += [f'"{expanded[0]}'] if word.startswith('"') else expanded
        try:
            return evaluate(words, scope.variables, scope.folder)
        except ValueError:
            if any("${" in word for word in call.words):
                return False  # it may use one of CMake's many variables that are unknown here
            shown = " ".join(f'"{word}"' for word in _all_expanded(call.words, scope.variables))
            text = f"given arguments:\n\n    {shown}\n\nUnknown arguments specified"
            raise CMakeError(text, call.line, call.name, scope.file) from None

    def _foreach(self, first: _Call, body: list[_Call], scope: _Scope) -> None:
        words = _all_expanded(first.words, scope.variables)
        if not words:
            raise CMakeError("foreach called with incorrect number of arguments", first.line, "foreach", scope.file)
        name, items = words[0], list(_items(words[1:], scope.variables))
        before = scope.variables.get(name)
        for item in items:
            scope.variables[name] = item
            if not self._run_iteration(body, scope):
                break
        scope.variables.pop(name, None)
        if before is not None:
            scope.variables[name] = before

    def _run_iteration(self, body: list[_Call], scope: _Scope) -> bool:
        """Run the body of a loop once; returns whether the loop continues."""
        try:
            self.block(body, scope)
        except _Leave as leave:
            if leave.args[0] == "return":
                raise
            return bool(leave.args[0] == "continue")
        return True

    # -- commands ------------------------------------------------------------------------------------------------------

    def _run(self, call: _Call, scope: _Scope) -> None:
        words = _all_expanded(call.words, scope.variables)
        function = self._functions.get(call.name)
        if function is not None:
            self._call(function, call, words, scope)
            return
        command = Command(call.name, words, call.line, scope.folder, scope.file)
        if call.name in ("find_package", "ament_auto_find_build_dependencies"):
            for name in self._find(command):
                scope.variables[f"{name}_FOUND"] = "1"
        elif call.name == "include" and words:
            modules = (
                Path(each, f"{words[0]}.cmake") for each in items_of(scope.variables.get("CMAKE_MODULE_PATH", ""))
            )
            self._read(next(filter(Path.is_file, modules), scope.folder / words[0]), scope)
        elif call.name == "add_subdirectory" and words:
            folder = scope.folder / words[0]
            inner = _Scope(
                {**scope.variables, "CMAKE_CURRENT_SOURCE_DIR": str(folder)},
                folder,
                scope.file,
                scope.variables,
                scope.depth,
            )
            self._read(folder / LISTS, inner)
        elif call.name == "set":
            _set_variable(command, scope)
        elif call.name == "project":
            _project(command, scope)
        elif (work_out := VALUE_COMMANDS.get(call.name)) is not None:
            work_out(words, scope.variables, scope.folder)
        if sum(map(len, (scope.variables.get(word, "") for word in words[:2]))) > _MOST_TEXT:
            raise command.error(f"day6-tui keeps at most {_MOST_TEXT} characters in a variable.")
        self.commands.append(command)

    def _call(self, function: _Function, call: _Call, words: list[str], scope: _Scope) -> None:
        if scope.depth >= _DEEPEST:
            raise CMakeError(f"Maximum recursion depth of {_DEEPEST} exceeded", call.line, call.name, scope.file)
        given = dict(zip(function.parameters, words, strict=False))
        more = words[len(function.parameters) :]
        given.update({"ARGN": ";".join(more), "ARGV": ";".join(words), "ARGC": str(len(words))})
        given.update({f"ARGV{number}": word for number, word in enumerate(words)})
        if function.is_macro:
            before = {name: scope.variables.get(name) for name in given}
            scope.variables.update(given)
            scope.depth += 1
            try:
                self.block(function.body, scope)
            finally:
                scope.depth -= 1
                for name, value in before.items():
                    scope.variables.pop(name, None)
                    if value is not None:
                        scope.variables[name] = value
            return
        inner = _Scope({**scope.variables, **given}, scope.folder, scope.file, scope.variables, scope.depth + 1)
        self.file(function.body, inner)

    def _read(self, path: Path, scope: _Scope) -> None:
        """Run another file of the package; does nothing for a module of CMake or ament, which is not a file here."""
        if not path.is_file() or scope.depth >= _DEEPEST:
            return
        shown = Path(os.path.relpath(path, self.top)).as_posix()
        text = path.read_text(encoding="utf-8", errors="replace")
        before, folder = scope.file, scope.variables.get("CMAKE_CURRENT_LIST_DIR", "")
        scope.file, scope.depth = shown, scope.depth + 1
        scope.variables["CMAKE_CURRENT_LIST_DIR"] = str(path.parent)
        self.file(_calls(text, shown), scope)
        scope.file, scope.depth = before, scope.depth - 1
        scope.variables["CMAKE_CURRENT_LIST_DIR"] = folder

    def file(self, calls: list[_Call], scope: _Scope) -> None:
        """Run the commands of a file or function, up to a `return`."""
        try:
            self.block(calls, scope)
        except _Leave:
            return


# -- commands that set variables ---------------------------------------------------------------------------------------


def _set_variable(command: Command, scope: _Scope) -> None:
    name, *values = command.words or [""]
    target = scope.variables
    if values[-1:] == ["PARENT_SCOPE"]:
        values.pop()
        target = scope.parent if scope.parent is not None else target
    elif "CACHE" in values:
        values = values[: values.index("CACHE")]
        if name in target:
            return
    if values:
        target[name] = ";".join(values)
    else:
        target.pop(name, None)


def _project(command: Command, scope: _Scope) -> None:
    for name in command.words[:1]:
        scope.variables.update({"PROJECT_NAME": name, "CMAKE_PROJECT_NAME": name})
        scope.variables["PROJECT_SOURCE_DIR"] = str(scope.folder)


def _items(words: list[str], variables: Mapping[str, str]) -> Iterator[str]:
    """Yield the items of a `foreach`."""
    if words[:1] == ["RANGE"]:
        try:
            numbers = [int(word) for word in words[1:4]]
        except ValueError:
            return
        start, stop = (0, numbers[0]) if len(numbers) == 1 else numbers[:2]
        step = numbers[2] if len(numbers) > 2 else 1
        yield from map(str, range(start, min(stop + 1, start + _MOST_CALLS), max(step, 1)))
        return
    if words[:1] != ["IN"]:
        yield from words
        return
    mode = ""
    for word in words[1:]:
        if word in ("LISTS", "ITEMS"):
            mode = word
        elif mode == "LISTS":
            yield from items_of(variables.get(word, ""))
        else:
            yield word


# -- text --------------------------------------------------------------------------------------------------------------


def _calls(text: str, file: str) -> list[_Call]:
    text = _without_comments(text)
    calls: list[_Call] = []
    at, line, counted = 0, 1, 0
    while match := _COMMAND.search(text, at):
        line += text.count("\n", counted, match.start(1))
        counted = match.start(1)
        words, at = _arguments(text, match.end(), line, file)
        calls.append(_Call(match.group(1).lower(), words, line))
    return calls


def _end_of(calls: list[_Call], start: int, file: str) -> int:
    """Return the index at which the block that begins at `start` ends. Raises CMakeError if it does not end."""
    depth = 0
    for at in range(start, len(calls)):
        depth += (calls[at].name in _BLOCKS) - (calls[at].name in _BLOCKS.values())
        if not depth:
            return at
    raise CMakeError("Flow control statements are not properly nested.", calls[start].line, calls[start].name, file)


def _without_comments(text: str) -> str:
    """Blank out comments, keeping line numbers."""
    text = re.sub(r"(?s)#\[(=*)\[.*?\]\1\]", lambda match: "\n" * match[0].count("\n"), text)
    return re.sub(r'"(?:[^"\\]|\\.)*"|#[^\n]*', lambda match: match[0] if match[0][0] == '"' else "", text)


def _arguments(text: str, at: int, line: int, file: str) -> tuple[list[str], int]:
    words: list[str] = []
    depth = 1
    while match := _WORD.match(text, at):
        at = match.end()
        quoted, plain, opening, closing, _ = match.groups()
        if quoted is not None:
            words.append(f'"{quoted}')
        elif plain is not None:
            words.append(plain)
        elif opening:
            depth += 1
            words.append("(")
        elif closing:
            depth -= 1
            if not depth:
                return words, at
            words.append(")")
    raise CMakeError('Parse error.  Function missing ending ")".  End of file reached.', line, "", file)


def _all_expanded(words: Iterable[str], variables: Mapping[str, str]) -> list[str]:
    return [part for word in words for part in _expanded(word, variables)]


def _expanded(word: str, variables: Mapping[str, str]) -> list[str]:
    quoted = word.startswith('"')
    value = _ESCAPE.sub(_hidden, word[1:] if quoted else word)
    for _ in range(10):  # ${A_${B}} from the inside out
        changed = _REFERENCE.sub(lambda match: _value(match[1], match[2], variables), value)
        if changed == value or len(changed) > _MOST_TEXT:
            break
        value = changed
    return [_shown(value)] if quoted else [_shown(part) for part in value.split(";") if part]


def _hidden(escape: re.Match[str]) -> str:
    """Return the character that an escape sequence stands for, hidden from what expands variables."""
    return _CONTROLS.get(escape[1]) or chr(_HIDDEN + ord(escape[1]))


def _shown(text: str) -> str:
    return "".join(chr(ord(each) - _HIDDEN) if _HIDDEN < ord(each) < _HIDDEN + 128 else each for each in text)


def _value(kind: str | None, name: str, variables: Mapping[str, str]) -> str:
    return variables.get(f"ENV{{{name}}}" if kind else name, "")
