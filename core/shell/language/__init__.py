"""The language of the shell: bash's, as far as lessons and an Ubuntu .bashrc use it.

`lexer`, `words`, `parser` and `syntax` read it; `expansion` (with `arithmetic`) and `redirection` prepare it; `interpreter`,
`compound`, `conditional` (with `file_tests`) and `functions` run it on a `shell_state`, and `control_flow` is how they leave;
`jobs` is what it has started.
"""
