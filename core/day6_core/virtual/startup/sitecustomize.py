"""Python imports this when it starts, from a folder that is on PYTHONPATH in virtual time; see `day6_core/virtual`."""

import os
import sys


def _begin() -> None:
    if os.environ.get("DAY6_TIME"):
        from day6_core.virtual.follow import begin

        begin()


def _run_the_one_behind() -> None:
    """This module hides another one of its name."""
    from importlib.machinery import PathFinder

    here = os.path.dirname(__file__)
    spec = PathFinder.find_spec(__name__, [folder for folder in sys.path if folder != here])
    if spec is not None and spec.loader is not None:
        from importlib.util import module_from_spec

        module = module_from_spec(spec)
        sys.modules[__name__] = module
        spec.loader.exec_module(module)


_begin()
_run_the_one_behind()
