"""The QGIS shell: each algorithm reads its parameters, calls the core and writes the results."""
