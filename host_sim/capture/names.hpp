// The names of precisions and formats, as the variables of the drop-in pair and the options of the command
// line use them (docs/programs.md).
#pragma once

#include <string>
#include <string_view>

#include <spangle/EGL/egl.h>
#include <spangle/format.hpp>

namespace spangle::names {

struct Precision {
    const char* name;
    EGLint value; ///< value of the attribute EGL_PRECISION_SPANGLE
};
inline constexpr Precision precisions[] = {{"exact", EGL_PRECISION_EXACT_SPANGLE},
                                           {"balanced", EGL_PRECISION_BALANCED_SPANGLE},
                                           {"fast", EGL_PRECISION_FAST_SPANGLE},
                                           {"double", EGL_PRECISION_DOUBLE_SPANGLE},
                                           {"shadow", EGL_PRECISION_SHADOW_SPANGLE},
                                           {"shadow-balanced", EGL_PRECISION_SHADOW_BALANCED_SPANGLE},
                                           {"shadow-fast", EGL_PRECISION_SHADOW_FAST_SPANGLE}};

struct Format {
    const char* name;
    PixelFormat value;
};
inline constexpr Format formats[] = {
    {"rgb565", PixelFormat::rgb565_be}, {"rgb565_le", PixelFormat::rgb565_le},
    {"rgb888", PixelFormat::rgb888},    {"rgba8888", PixelFormat::rgba8888},
    {"rgb666", PixelFormat::rgb666},    {"rgb444", PixelFormat::rgb444},
    {"rgb332", PixelFormat::rgb332},    {"grey4", PixelFormat::grey4},
    {"mono", PixelFormat::mono}};

/// The row of the table that has that name, or null.
template <class Row, unsigned Count>
constexpr const Row* find(const Row (&table)[Count], std::string_view name) {
    for (const Row& row : table)
        if (name == row.name)
            return &row;
    return nullptr;
}

/// The name of a value; empty if it has none.
template <class Row, unsigned Count, class Value>
constexpr const char* name_of(const Row (&table)[Count], Value value) {
    for (const Row& row : table)
        if (value == row.value)
            return row.name;
    return "";
}

/// All names of a table, as a sentence lists them: "a, b or c".
template <class Row, unsigned Count> std::string listed(const Row (&table)[Count]) {
    std::string out;
    for (unsigned i = 0; i < Count; ++i)
        out += std::string(i == 0 ? "" : i + 1 < Count ? ", " : " or ") + table[i].name;
    return out;
}

} // namespace spangle::names
