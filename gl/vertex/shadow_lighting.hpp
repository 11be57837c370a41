// Lights each vertex twice, in fixed point and in double, and reports the difference. Only hosts have this
// policy.
#pragma once

#include "gl/vertex/double_lighting.hpp"
#include "gl/vertex/fixed_lighting.hpp"
#include "gl/vertex/shadow_math.hpp"

namespace spangle::gl {

class ShadowLighting {
  public:
    using Product = FixedLighting;
    using Input = FixedAndDouble<Product::Input, DoubleLighting::Input>;

    void derive(const Context& context, unsigned dirty) {
        fixed_.derive(context, dirty);
        twin_.derive(context, dirty);
    }
    void materials_changed() {
        fixed_.materials_changed();
        twin_.materials_changed();
    }
    /// True if a policy needs the position in eye space. The double policy needs it more often.
    bool needs_eye() const { return fixed_.needs_eye() || twin_.needs_eye(); }
    bool two_sided() const { return fixed_.two_sided(); }
    bool tracks_color() const { return fixed_.tracks_color(); }

    static Input input(const Real (&normal)[3]) {
        return {Product::input(normal), DoubleLighting::input(normal)};
    }
    void light(const Context& context, const Real (&normal)[3], const ShadowMath::Eye& eye, int side,
               raster::ShadowVertex& out) {
        light(context, input(normal), eye, side, out);
    }
    void light(const Context& context, const Input& vertex, const ShadowMath::Eye& eye, int side,
               raster::ShadowVertex& out) {
        fixed_.light(context, vertex.fixed, eye.fixed, side, out.fixed);
        twin_.light(context, vertex.twin, eye.twin, side, out.twin);
        ShadowMath::report_color(out);
    }
    static void mix(const Input& a, const Input& b, const ShadowMath::Parameter& t, Input& out) {
        Product::mix(a.fixed, b.fixed, t.fixed, out.fixed);
        DoubleLighting::mix(a.twin, b.twin, t.twin, out.twin);
    }

  private:
    Product fixed_;
    DoubleLighting twin_;
};

} // namespace spangle::gl
