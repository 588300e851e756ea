"""In: a folder of C or C++ code, as Simulink Coder generates it or as it is written by hand.
Out: a frozen description of its calls, objects, variables and parameters, each with its line.
"""
