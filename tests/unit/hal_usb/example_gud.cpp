// Runs the GUD example unchanged on a modelled device. (Its main() is called example_main here.)

#include "tests/support/example_length.hpp"
#include "tests/unit/hal_usb/gud_rig.hpp"

int example_main(int argc, char** argv);

namespace {

using namespace gud_test;

int run(const char* frames) {
    std::string program = "triangle", count = frames, file = path;
    char* words[] = {program.data(), count.data(), file.data(), nullptr};
    return example_main(3, words);
}

TEST(GudExample, DrawsATriangle) {
    GudRig rig;
    rig.size(160, 120);
    rig.device.max_buffer_size = 4096;
    rig.usb.attach(rig.kernel, path);
    sim::Image last;
    rig.usb.fate = [&](std::size_t) {
        last = rig.device.glass();
        return sim::UsbfsDevice::Fate::normal;
    };
    ASSERT_EQ(run("8"), 0);
    EXPECT_EQ(rig.kernel.open_files(), 0);
    EXPECT_FALSE(rig.device.enabled()) << "switched off at the end";
    EXPECT_EQ(rig.device.violations(), "");
    ASSERT_EQ(last.width, 160);
    int lit = 0;
    for (int y = 0; y < last.height; ++y)
        for (int x = 0; x < last.width; ++x)
            lit += last.at(x, y)[0] + last.at(x, y)[1] + last.at(x, y)[2] > 200;
    EXPECT_GT(lit, 160 * 120 / 8);
    EXPECT_LT(lit, 160 * 120 / 2);
}

TEST(GudExample, SaysWhatIsMissing) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(run("1"), 1);
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "triangle: eglInitialize: /dev/bus/usb/001/002: open: No such file or "
              "directory; lsusb lists what is plugged in\n");
}

TEST(GudExample, IsShort) {
    spangle::test::expect_short("gud_display/triangle.cpp");
}

} // namespace
