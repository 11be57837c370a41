// Counts the covered pixels, and checks that they are the right ones. Every triangle is compared with brute
// force on its own snapped vertices and, where the policy knows them, on the unsnapped vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "raster/span/draw_state.hpp"

namespace spangle::trade {

/// The pixels that the triangles of one frame cover: one flag per pixel, rows from the bottom.
struct FrameCoverage {
    std::vector<bool> snapped; ///< pixels that vertices on the n.8 grid cover, as the policy snapped them
    std::vector<bool>
        exact; ///< pixels that unsnapped vertices cover, where the policy knows them; else as `snapped`
};
/// The number of pixels that only one of the two covers.
std::uint64_t count_differences(const std::vector<bool>& a, const std::vector<bool>& b);

class Coverage : public raster::Observer {
  public:
    Coverage(int width, int height);

    /// Ends the frame and returns its coverage; call it after each frame.
    FrameCoverage end_frame();

    /// The number of pixels whose coverage differs from brute force on the snapped vertices.
    std::uint64_t mismatches() const { return mismatches_; }
    /// The pixels that anything was drawn to since the last call, top row first.
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
    std::vector<std::uint8_t> hit_count_;
    std::vector<bool> covered_mask_;
    FrameCoverage frame_;
    std::uint64_t mismatches_ = 0;

    void begin(const std::int32_t x[3], const std::int32_t y[3], const double* exact_x, const double* exact_y,
               Rect scissor);
    void add(std::int32_t y, std::int32_t begin, std::int32_t end);
    void close_triangle();
    bool is_inside(std::int64_t px, std::int64_t py) const;
    bool inside_exact(double px, double py) const;
};

} // namespace spangle::trade
