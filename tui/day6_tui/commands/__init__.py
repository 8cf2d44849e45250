"""The sub-commands of `day6-tui`: their table, and those that need no folder of their own.

A module with a command has `main(words)`, which returns the exit status, and `build_parser(language)`, which help, completion
and the reference ask for.
"""
