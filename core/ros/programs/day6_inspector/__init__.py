"""The inspector: what is wrong with the graph right now, in plain words.

`_rules` holds the rules over plain facts, `_facts` gathers the facts through a node, `inspector` is the program.
"""
