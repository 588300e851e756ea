"""Parts of an Integration JSON that an RTE generator would refuse."""
