"""The code that the algorithms share: parameters, fields, outputs, styling and messages."""
