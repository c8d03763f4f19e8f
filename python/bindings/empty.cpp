// The module of a wheel is empty: what it loads has the code (python/CMakeLists.txt).
