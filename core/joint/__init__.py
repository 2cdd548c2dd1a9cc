"""Hints that accepted photographs give to others of the same walk."""
