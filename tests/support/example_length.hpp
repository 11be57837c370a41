// Examples must be short enough to be read in one sitting: fewer than 60 lines.
#pragma once

#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/source_dir.hpp"

namespace spangle::test {

/// Checks the length of an example; `path` is relative to boards/examples.
inline void expect_short(const std::string& path) {
    std::ifstream source(SPANGLE_SOURCE_DIR "/boards/examples/" + path);
    int lines = 0;
    for (std::string line; std::getline(source, line);)
        ++lines;
    EXPECT_GT(lines, 0) << path;
    EXPECT_LT(lines, 60) << path;
}

} // namespace spangle::test
