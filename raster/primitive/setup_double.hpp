// Set-up of the reference policy: plane equations in double, perspective-correct throughout (GL 1.3,
// equations 3.4 and 3.6). Depth is affine. It is compiled on hosts only.
#pragma once

#include "raster/primitive/setup.hpp"
#include "raster/reference/policy_double.hpp"

namespace spangle::raster {

template <> class Setup<Double> {
  public:
    using Vertex = DoubleVertex;

    Setup(Span<Double>& span, const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& provoking,
          std::int64_t area2);
    Setup(Span<Double>& span, const Vertex& a, const Vertex& b, const Vertex& provoking, bool along_x,
          std::int32_t begin, std::int32_t end);
    Setup(Span<Double>& span, const Vertex& v);

  private:
    /// How attributes vary through three positions, or along an axis.
    struct Plane {
        double origin_x, origin_y; ///< position of reference vertex 0, in pixels
        double x1, y1, x2, y2;     ///< d/dx = d1 x1 + d2 x2, d/dy = d1 y1 + d2 y2
    };
    static Plane plane_through(double ax, double ay, double bx, double by, double cx, double cy);
    /// Adds the gradients of an attribute with these values at the three reference vertices.
    void add(const Plane& plane, Interpolant<double>& at, double v0, double v1, double v2,
             double* dy = nullptr);
    void attributes(const Vertex& provoking);

    Span<Double>& span_;
    const Vertex* v_[3];
    Plane snapped_, exact_; ///< snapped_ is for depth, exact_ for all other attributes
};

} // namespace spangle::raster
