"""What messages mean: cards, causes that are looked for in files and graph, and hints below errors. The errors stay as they are.

`cards/*.md` are read by `card_files`, found for a line by `matching`, explained by `explain` with the help of lookers; `rules`
gives the hints. A cause or a hint is told only where it is certain: a wrong one costs a beginner more than none. The shell,
colcon, the inspector and the desktop use this; it imports nothing above the interfaces and the graph.
"""
