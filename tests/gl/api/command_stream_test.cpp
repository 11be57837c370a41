// Runs random command streams on the real pipeline: nothing breaks. ASan and UBSan give this test its full
// meaning.
#include "tests/gl/api/command_seeds.hpp"
#include "tests/gl/api/command_stream.hpp"

#include <cstdlib>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/system/fuzz/replay.hpp"

namespace {

TEST(CommandStream, RandomStreams) {
    const char* const wanted = std::getenv("SPANGLE_STREAMS");
    const int streams = wanted != nullptr ? std::atoi(wanted) : 1500;
    for (int i = 0; i < streams; ++i) {
        std::mt19937 random(static_cast<unsigned>(i));
        std::vector<std::uint8_t> data(600 + random() % 3000);
        for (std::uint8_t& byte : data)
            byte = static_cast<std::uint8_t>(random() >> 9);
        SCOPED_TRACE(i);
        spangle::test::run_command_stream(data.data(), data.size());
    }
}

TEST(CommandStream, Seeds) {
    for (const std::vector<std::uint8_t>& seed : spangle::test::command_seeds())
        spangle::test::run_command_stream(seed.data(), seed.size());
}

TEST(CommandStream, Corpus) {
    EXPECT_GT(spangle::test::replay_corpus("gl_commands", spangle::test::run_command_stream), 0);
}

} // namespace
