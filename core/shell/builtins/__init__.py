"""The commands of the simulated terminal, one module per group; `core/shell/commands.py` says which is where.

Each module has a table `COMMANDS: name -> async def main(session) -> int | None`. What they print, errors included, is what bash
and coreutils print. A built-in that changes its shell does so through `session.shell`.
"""
