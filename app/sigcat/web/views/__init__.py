"""Views of pages: values of the other rooms in, values for templates out.

Nothing here knows HTTP.
"""
