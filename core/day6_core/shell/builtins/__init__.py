"""The commands of the simulated terminal, one module per group; `day6_core/shell/commands.py` lists where each one is.

Each is an `async def command(session) -> int | None`. What they print, errors included, is what bash
and coreutils print. A built-in that changes its shell does so through `shell_of`.
"""
