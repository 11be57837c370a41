// Finds places for the names of a plot's points, so that no name covers another.
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

/// The place of a name: its left end, at half of its height.
struct NamePlace {
    double x, y;
};

/// Places each name right of its point, left, above or below, nearer before further. A name lies inside the
/// area, and clear of all points and of names placed before. A name without room has no place.
std::vector<std::optional<NamePlace>> place_names(const std::vector<NamedPoint>& points, double width,
                                                  double height);

} // namespace spangle::trade
