// Sends random and recorded streams to the controller models: nothing breaks, and pins and bytes agree.
#include "tests/system/sim/controller_stream.hpp"

#include <random>

#include <gtest/gtest.h>

#include "tests/system/fuzz/replay.hpp"

namespace {

TEST(ControllerStream, SeedsAndTheirMutations) {
    std::mt19937 random(1);
    for (const std::vector<std::uint8_t>& seed : sim_test::controller_seeds()) {
        sim_test::run_controller_stream(seed.data(), seed.size());
        for (int variant = 0; variant < 4; ++variant) {
            std::vector<std::uint8_t> bytes = seed;
            bytes[0] |= 3; // chooses a small memory
            for (int change = 0; change < 6; ++change)
                bytes[1 + random() % (bytes.size() - 1)] = static_cast<std::uint8_t>(random());
            sim_test::run_controller_stream(bytes.data(), bytes.size());
        }
    }
}

TEST(ControllerStream, Corpus) {
    EXPECT_GT(spangle::test::replay_corpus("controller", sim_test::run_controller_stream), 100);
}

} // namespace
