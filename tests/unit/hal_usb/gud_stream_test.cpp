// Devices answer whatever they like, and nothing breaks. ASan and UBSan give this test its full meaning.
#include "tests/unit/hal_usb/gud_stream.hpp"

#include <gtest/gtest.h>

#include "tests/system/fuzz/replay.hpp"

namespace {

TEST(GudStream, Seeds) {
    for (const std::vector<std::uint8_t>& seed : gud_test::gud_seeds())
        gud_test::run_gud_stream(seed.data(), seed.size());
}

TEST(GudStream, Corpus) {
    EXPECT_GT(spangle::test::replay_corpus("gud", gud_test::run_gud_stream), 0);
}

} // namespace
