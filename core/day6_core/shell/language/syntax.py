"""The syntax tree of a command line: made by `parser`, run by `interpreter` and `compound`."""

from __future__ import annotations

from dataclasses import dataclass, field

from day6_core.shell.language.words import ArrayLiteral, Word


@dataclass
class Redirection:
    """`fd` is the descriptor to change, None for the operator's own, a text for `{NAME}`; `target` is a file, a descriptor or a
    document's end.
    """

    fd: int | str | None
    operator: str
    target: Word
    document: list[Word] = field(default_factory=list)
    """The body of a here-document, which is there once its line has been read."""


@dataclass(frozen=True)
class Assignment:
    """`name=value`, `name[subscript]+=value`, `name=(…)`."""

    name: str
    subscript: str | None
    append: bool
    value: Word | ArrayLiteral


@dataclass
class SimpleCommand:
    """`A=1 command word … > file`."""

    assignments: list[Assignment] = field(default_factory=list)
    words: list[Word] = field(default_factory=list)
    redirections: list[Redirection] = field(default_factory=list)

    @property
    def source(self) -> str:
        """Its words and redirections as they were typed; of documents only the first line."""
        redirected = (
            f"{'' if each.fd is None else each.fd}{each.operator} {each.target.source}" for each in self.redirections
        )
        return " ".join((*(word.source for word in self.words), *redirected))


@dataclass
class Group:
    """`( list )` in a copy of the shell, or `{ list; }` in the shell itself."""

    body: Sequence
    subshell: bool
    redirections: list[Redirection] = field(default_factory=list)
    source: str = ""
    """As it was typed; of one that is a whole pipeline with its `!` or `time`."""


@dataclass
class For:
    name: str
    words: list[Word] | None
    body: Sequence
    asks: bool = False
    """Whether it is `select`."""
    redirections: list[Redirection] = field(default_factory=list)


@dataclass
class While:
    condition: Sequence
    body: Sequence
    until: bool
    redirections: list[Redirection] = field(default_factory=list)


@dataclass
class If:
    branches: list[tuple[Sequence, Sequence]]
    otherwise: Sequence | None
    redirections: list[Redirection] = field(default_factory=list)


@dataclass
class ArithmeticFor:
    """`for ((first; condition; step))`; an empty condition is true."""

    first: str
    condition: str
    step: str
    body: Sequence
    redirections: list[Redirection] = field(default_factory=list)


@dataclass
class Case:
    """`case word in pattern|pattern) body ;; … esac`; the third of a choice is its end: `;;`, `;&` or `;;&`."""

    word: Word
    choices: list[tuple[list[Word], Sequence, str]]
    redirections: list[Redirection] = field(default_factory=list)


@dataclass
class Arithmetic:
    """`(( … ))`: true if the value is not 0."""

    source: str
    redirections: list[Redirection] = field(default_factory=list)


@dataclass
class Test:
    """One test of `[[ … ]]`; `operator` is '' for a single word, which is true if it is not empty."""

    operator: str
    operands: tuple[Word, ...]


@dataclass
class Not:
    inner: Condition


@dataclass
class AndOrCondition:
    """`left && right`, `left || right`."""

    operator: str
    left: Condition
    right: Condition


Condition = Test | Not | AndOrCondition


@dataclass
class Conditional:
    """`[[ … ]]`."""

    condition: Condition
    redirections: list[Redirection] = field(default_factory=list)


@dataclass
class Function:
    """`name() body`; running this node defines the function."""

    name: str
    body: Command
    source: str
    file: str = ""
    """The file it was defined in."""
    redirections: list[Redirection] = field(default_factory=list)


Command = SimpleCommand | Group | For | While | If | ArithmeticFor | Case | Arithmetic | Conditional | Function


@dataclass
class Pipeline:
    commands: list[Command]
    negated: bool
    source: str
    timed: str = ""
    """Whether `time` stands before it."""
    line: int = 1
    """The number of its line in the text it is in."""


@dataclass
class AndOr:
    """`first && second || third`: operators and pipelines in turn; the first operator is always '&&'."""

    items: list[tuple[str, Pipeline]]
    background: bool
    source: str


@dataclass
class Sequence:
    items: list[AndOr]


COMPOUND = (Group, For, While, If, ArithmeticFor, Case, Arithmetic, Conditional, Function)
