"""In: texts of C and C++, as JSON.
Out: what they declare, as JSON, told by clang's parser in a process of its own.
"""
