// Tests every DCS panel of the table on the model of its controller, in all eight orientations and on both
// buses. The glass shows the surface, no rule is broken, and the controller is the expected one.
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <spangle/GL/gl.h>
#include <spangle/hal/readback.hpp>
#include <spangle/panels.hpp>
#include <spangle/sim/board.hpp>

#include "host_sim/board/module.hpp"
#include "host_sim/bus/sim_bus.hpp"
#include "tests/support/scene_player.hpp"

namespace {

using namespace spangle;

/// Returns a board that is as fast as the panel, in the first format that the panel takes on the bus.
hal::Board board_of(const hal::PanelDesc& panel, hal::BusKind bus, hal::Orientation o) {
    hal::Board board{.name = panel.name, .display = {.panel = &panel, .orientation = o}, .bus = bus};
    if (!hal::format_code(panel, bus, hal::WireFormat::rgb565).taken)
        board.display.format = PixelFormat::rgb888;
    board.write_hz = bus == hal::BusKind::spi4 ? panel.timing.practical_serial_mhz * 1000000u
                                               : 1000000000u / panel.timing.parallel_write_ns;
    board.read_hz = 2000000;
    board.display.read_back = true;
    return board;
}

/// Returns the bits that reach the wire: RGB565, or the upper six bits of RGB888.
sim::Image on_the_wire(const std::vector<std::uint8_t>& rgb, int width, int height, bool six_each) {
    sim::Image out(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) {
                const int v = rgb[static_cast<std::size_t>(((height - 1 - y) * width + x) * 3 + c)];
                const int most = c == 1 ? 63 : 31;
                out.at(x, y)[c] =
                    static_cast<std::uint8_t>(six_each ? v >> 2 : (v * most + 127) / 255 << (c == 1 ? 0 : 1));
            }
    return out;
}

/// Returns these same bits of a glass of six bits a component.
sim::Image same_bits(const sim::Image& glass, bool six_each) {
    sim::Image out(glass.width, glass.height);
    for (int y = 0; y < glass.height; ++y)
        for (int x = 0; x < glass.width; ++x)
            for (int c = 0; c < 3; ++c)
                out.at(x, y)[c] =
                    static_cast<std::uint8_t>(glass.at(x, y)[c] >> 2 & (six_each || c == 1 ? 63 : 62));
    return out;
}

struct Drawn {
    sim::Image surface, glass;
    std::string violations;
};

/// Draws two frames, so that the second one is sent as damage.
Drawn draw(const scenes::Scene& scene, const hal::Board& board) {
    sim::SimBoard sim(board);
    const bool six_each = board.display.format == PixelFormat::rgb888;
    const hal::DisplayInfo info = sim.display().info();
    std::vector<std::uint8_t> rgb(static_cast<std::size_t>(info.width * info.height * 3));
    EXPECT_TRUE(test::play(sim.display(), scene, 2, [&] {
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, info.width, info.height, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
    })) << board.name;
    return {on_the_wire(rgb, info.width, info.height, six_each), same_bits(sim.scan_out(), six_each),
            sim.violations_text()};
}

/// Returns the panels with DCS controllers.
std::vector<const hal::PanelDesc*> dcs_panels() {
    std::vector<const hal::PanelDesc*> out;
    for (const hal::PanelDesc* panel : hal::panels::all)
        if (panel->commands->status_registers)
            out.push_back(panel);
    return out;
}

class Panels : public testing::TestWithParam<const hal::PanelDesc*> {};

/// The scenes take turns: together the panels show each scene in each orientation.
TEST_P(Panels, ShowTheSurfaceInEveryOrientation) {
    std::vector<const scenes::Scene*> every;
    for (const scenes::Scene& scene : scenes::all())
        every.push_back(&scene);
    std::size_t turn = static_cast<std::size_t>(GetParam()->glass.width);
    for (const hal::Orientation o : hal::orientations) {
        const auto bus = o.mirrored ? hal::BusKind::i8080 : hal::BusKind::spi4;
        const scenes::Scene& scene = *every[turn++ % every.size()];
        const Drawn drawn = draw(scene, board_of(*GetParam(), bus, o));
        const std::string where = std::string(scene.id) + ", turned " + std::to_string(90 * int(o.rotation)) +
                                  (o.mirrored ? ", mirrored" : "");
        EXPECT_EQ(drawn.violations, "") << where;
        EXPECT_EQ(drawn.glass, drawn.surface) << where;
    }
}

TEST_P(Panels, ReadBackWhatWasWritten) {
    for (const auto kind : {hal::BusKind::spi4, hal::BusKind::i8080}) {
        const hal::Board board = board_of(*GetParam(), kind, {hal::Rotation::r90});
        sim::DcsController controller(sim::chip_of(*GetParam()), sim::mount_of(*GetParam()),
                                      kind == hal::BusKind::i8080);
        sim::SimBus bus(controller, hal::bus_caps(board));
        hal::PanelStorage<hal::PanelSizes{.height = 320}> storage;
        hal::PanelDisplay display(bus, board.display, storage.memory());
        ASSERT_TRUE(display.init().ok());
        const auto frame = display.acquire();
        ASSERT_TRUE(frame.ok());
        const int bytes = format_info(board.display.format).bytes_per_pixel;
        const Rect area{3, 5, 17, 4};
        std::vector<std::uint8_t> wanted, read(17 * 4 * 3);
        for (int y = area.y; y < area.y + area.h; ++y) {
            for (int x = area.x; x < area.x + area.w; ++x) {
                std::uint8_t* const at = frame.value().pixels + y * frame.value().stride + x * bytes;
                const unsigned word = static_cast<unsigned>(y * 977 + x) * 2654435761u >> 8 & 0xFFFF;
                const auto eight = [](unsigned v) { return static_cast<std::uint8_t>(v); };
                const std::uint8_t r = eight(word >> 8 & 0xF8), g = eight(word >> 3 & 0xFC),
                                   b = eight(word << 3 & 0xF8);
                wanted.insert(wanted.end(), {r, g, b});
                at[0] = bytes == 2 ? eight(word >> 8) : r;
                at[1] = bytes == 2 ? eight(word) : g;
                if (bytes == 3)
                    at[2] = b;
            }
            frame.value().extents->rows[y] = {3, 20};
        }
        ASSERT_TRUE(display.present().ok());
        ASSERT_TRUE(display.read_back(area, read.data()).ok());
        for (std::size_t i = 0; i < read.size(); ++i) // EPF decides the low bit of red and blue
            read[i] &= i % 3 == 1 ? 0xFC : 0xF8;
        EXPECT_EQ(read, wanted);
        EXPECT_TRUE(controller.violations().empty()) << controller.violations().front().text;
    }
}

/// Returns whether the identity tells the chips apart. Register 04h of an ILI9341 is three zeros, and so is
/// the answer of chips that are identified by another register.
bool tells(const hal::PanelDesc& asked, const sim::Chip& answering) {
    const bool zeros = asked.identity.command == 0x04 && asked.identity.id == 0;
    return !zeros || answering.id != std::array<std::uint8_t, 3>{};
}

TEST_P(Panels, AreTakenForNoOther) {
    const hal::PanelDesc& asked = *GetParam();
    for (const hal::PanelDesc* built : dcs_panels())
        for (const auto kind : {hal::BusKind::spi4, hal::BusKind::i8080}) {
            const sim::Chip chip = sim::chip_of(*built);
            sim::DcsController controller(chip, sim::mount_of(*built), kind == hal::BusKind::i8080);
            sim::SimBus bus(controller, hal::bus_caps(board_of(*built, kind, {})));
            bus.pass(200'000'000);
            hal::ReadScratch scratch;
            const auto answer = hal::check_identity(bus, asked, scratch);
            const bool same = built->controller == asked.controller;
            if (!same && !tells(asked, chip))
                continue;
            EXPECT_EQ(answer.ok() ? hal::Fault::none : answer.error().fault,
                      same ? hal::Fault::none : hal::Fault::wrong_device)
                << built->name;
        }
}

INSTANTIATE_TEST_SUITE_P(All, Panels, testing::ValuesIn(dcs_panels()), [](const auto& info) {
    std::string name = info.param->name;
    for (char& c : name)
        c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
});

TEST(PanelModule, HasAMemoryItsControllerCanBeStrappedTo) {
    hal::PanelDesc panel = hal::panels::st7735_128x160;
    EXPECT_EQ(sim::chip_of(panel).width, 128);
    EXPECT_EQ(sim::chip_of(hal::panels::st7735_80x160_26).height, 162);
    panel.memory.height = 161;
    EXPECT_THROW(sim::chip_of(panel), std::invalid_argument);
}

} // namespace
