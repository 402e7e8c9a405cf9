// Compiles nothing: it carries the precompiled header that all tests share.
