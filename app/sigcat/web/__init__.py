"""The pages in the browser, over the same functions as the API.

What a page shows is a view; how it looks is a template.
"""
