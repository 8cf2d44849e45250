"""The language of the shell: bash's. What is not there is refused (`refusals`), before anything of its line runs.

`lexer` (with `tokens`, `words`), `parser` (with `compound_grammar`, `condition_grammar`) and `syntax` read it. `expansion` makes
arguments of words, by `braces`, `parameters`, `patterns`, `file_names`, `regular`, `arithmetic`, `substitution` and `quoting`;
`assignments` and `redirection` do the rest. `interpreter` runs it, with `simple`, `pipelines`, `compound`, `menu`, `conditional`
(with `file_tests`), `functions`, `subshells`, `traps`, `tracing` and `failures`, on a `shell_state` with `variables`, `specials`
and `settings`; `control_flow` has the exceptions that end a line early, `jobs` the programs it has started, `hints` what is
written below a message.
"""
