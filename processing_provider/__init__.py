"""The provider of the Processing toolbox, with its algorithms and models."""
