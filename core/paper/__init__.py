"""The published method of Twarog, complete and separate from the default method."""
