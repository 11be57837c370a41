// The one table of state: where each value is stored, how queries convert it, and which attribute group saves
// it.
#pragma once

#include <array>
#include <span>

#include <spangle/message.hpp>

#include "gl/api/family.hpp"
#include "gl/context/types.hpp"

namespace spangle::gl {

struct Context;

/// How a value is stored, and as what it converts.
enum class Source : std::uint8_t {
    boolean,       ///< a bool in the context
    integer,       ///< a GLint, GLuint or GLenum in the context
    real,          ///< a Real in the context
    color,         ///< a Real in the context, mapped linearly to integers (GL 1.3, 6.1.2)
    pointer,       ///< a pointer to client memory; only GetPointerv returns it
    constant,      ///< the value is StateRow::where
    computed,      ///< an integer that a function computes
    computed_real, ///< a Real that a function computes
};

constexpr Kind kind_of(Source source) {
    constexpr unsigned of_each = 0x2A4A; // each Source has 2 bits, in its order
    return static_cast<Kind>(of_each >> static_cast<unsigned>(source) * 2 & 3);
}
static_assert(kind_of(Source::boolean) == Kind::integer && kind_of(Source::integer) == Kind::integer &&
              kind_of(Source::real) == Kind::real && kind_of(Source::color) == Kind::color &&
              kind_of(Source::constant) == Kind::integer && kind_of(Source::computed) == Kind::integer &&
              kind_of(Source::computed_real) == Kind::real);

/// Tells whether a state is a capability of Enable, Disable and IsEnabled.
enum class Switch : std::uint8_t {
    none,
    server,
    client, ///< a capability of the client, which GL_ENABLE_BIT does not save
};

/// Attribute groups, numbered by their mask bits (GL 1.3, table 6.4). The client's groups follow the
/// server's.
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

/// The kind of unit that has a value of its own. The values of all units are equally spaced in the context.
enum class Unit : std::uint8_t {
    none,
    texture, ///< each TextureUnitState has one value
    coords,  ///< each texture unit has four Reals
    /// One value in each ClientArray. ClientActiveTexture selects the unit, not ActiveTexture.
    client,
};

inline constexpr unsigned names_bits = 4, unit_bits = 8;

/// A state, or several states whose names and places are consecutive. A board's flash holds some 200 rows.
struct StateRow {
    std::uint16_t name = 0; ///< token of the first state
    /// Offset in Context, the constant, or the index of the function that computes it.
    std::uint16_t where = 0;
    std::uint16_t names : names_bits = 1; ///< number of states in the row
    std::uint16_t count : 5 = 0;          ///< number of values of each state, up to most_values; 0: left out
    Source source : 3 = Source::constant;
    Switch toggle : 2 = Switch::none;
    Unit unit : 2 = Unit::none;
#if SPANGLE_MESSAGES
    const char* missing = nullptr; ///< message that names the missing system, or null
#else
    static constexpr const char* missing = nullptr;
#endif
    constexpr bool left_out() const {
        return count == 0;
    }
};

/// Bytes that are saved with their group but queried by a command of their own, such as GetLight.
struct OwnQueryRow {
    std::uint16_t offset = 0, bytes = 0;
    /// 4-byte words from one unit's bytes to the next unit's. 0: there are no units.
    std::uint16_t unit_words : unit_bits = 0;
    Group group : 5 = Group::none;

    constexpr std::uint32_t unit_step() const { return unit_words * std::uint32_t{4}; }
};

/// A function that writes the values of a computed row.
using Compute = void(const Context& context, GLenum name, Param* out);

inline constexpr int most_values = 16;

/// Returns the row of the state `name`, or null.
const StateRow* find_state(GLenum name);

/// Returns the row of the switch `name`, or null.
const StateRow* find_switch(GLenum name);

/// Rows, and the attribute group of each row. Every Switch::server belongs to Group::enable, too.
struct GroupedRows {
    std::span<const StateRow> rows;
    const Group* groups;
};
/// Returns all rows, in two parts and in any order.
std::array<GroupedRows, 2> all_state();
std::span<const OwnQueryRow> own_query_rows();

/// Returns the bytes that each state of a row occupies in the context, for the first unit. 0: no bytes.
constexpr std::uint32_t bytes_per_state(const StateRow& row) {
    constexpr std::uint32_t of_each = 0x4441 | sizeof(void*) << 16; // each Source has 4 bits, in its order
    return row.count * (of_each >> static_cast<unsigned>(row.source) * 4 & 15);
}

/// Returns the bytes from one unit's value to the next unit's. 0: there are no units.
std::uint32_t unit_step(const StateRow& row);

/// Returns the number of units that a row with this unit_step() has.
constexpr std::uint32_t units_of(std::uint32_t unit_step) {
    return unit_step == 0 ? 1 : texture_units;
}

/// Returns the offset in the context, in bytes, of the value of `name`, which must not be computed. Each name
/// before it in the row occupies `bytes` bytes.
std::size_t offset_of(const Context& context, const StateRow& row, GLenum name, std::size_t bytes);

/// Reads all row.count values of the state `name` of a row.
void load_state(const Context& context, const StateRow& row, GLenum name, Param* out);

} // namespace spangle::gl
