// Random command streams on the real pipeline: nothing breaks (run it under ASan and UBSan for the whole
// meaning).
#include "tests/gl_api/command_seeds.hpp"
#include "tests/gl_api/command_stream.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/source_dir.hpp"

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
    int files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(SPANGLE_SOURCE_DIR "/tests/fuzz/corpus/gl_commands")) {
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file), {}};
        spangle::test::run_command_stream(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
        ++files;
    }
    EXPECT_GT(files, 0);
}

} // namespace
