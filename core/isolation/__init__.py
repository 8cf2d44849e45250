"""Keeps the pupils of one machine apart: their files, their processes, and what each may take of the machine."""
