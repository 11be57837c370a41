// A program that draws nothing: what is measured is the image, which holds the commands that were recorded.
#pragma once

namespace spangle::measure {

struct Nothing {
    static void setup(int, int) {}
    static void draw(int) {}
};
inline constexpr Nothing nothing;

} // namespace spangle::measure
