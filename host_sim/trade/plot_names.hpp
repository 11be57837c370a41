// Where the names of a plot's points stand, so that none covers another.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace spangle::trade {

/// A point in pixels of the plot's area, y upwards, and its name; an empty name is not written.
struct NamedPoint {
    double x, y;
    std::string name;
};

/// Where a name begins, at half of its height.
struct NamePlace {
    double x, y;
};

/// Names stand right of their points, left, above or below, nearer before further, inside of the area and
/// clear of all points and of names placed before. A name that finds no room has no place.
std::vector<std::optional<NamePlace>> place_names(const std::vector<NamedPoint>& points, double width,
                                                  double height);

} // namespace spangle::trade
