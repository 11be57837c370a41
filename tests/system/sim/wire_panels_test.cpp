// Tests every panel in every wire format that it takes, on the model of its controller. Scenes drawn through
// EGL show what the surface holds, dithered to the wire's steps, on each bus and in all eight orientations,
// and no rule is broken.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <spangle/GL/gl.h>
#include <spangle/boards/boards.hpp>
#include <spangle/panels.hpp>
#include <spangle/sim/board.hpp>

#include "tests/support/scene_player.hpp"

namespace {

using namespace spangle;
using hal::WireFormat;

struct Case {
    const hal::PanelDesc* panel;
    hal::Wire wire;
    hal::BusKind bus;
};

constexpr hal::Wire every_wire[] = {hal::wires::rgb565, hal::wires::rgb666, hal::wires::rgb444,
                                    hal::wires::rgb332, hal::wires::grey4,  hal::wires::mono};

bool is_large(const hal::PanelDesc& panel) {
    return panel.commands->status_registers;
}

std::vector<Case> cases() {
    std::vector<Case> out;
    for (const hal::PanelDesc* panel : hal::panels::all)
        for (const hal::Wire& wire : every_wire)
            for (const auto bus : {panel->serial_bus, hal::BusKind::i8080, hal::BusKind::i2c})
                if (hal::format_code(*panel, bus, wire.format).taken) {
                    out.push_back({panel, wire, bus});
                    if (is_large(*panel))
                        break; // one bus is enough: panels_test.cpp draws on the others
                }
    return out;
}

std::string name_of(const Case& c) {
    constexpr const char* wires[] = {"565", "666", "444", "332", "grey4", "mono"};
    constexpr const char* buses[] = {"spi", "8080", "i2c", "spi_start"};
    std::string name = std::string(c.panel->name) + "_" + wires[static_cast<unsigned>(c.wire.format)] + "_" +
                       buses[static_cast<unsigned>(c.bus)];
    for (char& letter : name)
        letter = std::isalnum(static_cast<unsigned char>(letter)) ? letter : '_';
    return name;
}

hal::Board board_of(const Case& c, hal::Orientation o, PixelFormat surface) {
    hal::Board board{.name = c.panel->name,
                     .display = {.panel = c.panel, .orientation = o, .format = surface, .wire = c.wire},
                     .bus = c.bus};
    board.write_hz = c.bus == hal::BusKind::i2c     ? std::min(c.panel->timing.i2c_hz, 400000u)
                     : c.bus == hal::BusKind::i8080 ? 1000000000u / c.panel->timing.parallel_write_ns
                                                    : c.panel->timing.practical_serial_mhz * 1000000u;
    EXPECT_EQ(hal::flaw(board), nullptr);
    return board;
}

/// Returns the bits of red, green and blue that a format keeps.
std::vector<unsigned> bits_of(WireFormat format) {
    switch (format) {
    case WireFormat::rgb565:
        return {5, 6, 5};
    case WireFormat::rgb666:
        return {6, 6, 6};
    case WireFormat::rgb444:
    case WireFormat::grey4:
        return {4, 4, 4};
    case WireFormat::rgb332:
        return {3, 3, 2};
    default:
        return {1, 1, 1};
    }
}

/// Returns what the surface's pixels (8 bits each, in GL's rows) become on the wire: floor(c (2^n - 1) + t)
/// in doubles.
std::vector<unsigned> steps_of(const std::vector<std::uint8_t>& rgb, int width, int height, WireFormat wire,
                               PixelFormat surface) {
    constexpr int k[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    const std::vector<unsigned> bits = bits_of(wire);
    std::vector<unsigned> out;
    for (int y = height - 1; y >= 0; --y)
        for (int x = 0; x < width; ++x) {
            const std::uint8_t* const p = &rgb[static_cast<std::size_t>((y * width + x) * 3)];
            const double t = (k[y & 3][x & 3] + 0.5) / 16;
            for (unsigned c = 0; c < 3; ++c) {
                const int most = surface == PixelFormat::rgb888 ? 255 : c == 1 ? 63 : 31;
                double value = std::round(p[c] * most / 255.0) / most;
                if (wire == WireFormat::grey4 || wire == WireFormat::mono)
                    value = (3 * p[0] + 6 * p[1] + p[2]) / 10 / 255.0;
                out.push_back(static_cast<unsigned>(std::floor(value * ((1u << bits[c]) - 1) + t + 1e-9)));
            }
        }
    return out;
}

std::vector<unsigned> steps_on(const sim::Image& glass, WireFormat wire) {
    const std::vector<unsigned> bits = bits_of(wire);
    std::vector<unsigned> out;
    for (int y = 0; y < glass.height; ++y)
        for (int x = 0; x < glass.width; ++x)
            for (unsigned c = 0; c < 3; ++c)
                out.push_back(static_cast<unsigned>(glass.at(x, y)[c]) >> (8 - bits[c]));
    return out;
}

void expect_scene(const Case& c, const scenes::Scene& scene, hal::Orientation o, PixelFormat surface) {
    const hal::Board board = board_of(c, o, surface);
    sim::SimBoard sim(board);
    const hal::DisplayInfo info = sim.display().info();
    std::vector<std::uint8_t> rgb(static_cast<std::size_t>(info.width * info.height * 3));
    // Draws two frames, so that the second one is sent as damage.
    ASSERT_TRUE(test::play(sim.display(), scene, 2, [&] {
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, info.width, info.height, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
    }));
    const std::string where = std::string(scene.id) + ", turned " + std::to_string(90 * int(o.rotation)) +
                              (o.mirrored ? ", mirrored" : "");
    EXPECT_EQ(sim.violations_text(), "") << where;
    const std::vector<unsigned> seen = steps_on(sim.scan_out(), c.wire.format),
                                wanted = steps_of(rgb, info.width, info.height, c.wire.format, surface);
    ASSERT_EQ(seen.size(), wanted.size());
    const auto [at, other] = std::mismatch(seen.begin(), seen.end(), wanted.begin());
    EXPECT_EQ(at, seen.end()) << where << ": value " << (at - seen.begin()) << " is " << *at << ", not "
                              << *other;
}

/// GoogleTest prints cases with this function.
void PrintTo(const Case& c, std::ostream* out) {
    *out << name_of(c);
}

class WirePanels : public testing::TestWithParam<Case> {};

/// The scenes take turns. Large panels are drawn in one orientation only, because panels_test.cpp turns them
/// already.
TEST_P(WirePanels, ShowTheSurfaceInTheirSteps) {
    std::vector<const scenes::Scene*> every;
    for (const scenes::Scene& scene : scenes::all())
        every.push_back(&scene);
    unsigned turn =
        static_cast<unsigned>(GetParam().panel->glass.width) + static_cast<unsigned>(GetParam().bus);
    for (const hal::Orientation o : hal::orientations) {
        if (is_large(*GetParam().panel) && o != hal::Orientation{hal::Rotation::r90, true})
            continue;
        const PixelFormat surface = turn % 2 == 0 ? PixelFormat::rgb565_be : PixelFormat::rgb888;
        expect_scene(GetParam(), *every[turn++ % every.size()], o, surface);
    }
}

INSTANTIATE_TEST_SUITE_P(All, WirePanels, testing::ValuesIn(cases()),
                         [](const auto& info) { return name_of(info.param); });

TEST(WirePanels, NamedBoardsShowAScene) {
    for (const hal::Board* board : boards::all) {
        if (!board->display.wire.converts())
            continue;
        sim::SimBoard sim(*board);
        ASSERT_TRUE(test::play(sim.display(), *scenes::find("S6"), 3)) << board->name;
        EXPECT_EQ(sim.violations_text(), "") << board->name;
        const auto steps = steps_on(sim.glass(), board->display.wire.format);
        EXPECT_NE(*std::max_element(steps.begin(), steps.end()), 0u) << board->name << " stays dark";
    }
}

/// If the wire has another format than the surface, the surface is free as soon as it was converted.
TEST(WirePanels, APresentReturnsWhileTheFrameIsOnTheWire) {
    sim::SimBoard sim(boards::ssd1306_i2c);
    ASSERT_TRUE(sim.display().init().ok());
    const auto frame = sim.display().acquire();
    ASSERT_TRUE(frame.ok());
    for (int y = 0; y < 64; ++y)
        frame.value().extents->rows[y] = {0, 128};
    const sim::Time before = sim.now();
    ASSERT_TRUE(sim.display().present().ok());
    EXPECT_LT(sim.now() - before, 1'000'000u);
    frame.value().pixels[0] = 0xFF;
    frame.value().extents->rows[0] = {0, 1};
    ASSERT_TRUE(sim.display().present().ok());
    EXPECT_GT(sim.now() - before, 23'000'000u) << "the second waits: 1024 bytes of nine clocks at 400 kHz";
    EXPECT_EQ(sim.violations_text(), "") << "rule 11 would say so";
}

/// Cells that were drawn again unchanged are not sent, whatever the wire's format.
TEST(WirePanels, TheRowHashServesThemToo) {
    for (const hal::Board* named : {&boards::ssd1306_i2c, &boards::ssd1327_spi, &boards::sh1106_i2c}) {
        std::uint64_t bytes[2];
        sim::Image seen[2];
        for (const bool hashed : {false, true}) {
            hal::Board board = *named;
            board.display.row_hash = hashed;
            sim::SimBoard sim(board);
            ASSERT_TRUE(test::play(sim.display(), *scenes::find("HUD"), 6)) << board.name;
            seen[hashed] = sim.glass();
            bytes[hashed] = sim.counters().bytes;
            EXPECT_EQ(sim.violations_text(), "") << board.name;
        }
        EXPECT_EQ(seen[1], seen[0]) << named->name;
        EXPECT_LT(bytes[1], bytes[0]) << named->name;
    }
}

TEST(WirePanels, EglConfigsTellTheFormatOnTheWire) {
    const struct {
        const hal::Board& board;
        EGLint visual;
    } table[] = {{boards::ssd1306_i2c, 0x600}, {boards::ssd1327_spi, 0x500}, {boards::ssd1351_spi, 0}};
    for (const auto& row : table) {
        sim::SimBoard sim(row.board);
        const EGLDisplay display = eglGetDisplay(native(sim.display()));
        ASSERT_TRUE(eglInitialize(display, nullptr, nullptr));
        const EGLint wish[] = {EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                               EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0, visual = -1;
        ASSERT_TRUE(eglChooseConfig(display, wish, &config, 1, &count) && count == 1);
        EXPECT_TRUE(eglGetConfigAttrib(display, config, EGL_NATIVE_VISUAL_ID, &visual));
        EXPECT_EQ(visual, row.visual) << row.board.name;
        EXPECT_TRUE(eglTerminate(display));
    }
}

TEST(WirePanels, AByteLostOnTheWireIsSeen) {
    for (std::uint64_t n : {0u, 1u, 2u, 3u, 200u}) { // address, control, command, parameter, data
        sim::SimBoard sim(boards::ssd1306_i2c);
        ASSERT_TRUE(sim.display().init().ok());
        const auto frame = sim.display().acquire();
        ASSERT_TRUE(frame.ok());
        for (int y = 0; y < 64; ++y)
            frame.value().extents->rows[y] = {0, 128};
        sim.drop_byte(n);
        ASSERT_TRUE(sim.display().present().ok());
        frame.value().extents->rows[9] = {3, 4};
        const auto next = sim.display().present();
        EXPECT_EQ(next.error().fault, n == 0 ? hal::Fault::no_answer : hal::Fault::none);
        EXPECT_EQ(sim.violations_text() == "", n == 0) << n;
    }
}

} // namespace
