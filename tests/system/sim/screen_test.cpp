// Reads pictures of screens as an emulator drew them.
#include <cstdio>
#include <fstream>

#include <gtest/gtest.h>

#include "host_sim/boards/screen.hpp"

namespace {

using namespace spangle;
using namespace spangle::sim;

Image one(std::uint8_t r, std::uint8_t g, std::uint8_t b) {
    Image image(1, 1);
    image.at(0, 0)[0] = r;
    image.at(0, 0)[1] = g;
    image.at(0, 0)[2] = b;
    return image;
}

std::string file(const std::string& content) {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    const std::string path = testing::TempDir() + "screen_" + test + ".ppm"; // tests run side by side
    std::ofstream(path, std::ios::binary) << content;
    return path;
}

TEST(Screen, ReadsPictures) {
    Image image;
    ASSERT_EQ(read_ppm(file("P6\n2 1\n255\nabcdef"), image), "");
    EXPECT_EQ(image.width, 2);
    EXPECT_EQ(image.at(1, 0)[0], 'd');
    EXPECT_EQ(image.at(1, 0)[2], 'f');
    EXPECT_EQ(image.at(1, 0)[3], 255);
}

TEST(Screen, RefusesWhatIsNone) {
    Image image;
    for (const char* text :
         {"P5\n1 1\n255\nabc", "P6\n0 1\n255\n", "P6\n1 1\n65535\nabcdef", "P6\n1 1\n255\nab", ""})
        EXPECT_NE(read_ppm(file(text), image), "") << text;
    EXPECT_NE(read_ppm("no/such/file", image), "");
}

TEST(Screen, StepsOfAFormatAreComparedNotTheirScale) {
    EXPECT_TRUE(shows(one(248, 252, 248), one(255, 255, 255), PixelFormat::rgb565_be));
    EXPECT_TRUE(shows(one(8, 4, 0), one(8, 4, 7), PixelFormat::rgb565_le));
    EXPECT_FALSE(shows(one(8, 8, 0), one(8, 4, 0), PixelFormat::rgb565_le));
    EXPECT_FALSE(shows(one(0, 0, 16), one(0, 0, 8), PixelFormat::rgb565_le));
    EXPECT_TRUE(shows(one(17, 17, 17), one(20, 20, 20), PixelFormat::grey4));
    EXPECT_FALSE(shows(one(34, 34, 34), one(20, 20, 20), PixelFormat::grey4));
    EXPECT_FALSE(shows(one(51, 51, 51), one(34, 34, 34), PixelFormat::grey4));
    EXPECT_TRUE(shows(one(128, 255, 200), one(255, 255, 255), PixelFormat::mono));
    EXPECT_FALSE(shows(one(127, 255, 200), one(255, 255, 255), PixelFormat::mono));
    EXPECT_FALSE(shows(Image(2, 1), Image(1, 1), PixelFormat::mono));
    EXPECT_FALSE(shows(Image(1, 2), Image(1, 1), PixelFormat::mono));
}

TEST(Screen, MagnifiedPixelsMustBeEqual) {
    Image large(4, 2);
    for (int i = 0; i < 2; ++i)
        for (int k = 0; k < 2; ++k)
            large.at(2 + i, k)[0] = 7;
    const Image small = shrink_picture(large, 2);
    ASSERT_EQ(small.width, 2);
    ASSERT_EQ(small.height, 1);
    EXPECT_EQ(small.at(0, 0)[0], 255);
    EXPECT_EQ(small.at(1, 0)[0], 7);
    large.at(3, 1)[0] = 8;
    EXPECT_EQ(shrink_picture(large, 2).width, 0);
    EXPECT_EQ(shrink_picture(Image(3, 2), 2).width, 0);
}

} // namespace
