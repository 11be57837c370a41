#include "gl/context/saved_runs.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "gl/context/written_rows.hpp"

namespace spangle::gl {

namespace {

constexpr SavedRun run_of(const WrittenRow& row) {
    const std::size_t bytes = row.becomes == Row::held ? row.bytes
                              : row.absent             ? 0
                                                       : row.names * bytes_per_state(row);
    return {static_cast<std::uint16_t>(row.value), static_cast<std::uint16_t>(bytes),
            static_cast<std::uint16_t>(row.step), derived_from(row.value),
            groups_that_save(row.group, row.toggle)};
}

constexpr bool same_kind(const SavedRun& a, const SavedRun& b) {
    return a.unit_step == b.unit_step && a.dirty == b.dirty && a.groups == b.groups;
}

struct Joined {
    std::array<SavedRun, written_rows.size()> run{};
    std::size_t count = 0;
};
/// Returns the runs of all rows in the order of their offsets. Adjacent runs of one kind are joined.
constexpr Joined join_all() {
    Joined all;
    for (const WrittenRow& row : written_rows)
        if (const SavedRun run = run_of(row);
            row.becomes != Row::section && run.bytes != 0 && row.group != Group::none)
            all.run[all.count++] = run;
    const auto end = all.run.begin() + static_cast<std::ptrdiff_t>(all.count);
    std::sort(all.run.begin(), end, [](const SavedRun& a, const SavedRun& b) { return a.offset < b.offset; });
    std::size_t used = 0;
    for (std::size_t i = 0; i < all.count; ++i) {
        const SavedRun& next = all.run[i];
        if (used != 0 && same_kind(all.run[used - 1], next) &&
            all.run[used - 1].offset + all.run[used - 1].bytes == next.offset)
            all.run[used - 1].bytes = static_cast<std::uint16_t>(all.run[used - 1].bytes + next.bytes);
        else
            all.run[used++] = next;
    }
    all.count = used;
    return all;
}

constexpr auto runs = [] {
    constexpr Joined all = join_all();
    std::array<SavedRun, joins_saved_runs ? all.count : 0> kept{};
    for (std::size_t i = 0; i < kept.size(); ++i)
        kept[i] = all.run[i];
    return kept;
}();

/// A gap of more bytes than alignment needs ends a chunk.
constexpr std::size_t widest_gap = 4;

struct Chunks {
    std::array<SavedChunk, runs.size()> chunk{};
    std::size_t count = 0;
};
constexpr Chunks join_neighbours() {
    Chunks all;
    std::size_t end = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const SavedRun& run = runs[i];
        if ((run.groups & server_groups) == 0) {
            end = 0;
            continue;
        }
        const bool joins =
            end != 0 && all.chunk[all.count - 1].unit_step == run.unit_step && run.offset < end + widest_gap;
        if (!joins)
            all.chunk[all.count++] = {run.offset, 0, run.unit_step, static_cast<std::uint16_t>(i), 0};
        SavedChunk& chunk = all.chunk[all.count - 1];
        const std::size_t run_end = std::size_t{run.offset} + run.bytes;
        end = joins ? std::max(end, run_end) : run_end;
        chunk.bytes = static_cast<std::uint16_t>(end - chunk.offset);
        ++chunk.count;
    }
    return all;
}

constexpr auto chunks = [] {
    constexpr Chunks all = join_neighbours();
    std::array<SavedChunk, all.count> kept{};
    for (std::size_t i = 0; i < kept.size(); ++i)
        kept[i] = all.chunk[i];
    return kept;
}();

} // namespace

std::span<const SavedChunk> saved_chunks() {
    return chunks;
}

std::span<const SavedRun> saved_runs() {
    return runs;
}

} // namespace spangle::gl
