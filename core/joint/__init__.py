"""The photographs of a walk as one problem: what each is, given all the others."""
