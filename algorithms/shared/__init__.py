"""What the algorithms share: parameters, fields, outputs, styling and messages."""
