"""The inspector: what is wrong with the graph right now, in plain words.

`rules` holds the rules over plain facts, `model` gathers the facts through a node, `inspector` is the program.
"""
