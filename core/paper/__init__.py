"""The published method of Twarog, all of it and only here, separate from the default method."""
