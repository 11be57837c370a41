// Runs the committed inputs of a fuzzer in the everyday tests.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "tests/source_dir.hpp"

namespace spangle::test {

/// Runs every file of tests/system/fuzz/corpus/`fuzzer`. Returns how many there were.
template <class Run> int replay_corpus(const std::string& fuzzer, Run run) {
    int files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(SPANGLE_SOURCE_DIR "/tests/system/fuzz/corpus/" + fuzzer)) {
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file), {}};
        SCOPED_TRACE(entry.path().filename());
        run(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
        ++files;
    }
    return files;
}

} // namespace spangle::test
