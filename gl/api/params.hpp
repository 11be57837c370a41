// Commands of a pname and its values, and their queries: one function for the entry points of a family,
// whatever the type of the values.
#pragma once

#include "gl/api/convert.hpp"
#include "gl/api/issue.hpp"

namespace spangle::gl {

// What stands before the pname is a target, or nothing.
template <class F, const auto& rows>
[[gnu::noinline]] void issue_param(GLenum pname, const void* value, convert::Number type) {
    issue<F>(pname, convert::scalar(find_shape(rows, pname), value, type));
}
template <class F, const auto& rows>
[[gnu::noinline]] void issue_param(GLenum target, GLenum pname, const void* value, convert::Number type) {
    issue<F>(target, pname, convert::scalar(find_shape(rows, pname), value, type));
}

template <class F, const auto& rows>
[[gnu::noinline]] void issue_params(GLenum pname, const void* values, convert::Number type,
                                    const char* null_text) {
    if (values == nullptr)
        return refuse_null(null_text);
    issue<F>(pname, convert::vector(find_shape(rows, pname), values, type));
}
template <class F, const auto& rows>
[[gnu::noinline]] void issue_params(GLenum target, GLenum pname, const void* values, convert::Number type,
                                    const char* null_text) {
    if (values == nullptr)
        return refuse_null(null_text);
    issue<F>(target, pname, convert::vector(find_shape(rows, pname), values, type));
}

template <class F, const auto& rows>
[[gnu::noinline]] void fetch_params(GLenum target, GLenum pname, void* out, convert::Number type,
                                    const char* null_text) {
    if (out == nullptr)
        return refuse_null(null_text);
    Params found;
    fetch<F>(found, target, pname);
    convert::store(find_shape(rows, pname), found, out, type);
}
template <class F, const auto& rows>
[[gnu::noinline]] void fetch_params(GLenum target, GLint level, GLenum pname, void* out, convert::Number type,
                                    const char* null_text) {
    if (out == nullptr)
        return refuse_null(null_text);
    Params found;
    fetch<F>(found, target, level, pname);
    convert::store(find_shape(rows, pname), found, out, type);
}

} // namespace spangle::gl
