// A library needs a source: what counts here are the headers compiled with it, scree_tests.cmake lists them.
