"""An interface package of Integration JSON in; message and service files, package.xml and CMakeLists.txt out.

rosidl builds it, and takes the comments into what it generates.
"""
