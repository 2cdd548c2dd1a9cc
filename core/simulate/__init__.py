"""Render photographs of a DEM with exactly known pose."""
