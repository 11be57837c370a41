// After every present the glass shows the surface in every wire format, whatever was touched. Windows end
// where bytes do, and on some controllers after one page.
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <spangle/boards/boards.hpp>
#include <spangle/sim/board.hpp>

namespace {

using namespace spangle;

/// Fills an area with random black and white, which are steps of every format.
void touch(const hal::Frame& frame, const Rect& area, std::mt19937& random) {
    for (int y = area.y; y < area.y + area.h; ++y) {
        for (int x = area.x; x < area.x + area.w; ++x)
            frame.pixels[y * frame.stride + 2 * x] = frame.pixels[y * frame.stride + 2 * x + 1] =
                static_cast<std::uint8_t>((random() >> 9 & 1) != 0 ? 0xFF : 0);
        RowSpan& row = frame.extents->rows[y];
        row = {std::min(row.begin, static_cast<std::int16_t>(area.x)),
               std::max(row.end, static_cast<std::int16_t>(area.x + area.w))};
    }
}

/// Returns the first pixel that differs from the surface; empty if there is none.
std::string difference(const hal::Frame& frame, const sim::Image& glass) {
    for (int y = 0; y < glass.height; ++y)
        for (int x = 0; x < glass.width; ++x)
            if ((frame.pixels[y * frame.stride + 2 * x] != 0) != (glass.at(x, y)[1] != 0))
                return "pixel " + std::to_string(x) + ", " + std::to_string(y);
    return "";
}

TEST(WireDamage, TheGlassShowsTheSurfaceAfterEveryPresent) {
    std::mt19937 random(11);
    for (const hal::Board* named : boards::all) {
        if (!named->display.wire.converts())
            continue;
        for (const hal::Orientation o : hal::orientations) {
            hal::Board board = *named;
            board.display.orientation = o;
            sim::SimBoard sim(board);
            ASSERT_TRUE(sim.display().init().ok()) << board.name;
            const hal::DisplayInfo info = sim.display().info();
            for (int present = 0; present < 30; ++present) {
                const auto frame = sim.display().acquire();
                ASSERT_TRUE(frame.ok());
                for (unsigned n = random() % 4; n > 0; --n) {
                    const int x = static_cast<int>(random() % static_cast<unsigned>(info.width)),
                              y = static_cast<int>(random() % static_cast<unsigned>(info.height));
                    touch(frame.value(),
                          {x, y, 1 + static_cast<int>(random() % static_cast<unsigned>(info.width - x)),
                           1 + static_cast<int>(random() % static_cast<unsigned>(info.height - y))},
                          random);
                }
                ASSERT_TRUE(sim.display().present().ok());
                ASSERT_EQ(difference(frame.value(), sim.glass()), "")
                    << board.name << ", orientation " << int(o.rotation) << o.mirrored << ", present "
                    << present;
            }
            EXPECT_EQ(sim.violations_text(), "") << board.name;
        }
    }
}

} // namespace
