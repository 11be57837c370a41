// Reads PNG files that were made to harm their reader.
#include <fstream>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spangle/sim/image.hpp>
#include <unistd.h>

namespace {

using spangle::sim::decode_png;
using spangle::sim::encode_png;
using spangle::sim::Image;
using testing::HasSubstr;

std::uint32_t crc(const std::string& bytes) { // PNG, annex D
    std::uint32_t c = 0xFFFFFFFFu;
    for (const char byte : bytes) {
        c ^= static_cast<std::uint8_t>(byte);
        for (int bit = 0; bit < 8; ++bit)
            c = c >> 1 ^ (0xEDB88320u & (0u - (c & 1)));
    }
    return ~c;
}

std::string word(std::uint32_t v) {
    std::string out;
    for (int shift = 24; shift >= 0; shift -= 8)
        out += static_cast<char>(v >> shift & 255);
    return out;
}

std::string sound() {
    Image image(5, 3);
    image.rgba[4] = 7;
    image.rgba[11] = 9;
    std::string bytes;
    EXPECT_EQ(encode_png(image, bytes), "");
    return bytes;
}

/// Returns a sound file whose header claims another size.
std::string sized(std::uint32_t width, std::uint32_t height) {
    std::string bytes = sound();
    bytes.replace(16, 8, word(width) + word(height));
    return bytes.replace(29, 4, word(crc(bytes.substr(12, 17))));
}

TEST(HostilePictures, SizesAreLimitedBeforeAnythingIsDecoded) {
    Image image(1, 1);
    const Image before = image;
    const std::pair<std::uint32_t, std::uint32_t> sizes[] = {{16385, 1},    {1, 16385},    {1000000, 1000000},
                                                             {16384, 4097}, {4097, 16384}, {999999, 3}};
    for (const auto& [width, height] : sizes) {
        EXPECT_THAT(decode_png(sized(width, height), image), HasSubstr("at most 16384 pixels a side"))
            << width << "x" << height;
        EXPECT_EQ(image, before);
    }
    for (const std::uint32_t side : {0u, 0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu}) {
        EXPECT_NE(decode_png(sized(side, 1), image), "") << side;
        EXPECT_NE(decode_png(sized(1, side), image), "") << side;
    }
    EXPECT_NE(decode_png(sized(16384, 4096), image), "") << "within the limit, but the rows are not there";
    EXPECT_EQ(image, before);
}

TEST(HostilePictures, TruncatedAndBrokenOnes) {
    const std::string whole = sound();
    Image image, expected;
    ASSERT_EQ(decode_png(whole, expected), "");
    for (std::size_t length = 0; length + 12 < whole.size(); ++length) // IEND may be missing
        EXPECT_NE(decode_png(whole.substr(0, length), image), "") << length;
    std::mt19937 random(20);
    for (int n = 0; n < 3000; ++n) {
        std::string broken = whole;
        for (unsigned changes = 1 + random() % 4; changes > 0; --changes)
            broken[random() % broken.size()] = static_cast<char>(random());
        Image out;
        if (decode_png(broken, out).empty()) {
            EXPECT_EQ(out.rgba.size(),
                      std::size_t{4} * static_cast<unsigned>(out.width) * static_cast<unsigned>(out.height));
        }
    }
}

TEST(HostilePictures, FilesSayTheirName) {
    const std::string path = testing::TempDir() + "hostile-" + std::to_string(getpid()) + ".png";
    std::ofstream(path, std::ios::binary) << sized(20000, 20000);
    Image image;
    EXPECT_THAT(spangle::sim::read_png(path, image), HasSubstr(path + "': it is 20000x20000"));
    unlink(path.c_str());
    EXPECT_NE(spangle::sim::read_png(path, image), "");
    EXPECT_NE(spangle::sim::read_png("/", image), "");
}

} // namespace
