"""In: texts of C and C++, as JSON.
Out: their declarations, as JSON, from clang's parser in a separate process.
"""
