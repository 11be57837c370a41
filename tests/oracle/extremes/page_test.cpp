// docs/extremes.md must have a row for each extreme case and no other.
#include <algorithm>
#include <fstream>
#include <set>
#include <string>

#include "tests/source_dir.hpp"
#include <gtest/gtest.h>

namespace spangle::test {
namespace {

TEST(ExtremePage, HasARowForEachTest) {
    std::set<std::string> tests, rows;
    const testing::UnitTest& all = *testing::UnitTest::GetInstance();
    for (int i = 0; i < all.total_test_suite_count(); ++i) {
        const testing::TestSuite& suite = *all.GetTestSuite(i);
        for (int j = 0; std::string(suite.name()) == "Extreme" && j < suite.total_test_count(); ++j)
            tests.insert(suite.GetTestInfo(j)->name());
    }
    std::ifstream page(SPANGLE_SOURCE_DIR "/docs/extremes.md");
    ASSERT_TRUE(page);
    for (std::string line; std::getline(page, line);)
        if (line.size() > 4 && line.compare(0, 2, "| ") == 0 && line[2] >= '0' && line[2] <= '9') {
            EXPECT_TRUE(rows.insert(line.substr(2, line.find(' ', 2) - 2)).second) << "twice: " << line;
            EXPECT_EQ(std::count(line.begin(), line.end(), '|'), 6) << line;
        }
    EXPECT_EQ(rows, tests);
    EXPECT_GE(tests.size(), 37u);
}

} // namespace
} // namespace spangle::test
