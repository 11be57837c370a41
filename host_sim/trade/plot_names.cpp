#include "host_sim/trade/plot_names.hpp"

#include <algorithm>

namespace spangle::trade {

namespace {

/// Sizes of a letter and of a point, in units of the plot.
constexpr double letter_width = 5.6, letter_height = 11, radius = 4;

struct Box {
    double left, bottom, right, top;
    bool meets(const Box& other) const {
        return left < other.right && other.left < right && bottom < other.top && other.bottom < top;
    }
    bool within(double width, double height) const {
        return left >= 0 && bottom >= 0 && right <= width && top <= height;
    }
};

Box box_of_point(const NamedPoint& point) {
    return {point.x - radius, point.y - radius, point.x + radius, point.y + radius};
}

Box box_of_name(const NamePlace& place, double length) {
    return {place.x, place.y - letter_height / 2, place.x + length, place.y + letter_height / 2};
}

/// The places for a name around its point, in the order in which they are tried.
std::vector<NamePlace> places_around(const NamedPoint& point, double length) {
    std::vector<NamePlace> out;
    for (const double away : {radius + 2, 2 * radius + 4, 4 * radius}) {
        const double right = point.x + away, left = point.x - away - length, middle = point.x - length / 2,
                     above = point.y + away + letter_height / 2, below = point.y - away - letter_height / 2;
        for (const NamePlace& place : {NamePlace{right, point.y},
                                       {left, point.y},
                                       {middle, above},
                                       {middle, below},
                                       {right, above},
                                       {right, below},
                                       {left, above},
                                       {left, below}})
            out.push_back(place);
    }
    return out;
}

} // namespace

std::vector<std::optional<NamePlace>> place_names(const std::vector<NamedPoint>& points, double width,
                                                  double height) {
    std::vector<Box> taken;
    taken.reserve(2 * points.size()); // room for the boxes of points and of names
    for (const NamedPoint& point : points)
        taken.push_back(box_of_point(point));
    std::vector<std::optional<NamePlace>> out(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double length = letter_width * static_cast<double>(points[i].name.size());
        for (const NamePlace& place : places_around(points[i], length)) {
            const Box box = box_of_name(place, length);
            const bool free =
                std::none_of(taken.begin(), taken.end(), [&](const Box& other) { return box.meets(other); });
            if (points[i].name.empty() || !free || !box.within(width, height))
                continue;
            out[i] = place;
            taken.push_back(box);
            break;
        }
    }
    return out;
}

} // namespace spangle::trade
