#include "gl/context/state_table.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

#include "gl/context/written_rows.hpp"

namespace spangle::gl {

namespace {

template <class Wanted> constexpr std::size_t count_rows(Wanted wanted) {
    std::size_t n = 0;
    for (const WrittenRow& row : written_rows)
        n += wanted(row) ? 1 : 0;
    return n;
}

constexpr bool is_computed_source(Source source) {
    return source == Source::computed || source == Source::computed_real;
}
constexpr bool is_computed(const WrittenRow& row) {
    return is_computed_source(row.source) && !row.absent;
}
struct Computing {
    Compute* compute = nullptr;
    std::uint64_t function = 0;
};
/// All functions that compute rows, each once. Unused elements are 0.
constexpr auto all_computing = [] {
    std::array<Computing, count_rows(is_computed)> all{};
    std::size_t used = 0;
    for (const WrittenRow& row : written_rows)
        if (is_computed(row)) {
            std::size_t i = 0;
            while (i < used && all[i].function != row.function)
                ++i;
            if (i == used)
                all[used++] = {row.compute, row.function};
        }
    return all;
}();
constexpr auto computing = [] {
    constexpr auto end = [] {
        std::size_t n = 0;
        while (n < all_computing.size() && all_computing[n].function != 0)
            ++n;
        return n;
    }();
    std::array<Compute*, end> kept{};
    for (std::size_t i = 0; i < end; ++i)
        kept[i] = all_computing[i].compute;
    return kept;
}();

/// Returns the row in its final form. A row that is left out has no place and no values.
constexpr StateRow pack_row(const WrittenRow& row) {
    StateRow out = row;
    std::size_t where = row.value;
    if (is_computed(row))
        while (all_computing[where].function != row.function)
            ++where;
    out.where = row.absent ? std::uint16_t{0} : static_cast<std::uint16_t>(where);
    if (row.absent)
        out.count = 0;
    return out;
}

constexpr std::array<std::size_t, 4> unit_steps{0, sizeof(TextureUnitState), sizeof(CurrentState::TexCoord),
                                                sizeof(ClientArray)};

constexpr bool all_fit() {
    for (const WrittenRow& row : written_rows)
        if (row.value > 0xFFFF || row.bytes > 0xFFFF || row.step % 4 != 0 || row.step / 4 >> unit_bits != 0 ||
            (row.function == 0 && is_computed_source(row.source)) ||
            (row.becomes != Row::held && row.step != unit_steps[static_cast<unsigned>(row.unit)]) ||
            (row.count == 0 && row.becomes == Row::state) ||
            (row.group == Group::none && row.becomes == Row::held))
            return false;
    return true;
}
static_assert(all_fit());

/// True if only the name of the row is kept, in LeftOut. Its system is missing, and the build has no message
/// that names the system. Rows of pointers stay rows.
constexpr bool is_left_out(const WrittenRow& row) {
    return !SPANGLE_MESSAGES && row.absent && row.source != Source::pointer;
}
/// True if the row is a state of the table that `switches` selects: the table of rows with a Switch, or that
/// of all other rows.
template <bool switches> constexpr bool has_name(const WrittenRow& row) {
    return row.becomes == Row::state && (row.toggle != Switch::none) == switches;
}
template <bool switches> constexpr bool is_named(const WrittenRow& row) {
    return has_name<switches>(row) && !is_left_out(row);
}
template <bool switches> constexpr bool is_only_named(const WrittenRow& row) {
    return has_name<switches>(row) && is_left_out(row);
}
/// Consecutive names of missing states, in few bytes.
struct LeftOut {
    std::uint8_t low = 0, high = 0, names = 0;

    constexpr unsigned first() const { return low | unsigned{high} << 8; }
};
template <bool switches> constexpr auto all_left_out() {
    std::array<unsigned, count_rows(is_only_named<switches>)> names{};
    std::size_t count = 0;
    for (const WrittenRow& row : written_rows)
        if (is_only_named<switches>(row))
            names[count++] = row.name;
    std::ranges::sort(names);
    std::array<LeftOut, names.size()> out{};
    std::size_t used = 0;
    for (const unsigned name : names) {
        if (used == 0 || name != out[used - 1].first() + out[used - 1].names)
            out[used++] = {static_cast<std::uint8_t>(name & 0xFF), static_cast<std::uint8_t>(name >> 8), 0};
        ++out[used - 1].names;
    }
    return std::pair{out, used};
}
template <bool switches> constexpr auto left_out_names() {
    constexpr auto all = all_left_out<switches>();
    std::array<LeftOut, all.second> names{};
    for (std::size_t i = 0; i < names.size(); ++i)
        names[i] = all.first[i];
    return names;
}

struct GroupedRow {
    StateRow row;
    Group group;
};
template <bool switches> constexpr auto sorted_by_name() {
    std::array<GroupedRow, count_rows(is_named<switches>)> rows{};
    std::size_t used = 0;
    for (const WrittenRow& row : written_rows)
        if (is_named<switches>(row))
            rows[used++] = {pack_row(row), row.group};
    for (std::size_t i = 1; i < rows.size(); ++i)
        for (std::size_t k = i; k > 0 && rows[k].row.name < rows[k - 1].row.name; --k)
            std::swap(rows[k], rows[k - 1]);
    return rows;
}

/// Compares two texts; either may be null.
constexpr bool same_text(const char* a, const char* b) {
    if (a == nullptr || b == nullptr)
        return a == b;
    for (; *a != 0 && *a == *b; ++a)
        ++b;
    return *a == *b;
}
/// True if `row` can be extended by `next`.
constexpr bool goes_on(const StateRow& row, const StateRow& next) {
    return next.name == row.name + row.names && next.where == row.where + row.names * bytes_per_state(row) &&
           row.names + 1u < 1u << names_bits && next.count == row.count && next.unit == row.unit &&
           next.source == row.source && next.toggle == row.toggle && same_text(next.missing, row.missing);
}
template <bool switches> constexpr auto all_joined() {
    auto rows = sorted_by_name<switches>();
    std::size_t used = 0;
    for (const GroupedRow& next : rows) {
        if (used > 0 && next.group == rows[used - 1].group && goes_on(rows[used - 1].row, next.row)) {
            StateRow& row = rows[used - 1].row;
            row.names = (row.names + 1u) & ((1u << names_bits) - 1);
        } else {
            rows[used++] = next;
        }
    }
    return std::pair{rows, used};
}
template <bool switches> constexpr auto joined_rows() {
    constexpr auto all = all_joined<switches>();
    std::array<StateRow, all.second> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i] = all.first[i].row;
    return rows;
}
template <bool switches> constexpr auto groups_of_rows() {
    constexpr auto all = all_joined<switches>();
    std::array<Group, all.second> groups{};
    for (std::size_t i = 0; i < groups.size(); ++i)
        groups[i] = all.first[i].group;
    return groups;
}

// Switches have an array of their own, so that a program without other queries links only the smaller one.
constexpr auto switches = joined_rows<true>();
constexpr auto others = joined_rows<false>();
// Only attribute stacks use the groups.
constexpr auto groups_of_switches = groups_of_rows<true>();
constexpr auto groups_of_others = groups_of_rows<false>();
constexpr auto left_out_switches = left_out_names<true>();
constexpr auto left_out_others = left_out_names<false>();
constexpr StateRow left_out_row = pack_row(of_feature(false, "", absent_switch(0)));

constexpr bool is_held(const WrittenRow& row) {
    return row.becomes == Row::held;
}
constexpr auto held_rows = [] {
    std::array<OwnQueryRow, count_rows(is_held)> rows{};
    std::size_t used = 0;
    for (const WrittenRow& row : written_rows)
        if (is_held(row)) {
            OwnQueryRow& held = rows[used++];
            held.offset = static_cast<std::uint16_t>(row.value);
            held.bytes = static_cast<std::uint16_t>(row.bytes);
            held.unit_words = row.step / 4 & ((1u << unit_bits) - 1);
            held.group = row.group;
        }
    return rows;
}();

constexpr bool names_differ() {
    for (std::size_t i = 0; i < written_rows.size(); ++i)
        for (std::size_t k = i + 1; k < written_rows.size(); ++k)
            if (written_rows[i].name == written_rows[k].name && written_rows[i].name != 0)
                return false;
    return true;
}
static_assert(names_differ());

/// Rows of states, and the names of missing states.
struct Part {
    const StateRow* rows;
    std::size_t count;
    const LeftOut* left_out;
    std::size_t left_out_count;
};
constexpr Part switch_part{switches.data(), switches.size(), left_out_switches.data(),
                           left_out_switches.size()},
    other_part{others.data(), others.size(), left_out_others.data(), left_out_others.size()};

const StateRow* find(const Part& part, GLenum name) {
    const std::span rows{part.rows, part.count};
    std::size_t low = 0, high = rows.size();
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        const StateRow& row = rows[middle];
        if (name - row.name < row.names)
            return &row;
        (row.name < name ? low : high) = row.name < name ? middle + 1 : middle;
    }
    for (const LeftOut& others : std::span{part.left_out, part.left_out_count})
        if (name - others.first() < others.names)
            return &left_out_row;
    return nullptr;
}

} // namespace

const StateRow* find_switch(GLenum name) {
    return find(switch_part, name);
}

const StateRow* find_state(GLenum name) {
    const StateRow* const row = find(other_part, name);
    return row != nullptr ? row : find_switch(name);
}

std::array<GroupedRows, 2> all_state() {
    return {GroupedRows{others, groups_of_others.data()}, GroupedRows{switches, groups_of_switches.data()}};
}

std::span<const OwnQueryRow> own_query_rows() {
    return held_rows;
}

std::uint32_t unit_step(const StateRow& row) {
    return static_cast<std::uint32_t>(unit_steps[static_cast<unsigned>(row.unit)]);
}

static_assert(sizeof(Param) == sizeof(std::uint32_t) && std::is_trivially_copyable_v<Param>);

std::size_t offset_of(const Context& context, const StateRow& row, GLenum name, std::size_t bytes) {
    const std::size_t unit =
        row.unit == Unit::client ? context.array_bindings.client_unit() : context.texture.active_unit();
    return row.where + (name - row.name) * bytes + unit_step(row) * unit;
}

void load_state(const Context& context, const StateRow& row, GLenum name, Param* out) {
    if (is_computed_source(row.source))
        return computing[row.where](context, name, out);
    const auto* const from = reinterpret_cast<const unsigned char*>(&context) +
                             offset_of(context, row, name, bytes_per_state(row));
    if (row.source == Source::boolean)
        for (int i = 0; i < row.count; ++i)
            out[i] = Param::from_integer(reinterpret_cast<const bool*>(from)[i]);
    else if (row.source == Source::constant)
        out[0] = Param::from_integer(row.where);
    else // each value is a word, since load_state() is never called for pointers
        std::memcpy(out, from, row.count * sizeof *out);
}

} // namespace spangle::gl
