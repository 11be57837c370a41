// Commands with a pname and its values, and their queries. The entry points of a family share one function
// for all types of values.
#pragma once

#include "gl/api/convert.hpp"
#include "gl/api/issue.hpp"

namespace spangle::gl {

/// A command and the shapes of its pnames.
struct ParamFamily {
    const Command* command;
    const ShapeRow* rows;
};
template <class F, const auto& rows> inline constexpr ParamFamily params_of{&command<F>, rows};

// All families share this code. Families without a target do not use `target`. The family is the last
// argument, so that the arguments of an entry point stay in their registers.
void issue_value(GLenum target, GLenum pname, std::uint32_t word, convert::Number type,
                 const ParamFamily& family);
void issue_values(GLenum target, GLenum pname, const void* values, convert::Number type,
                  const ParamFamily& family, const char* null_text);

template <class F, const auto& rows>
[[gnu::noinline]] void issue_param(GLenum pname, std::uint32_t word, convert::Number type) {
    if constexpr (F::listing == Listing::never)
        issue<F>(pname, convert::vector(find_shape(rows, pname), &word, type)); // PixelStore takes one value
    else
        issue_value(0, pname, word, type, params_of<F, rows>);
}
template <class F, const auto& rows>
[[gnu::noinline]] void issue_param(GLenum target, GLenum pname, std::uint32_t word, convert::Number type) {
    issue_value(target, pname, word, type, params_of<F, rows>);
}

template <class F, const auto& rows>
[[gnu::noinline]] void issue_params(GLenum pname, const void* values, convert::Number type,
                                    const char* null_text) {
    issue_values(0, pname, values, type, params_of<F, rows>, null_text);
}
template <class F, const auto& rows>
[[gnu::noinline]] void issue_params(GLenum target, GLenum pname, const void* values, convert::Number type,
                                    const char* null_text) {
    issue_values(target, pname, values, type, params_of<F, rows>, null_text);
}

/// Whether all pnames have the same shape. If so, no table is searched.
template <std::size_t count> constexpr bool all_alike(const ShapeRow (&rows)[count]) {
    for (std::size_t i = 0; i + 1 < count; ++i)
        if (rows[i].kind != rows[0].kind || rows[i].count != rows[0].count)
            return false;
    return true;
}

/// The function that answers the queries of a family, and the shapes of their pnames.
struct AnswerFamily {
    void (*answer)(Context& context, GLenum target, GLenum pname, Params& out);
    const ShapeRow* rows;
};
template <class F, const auto& rows> inline constexpr AnswerFamily answers_of{F::run, rows};

[[gnu::noinline]] inline void fetch_values(GLenum target, GLenum pname, void* out, convert::Number type,
                                           const AnswerFamily& family, const CommandText* text,
                                           const char* null_text) {
    if (out == nullptr)
        return refuse_null(null_text);
    Params found;
    if (Context* context = outside_begin_end(text); context != nullptr) {
        family.answer(*context, target, pname, found);
        const Arg given[] = {target, pname};
        explain_error(*context, text, given, 2);
    }
    convert::store(find_shape(family.rows, pname), found, out, type);
}

template <class F, const auto& rows>
[[gnu::noinline]] void fetch_params(GLenum target, GLenum pname, void* out, convert::Number type,
                                    const char* null_text) {
    static_assert(F::listing == Listing::never && !F::inside);
    fetch_values(target, pname, out, type, answers_of<F, rows>, F::text, null_text);
}
template <class F, const auto& rows>
[[gnu::noinline]] void fetch_params(GLenum target, GLint level, GLenum pname, void* out, convert::Number type,
                                    const char* null_text) {
    if (out == nullptr)
        return refuse_null(null_text);
    Params found;
    fetch<F>(found, target, level, pname);
    convert::store(all_alike(rows) ? Shape{rows[0].kind, rows[0].count} : find_shape(rows, pname), found, out,
                   type);
}

} // namespace spangle::gl
