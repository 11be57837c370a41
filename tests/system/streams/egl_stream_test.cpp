// Plays streams of EGL and GL calls: nothing breaks. ASan and UBSan give this test its full meaning.
#include "tests/system/streams/egl_stream.hpp"

#include <gtest/gtest.h>

#include "tests/system/fuzz/replay.hpp"

namespace {

TEST(EglStream, Seeds) {
    for (const std::vector<std::uint8_t>& seed : spangle::test::egl_seeds())
        spangle::test::run_egl_stream(seed.data(), seed.size());
}

TEST(EglStream, Corpus) {
    EXPECT_GT(spangle::test::replay_corpus("egl", spangle::test::run_egl_stream), 0);
}

} // namespace
