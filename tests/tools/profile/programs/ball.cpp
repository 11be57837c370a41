#include "tests/tools/profile/programs/program.hpp"

namespace spangle::programs {

namespace {

/// Sines of multiples of 15 degrees; sine() continues them from 0 to 24 steps.
constexpr float quarter[7] = {0.0f, 0.258819f, 0.5f, 0.707107f, 0.866025f, 0.965926f, 1.0f};
constexpr float sine(int step) {
    step = (step % 24 + 24) % 24;
    return step <= 6 ? quarter[step] : step <= 12 ? quarter[12 - step] : -sine(step - 12);
}
constexpr float cosine(int step) {
    return sine(step + 6);
}

} // namespace

void ball() {
    for (int row = 0; row < 12; ++row) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int column = 0; column <= 24; ++column)
            for (int side = 1; side >= 0; --side) {
                const int across = row + side;
                const float x = sine(across) * cosine(column), y = cosine(across),
                            z = sine(across) * sine(column);
                glNormal3f(x, y, z);
                glVertex3f(x, y, z);
            }
        glEnd();
    }
}

} // namespace spangle::programs
