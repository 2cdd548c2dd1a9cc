"""QGIS Processing algorithms: thin shells that read, call the core, and write."""
