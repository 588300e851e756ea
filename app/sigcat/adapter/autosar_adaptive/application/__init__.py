"""Integration JSON in, adaptive applications in C++ out: sources and build files of every executable.

What they do stands in docs/reference/adapter.md, and is done by the core; they connect it to ara::com, ara::exec, ara::diag,
ara::per and ara::log. Files that are the same in every application are in `cpp`, as they are.
"""
