"""What the Processing toolbox shows: the provider with its algorithms and models."""
