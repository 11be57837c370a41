// The one table of queryable state: where each value lies and how queries convert it.
#pragma once

#include "gl/api/family.hpp"
#include "gl/context/types.hpp"

namespace spangle::gl {

struct Context;

/// How a value is kept.
enum class Source : std::uint8_t {
    boolean,  ///< bool in the context
    integer,  ///< GLint, GLuint or GLenum in the context
    real,     ///< Real in the context
    constant, ///< `where` itself
    computed, ///< asked of a function
};

enum class Switch : std::uint8_t {
    none,
    server, ///< Enable, Disable and IsEnabled
    client, ///< IsEnabled only: EnableClientState sets it
};

struct StateRow {
    GLenum name;
    Kind kind; ///< conversion to integers: Kind::color is linear (GL 1.3, 6.1.2)
    Source source;
    Switch toggle;
    std::uint8_t count;
    std::uint32_t where; ///< offset in Context, or the constant
    void (*compute)(const Context& context, GLenum name, Param* out);
    const char* missing; ///< the system this build left out, or null: then the row is there
    bool left_out;
};

inline constexpr int most_values = 16;

/// The row called `name`, or null.
const StateRow* find_state(GLenum name);

/// Writes row.count values.
void load_state(const Context& context, const StateRow& row, Param* out);

} // namespace spangle::gl
