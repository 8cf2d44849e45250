"""Run by Python as a folder (`__main__.py`); never imported."""
