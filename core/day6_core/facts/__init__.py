"""What is so: packages of workspaces and what of them is built and sourced, what a setup.py says, what a graph holds.

Plain data and the questions it answers, for whoever says what is wrong: the cards (`day6_core.advice`) and the inspector.
"""
