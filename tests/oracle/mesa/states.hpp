// Drawings in random states, the same from Mesa and from Spangle. Each chapter of GL has families of them.
#pragma once

#include <ostream>
#include <vector>

#include "tests/support/random.hpp"

namespace spangle::oracle {

inline constexpr int state_size = 24; ///< width and height in pixels

/// The result of one drawing, rows from below: RGBA, stencil and depth (255ths).
inline constexpr int pixel_channels = 6;
using Planes = std::vector<unsigned char>;

/// Mesa draws a rectangle as two triangles, and clips these to the window. A pixel whose centre lies on an
/// edge between the parts is sometimes drawn twice or not at all (in one image of 1,000). These pixels are
/// noted here.
class Quads {
  public:
    void add(double x0, double y0, double x1, double y1);
    /// Notes an edge of any polygon. Either side may have the pixels on the edge, as long as one has (GL 1.3,
    /// 3.5.1).
    void add_edge(double x0, double y0, double x1, double y1);
    bool has_on_edge(int x, int y) const; ///< whether the centre of pixel (x, y) lies on a noted edge

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
    int tolerance;    ///< largest difference of a channel, in 255ths
    double identical; ///< share of the pixels that must be the same to the bit
    void (*draw)(test::Random&, Quads&);
    int samples = 0;                 ///< samples of a pixel
    const char* driver = "softpipe"; ///< Mesa's driver
};
/// GoogleTest prints families with this function.
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
/// Draws drawing `n` of a family; state is as before afterwards. The current drawable must have the size
/// above. `resolve` makes samples readable if GL does not do so itself.
Drawn draw_state(const Family& family, int n, void (*resolve)() = nullptr);

} // namespace spangle::oracle
