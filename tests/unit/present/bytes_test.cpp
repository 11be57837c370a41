// Compares the bytes on the wire for each frame with what brute force finds in the pictures, and with a
// golden table.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <spangle/boards/boards.hpp>

#include "gl/context/create.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "raster/span/draw_state.hpp"
#include "tests/source_dir.hpp"
#include "tests/support/scene_player.hpp"
#include "tests/unit/present/watched_display.hpp"

namespace {

using namespace spangle;

constexpr int frames = 60;
constexpr std::uint64_t window_commands = 11; ///< CASET and RASET with four bytes each, and RAMWR
constexpr const char* scenes_measured[] = {"S5", "S6", "S8", "S9", "HUD"};

/// An interval of columns of a row; empty if begin >= end.
struct Interval {
    int begin = 1 << 20, end = 0;
    bool empty() const { return begin >= end; }
    void add(int x) { begin = std::min(begin, x), end = std::max(end, x + 1); }
    void add(const Interval& o) { begin = std::min(begin, o.begin), end = std::max(end, o.end); }
    bool operator==(const Interval&) const = default;
};
using Rows = std::vector<Interval>;

/// Returns the least bytes of windows around groups of rows; every grouping is tried.
std::uint64_t cheapest_windows(const Rows& rows) {
    std::vector<std::uint64_t> best(rows.size() + 1, 0);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        best[i + 1] = rows[i].empty() ? best[i] : UINT64_MAX;
        Interval box;
        for (std::size_t j = i + 1; j-- > 0;) {
            box.add(rows[j]);
            if (!box.empty())
                best[i + 1] = std::min(best[i + 1],
                                       best[j] + window_commands +
                                           static_cast<std::uint64_t>(box.end - box.begin) * (i + 1 - j) * 2);
        }
    }
    return best.back();
}

/// Records which pixels the primitives of a frame covered, from the rasterizer's spans.
struct Coverage : raster::Observer {
    int width, height;
    std::vector<bool> mask;

    Coverage(int w, int h) : width(w), height(h), mask(static_cast<std::size_t>(w * h)) {
        triangle = [](Observer&, const std::int32_t*, const std::int32_t*, const double*, const double*,
                      Rect) {};
        other = [](Observer&) {};
        span = [](Observer& self, std::int32_t y, std::int32_t from, std::int32_t to) {
            auto& c = static_cast<Coverage&>(self);
            for (std::int32_t x = from; x < to; ++x)
                c.mask[static_cast<std::size_t>((c.height - 1 - y) * c.width + x)] = true;
        };
    }
    Rows take() {
        Rows rows(static_cast<std::size_t>(height));
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                if (mask[static_cast<std::size_t>(y * width + x)])
                    rows[static_cast<std::size_t>(y)].add(x);
        mask.assign(mask.size(), false);
        return rows;
    }
};

using Picture = std::vector<std::uint8_t>; ///< two bytes a pixel

/// Returns the bytes of windows around changed blocks of 16x1 cells: equal runs below each other are one
/// window.
std::uint64_t changed_cell_bytes(const Picture& a, const Picture& b, int width, int height) {
    std::uint64_t bytes = 0;
    Rows above;
    for (int y = 0; y < height; ++y) {
        Rows runs;
        for (int x = 0; x < width; x += 16) {
            const auto from = static_cast<std::ptrdiff_t>(2 * (y * width + x));
            const std::ptrdiff_t count = 2 * std::min(16, width - x);
            if (std::equal(a.begin() + from, a.begin() + from + count, b.begin() + from))
                continue;
            bytes += static_cast<std::uint64_t>(count);
            if (runs.empty() || runs.back().end != x)
                runs.push_back({x, x});
            runs.back().end = x + static_cast<int>(count / 2);
        }
        for (const Interval& run : runs)
            if (std::find(above.begin(), above.end(), run) == above.end())
                bytes += window_commands;
        above = runs;
    }
    return bytes;
}

struct Measured {
    double sent = 0, union_rows = 0, cells = 0; ///< bytes of a frame: sent, by union of rows, by cells
};

/// Measures from the second frame on, because the first is a whole picture.
Measured measure(const char* scene, bool row_hash) {
    hal::Board board = boards::ili9341_spi;
    board.display.row_hash = row_hash;
    sim::SimBoard sim(board);
    test::WatchedDisplay watched(sim, board);
    watched.compare = false;
    const hal::DisplayInfo info = sim.display().info();
    Coverage coverage(info.width, info.height);
    raster::Counters counters;
    counters.observer = &coverage;
    std::vector<Rows> drawn;
    std::vector<Picture> pictures;
    const scenes::Scene* const found = scenes::find(scene);
    EXPECT_NE(found, nullptr) << scene;
    EXPECT_TRUE(test::play(watched, *found, frames, [&] {
        if (drawn.empty()) { // the context exists now; what the first frame drew counts for the second
            gl::observe(*gl::current_context(), &counters, false);
            found->draw(0);
        }
        drawn.push_back(coverage.take());
        const auto frame = watched.acquire();
        pictures.emplace_back(frame.value().pixels,
                              frame.value().pixels + frame.value().stride * info.height);
    }));
    Measured m;
    for (std::size_t f = 1; f < frames; ++f) {
        Rows both = drawn[f];
        for (std::size_t y = 0; y < both.size(); ++y)
            both[y].add(drawn[f - 1][y]);
        m.union_rows += static_cast<double>(cheapest_windows(both));
        m.cells +=
            static_cast<double>(changed_cell_bytes(pictures[f - 1], pictures[f], info.width, info.height));
        m.sent += static_cast<double>(watched.bytes[f]);
    }
    for (double* sum : {&m.sent, &m.union_rows, &m.cells})
        *sum /= frames - 1;
    return m;
}

/// A line is "scene extents row_hash", in bytes a frame.
using Golden = std::map<std::string, std::array<double, 2>>;
constexpr const char* golden_file = SPANGLE_SOURCE_DIR "/tests/unit/present/bytes_per_frame.txt";

Golden read_golden() {
    Golden golden;
    std::ifstream file(golden_file);
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string scene;
        if (line.empty() || line[0] == '#' || !(words >> scene))
            continue;
        words >> golden[scene][0] >> golden[scene][1];
    }
    return golden;
}

void write_golden(const Golden& golden) {
    std::ofstream file(golden_file);
    file << "# Bytes a frame on the wire, window commands included: ILI9341 320x240 RGB565, frames 1 to "
         << frames - 1 << ".\n# A test fails 2 % above; SPANGLE_UPDATE_GOLDEN=1 writes what is measured.\n"
         << "# scene extents row_hash\n";
    for (const auto& [scene, bytes] : golden)
        file << scene << ' ' << std::lround(bytes[0]) << ' ' << std::lround(bytes[1]) << '\n';
}

TEST(Bytes, AFrameCostsWhatTheTablesSay) {
    Golden measured;
    for (const char* scene : scenes_measured) {
        const Measured extents = measure(scene, false), hashed = measure(scene, true);
        measured[scene] = {extents.sent, hashed.sent};
        EXPECT_LE(extents.sent, 1.02 * extents.union_rows) << scene << ": union interval of each row";
        EXPECT_LE(hashed.sent, 1.02 * hashed.cells) << scene << ": changed 16x1 cells";
        EXPECT_LE(hashed.sent, 1.002 * extents.sent) << scene << ": the hash never costs more than a cell";
    }
    if (std::getenv("SPANGLE_UPDATE_GOLDEN") != nullptr)
        return write_golden(measured);
    const Golden golden = read_golden();
    for (const auto& [scene, bytes] : measured)
        for (const std::size_t i : {0u, 1u}) {
            ASSERT_EQ(golden.count(scene), 1u) << scene << " has no line in " << golden_file;
            const double known = golden.at(scene)[i];
            EXPECT_LE(bytes[i], 1.02 * known) << scene << (i == 0 ? ", extents" : ", row hash");
            EXPECT_GE(bytes[i], 0.98 * known) << scene << ": better; write it down (SPANGLE_UPDATE_GOLDEN=1)";
        }
}

} // namespace
