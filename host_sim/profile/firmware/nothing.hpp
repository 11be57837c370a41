// A program that draws nothing. It serves to measure the size of an image that holds the recorded commands.
#pragma once

namespace spangle::measure {

struct Nothing {
    static void setup(int, int) {}
    static void draw(int) {}
};
inline constexpr Nothing nothing;

} // namespace spangle::measure
