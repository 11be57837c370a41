// Compares rows of the next level with means that are computed texel by texel.
#include "gl/texture/halve_row.hpp"

#if SPANGLE_ROW_CODES && SPANGLE_FEATURE_MIPMAP_GENERATION

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "gl/pixel/group.hpp"
#include "gl/texture/internal_format.hpp"

namespace spangle::gl {
namespace {

TEST(RowHalver, IsTheMeanOfEightTexels) {
    std::mt19937 random(1);
    for (unsigned f = 0; f <= static_cast<unsigned>(raster::TexelFormat::rgb332); ++f) {
        const PixelLayout layout = texel_layout(static_cast<raster::TexelFormat>(f));
        const Groups texels(layout);
        RowHalver halver(layout);
        ASSERT_TRUE(halver.works());
        for (unsigned shape = 0; shape < 90; ++shape) {
            const std::size_t count = 1 + random() % 80, size = layout.group_bytes();
            std::vector<std::uint8_t> row[4], out(count * size + 8, 0xA5);
            for (auto& bytes : row) {
                bytes.resize(2 * count * size);
                for (std::uint8_t& b : bytes)
                    b = static_cast<std::uint8_t>(random() % 4 != 0 ? random() : 255);
            }
            const auto& first = row[0];
            const auto& second = row[shape % 3 == 0 ? 0 : 1];
            const auto& third = row[shape % 3 == 2 ? 2 : 0];
            const auto& fourth = shape % 3 == 2 ? row[3] : second;
            auto wanted = out;
            halver.halve({row[0].data(), second.data(), third.data(), fourth.data()},
                         static_cast<std::int32_t>(count), out.data());
            for (std::size_t i = 0; i < count; ++i) {
                Pixel mean{};
                for (unsigned c = 0; c < 4; ++c) {
                    std::uint32_t sum = 4;
                    for (const std::vector<std::uint8_t>* const of : {&first, &second, &third, &fourth})
                        for (unsigned k = 0; k < 2; ++k) {
                            mean.value[c].bits = texels.color(of->data(), 2 * i + k).value[c].bits;
                            sum += texels.color(of->data(), 2 * i + k).value[c].code;
                        }
                    mean.value[c].code = sum >> 3;
                }
                pack_pixel(layout, false, mean, &wanted[i * size]);
            }
            ASSERT_EQ(out, wanted) << "format " << f << ", " << count << " texels";
        }
    }
}

TEST(RowHalver, DepthsAreNotOfTexels) {
    EXPECT_FALSE(RowHalver(texel_layout(raster::TexelFormat::z16)).works());
    EXPECT_FALSE(RowHalver(texel_layout(raster::TexelFormat::z24)).works());
}

} // namespace
} // namespace spangle::gl

#endif
