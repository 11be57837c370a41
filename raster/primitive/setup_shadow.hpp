// Set-up of the shadow policy: it runs both set-ups. It is compiled on hosts only.
#pragma once

#include "raster/primitive/setup_double.hpp"
#include "raster/reference/shadow.hpp"

namespace spangle::raster {

template <> class Setup<Shadow> {
  public:
    using Vertex = ShadowVertex;

    Setup(Span<Shadow>& span, const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& provoking,
          std::int64_t area2)
        : fixed_(span, a.fixed, b.fixed, c.fixed, provoking.fixed, area2),
          twin_(with_state(span), a.twin, b.twin, c.twin, provoking.twin, area2) {}
    Setup(Span<Shadow>& span, const Vertex& a, const Vertex& b, const Vertex& provoking, bool along_x,
          std::int32_t begin, std::int32_t end)
        : fixed_(span, a.fixed, b.fixed, provoking.fixed, along_x, begin, end),
          twin_(with_state(span), a.twin, b.twin, provoking.twin, along_x, begin, end) {}
    Setup(Span<Shadow>& span, const Vertex& v) : fixed_(span, v.fixed), twin_(with_state(span), v.twin) {}

  private:
    static Span<Double>& with_state(Span<Shadow>& span) {
        span.twin.state = span.state;
        return span.twin;
    }
    Setup<Fixed> fixed_;
    Setup<Double> twin_;
};

} // namespace spangle::raster
