"""Skyline Viewshed's domain code: pure Python on NumPy and SciPy, no QGIS and no Qt."""
