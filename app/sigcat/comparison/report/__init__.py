"""Input: the measurements of each platform, as one frozen value.
Output: the same as JSON, as Markdown and as a self-contained page; and that value again, from its JSON.
"""
