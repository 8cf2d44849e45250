"""The simulated machine and its terminals: the desk, the shell's language, its commands, students' processes.

`desk.Desk` is the machine, `terminal.Terminal` one terminal of it, `interpreter.Shell` the shell in it, `builtins/` its commands,
`execute` the same without a screen. May import the rest of `core`; nothing here imports Textual or rich.
"""
