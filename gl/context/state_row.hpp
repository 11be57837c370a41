// How a row of the state table is written: where its value is stored, how it converts, and which group it
// belongs to. The files of rows (state_rows_*.hpp) and the table made of them include this header.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "gl/context/context.hpp"
#include "gl/context/limits.hpp"
#include "gl/context/state_computed.hpp"
#include "gl/context/state_table.hpp"

namespace spangle::gl {

template <class T> constexpr Source source_of_type() {
    using Element = std::remove_all_extents_t<T>;
    return std::is_same_v<Element, bool>          ? Source::boolean
           : std::is_same_v<Element, Real>        ? Source::real
           : std::is_same_v<Element, const void*> ? Source::pointer
                                                  : Source::integer;
}

/// Converts the token of a state, which always has 16 bits.
constexpr std::uint16_t short_name(GLenum name) {
    return static_cast<std::uint16_t>(name);
}

/// The kind of a written row.
enum class Row : std::uint8_t {
    state,   ///< becomes a StateRow
    held,    ///< becomes an OwnQueryRow
    section, ///< becomes no row, but sets the group of the rows that follow
};

/// A row as it is written, before state_table.cpp packs it into as few bytes as it needs.
struct WrittenRow : StateRow {
    Row becomes = Row::state;
    Group group = Group::none;
    bool absent = false;   ///< true if the row is packed as StateRow::left_out()
    std::size_t value = 0; ///< value that becomes StateRow::where
    std::size_t bytes = 0; ///< for a held row: bytes that the groups save
    std::size_t step = 0;  ///< bytes from one unit's value to the next unit's; 0: no units
    Compute* compute = nullptr;
    /// identity() of `compute`, since addresses of functions are not always comparable constants.
    std::uint64_t function = 0;
};

constexpr WrittenRow constant(GLenum name, std::int32_t value) {
    WrittenRow row;
    row.name = short_name(name);
    row.count = 1;
    row.value = static_cast<std::uint32_t>(value);
    return row;
}

template <class T>
constexpr WrittenRow stored_row(GLenum name, std::size_t offset, Switch toggle = Switch::none) {
    constexpr Source source = source_of_type<T>();
    static_assert(source != Source::integer || sizeof(std::remove_all_extents_t<T>) == 4);
    WrittenRow row = constant(name, static_cast<std::int32_t>(offset));
    row.source = source;
    row.toggle = toggle;
    row.count = sizeof(T) / sizeof(std::remove_all_extents_t<T>);
    return row;
}

/// Marks a Real that maps linearly to integers when it is queried: a colour, a normal or a depth (GL 1.3,
/// 6.1.2).
constexpr WrittenRow linear(WrittenRow row) {
    row.source = row.source == Source::real ? Source::color : row.source;
    return row;
}

constexpr WrittenRow absent_switch(GLenum name) {
    WrittenRow row = constant(name, 0);
    row.toggle = Switch::server;
    return row;
}

/// Returns a number that identifies a function: the 64-bit FNV-1a hash of its name.
template <Compute* function> constexpr std::uint64_t identity() {
    std::uint64_t hash = 14695981039346656037u;
    for (const char c : __PRETTY_FUNCTION__)
        hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    return hash;
}
template <Compute* function> constexpr WrittenRow computed(GLenum name, Kind kind, unsigned count) {
    WrittenRow row = constant(name, 0);
    row.source = kind == Kind::real ? Source::computed_real : Source::computed;
    row.count = count & 31u;
    row.compute = function;
    constexpr std::uint64_t of_function = identity<function>();
    row.function = of_function;
    return row;
}

constexpr WrittenRow held(std::size_t offset, std::size_t bytes) {
    WrittenRow row;
    row.becomes = Row::held;
    row.value = offset;
    row.bytes = bytes;
    return row;
}

/// Sets the group of all rows up to the next in().
constexpr WrittenRow in(Group group) {
    WrittenRow row;
    row.becomes = Row::section;
    row.group = group;
    return row;
}

/// Makes a row of an optional system. A query of it in a build without that system is an INVALID_OPERATION,
/// with a message.
constexpr WrittenRow of_feature(bool present, [[maybe_unused]] const char* text, WrittenRow row) {
    if (present)
        return row; // another of_feature() may still mark it absent
    row.absent = true;
#if SPANGLE_MESSAGES
    row.missing = text;
#endif
    return row;
}
#define FEATURE(function, name)                                                                              \
    constexpr WrittenRow function(WrittenRow row) {                                                          \
        return of_feature(SPANGLE_FEATURE_##name != 0,                                                       \
                          SPANGLE_TEXT("this build has no SPANGLE_FEATURE_" #name), row);                    \
    }
FEATURE(of_lighting, LIGHTING)
FEATURE(of_fog, FOG)
FEATURE(of_polygon_mode, POLYGON_MODE)
FEATURE(of_secondary_color, SECONDARY_COLOR)
FEATURE(of_color_index, COLOR_INDEX)
FEATURE(of_texgen, TEXGEN)
FEATURE(of_texture_1d, TEXTURE_1D)
FEATURE(of_texture_3d, TEXTURE_3D)
FEATURE(of_cube_map, TEXTURE_CUBE_MAP)
FEATURE(of_compressed, COMPRESSED_TEXTURES)
FEATURE(of_raster_pos, RASTER_POS)
FEATURE(of_buffers, BUFFERS)
FEATURE(of_vertex_array_objects, VERTEX_ARRAY_OBJECTS)
FEATURE(of_primitive_restart, PRIMITIVE_RESTART)
FEATURE(of_pixel_transfer, PIXEL_TRANSFER)
FEATURE(of_draw_pixels, DRAW_PIXELS)
FEATURE(of_clip_planes, CLIP_PLANES)
FEATURE(of_attrib_stacks, ATTRIB_STACKS)
FEATURE(of_stencil_sides, STENCIL_SIDES)
FEATURE(of_accum, ACCUM)
FEATURE(of_selection, SELECTION)
FEATURE(of_evaluators, EVALUATORS)
FEATURE(of_feedback, FEEDBACK)
FEATURE(of_lists, LISTS)
FEATURE(of_stipple, STIPPLE)
FEATURE(of_antialiasing, ANTIALIASING)
FEATURE(of_polygon_offset, POLYGON_OFFSET)
FEATURE(of_point_parameters, POINT_PARAMETERS)
#undef FEATURE

/// Makes a row of a value that each texture unit has.
constexpr WrittenRow of_unit(std::size_t step, WrittenRow row) {
    row.step = step;
    row.unit = step == sizeof(TextureUnitState) ? Unit::texture : Unit::coords;
    return row;
}
constexpr WrittenRow of_client_unit(WrittenRow row) {
    row.step = sizeof(ClientArray);
    row.unit = Unit::client;
    return row;
}

#define STORED(NAME, MEMBER)                                                                                 \
    stored_row<std::remove_reference_t<decltype(std::declval<Context&>().MEMBER)>>(                          \
        NAME, offsetof(Context, MEMBER))
#define SWITCH(NAME, MEMBER) stored_row<bool>(NAME, offsetof(Context, MEMBER), Switch::server)
#define CLIENT_SWITCH(NAME, MEMBER) stored_row<bool>(NAME, offsetof(Context, MEMBER), Switch::client)
#define HELD(MEMBER) held(offsetof(Context, MEMBER), sizeof(std::declval<Context&>().MEMBER))

} // namespace spangle::gl
