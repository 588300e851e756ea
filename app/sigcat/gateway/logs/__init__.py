"""A log of CAN in one of several forms comes in; its frames go out one after the other, so that a log of any size takes the same
memory, and findings about unreadable parts. The rest of a damaged log is read."""
