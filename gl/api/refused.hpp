// Entry points of systems that this build leaves out.
#pragma once

#include "gl/api/issue.hpp"

#if SPANGLE_MESSAGES || !defined(__ELF__) || defined(__clang__)
#define SPANGLE_REFUSED(text, ...)                                                                           \
    __VA_ARGS__ {                                                                                            \
        refuse_feature(SPANGLE_TEXT(text));                                                                  \
    }
#else
// Without messages these entry points do the same, so one function, which reads no arguments, has all their
// names. clang does not find a static function by its C name.
#pragma GCC diagnostic ignored "-Wattribute-alias"
extern "C" {
[[maybe_unused]] static void spangle_refused() {
    spangle::gl::refuse_feature(nullptr);
}
}
#define SPANGLE_REFUSED(text, ...) __VA_ARGS__ __attribute__((alias("spangle_refused")));
#endif
