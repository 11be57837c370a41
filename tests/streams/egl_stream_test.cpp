// Streams of EGL and GL calls: nothing breaks (run it under ASan and UBSan for the whole meaning).
#include "tests/streams/egl_stream.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "tests/source_dir.hpp"

namespace {

TEST(EglStream, Seeds) {
    for (const std::vector<std::uint8_t>& seed : spangle::test::egl_seeds())
        spangle::test::run_egl_stream(seed.data(), seed.size());
}

TEST(EglStream, Corpus) {
    int files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(SPANGLE_SOURCE_DIR "/tests/fuzz/corpus/egl")) {
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file), {}};
        spangle::test::run_egl_stream(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
        ++files;
    }
    EXPECT_GT(files, 0);
}

} // namespace
