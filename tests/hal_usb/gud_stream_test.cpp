// Devices that answer what they like: nothing breaks (run it under ASan and UBSan for the whole meaning).
#include "tests/hal_usb/gud_stream.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "tests/source_dir.hpp"

namespace {

TEST(GudStream, Seeds) {
    for (const std::vector<std::uint8_t>& seed : gud_test::gud_seeds())
        gud_test::run_gud_stream(seed.data(), seed.size());
}

TEST(GudStream, Corpus) {
    int files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(SPANGLE_SOURCE_DIR "/tests/fuzz/corpus/gud")) {
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file), {}};
        gud_test::run_gud_stream(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
        ++files;
    }
    EXPECT_GT(files, 0);
}

} // namespace
