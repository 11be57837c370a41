// Names of a plot's points must not cover each other.
#include <gtest/gtest.h>

#include <string>

#include "host_sim/trade/plot_names.hpp"

namespace spangle::trade {
namespace {

constexpr double width = 600, height = 300, letter = 5.6, half = 5.5;

TEST(PlotNames, StandRightOfTheirPoints) {
    const auto places = place_names({{100, 100, "S4r"}}, width, height);
    ASSERT_TRUE(places[0].has_value());
    EXPECT_GT(places[0]->x, 104);
    EXPECT_LT(places[0]->x, 110);
    EXPECT_EQ(places[0]->y, 100);
}

TEST(PlotNames, StayInsideOfTheArea) {
    const auto places = place_names({{598, 298, "OFFSET"}, {2, 2, "S1"}}, width, height);
    ASSERT_TRUE(places[0].has_value() && places[1].has_value());
    EXPECT_LE(places[0]->x + 6 * letter, width);
    EXPECT_LE(places[0]->y + half, height);
    EXPECT_GE(places[1]->x, 0);
    EXPECT_GE(places[1]->y - half, 0);
}

/// Makes a row of points that are nearer to each other than their names are long.
TEST(PlotNames, CoverNeitherPointsNorNames) {
    std::vector<NamedPoint> points;
    for (int i = 0; i < 12; ++i)
        points.push_back({100.0 + 9 * i, 150.0 + (i % 2), "SCENE" + std::to_string(i)});
    const auto places = place_names(points, width, height);
    int placed = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!places[i])
            continue;
        ++placed;
        const double left = places[i]->x, right = left + letter * static_cast<double>(points[i].name.size());
        for (const NamedPoint& point : points)
            EXPECT_FALSE(point.x > left - 3.9 && point.x < right + 3.9 &&
                         std::abs(point.y - places[i]->y) < half + 3.9)
                << points[i].name << " covers a point";
        for (std::size_t k = 0; k < i; ++k) {
            if (!places[k])
                continue;
            const double other = places[k]->x,
                         end = other + letter * static_cast<double>(points[k].name.size());
            EXPECT_FALSE(left < end && other < right && std::abs(places[i]->y - places[k]->y) < 2 * half)
                << points[i].name << " covers " << points[k].name;
        }
    }
    EXPECT_GE(placed, 4) << "room is not used";
    EXPECT_LT(placed, 12) << "there is no room for all";
}

TEST(PlotNames, AreNotWrittenWhereTheyAreEmpty) {
    EXPECT_FALSE(place_names({{100, 100, ""}}, width, height)[0].has_value());
}

} // namespace
} // namespace spangle::trade
