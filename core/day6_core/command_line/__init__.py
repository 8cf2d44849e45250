"""What all sub-commands of `day6-tui` have in common: the parser, the kinds of values, and every text of the command line.

The table of the commands is in `day6_tui.commands`; a module with a command has `main(words)` and `build_parser(language)`.
"""
