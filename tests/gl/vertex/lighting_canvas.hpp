// Draws lit vertices, and compares them with the equation of the specification.
#pragma once

#include <cmath>

#include "raster/surface/units.hpp"
#include "tests/gl/vertex/canvas.hpp"
#include "tests/gl/vertex/lighting_equation.hpp"
#include "tests/gl/vertex/window_recorder.hpp"

namespace spangle::test {

inline constexpr double units = raster::color_one;

class Lighting : public Canvas {
  protected:
    void SetUp() override {
        Canvas::SetUp();
        glEnable(GL_LIGHTING);
        glMatrixMode(GL_PROJECTION);
        glOrtho(-200, 200, -200, 200, -200, 200);
        glMatrixMode(GL_MODELVIEW);
    }

    static raster::FixedVertex lit_point(const LitVertex& v) {
        specify(v);
        WindowRecorder recorder;
        glNormal3fv(floats(v.normal).data());
        glBegin(GL_POINTS);
        glVertex4fv(floats(v.position).data());
        glEnd();
        EXPECT_EQ(recorder.primitives.size(), 1u);
        return recorder.primitives.empty() ? raster::FixedVertex{} : recorder.primitives[0].corner[0];
    }

    /// Returns the largest difference of a component, in 255ths.
    static double difference(const raster::FixedVertex& v, const LitColor& expected) {
        double worst = 0;
        for (std::size_t c = 0; c < 4; ++c)
            worst = std::fmax(worst, std::fabs(v.color[c] / units - expected.primary[c]));
        for (std::size_t c = 0; c < 3; ++c)
            worst = std::fmax(worst, std::fabs(v.secondary[c] / units - expected.secondary[c]));
        return worst * 255;
    }

    static Vec3 red_of(const raster::FixedVertex& v) {
        return {v.color[0] / units, v.color[1] / units, v.color[2] / units};
    }
};

inline Mat4 translation(double x, double y, double z) {
    return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1};
}
inline Mat4 scaling(double x, double y, double z) {
    return {x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1};
}
/// A quarter turn about x: y becomes z, and z becomes -y.
inline Mat4 quarter_about_x() {
    return {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1};
}

/// Leaves only the diffuse colour of this light, on a white diffuse material.
inline void only_diffuse(LitVertex& v) {
    v.scene_ambient = {0, 0, 0, 1};
    v.material[0].diffuse = {1, 1, 1, 1};
}

} // namespace spangle::test
