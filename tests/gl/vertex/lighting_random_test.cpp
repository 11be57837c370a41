// Rows C04, C06: compares the whole equation in random scenes, and on stretched objects.
#include <cstdio>
#include <random>

#include "tests/gl/vertex/lighting_canvas.hpp"

namespace spangle::test {
namespace {

/// All terms are on at once. Where the equation jumps (the edge of a cone, the terminator of a highlight)
/// rounding may go to either side, so within 2^-20 of it nothing is compared.
TEST_F(Lighting, RandomScenes) {
    std::mt19937 random(3);
    const auto real = [&random](double low, double high) {
        return static_cast<double>(static_cast<float>(std::uniform_real_distribution<>(low, high)(random)));
    };
    const auto flip = [&random] { return (random() & 1) != 0; };
    const auto color = [&] { return Vec4{real(0, 1), real(0, 1), real(0, 1), real(0, 1)}; };
    const auto direction = [&] { return Vec3{real(-1, 1), real(-1, 1), real(-1, 1)}; };
    const auto turned = [&](double scale) {
        // Orthonormal axes by Gram and Schmidt, then scaled differently. They are floats, because GL keeps
        // more bits of a matrix than a float has.
        const Vec3 x = unit(direction()), d = direction();
        const Vec3 y = unit(sum(d, scaled(x, -dot(x, d))));
        const Vec3 z{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
        Mat4 m = identity();
        for (std::size_t i = 0; i < 3; ++i) {
            m[i] = static_cast<float>(x[i] * scale);
            m[4 + i] = static_cast<float>(y[i] * scale);
            m[8 + i] = static_cast<float>(z[i] * scale);
            m[12 + i] = real(-20, 20);
        }
        return m;
    };
    double worst = 0, total = 0;
    int compared = 0;
    for (int n = 0; n < 40000; ++n) {
        LitVertex v;
        const int lights = 1 + static_cast<int>(random() % 8);
        const double share = 1.0 / lights;
        for (int i = 0; i < lights; ++i) {
            LightSource& l = v.light[random() % 8];
            l.on = true;
            l.ambient = color(), l.diffuse = color(), l.specular = color();
            for (Vec4* part : {&l.ambient, &l.diffuse, &l.specular})
                for (double& c : *part)
                    c = static_cast<float>(c * share);
            l.position = {real(-30, 30), real(-30, 30), real(-30, 30), flip() ? 0 : real(0.5, 2)};
            l.spot_direction = direction();
            if (flip()) {
                l.spot_cutoff = real(20, 90);
                l.spot_exponent = flip() ? 0 : real(0, 128);
            }
            if (flip())
                l.constant = real(0.5, 2), l.linear = real(0, 0.2), l.quadratic = real(0, 0.02);
        }
        SurfaceMaterial& m = v.material[0];
        m.ambient = color(), m.diffuse = color(), m.emission = color();
        if (flip())
            m.specular = color(), m.shininess = real(0, 128);
        v.scene_ambient = color();
        v.local_viewer = flip(), v.separate_specular = flip();
        const int normals = static_cast<int>(random() % 3);
        v.normalize = normals == 1, v.rescale = normals == 2;
        v.light_matrix = turned(1);
        v.modelview = turned(normals == 0 ? 1 : real(0.2, 4));
        const Vec3 normal = unit(direction());
        for (std::size_t c = 0; c < 3; ++c)
            v.normal[c] = static_cast<float>(normal[c] * (v.normalize ? 3 : 1));
        v.position = {real(-20, 20), real(-20, 20), real(-20, 20), 1};
        const LitColor expected = equation(v, 0);
        if (expected.margin < 1.0 / (1 << 20))
            continue;
        const double error = difference(lit_point(v), expected);
        ++compared;
        total += error;
        worst = std::fmax(worst, error);
    }
    std::printf("%d random scenes: worst component off by %.6f / 255, mean of the worst %.7f / 255\n",
                compared, worst, total / compared);
    EXPECT_GT(compared, 39000);
    EXPECT_LT(worst, 0.01);
}

/// The position of a light is x, y and z divided by w, also if w is tiny, huge or negative.
TEST_F(Lighting, AnyWOfALight) {
    std::mt19937 random(5);
    const auto real = [&random](double low, double high) {
        return static_cast<double>(static_cast<float>(std::uniform_real_distribution<>(low, high)(random)));
    };
    int lit = 0;
    for (int n = 0; n < 6000; ++n) {
        LitVertex v;
        only_diffuse(v);
        LightSource& l = v.light[0];
        l.on = true;
        l.diffuse = {1, 1, 1, 1};
        const double w = std::ldexp(real(0.5, 1), static_cast<int>(random() % 180) - 120);
        l.position = {real(-30, 30), real(-30, 30), real(-30, 30), n % 2 == 0 ? w : -w};
        if (n % 3 == 0)
            l.constant = real(0.5, 2),
            l.linear = std::ldexp(real(0.5, 1), static_cast<int>(random() % 100) - 60);
        const Vec3 normal = unit({real(-1, 1), real(-1, 1), real(-1, 1)});
        for (std::size_t c = 0; c < 3; ++c)
            v.normal[c] = static_cast<float>(normal[c]);
        v.position = {real(-20, 20), real(-20, 20), real(-20, 20), 1};
        const LitColor expected = equation(v, 0);
        if (expected.margin < 1.0 / (1 << 20))
            continue;
        lit += expected.primary[0] > 0.1 ? 1 : 0;
        ASSERT_LT(difference(lit_point(v), expected), 0.01)
            << "w " << l.position[3] << " linear " << l.linear;
    }
    EXPECT_GT(lit, 1000);
}

/// Lights reach every vertex alike, on objects that are stretched by up to 2^9 before and after they are
/// turned.
TEST_F(Lighting, StretchedObjects) {
    std::mt19937 random(5);
    const auto real = [&random](double low, double high) {
        return static_cast<double>(static_cast<float>(std::uniform_real_distribution<>(low, high)(random)));
    };
    const auto stretch = [&random] { return std::ldexp(1.0, static_cast<int>(random() % 10)); };
    const Mat4 turn = {2 / 3.0,  -2 / 3.0, 1 / 3.0, 0, 1 / 3.0, 2 / 3.0, 2 / 3.0, 0,
                       -2 / 3.0, -1 / 3.0, 2 / 3.0, 0, 0,       0,       0,       1};
    double worst = 0;
    for (int n = 0; n < 20000; ++n) {
        LitVertex v;
        only_diffuse(v);
        v.light[0].position = {real(-1, 1), real(-1, 1), real(-1, 1), 0};
        v.light[3] = v.light[0];
        v.light[3].position = {real(-1, 1), real(-1, 1), real(-1, 1), 0};
        const bool before = (n & 1) != 0, after = (n & 2) != 0;
        v.modelview = before ? times(turn, scaling(stretch(), stretch(), stretch())) : turn;
        if (after)
            v.modelview = times(scaling(stretch(), stretch(), stretch()), v.modelview);
        if ((n & 4) != 0)
            v.modelview = times(turn, v.modelview);
        for (double& e : v.modelview)
            e = static_cast<float>(e);
        v.normalize = true;
        for (double& c : v.normal)
            c = real(-1, 1) * stretch();
        if ((n & 8) != 0) { // gives normals that GL makes unit vectors
            const Mat4& m = v.modelview;
            const Vec3 eye = unit(v.normal);
            for (std::size_t c = 0; c < 3; ++c)
                v.normal[c] =
                    static_cast<float>(m[4 * c] * eye[0] + m[4 * c + 1] * eye[1] + m[4 * c + 2] * eye[2]);
        }
        worst = std::fmax(worst, difference(lit_point(v), equation(v, 0)));
    }
    std::printf("stretched objects: worst component off by %.6f / 255\n", worst);
    EXPECT_LT(worst, 0.001);
}

} // namespace
} // namespace spangle::test
