"""What comes in: what was measured on each platform, as one frozen value.
What goes out: the same as JSON, as Markdown and as a page that stands for itself; and that value again, from its JSON.
"""
