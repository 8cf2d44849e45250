"""Makes the pictures of the documentation: `python -m tests.pictures` plays every script of docs/pictures, with names only these."""

from __future__ import annotations

import argparse
import sys

from tests import conftest as surroundings  # first: it sets every variable

# isort: split
from tests.pictures.playing import drawn, frames_of
from tests.pictures.script import LANGUAGES, names, script


def main() -> int:
    """Play and draw; the exit status is 1 if a script did not reach its screen."""
    parser = argparse.ArgumentParser(prog="python -m tests.pictures", description=__doc__)
    parser.add_argument("names", metavar="NAME", nargs="*", choices=[[], *names()], help="all of them without names")
    parser.add_argument("--lang", choices=LANGUAGES, action="append", help="both without it")
    options = parser.parse_args()
    surroundings.set_environment({**surroundings.environment(), "TZ": "UTC"})
    failed = 0
    for lang in options.lang or LANGUAGES:
        for name in options.names or names():
            told = script(name, lang)
            try:
                text = drawn(told, frames_of(told))
            except AssertionError as error:
                failed += 1
                print(f"{told.picture.name}: {error}", file=sys.stderr)
                continue
            told.picture.write_text(text, encoding="utf-8", newline="\n")
            print(f"{told.picture.name}: {len(text.encode()) / 1000:.0f} kB", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
