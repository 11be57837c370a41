// The bytes of the context that attribute groups keep, run by run (GL 1.3, 6.1.12).
#pragma once

#include <cstdint>
#include <span>

#include "gl/context/derived.hpp"
#include "gl/context/state_table.hpp"
#include "raster/numeric/machine.hpp"

namespace spangle::gl {

/// Bytes that the same groups keep and that lie one behind the other.
struct KeptRun {
    std::uint16_t offset = 0, bytes = 0; ///< in Context, of the first unit
    std::uint16_t unit_step = 0;         ///< from one unit's to the next one's; 0: there are no units
    Dirty dirty = dirty_all;             ///< what is derived from it
    std::uint32_t groups = 0;            ///< bit 1 << Group of each that keeps it
};

/// The groups that keep what is of this one: of switches, GL_ENABLE_BIT is another (GL 1.3, table 6.4).
constexpr std::uint32_t kept_with(Group group, Switch toggle) {
    const auto bit = [](Group g) { return 1u << static_cast<unsigned>(g); };
    return bit(group) | (toggle == Switch::server ? bit(Group::enable) : 0);
}

/// Hosts hold a table of runs that are as long as they can be. A board has no flash for that: there each row
/// of the state table is a run.
inline constexpr bool joins_kept_runs = numeric::wide_words;

/// Where runs are joined: all of them.
std::span<const KeptRun> kept_runs();

/// Calls visit(run) for every run that one of the groups keeps, in the same order each time.
template <class Visit> SPANGLE_INLINE void each_kept_run(std::uint32_t groups, Visit visit) {
    if constexpr (joins_kept_runs) {
        for (const KeptRun& run : kept_runs())
            if ((run.groups & groups) != 0)
                visit(run);
        return;
    }
    const auto visit_kept = [&](const KeptRun& run) {
        if ((run.groups & groups) != 0)
            visit(run);
    };
    for (const GroupedRows& part : all_state()) {
        const Group* group = part.groups;
        for (const StateRow& row : part.rows)
            visit_kept({row.where, static_cast<std::uint16_t>(row.names * kept_by(row)),
                        static_cast<std::uint16_t>(unit_step(row)), derived_from(row.where),
                        kept_with(*group++, row.toggle)});
    }
    for (const HeldRow& row : all_held())
        visit_kept({row.offset, row.bytes, static_cast<std::uint16_t>(row.unit_step()),
                    derived_from(row.offset), kept_with(row.group, Switch::none)});
}

} // namespace spangle::gl
