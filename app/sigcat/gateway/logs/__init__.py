"""A log of CAN in one of several forms comes in; its frames go out one after the other, so that a log of any size takes the same
memory, and findings of what cannot be read. Of a log that is damaged, all that can be read is read."""
