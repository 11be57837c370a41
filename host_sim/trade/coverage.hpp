// Which pixels were covered, and whether they were the right ones: every triangle is held against brute force
// on its own snapped vertices, and where the policy knows them, on the unsnapped ones.
#pragma once

#include <cstdint>
#include <vector>

#include "raster/span/draw_state.hpp"

namespace spangle::trade {

/// What the triangles of one frame cover: one flag per pixel, rows from the bottom.
struct FrameCoverage {
    std::vector<bool> snapped; ///< their vertices on the n.8 grid, as the policy snapped them
    std::vector<bool>
        exact; ///< where the policy knows them, their vertices as they were before; else snapped
};
/// Pixels that only one of the two covers.
std::uint64_t differences(const std::vector<bool>& a, const std::vector<bool>& b);

class Coverage : public raster::Observer {
  public:
    Coverage(int width, int height);

    /// Call at the end of each frame.
    FrameCoverage end_frame();

    std::uint64_t mismatches() const { return mismatches_; } ///< pixels, on snapped vertices
    /// Pixels anything was drawn to since the last call, top row first.
    std::vector<bool> take_mask();

  private:
    struct Triangle {
        std::int64_t x[3], y[3];
        double exact_x[3], exact_y[3];
        bool has_exact, open = false;
        Rect scissor;
    };
    int width_, height_;
    Triangle triangle_{};
    std::vector<std::uint8_t> hits_;
    std::vector<bool> mask_;
    FrameCoverage frame_;
    std::uint64_t mismatches_ = 0;

    void begin(const std::int32_t x[3], const std::int32_t y[3], const double* exact_x, const double* exact_y,
               Rect scissor);
    void add(std::int32_t y, std::int32_t begin, std::int32_t end);
    void close_triangle();
    bool inside(std::int64_t px, std::int64_t py) const;
    bool inside_exact(double px, double py) const;
};

} // namespace spangle::trade
