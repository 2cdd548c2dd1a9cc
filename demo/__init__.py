"""An invented mountain range and viewpoints in it, for the demo, tests and benchmarks; not part of the plugin."""
