"""The simulated machine and its terminals: the desk, the shell's language, its commands, students' processes.

- The machine: `desk.Desk` is all of it except the drawing; `execute` runs lines on it without a screen.
- A terminal: `terminal.Terminal`, its picture (`screen`, `rows`), its keys (`discipline`), the line being typed
  (`line_editor`, `edit_line`, `history`, `recall`, `completion`), the shell's life in it (`login`, `prompt`).
- The language is in `language/`: reading, expanding, running, jobs.
- Commands: `commands` maps a name to its program; ours are in `builtins/`, the editors' model in `editing/`.
- Students' programs: `process` and `prepared` here, `launch_process` and `memory` on the other side.
- The real terminal and other editors: `subshell`, `variables`, `real_completion`, `ide`.

May import the rest of `core`; nothing here imports Textual or rich.
"""
