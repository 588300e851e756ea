"""Integration JSON in, adaptive applications in C++ out, which call the cores and connect them with `ara::`.

Files that are the same in every application are in `cpp`; `player` plays recorded drives to them.
"""
