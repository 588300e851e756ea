"""The bench: what a vendor's platform and generator would bring, so that an application runs on any desk.

In: an integration model. Out: implementation datatypes, proxies and skeletons in C++, and the runtime below them.
"""
