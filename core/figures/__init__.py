"""Drawings of results: overlays, profiles, score curves and maps as arrays or SVG."""
