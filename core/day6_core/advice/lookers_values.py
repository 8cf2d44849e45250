"""Lookers for the contents of a message, a request or a goal on the command line: blanks after colons, names of fields, depth."""

from __future__ import annotations

import re
import shlex
from collections.abc import Mapping

from day6_core.advice import known
from day6_core.advice.looking import Found, Situation, found, looker
from day6_core.facts.names import nearest
from day6_core.language import language_of
from day6_urdf.explain import chinese_numbers

_TYPE = re.compile(r"\b[a-z]\w*/(?:(?:msg|srv|action)/)?[A-Z]\w*")
_DEEPEST = 4
"""Messages within messages that are looked at."""

_OF_COMMAND = {"topic": "msg", "service": "srv", "action": "action"}

_TURNING = {"geometry_msgs/msg/Twist": {"z": "angular"}}
"""Which of several fields is meant where only one makes sense for what drives on the ground."""


@looker
def chinese_value(scene: Situation) -> Found | None:
    """Chinese punctuation in a number of a robot description."""
    text = chinese_numbers(scene.said, language_of(scene.variables))
    return found("said", "", text=text) if text else None


@looker
def fields(scene: Situation) -> Found | None:
    """What does not fit between the contents that were typed and their type, and the line put right."""
    whole, text = sent(scene)
    layout = known.sent_layout(whole, scene.variables) if whole else {}
    if not layout:
        return None
    fixed, first = _with_blanks(text, _names_below(layout, scene.variables))
    if first:
        return found("value.blank", _put_right(scene, text, fixed), name=first)
    if len(layout) == 1 and text and not re.search(r"[:{}\[\]]", text):
        only = next(iter(layout))
        fixed = f"{{{only}: {text}}}"
        return found("value.name", _put_right(scene, text, fixed), name=only, right=fixed)
    reason = scene.value("reason")
    show = shlex.join(["ros2", "interface", "show", whole])
    missing = re.search(r"'(\w+)' object has no attribute '([^']+)'", reason)
    if missing is not None:
        return _no_field(scene, whole, text, layout, missing[1], missing[2]) or _listed(whole, layout, show)
    if "expected to be a dictionary" in reason:
        for name, base in layout.items():
            inner = known.layout_of(base, scene.variables)
            if inner and re.search(rf"\b{name}:\s*[^\s{{]", text):
                shape = ", ".join(f"{each}: …" for each in inner)
                return found("value.deeper", show, name=name, right=f"{name}: {{{shape}}}")
    named = re.search(r"The '(\w+)' field must be", reason)
    literal = re.search(r"(?:literal for int\(\) with base 10|could not convert string to float): '([^']*)'", reason)
    wrong = named or (re.search(rf"\b(\w+):\s*['\"]?{re.escape(literal[1])}", text) if literal is not None else None)
    kinds = _names_below(layout, scene.variables)
    if wrong is not None and kinds.get(wrong[1]) in _WORDS:
        return found(f"value.{_WORDS[kinds[wrong[1]]]}", show, name=wrong[1], **_limits(kinds[wrong[1]]))
    return _listed(whole, layout, show)


@looker
def unquoted(scene: Situation) -> Found | None:
    """Contents without quotation marks around them, which the shell takes for several words."""
    line = scene.command
    found_type = _TYPE.search(line)
    if found_type is None or line[found_type.end() : found_type.end() + 1] != " ":
        return None
    rest = line[found_type.end() :].strip()
    if re.search(r"[\"'$`]|(?:^|\s)-", rest) or ":" not in rest:
        return None
    return found("value.unquoted", f'{line[: found_type.end()]} "{rest}"')


def sent(scene: Situation) -> tuple[str, str]:
    """Return the type that a command line names, in three parts, and the contents behind it; '' for what is not there."""
    words = scene.words()
    kind = _OF_COMMAND.get(words[1], "") if words[:1] == ["ros2"] and len(words) > 1 else ""
    for index, word in enumerate(words):
        if kind and _TYPE.fullmatch(word):
            whole = word if word.count("/") == 2 else word.replace("/", f"/{kind}/")
            return whole, next((each for each in words[index + 1 :] if not each.startswith("-")), "")
    return "", ""


def _names_below(layout: Mapping[str, str], variables: Mapping[str, str], depth: int = 0) -> dict[str, str]:
    """The names of all fields, those of inner messages too, each with its type; the outer one counts."""
    names: dict[str, str] = {}
    for base in layout.values():
        if base.count("/") == 2 and depth < _DEEPEST:
            names |= _names_below(known.layout_of(base, variables), variables, depth + 1)
    return names | dict(layout)


def _with_blanks(text: str, names: Mapping[str, str]) -> tuple[str, str]:
    """The contents with a blank after each `name:` that has none, and the first such name ('': there is none)."""
    quoted = re.compile(r"'[^']*'|\"[^\"]*\"")
    pattern = re.compile(rf"(?<![\w.])({'|'.join(map(re.escape, sorted(names, key=len, reverse=True)))})\s*:(?=[^\s])")
    first = ""
    parts, end = [], 0
    for start, stop in [*(each.span() for each in quoted.finditer(text)), (len(text), len(text))]:
        plain = text[end:start]
        if (hit := pattern.search(plain)) is not None:
            first = first or hit[1]
        parts += [pattern.sub(r"\1: ", plain), text[start:stop]]
        end = stop
    return "".join(parts), first


def _no_field(scene: Situation, whole: str, text: str, layout: Mapping[str, str], kind: str, name: str) -> Found | None:
    """A field that is inside another one, or nearly another one."""
    own = kind.removesuffix("_Request").removesuffix("_Goal") == whole.rpartition("/")[2]
    holders = [each for each, base in layout.items() if name in known.layout_of(base, scene.variables)]
    if own and holders:
        meant = _TURNING.get(whole, {}).get(name, holders[0])
        example = f"{{{meant}: {{{name}: {_value_of(name, text)}}}}}"
        fixed = _nested(text, layout, whole, scene.variables)
        right = _put_right(scene, text, fixed) if fixed else ""
        return found("value.inside", right, name=name, holders=", ".join(holders), right=fixed or example)
    names = list(layout if own else _names_below(layout, scene.variables))
    near = nearest(name, names)
    if near and re.search(rf"\b{re.escape(name)}\b", text):
        fixed = re.sub(rf"\b{re.escape(name)}\b", near, text, count=1)
        return found("value.near", _put_right(scene, text, fixed), name=name, near=near)
    return None


def _nested(text: str, layout: Mapping[str, str], whole: str, variables: Mapping[str, str]) -> str:
    """`{x: 2.0, z: 1.8}` with each name inside the field that has it; '' for contents that are not so plain."""
    pairs = re.fullmatch(r"\{?\s*(\w+: *[^\s,{}\[\]]+(?:\s*,\s*\w+: *[^\s,{}\[\]]+)*)\s*\}?", text)
    if pairs is None:
        return ""
    inside: dict[str, list[str]] = {}
    for pair in re.split(r"\s*,\s*", pairs[1]):
        name, _, value = pair.partition(":")
        holders = [each for each, base in layout.items() if name in known.layout_of(base, variables)]
        if not holders:
            return ""
        holder = _TURNING.get(whole, {}).get(name, holders[0])
        inside.setdefault(holder, []).append(f"{name}: {value.strip()}")
    return "{" + ", ".join(f"{holder}: {{{', '.join(values)}}}" for holder, values in inside.items()) + "}"


def _value_of(name: str, text: str) -> str:
    value = re.search(rf"\b{re.escape(name)}:\s*([^\s,{{}}]+)", text)
    return value[1] if value is not None else "1.0"


_WORDS = dict.fromkeys(("int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64"), "integer") | {
    "float32": "decimal", "float64": "decimal", "bool": "bool", "string": "string",
}  # fmt: skip
"""Types of fields -> the text that says what they take."""


def _limits(kind: str) -> dict[str, object]:
    from day6_core.interfaces.fields import PRIMITIVES

    return {"low": PRIMITIVES[kind].low, "high": PRIMITIVES[kind].high} if _WORDS[kind] == "integer" else {}


def _listed(whole: str, layout: Mapping[str, str], show: str) -> Found:
    return found("value.fields", show, type=whole, fields=", ".join(layout))


def _put_right(scene: Situation, text: str, fixed: str) -> str:
    """The line with other contents, within the quotation marks it has or needs; '' if that cannot be done safely."""
    line = scene.command
    if not text or line.count(text) != 1 or re.search(r'["$`\\!]', fixed):
        return ""
    begin = line.index(text)
    quoted = line[begin - 1] in "\"'" and line[begin + len(text) : begin + len(text) + 1] == line[begin - 1]
    return line.replace(text, fixed if quoted else f'"{fixed}"')
