"""From image positions to map positions and back, for a photograph with a known pose."""
