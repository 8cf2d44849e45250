"""The language of the shell: bash's, as far as lessons and an Ubuntu .bashrc use it.

`lexer`, `words`, `parser` and `syntax` read it; `expansion` (with `arithmetic`) and `redirection` prepare it; `interpreter`,
`compound`, `conditional` (with `file_tests`) and `functions` run it on a `shell_state`; `control_flow` has the exceptions that
end a line early, `jobs` the programs it has started.
"""
