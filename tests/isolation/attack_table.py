"""Prints what one pupil can do to another, attack by mode, as tried on this machine: `python -m tests.isolation.attack_table`."""

from __future__ import annotations

from day6_core.isolation import attacks, modes
from tests.isolation.school import asked


def main() -> None:
    """Print the table; under it, why a mode is missing."""
    answers = {name: asked(name, "attacks") for name in modes.NAMES}
    print("| attack |", " | ".join(modes.NAMES), "|")
    print("| --- |" + " --- |" * len(modes.NAMES))
    for attack in attacks.names():
        cells = []
        for answer in answers.values():
            cells.append("not here" if isinstance(answer, str) else "GOT IN" if attack in answer["got"] else "-")
        print(f"| {attack} |", " | ".join(cells), "|")
    for answer in answers.values():
        if isinstance(answer, str):
            print(answer)


if __name__ == "__main__":
    main()
