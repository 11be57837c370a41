// Compares every scene and probe in RGBA8888 with two rasterizers of Mesa. A pixel is good if its largest
// channel difference is within the tolerance of one oracle, or, at edges, of some pixel of the 3x3
// neighbourhood in both directions. A picture passes if bad pixels are at most 0.1 %, or three times those of
// the two oracles against each other.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <spangle/GL/gl.h>

#include "tests/oracle/mesa/probes.hpp"
#include "tests/support/headless_gl.hpp"

namespace {

constexpr int width = 256, height = 192, frame = 2;
using Picture = std::vector<unsigned char>; // RGBA, top row first

Picture draw_with_mesa(const char* scene, const char* driver) {
    const std::string file =
        testing::TempDir() + "mesa_" + scene + "_" + driver + std::to_string(getpid()) + ".pam";
    // Mesa's own leaks are not reported.
    const std::string command = std::string("ASAN_OPTIONS=detect_leaks=0 GALLIUM_DRIVER=") + driver +
                                " '" MESA_SCENE "' " + scene + " " + std::to_string(width) + " " +
                                std::to_string(height) + " " + std::to_string(frame) + " '" + file + "'";
    if (std::system(command.c_str()) != 0)
        return {};
    std::ifstream in(file, std::ios::binary);
    std::string line;
    while (std::getline(in, line) && line != "ENDHDR") {
    }
    Picture out(static_cast<std::size_t>(width) * height * 4);
    in.read(reinterpret_cast<char*>(out.data()), static_cast<std::streamsize>(out.size()));
    std::remove(file.c_str());
    return in ? out : Picture();
}

Picture draw_with_spangle(const spangle::scenes::Scene& scene) {
    const spangle::test::HeadlessGl current(width, height,
                                            {EGL_PRECISION_SPANGLE, EGL_PRECISION_EXACT_SPANGLE});
    glDisable(GL_DITHER);
    scene.setup(width, height);
    scene.draw(frame);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    Picture rows(static_cast<std::size_t>(width) * height * 4), out(rows.size());
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
    for (int y = 0; y < height; ++y)
        std::copy_n(&rows[static_cast<std::size_t>(height - 1 - y) * width * 4], width * 4,
                    &out[static_cast<std::size_t>(y) * width * 4]);
    return out;
}

int difference(const Picture& a, int ax, int ay, const Picture& b, int bx, int by) {
    int worst = 0;
    for (int c = 0; c < 3; ++c)
        worst = std::max(worst, std::abs(a[static_cast<std::size_t>((ay * width + ax) * 4 + c)] -
                                         b[static_cast<std::size_t>((by * width + bx) * 4 + c)]));
    return worst;
}

/// Returns whether some pixel of b around (x, y) is within the tolerance of a's pixel.
bool near(const Picture& a, const Picture& b, int x, int y, int tolerance) {
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            const int u = x + dx, v = y + dy;
            if (u >= 0 && u < width && v >= 0 && v < height && difference(a, x, y, b, u, v) <= tolerance)
                return true;
        }
    return false;
}

bool good(const Picture& ours, const Picture& oracle, int x, int y, int tolerance) {
    return difference(ours, x, y, oracle, x, y) <= tolerance ||
           (near(ours, oracle, x, y, tolerance) && near(oracle, ours, x, y, tolerance));
}

class Scenes : public testing::TestWithParam<std::string> {};

TEST_P(Scenes, LookLikeMesa) {
    const spangle::scenes::Scene& scene = *spangle::oracle::find_picture(GetParam().c_str());
    const std::string id = scene.id;
    const int tolerance = id == "S4b" ? 4 : 2;
    const Picture softpipe = draw_with_mesa(scene.id, "softpipe"),
                  llvmpipe = draw_with_mesa(scene.id, "llvmpipe");
    ASSERT_FALSE(softpipe.empty());
    ASSERT_FALSE(llvmpipe.empty());
    const Picture ours = draw_with_spangle(scene);
    int bad = 0, spread = 0, drawn = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            bad += good(ours, softpipe, x, y, tolerance) || good(ours, llvmpipe, x, y, tolerance) ? 0 : 1;
            spread += good(softpipe, llvmpipe, x, y, tolerance) ? 0 : 1;
            drawn += difference(ours, x, y, ours, 0, 0) > 8 ? 1 : 0;
        }
    std::printf("%s: %d bad pixels of %d, the oracles disagree on %d\n", scene.id, bad, width * height,
                spread);
    if (id != "S1" && id != "S2") {
        EXPECT_GT(drawn, width * height / 50) << "nothing to see";
    }
    EXPECT_LE(bad, std::max(width * height / 1000, 3 * spread));
}

std::vector<std::string> every_scene() {
    std::vector<std::string> list;
    for (const spangle::scenes::Scene& scene : spangle::scenes::all())
        list.push_back(scene.id);
    for (const spangle::scenes::Scene& probe : spangle::oracle::probes())
        list.push_back(probe.id);
    return list;
}

INSTANTIATE_TEST_SUITE_P(All, Scenes, testing::ValuesIn(every_scene()), [](const auto& info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

} // namespace
