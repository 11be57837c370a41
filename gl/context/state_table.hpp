// The one table of state: where each value lies, how queries convert it, and which attribute group saves it.
#pragma once

#include <array>
#include <span>

#include <spangle/message.hpp>

#include "gl/api/family.hpp"
#include "gl/context/types.hpp"

namespace spangle::gl {

struct Context;

/// How a value is kept, and as what it converts.
enum class Source : std::uint8_t {
    boolean,       ///< bool in the context
    integer,       ///< GLint, GLuint or GLenum in the context
    real,          ///< Real in the context
    color,         ///< the same, linear as an integer (GL 1.3, 6.1.2)
    pointer,       ///< of client memory: GetPointerv only
    constant,      ///< `where` itself
    computed,      ///< an integer, asked of a function
    computed_real, ///< a Real, likewise
};

constexpr Kind kind_of(Source source) {
    constexpr unsigned of_each = 0x2A4A; // 2 bits for each, in their order
    return static_cast<Kind>(of_each >> static_cast<unsigned>(source) * 2 & 3);
}
static_assert(kind_of(Source::boolean) == Kind::integer && kind_of(Source::integer) == Kind::integer &&
              kind_of(Source::real) == Kind::real && kind_of(Source::color) == Kind::color &&
              kind_of(Source::constant) == Kind::integer && kind_of(Source::computed) == Kind::integer &&
              kind_of(Source::computed_real) == Kind::real);

/// What Enable, Disable and IsEnabled take.
enum class Switch : std::uint8_t {
    none,
    server,
    client, ///< ENABLE_BIT does not save it
};

/// Attribute groups by the number of their bit (GL 1.3, table 6.4), those of the client behind the others.
enum class Group : std::uint8_t {
    current,
    point,
    line,
    polygon,
    polygon_stipple,
    pixel_mode,
    lighting,
    fog,
    depth_buffer,
    accum_buffer,
    stencil_buffer,
    viewport,
    transform,
    enable,
    color_buffer,
    hint,
    eval,
    list,
    texture,
    scissor,
    multisample = 29,
    client_pixel_store,
    client_vertex_array,
    none = 28, ///< no mask has this bit
};

/// Which units have values of their own, one behind the other.
enum class Unit : std::uint8_t {
    none,
    texture, ///< a TextureUnitState each
    coords,  ///< four Reals each
    client,  ///< a ClientArray each; of ClientActiveTexture, not of ActiveTexture
};

inline constexpr unsigned names_bits = 4, unit_bits = 8;

/// A state, or several whose names are consecutive and whose values lie one behind the other. A board's flash
/// holds some 200 of them.
struct StateRow {
    std::uint16_t name = 0;  ///< of the first
    std::uint16_t where = 0; ///< offset in Context, or the constant, or which function computes it
    std::uint16_t names : names_bits = 1; ///< how many there are
    std::uint16_t count : 5 = 0; ///< of values that each has, most_values and less; 0: it is left out
    Source source : 3 = Source::constant;
    Switch toggle : 2 = Switch::none;
    Unit unit : 2 = Unit::none;
#if SPANGLE_MESSAGES
    const char* missing = nullptr; ///< the system that this build has not
#else
    static constexpr const char* missing = nullptr;
#endif
    constexpr bool left_out() const {
        return count == 0;
    }
};

/// Bytes that are saved with their group and asked for by a command of their own (GetLight...).
struct HeldRow {
    std::uint16_t offset = 0, bytes = 0;
    std::uint16_t unit_words : unit_bits = 0; ///< from one unit's to the next one's; 0: no units
    Group group : 5 = Group::none;

    constexpr std::uint32_t unit_step() const { return unit_words * std::uint32_t{4}; }
};

/// Writes the values of a row that no member of the context holds.
using Compute = void(const Context& context, GLenum name, Param* out);

inline constexpr int most_values = 16;

/// The row that has `name`, or null.
const StateRow* find_state(GLenum name);

/// The same of rows that are switches.
const StateRow* find_switch(GLenum name);

/// Rows, and the group that each is of: every Switch::server is in Group::enable, too.
struct GroupedRows {
    std::span<const StateRow> rows;
    const Group* groups;
};
/// Every row, in any order, in two parts.
std::array<GroupedRows, 2> all_state();
std::span<const HeldRow> all_held();

/// The bytes that each name of a row keeps in the context, of the first unit; 0 where it keeps none.
constexpr std::uint32_t kept_by(const StateRow& row) {
    constexpr std::uint32_t of_each = 0x4441 | sizeof(void*) << 16; // 4 bits for each Source, in its order
    return row.count * (of_each >> static_cast<unsigned>(row.source) * 4 & 15);
}

/// From one unit's value to the next one's, in bytes; 0: there are no units.
std::uint32_t unit_step(const StateRow& row);

/// How many of them stand so far apart.
constexpr std::uint32_t units_of(std::uint32_t unit_step) {
    return unit_step == 0 ? 1 : texture_units;
}

/// Where the value of a name that is not computed lies in its context, in bytes; each name before it keeps
/// `bytes`.
std::size_t offset_of(const Context& context, const StateRow& row, GLenum name, std::size_t bytes);

/// Writes row.count values.
void load_state(const Context& context, const StateRow& row, GLenum name, Param* out);

} // namespace spangle::gl
