"""Approximate headings that the accepted photographs of a walk give to others."""
