#include "gl/context/state_table.hpp"

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

#include "gl/context/state_rows_arrays.hpp"
#include "gl/context/state_rows_fragment.hpp"
#include "gl/context/state_rows_limits.hpp"
#include "gl/context/state_rows_pixel.hpp"
#include "gl/context/state_rows_raster.hpp"
#include "gl/context/state_rows_texture.hpp"
#include "gl/context/state_rows_vertex.hpp"

namespace spangle::gl {

namespace {

template <std::size_t... N> constexpr auto joined(const std::array<StateRow, N>&... parts) {
    std::array<StateRow, (N + ...)> all{};
    std::size_t used = 0;
    const auto add = [&all, &used](const auto& part) {
        for (const StateRow& row : part)
            all[used++] = row;
    };
    (add(parts), ...);
    return all;
}

constexpr auto unsorted =
    joined(vertex_rows, arrays_rows, raster_rows, texture_rows, fragment_rows, pixel_rows, limits_rows);

constexpr bool is_switch(const StateRow& row) {
    return row.toggle != Switch::none;
}

template <bool Switches> constexpr std::size_t count_rows() {
    std::size_t n = 0;
    for (const StateRow& row : unsorted)
        n += row.source != Source::section && is_switch(row) == Switches ? 1 : 0;
    return n;
}

/// Switches, or the other rows.
template <bool Switches> constexpr auto sorted_by_name() {
    std::array<StateRow, count_rows<Switches>()> rows{};
    Group group = Group::none;
    std::size_t used = 0;
    for (const StateRow& row : unsorted) {
        if (row.source == Source::section) {
            group = row.group;
        } else if (is_switch(row) == Switches) {
            rows[used] = row;
            rows[used++].group = group;
        }
    }
    for (std::size_t i = 1; i < rows.size(); ++i)
        for (std::size_t k = i; k > 0 && rows[k].name < rows[k - 1].name; --k)
            std::swap(rows[k], rows[k - 1]);
    return rows;
}

// Two arrays: a program that asks for nothing but turns systems on and off links the smaller one only.
constexpr auto switches = sorted_by_name<true>();
constexpr auto others = sorted_by_name<false>();

constexpr bool names_differ() {
    for (std::size_t i = 0; i < unsorted.size(); ++i)
        for (std::size_t k = i + 1; k < unsorted.size(); ++k)
            if (unsorted[i].name == unsorted[k].name && unsorted[i].name != 0)
                return false;
    return true;
}
static_assert(names_differ());
static_assert(sizeof(Context) <= 0x10000, "offsets of held bytes have 16 bits");

const StateRow* find(std::span<const StateRow> rows, GLenum name) {
    std::size_t low = 0, high = rows.size();
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (rows[middle].name == name)
            return &rows[middle];
        (rows[middle].name < name ? low : high) = rows[middle].name < name ? middle + 1 : middle;
    }
    return nullptr;
}

} // namespace

const StateRow* find_switch(GLenum name) {
    return find(switches, name);
}

const StateRow* find_state(GLenum name) {
    const StateRow* const row = find(others, name);
    return row != nullptr ? row : find_switch(name);
}

std::array<std::span<const StateRow>, 2> all_state() {
    return {others, switches};
}

Kept kept_by(const StateRow& row) {
    switch (row.source) {
    case Source::boolean:
        return {row.place.where, row.count};
    case Source::integer:
    case Source::real:
        return {row.place.where, row.count * std::uint32_t{4}};
    case Source::pointer:
        return {row.place.where, sizeof(void*)};
    case Source::held:
        return {row.place.where & 0xFFFF, row.place.where >> 16};
    default:
        return {0, 0};
    }
}

std::uint32_t units_of(const StateRow& row) {
    return row.per_unit == PerUnit::no ? 1 : texture_units;
}

std::size_t offset_of(const Context& context, const StateRow& row) {
    const std::size_t unit = row.per_unit == PerUnit::active   ? context.texture.active
                             : row.per_unit == PerUnit::client ? context.array_bindings.client_active
                                                               : 0;
    return row.place.where + row.unit_step * unit;
}

void load_state(const Context& context, const StateRow& row, Param* out) {
    if (row.source == Source::computed)
        return row.place.compute(context, row.name, out);
    const auto* const from = reinterpret_cast<const unsigned char*>(&context) + offset_of(context, row);
    switch (row.source) {
    case Source::boolean:
        for (int i = 0; i < row.count; ++i)
            out[i] = Param::from_integer(reinterpret_cast<const bool*>(from)[i]);
        break;
    case Source::integer:
        for (int i = 0; i < row.count; ++i)
            std::memcpy(&out[i].word, from + static_cast<std::size_t>(i) * sizeof(std::uint32_t),
                        sizeof(std::uint32_t));
        break;
    case Source::real:
        for (int i = 0; i < row.count; ++i)
            out[i] = Param::from(reinterpret_cast<const Real*>(from)[i]);
        break;
    case Source::constant:
        out[0] = Param::from_integer(row.place.where);
        break;
    default: // pointers and held bytes are no Params
        break;
    }
}

} // namespace spangle::gl
