"""Layouts that can be written down: trees of splits with roles ('terminal 2', 'rviz2 1') for panes; and the ready ones."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TypeAlias

from day6_tui.panes.splits import Key, Node, Split, Stack, Tree

VERSION = 1

Description: TypeAlias = Mapping[str, object]
"""What JSON keeps of a tree."""

DEEPEST = 20
"""More splits inside each other than anybody makes."""

SPOKEN = 0.6
"""The part of the desktop that the terminal gets when one speaks."""

PAGE, PAGE_COLUMNS = 0.375, (38, 45)
"""The part of the desktop that the page of a lesson gets, and the fewest and the most columns."""

LOWER_TALLER = (0.46, 0.54)
"""The parts of two terminals of a lesson: in the lower one, the newer, `ros2 topic echo` shows a whole Twist at 80x24."""

PRESENTED = 0.7
"""The part of the desktop that the picture gets when one presents."""


def describe(tree: Tree, role_of: Callable[[Key], str]) -> Description | None:
    """A tree with roles for its panes; None for an empty one. Panes whose role is '' are left out."""
    return _described(tree.root, role_of) if tree.root is not None else None


def _described(node: Node, role_of: Callable[[Key], str]) -> Description | None:
    if isinstance(node, Stack):
        roles = [role for key in node.keys if (role := role_of(key))]
        return {"stack": roles, "front": role_of(node.front) or roles[0]} if roles else None
    parts = [_described(part, role_of) for part in node.parts]
    shares = node.shares if node.shares is not None and all(parts) else None
    return {"across": node.across, "parts": [part for part in parts if part], "shares": shares}


def build(description: object, key_of: Callable[[str], Key | None]) -> Tree:
    """The tree of a description; roles that nobody plays are left out, and what they held is closed up.

    Raises:
        ValueError: it is no description.
    """
    return Tree(_built(description, key_of, DEEPEST))


def roles_in(description: object) -> list[str]:
    """All roles of a description. Raises ValueError if it is none."""
    found: list[str] = []

    def note(role: str) -> Key | None:
        found.append(role)
        return None

    build(description, note)
    return found


def _built(node: object, key_of: Callable[[str], Key | None], depth: int) -> Node | None:
    if not isinstance(node, Mapping) or depth < 0:
        raise ValueError("no layout")
    if "stack" in node:
        roles, front = node["stack"], node.get("front")
        if not isinstance(roles, list) or not all(isinstance(role, str) for role in roles):
            raise ValueError("no layout")
        keys = {role: key for role in roles if (key := key_of(role)) is not None}
        return Stack(list(keys.values()), keys.get(str(front), next(iter(keys.values())))) if keys else None
    across, parts, shares = node.get("across"), node.get("parts"), node.get("shares")
    if not isinstance(across, bool) or not isinstance(parts, list):
        raise ValueError("no layout")
    built = [_built(part, key_of, depth - 1) for part in parts]
    if shares is not None and (
        not isinstance(shares, list)
        or len(shares) != len(parts)
        or not all(isinstance(share, float) and 0 < share <= 1 for share in shares)
    ):
        raise ValueError("no layout")
    kept = [(part, shares[index] if shares else 0.0) for index, part in enumerate(built) if part is not None]
    if len(kept) < 2:
        return kept[0][0] if kept else None
    flat: list[tuple[Node, float]] = []
    for part, share in kept:
        if isinstance(part, Split) and part.across == across:
            inner = part.shares or [1 / len(part.parts)] * len(part.parts)
            flat += [(each, share * inner[index]) for index, each in enumerate(part.parts)]
        else:
            flat.append((part, share))
    total = sum(share for _, share in flat)
    return Split(across, [part for part, _ in flat], [share / total for _, share in flat] if shares else None)


# -- ready ones ------------------------------------------------------------------------------------------------------------


def grid(terminals: Sequence[Key], windows: Sequence[Key], *, wide: bool) -> Tree:
    """Four terminals, two by two (more are tabs of the last), and the windows as tabs of one place beside or above them."""
    tree = Tree()
    for index, key in enumerate(terminals):
        beside, side = ((None, ""), (0, "right"), (0, "below"), (1, "below"), (3, "tab"))[min(index, 4)]
        tree.add(key, None if beside is None else terminals[beside], side)
    if len(terminals) > 4:
        tree.bring_to_front(terminals[3])
    _add_stack(tree, windows, "right" if wide else "above")
    return tree


def presenter(terminals: Sequence[Key], windows: Sequence[Key], *, wide: bool) -> Tree:
    """A big picture, with the other windows behind it, and one terminal, with the others behind it."""
    tree = Tree()
    _add_stack(tree, windows, "")
    _add_stack(tree, terminals, "right" if wide else "below")
    if isinstance(tree.root, Split):
        tree.root.shares = [PRESENTED, 1 - PRESENTED]
    return tree


def speaker(terminals: Sequence[Key], windows: Sequence[Key], *, wide: bool) -> Tree:
    """A big terminal, with the others behind it, and one picture on its right or above it, with the other windows behind it."""
    tree = Tree()
    _add_stack(tree, terminals, "")
    _add_stack(tree, windows, "right" if wide else "above")
    if isinstance(tree.root, Split):
        shares = [SPOKEN, 1 - SPOKEN]
        tree.root.shares = shares if wide else shares[::-1]
    return tree


def lesson(
    page: Key,
    done_in: Sequence[Key],
    pictures: Sequence[Key],
    terminals: Sequence[Key],
    windows: Sequence[Key],
    columns: int,
) -> Tree:
    """A step of a lesson: its page on the right, the panes it is done in on the left, and pictures below both by turns.

    The other `terminals` are tabs of the last one it is done in, the other `windows` of the last picture. The desktop has
    so many `columns`.
    """
    left, right = list(done_in), [page]
    for picture in pictures:
        min((left, right), key=len).append(picture)
    behind: dict[Key, list[Key]] = {}
    behind.setdefault(left[max(0, len(done_in) - 1)], []).extend(terminals)
    behind.setdefault([page, *pictures][-1], []).extend(windows)

    def column(keys: Sequence[Key]) -> Node:
        places: list[Node] = [Stack([key, *behind.get(key, ())], key) for key in keys]
        shares = list(LOWER_TALLER) if keys == done_in and len(keys) == len(LOWER_TALLER) else None
        return Split(False, places, shares) if len(places) > 1 else places[0]

    part = max(PAGE_COLUMNS[0], min(PAGE_COLUMNS[1], PAGE * columns)) / max(columns, 2 * PAGE_COLUMNS[0])
    return Tree(Split(True, [column(left), column(right)], [1 - part, part]))


def _add_stack(tree: Tree, keys: Sequence[Key], side: str) -> None:
    """Put panes at a side of everything, as tabs of one place; the first one is seen."""
    for key in keys:
        if key == keys[0]:
            tree.add(key, None, side)
        else:
            tree.add(key, keys[0], "tab")
    if keys:
        tree.bring_to_front(keys[0])
