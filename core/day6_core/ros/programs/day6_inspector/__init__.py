"""The inspector: what is wrong right now, in plain words, and what to type next.

`facts` are what is known, gathered by `model` from the graph (`day6_core.facts`, `listening`, `publications`), from the terminals
(`outputs`) and windows of the desktop, from files (`files`) and from other programs (`asking`, `process_reports`). The rules turn
facts into findings: `rules` those about the graph, `output_rules` and `frame_rules`, `file_rules`, `program_rules` and
`robot_rules` the others. `inspector` is the program.
"""
