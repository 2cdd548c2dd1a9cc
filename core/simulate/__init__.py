"""Rendering of photographs of a DEM with an exactly known pose."""
