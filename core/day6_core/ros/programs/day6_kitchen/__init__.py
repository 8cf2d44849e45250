"""The kitchen: the live graph as a kitchen, in which nodes are cooks, topics are belts and messages are dishes.

`belts` decides over plain facts who stands at which belt, `dishes` what the dishes look like and where they are, `rates`
measures, `model` reads the graph, `kitchen` is the program.
"""
