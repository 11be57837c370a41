// Runs the OLED example unchanged on a modelled Linux board. (Its main() is called example_main here.)
#include <cerrno>

#include <gtest/gtest.h>
#include <spangle/boards/ssd1306_i2c.hpp>

#include "host_sim/board/module.hpp"
#include "host_sim/linux/i2c_adapter.hpp"
#include "tests/support/example_length.hpp"

int example_main(int argc, char** argv);

namespace {

using namespace spangle;

struct LinuxBoard {
    sim::Kernel& kernel = sim::Kernel::instance();
    std::unique_ptr<sim::Controller> oled =
        sim::make_controller(hal::panels::ssd1306_128x64, hal::BusKind::i2c);
    sim::I2cAdapter adapter{0x3C, oled.get()};

    LinuxBoard() { adapter.attach(kernel, "/dev/i2c-1"); }
    LinuxBoard(const LinuxBoard&) = delete;
    LinuxBoard& operator=(const LinuxBoard&) = delete;
    ~LinuxBoard() { kernel.forget_all(); }
    static int run(const char* frames) {
        std::string program = "gem", count = frames;
        char* words[] = {program.data(), count.data(), nullptr};
        return example_main(2, words);
    }
};

TEST(OledExample, RefusalsSayWhatToDo) {
    LinuxBoard board;
    board.kernel.set_judge(
        [](const sim::Call& call) { return sim::CallVerdict{call.path == "/dev/i2c-1" ? EACCES : 0}; });
    testing::internal::CaptureStderr();
    EXPECT_EQ(LinuxBoard::run("1"), 1);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("gem: /dev/i2c-1 address 3Ch: open: Permission denied"), std::string::npos) << said;
    EXPECT_NE(said.find("join group 'i2c'"), std::string::npos) << said;
}

/// The gem is as high as the glass and in its middle. The light comes from the eye, and shades of grey are
/// patterns of dots.
TEST(OledExample, DrawsAGem) {
    LinuxBoard board;
    ASSERT_EQ(LinuxBoard::run("20"), 0);
    EXPECT_EQ(board.kernel.open_files(), 0);
    EXPECT_EQ(board.adapter.wrong(), "");
    EXPECT_EQ(board.oled->violations_text(), "");
    const auto glass = board.oled->glass(board.kernel.now());
    int lit = 0, at_the_sides = 0;
    for (std::size_t i = 0; i < glass.size(); ++i) {
        lit += glass[i].g != 0;
        at_the_sides += glass[i].g != 0 && (i % 128 < 24 || i % 128 >= 104);
    }
    EXPECT_GT(lit, 400);
    EXPECT_LT(lit, 3000);
    EXPECT_EQ(at_the_sides, 0);
}

TEST(OledExample, IsShort) {
    spangle::test::expect_short("oled_i2c/gem.cpp");
}

} // namespace
