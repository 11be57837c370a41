// Drawings in states taken at random, the same from Mesa and from Spangle: a family of them a chapter of GL.
#pragma once

#include <ostream>
#include <vector>

#include "tests/random.hpp"

namespace spangle::oracle {

inline constexpr int state_size = 24; ///< pixels each way

/// What one drawing leaves behind, rows from below: RGBA, stencil and depth (255ths).
inline constexpr int pixel_channels = 6;
using Planes = std::vector<unsigned char>;

/// Rectangles that Mesa draws as two triangles, clipped to the window into polygons, those into triangles: of
/// the pixels whose centres lie on an edge between these it draws one twice or not at all now and then (one
/// image in 1,000).
class Quads {
  public:
    void add(double x0, double y0, double x1, double y1);
    /// Of any polygon: which side has the pixels on it, is free as long as one has (GL 1.3, 3.5.1).
    void add_edge(double x0, double y0, double x1, double y1);
    bool has_on_edge(int x, int y) const; ///< a pixel

  private:
    struct Point {
        double x, y;
    };
    struct Segment {
        Point from, to;
    };
    std::vector<Segment> inner_edges_;
    void add_triangle(Point a, Point b, Point c);
};

struct Family {
    const char* id;
    int drawings;
    int tolerance;    ///< largest difference of a channel, 255ths
    double identical; ///< share of the pixels that must be the same to the bit
    void (*draw)(test::Random&, Quads&);
    int samples = 0;                 ///< of a pixel
    const char* driver = "softpipe"; ///< of Mesa
};
/// For GoogleTest.
inline void PrintTo(const Family& family, std::ostream* out) {
    *out << family.id;
}
const std::vector<Family>& all_families();

struct Drawn {
    Planes planes;
    Quads quads;
};
constexpr std::uint32_t seed_of(int drawing) {
    return static_cast<std::uint32_t>(drawing) * 7919u + 17u;
}
/// Drawing `n` of a family, from a state of its own that is left as it was; the current drawable has the size
/// above. `resolve` makes of samples what can be read, where GL does not.
Drawn draw_state(const Family& family, int n, void (*resolve)() = nullptr);

} // namespace spangle::oracle
