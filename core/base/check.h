// Checks for bugs (never for bad input, which is a Result): active in debug and sanitizer builds.
#pragma once

#include <cstdio>
#include <cstdlib>

#ifdef VOXPRITE_CHECKS
#define VOXPRITE_CHECK(condition)                                                              \
    do {                                                                                       \
        if (!(condition)) {                                                                    \
            std::fprintf(stderr, "%s:%d: check failed: %s\n", __FILE__, __LINE__, #condition); \
            std::abort();                                                                      \
        }                                                                                      \
    } while (false)
#else
#define VOXPRITE_CHECK(condition) static_cast<void>(0)
#endif
