"""Random robots as URDF text, for whatever two readers must agree on."""

from __future__ import annotations

import random
from collections.abc import Callable

import pytest

KINDS = ("fixed", "continuous", "revolute", "prismatic", "floating", "planar")


@pytest.fixture
def random_description() -> Callable[..., str]:
    """A function `(random.Random, links=9, kinds=…, mimics=True) -> URDF text`."""
    return describe


def describe(choice: random.Random, links: int = 9, kinds: tuple[str, ...] = KINDS, mimics: bool = True) -> str:
    """Return a tree of links with joints of these kinds, mimic joints, every shape, materials by name and in place."""
    parts = ['<material name="global"><color rgba="0.1 0.2 0.3 1"/></material>']
    parts += [_link(choice, number) for number in range(links)]
    movers: list[str] = []
    for child in range(1, links):
        kind = choice.choice(kinds)
        name = f"j{child}"
        mimic = ""
        if kind in ("continuous", "revolute", "prismatic"):
            if mimics and movers and choice.random() < 0.3:
                mimic = f'<mimic joint="{choice.choice(movers)}" multiplier="{_n(choice)}" offset="{_n(choice)}"/>'
            else:
                movers.append(name)
        limit = '<limit lower="-1" upper="2" effort="3" velocity="4"/>' if kind in ("revolute", "prismatic") else ""
        # `dynamics` comes as text out of yourdfpy
        dynamics = '<dynamics damping="0.5" friction="0.25"/>' if choice.random() < 0.3 else ""
        parts.append(
            f'<joint name="{name}" type="{kind}"><parent link="l{choice.randrange(child)}"/><child link="l{child}"/>'
            f"{_origin(choice)}{_axis(choice)}{limit}{mimic}{dynamics}</joint>"
        )
    return f'<robot name="random">{"".join(parts)}</robot>'


def _n(choice: random.Random) -> str:
    return repr(round(choice.uniform(-2, 2), 4))


def _vector(choice: random.Random) -> str:
    return " ".join(_n(choice) for _ in range(3))


def _origin(choice: random.Random) -> str:
    return f'<origin xyz="{_vector(choice)}" rpy="{_vector(choice)}"/>' if choice.random() < 0.9 else ""


def _axis(choice: random.Random) -> str:
    # yourdfpy does not normalise the axis of a prismatic joint, KDL does: only axes of length 1 are the same for both.
    return f'<axis xyz="{choice.choice(["1 0 0", "0 1 0", "0 0 -1", "0.6 0 0.8", "0 -0.8 0.6"])}"/>'


def _link(choice: random.Random, number: int) -> str:
    shapes = (
        f'<box size="{abs(float(_n(choice)))} 1 2"/>',
        '<cylinder radius="0.5" length="0.1"/>',
        '<sphere radius="0.25"/>',
        '<mesh filename="package://p/m.stl" scale="1 2 3"/>',
        '<mesh filename="m.dae"/>',
    )
    material = choice.choice(
        (
            "",
            '<material name="global"/>',
            f'<material name="own{number}"><color rgba="1 0 0 0.5"/></material>',
            '<material name="shared"><color rgba="0 1 0 1"/></material>',
            '<material name="picture"><texture filename="p.png"/></material>',
            '<material name="nowhere"/>',
        )
    )
    visual = f"<visual>{_origin(choice)}<geometry>{choice.choice(shapes)}</geometry>{material}</visual>"
    inertia = '<inertia ixx="1" ixy="0.1" ixz="0.2" iyy="2" iyz="0.3" izz="3"/>'
    inertial = f'<inertial>{_origin(choice)}<mass value="1.5"/>{inertia}</inertial>' if choice.random() < 0.5 else ""
    collision = f'<collision name="c">{_origin(choice)}<geometry>{choice.choice(shapes)}</geometry></collision>'
    return f'<link name="l{number}">{inertial}{visual}{collision if choice.random() < 0.5 else ""}</link>'
