// The bytes of the context that attribute groups save, as runs of consecutive bytes (GL 1.3, 6.1.12).
#pragma once

#include <cstdint>
#include <span>

#include "gl/context/derived.hpp"
#include "gl/context/state_table.hpp"
#include "raster/numeric/machine.hpp"

namespace spangle::gl {

/// Consecutive bytes of the context that the same attribute groups save.
struct SavedRun {
    std::uint16_t offset = 0, bytes = 0; ///< place and length of the first unit's run in Context
    std::uint16_t unit_step = 0;         ///< bytes from one unit's run to the next unit's; 0: no units
    Dirty dirty = dirty_all;             ///< derived state that depends on these bytes
    std::uint32_t groups = 0;            ///< bit 1 << Group for each group that saves the run
};

/// Returns the groups that save a row of `group`. Server switches belong to GL_ENABLE_BIT, too (GL 1.3, table
/// 6.4).
constexpr std::uint32_t groups_that_save(Group group, Switch toggle) {
    const auto bit = [](Group g) { return 1u << static_cast<unsigned>(g); };
    return bit(group) | (toggle == Switch::server ? bit(Group::enable) : 0);
}

/// True if a table holds maximal runs, as on hosts. Boards have too little flash for it. There, each row of
/// the state table is a run of its own.
inline constexpr bool joins_saved_runs = numeric::wide_words;

/// Returns the table of all runs, which is empty unless joins_saved_runs.
std::span<const SavedRun> saved_runs();

/// All 21 groups of PushAttrib (GL 1.3, table 6.4).
inline constexpr std::uint32_t server_groups = 0x200FFFFF;

/// Neighbouring runs, saved and compared as one where all server groups are saved. Bytes between them belong
/// to no group. Such bytes are saved, too, but only the runs are restored.
struct SavedChunk {
    std::uint16_t offset = 0, bytes = 0; ///< place and length of the first unit's chunk in Context
    std::uint16_t unit_step = 0;         ///< bytes from one unit's chunk to the next unit's; 0: no units
    std::uint16_t first = 0, count = 0;  ///< the runs of the chunk in saved_runs()
};

/// Returns the chunks of all runs that a server group saves. The table is empty unless joins_saved_runs.
std::span<const SavedChunk> saved_chunks();

/// Calls visit(run) for every run that at least one of the groups saves, always in the same order.
template <class Visit> SPANGLE_INLINE void each_saved_run(std::uint32_t groups, Visit visit) {
    if constexpr (joins_saved_runs) {
        for (const SavedRun& run : saved_runs())
            if ((run.groups & groups) != 0)
                visit(run);
        return;
    }
    const auto visit_kept = [&](const SavedRun& run) {
        if ((run.groups & groups) != 0)
            visit(run);
    };
    for (const GroupedRows& part : all_state()) {
        const Group* group = part.groups;
        for (const StateRow& row : part.rows)
            visit_kept({row.where, static_cast<std::uint16_t>(row.names * bytes_per_state(row)),
                        static_cast<std::uint16_t>(unit_step(row)), derived_from(row.where),
                        groups_that_save(*group++, row.toggle)});
    }
    for (const OwnQueryRow& row : own_query_rows())
        visit_kept({row.offset, row.bytes, static_cast<std::uint16_t>(row.unit_step()),
                    derived_from(row.offset), groups_that_save(row.group, Switch::none)});
}

} // namespace spangle::gl
