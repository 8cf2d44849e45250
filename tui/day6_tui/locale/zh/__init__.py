"""The Chinese texts: a module for each part of the interface; `catalogue` merges them."""
