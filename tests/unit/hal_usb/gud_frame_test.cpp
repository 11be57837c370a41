// Tests how damage becomes bands: all of it is sent, nothing twice, and no band is larger than the device's
// buffer.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "hal/usb/gud_frame.hpp"
#include "hal/usb/gud_pixels.hpp"
#include "tests/support/random.hpp"

namespace spangle::hal {
namespace {

constexpr std::uint8_t formats[] = {gud::R1,     gud::R8,     gud::XRGB1111, gud::RGB332,
                                    gud::RGB565, gud::RGB888, gud::XRGB8888, gud::ARGB8888};

struct Cut {
    gud::Descriptor device;
    std::uint8_t format = 0;
    std::int32_t width = 0, height = 0;
    std::vector<RowSpan> damage;
    GudFrame frame;

    void run() {
        frame.damage = damage;
        const std::vector<std::uint8_t> pixels(static_cast<std::size_t>(2 * width * height));
        std::vector<std::uint16_t> plan(static_cast<std::size_t>(height));
        cut(frame, {pixels.data(), width, height}, device, format, plan.data());
    }

    /// Checks every rule of a band, and that the bands together cover the damage.
    void expect_good() const {
        std::vector<int> covered(static_cast<std::size_t>(width * height));
        std::size_t at = 0;
        const std::uint32_t unit = gud::pixels_per_byte(format);
        for (const GudFrame::Band& band : frame.bands) {
            const gud::Buffer& b = band.buffer;
            ASSERT_EQ(band.at, at) << "their pixels follow each other";
            ASSERT_EQ(b.length, gud::row_bytes(format, b.width) * b.height);
            at += b.length;
            ASSERT_TRUE(device.max_buffer_size == 0 || b.length <= device.max_buffer_size)
                << b.width << 'x' << b.height << " in " << device.max_buffer_size;
            ASSERT_TRUE(b.width != 0 && b.height != 0 && b.x % unit == 0);
            ASSERT_LE(b.x + b.width, static_cast<std::uint32_t>(width));
            ASSERT_LE(b.y + b.height, static_cast<std::uint32_t>(height));
            for (std::uint32_t y = b.y; y < b.y + b.height; ++y)
                for (std::uint32_t x = b.x; x < b.x + b.width; ++x)
                    ++covered[y * static_cast<std::uint32_t>(width) + x];
        }
        ASSERT_EQ(frame.wire.size(), at);
        for (std::int32_t y = 0; y < height; ++y)
            for (std::int32_t x = 0; x < width; ++x) {
                const int times = covered[static_cast<std::size_t>(y * width + x)];
                const RowSpan row = damage[static_cast<std::size_t>(y)];
                ASSERT_TRUE(times >= 1 || x < row.begin || x >= row.end) << x << ' ' << y << " is left out";
            }
    }
};

/// Sends whole pictures of every width with buffers of every size: bands are few, and each fits to the byte.
TEST(GudFrame, EveryBufferSizeOfEveryFormat) {
    for (const std::uint8_t format : formats)
        for (const std::int32_t width : {1, 7, 8, 9, 15, 16, 17, 31, 40})
            for (std::uint32_t most = 1; most <= 4 * 40 + 1; ++most) {
                Cut c;
                c.device.max_buffer_size = most;
                c.format = format;
                c.width = width;
                c.height = 5;
                c.damage.assign(5, RowSpan{0, static_cast<std::int16_t>(width)});
                const std::uint64_t bands = bands_of(c.device, format, width, 5);
                const std::uint32_t least =
                    gud::bits_per_pixel(format) < 8 ? 1 : gud::bits_per_pixel(format) / 8;
                ASSERT_EQ(bands == 0, most < least) << int{format} << ' ' << width << ' ' << most;
                if (bands == 0)
                    continue;
                c.run();
                c.expect_good();
                if (HasFatalFailure())
                    FAIL() << int{format} << ' ' << width << ' ' << most;
                ASSERT_EQ(c.frame.bands.size(), bands) << "as was foretold";
                // A row is cut into as few pieces as the buffer allows.
                const std::uint32_t unit = gud::pixels_per_byte(format);
                const std::uint64_t in_piece =
                    std::uint64_t{most} * 8 / gud::bits_per_pixel(format) / unit * unit;
                const std::size_t row = gud::row_bytes(format, static_cast<std::uint32_t>(width));
                if (row > most) {
                    ASSERT_EQ(bands, 5 * ((static_cast<std::uint64_t>(width) + in_piece - 1) / in_piece));
                } else {
                    ASSERT_EQ(bands, (5 + most / row - 1) / (most / row));
                }
            }
}

TEST(GudFrame, DamageAtRandom) {
    test::Random random{7};
    for (int run = 0; run < 3000; ++run) {
        Cut c;
        c.format = formats[random.below(std::size(formats))];
        c.width = static_cast<std::int32_t>(1 + random.below(70));
        c.height = static_cast<std::int32_t>(1 + random.below(20));
        c.device.max_buffer_size = random.below(4) == 0 ? 0 : 4 + random.below(300);
        c.damage.resize(static_cast<std::size_t>(c.height));
        for (RowSpan& row : c.damage) {
            const auto w = static_cast<std::uint32_t>(c.width);
            const auto begin = static_cast<std::int16_t>(random.below(w)),
                       end = static_cast<std::int16_t>(random.below(w + 1));
            if (begin < end && random.below(3) != 0)
                row = {begin, end};
        }
        c.run();
        c.expect_good();
        if (HasFatalFailure())
            FAIL() << run;
    }
}

/// A device of full updates gets the picture in one piece, or nothing.
TEST(GudFrame, FullUpdatesAreWhole) {
    Cut c;
    c.device.flags = gud::FULL_UPDATE;
    c.format = gud::RGB565;
    c.width = 20;
    c.height = 10;
    c.damage.assign(10, RowSpan{});
    c.run();
    EXPECT_TRUE(c.frame.bands.empty());
    c.damage[3] = {4, 5};
    c.run();
    ASSERT_EQ(c.frame.bands.size(), 1u);
    EXPECT_EQ(c.frame.bands[0].buffer.length, 400u);
    for (const std::uint32_t most : {0u, 400u, 401u, 399u, 1u}) {
        c.device.max_buffer_size = most;
        EXPECT_EQ(bands_of(c.device, c.format, 20, 10), most == 0 || most >= 400 ? 1u : 0u) << most;
    }
}

} // namespace
} // namespace spangle::hal
