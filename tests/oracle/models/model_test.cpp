// Reads models as their makers left them: with impossible materials, textures named on another machine,
// colours in vertices, and sizes that ask for all memory.
#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <new>
#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "host_sim/cli/confined.hpp"
#include "host_sim/cli/model.hpp"
#include "host_sim/cli/session.hpp"
#include "tests/source_dir.hpp"

namespace {

namespace fs = std::filesystem;
using namespace spangle;
using cli::Model;
using cli::ModelResult;

class Models : public testing::Test {
  protected:
    fs::path folder = fs::path(testing::TempDir()) / ("models-" + std::to_string(getpid()));

    void SetUp() override { fs::create_directories(folder / "Textures"); }
    void TearDown() override { fs::remove_all(folder); }

    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name, std::ios::binary) << text;
        return (folder / name).string();
    }
    /// Reads a square with this material that faces the eye.
    ModelResult square(const std::string& material) const {
        write("m.mtl", "newmtl m\n" + material);
        return cli::load_model(write("square.obj", "mtllib m.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
                                                   "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl m\n"
                                                   "f 1/1 2/2 3/3 4/4\n"));
    }
};

sim::Image draw(const Model& model) {
    cli::Session session;
    EXPECT_EQ(session.open_picture(32, 32, cli::Precision::exact), "");
    cli::setup_model(model, 32, 32);
    cli::draw_model(model, 0);
    return session.read();
}

TEST_F(Models, FitTheUnitSphere) {
    const ModelResult r =
        cli::load_model(write("far.obj", "v 1000 0 0\nv 3000 0 0\nv 1000 2000 0\nf 1 2 3\n"));
    ASSERT_EQ(r.error, "");
    EXPECT_EQ(r.model.triangles, 1u);
    for (const cli::ModelVertex& v : r.model.parts.at(0).vertices)
        EXPECT_NEAR(v.position[0] * v.position[0] + v.position[1] * v.position[1], 1.0f, 1e-5f);
}

TEST_F(Models, MaterialsThatCannotBeMeant) {
    ModelResult r = square("Kd 1 0 0\nKs 1 1 1\nNs 0\nd 0\n");
    ASSERT_EQ(r.error, "");
    EXPECT_EQ(r.model.parts.at(0).specular[0], 0.0f) << "an exponent of 0 lights everything";
    EXPECT_EQ(r.model.parts.at(0).diffuse[3], 1.0f) << "written for opaque";
    r = square("Kd 1 0 0\nKs 1 1 1\nNs 30\nd 0.5\n");
    EXPECT_GT(r.model.parts.at(0).specular[0], 0.0f);
    EXPECT_EQ(r.model.parts.at(0).diffuse[3], 0.5f);
}

TEST_F(Models, TexturesWhateverTheCaseAndTheSlashes) {
    const fs::path source = fs::path(SPANGLE_SOURCE_DIR) / "docs/pictures/duck.png";
    fs::copy_file(source, folder / "Textures/Skin.png");
    for (const char* name :
         {"Textures/Skin.png", "textures\\SKIN.PNG", "C:\\work\\skin.png", "/TEXTURES/skin.png"}) {
        const ModelResult r = square(std::string("Kd 1 1 1\nmap_Kd ") + name + "\n");
        ASSERT_EQ(r.error, "") << name;
        EXPECT_EQ(r.model.images.size(), 1u) << name;
        EXPECT_TRUE(r.model.notes.empty()) << name;
    }
    const ModelResult missing = square("map_Kd nowhere.png\n");
    EXPECT_EQ(missing.model.images.size(), 0u);
    EXPECT_EQ(missing.model.notes.size(), 1u);
    EXPECT_EQ(missing.model.parts.at(0).image, -1);
}

TEST_F(Models, ColorsOfVertices) {
    const auto ply = [](const char* colors) {
        std::string text =
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
            "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
            "property list uchar int vertex_indices\nend_header\n";
        for (const char* corner : {"-1 -1 0 ", "1 -1 0 ", "0 1 0 "})
            text += std::string(corner) + colors + "\n";
        return text + "3 0 1 2\n";
    };
    const ModelResult green = cli::load_model(write("green.ply", ply("0 255 0")));
    ASSERT_EQ(green.error, "");
    EXPECT_TRUE(green.model.parts.at(0).colored);
    const sim::Image picture = draw(green.model);
    const std::uint8_t* const middle = picture.at(16, 16);
    EXPECT_GT(middle[1], 40);
    EXPECT_EQ(middle[0], 0);
    EXPECT_EQ(middle[2], 0);
    const ModelResult black = cli::load_model(write("black.ply", ply("0 0 0")));
    EXPECT_FALSE(black.model.parts.at(0).colored) << "an empty layer, never shown";
    EXPECT_GT(draw(black.model).at(16, 16)[0], 40);
}

TEST_F(Models, EdgesOfACubeStaySharp) {
    const ModelResult r = cli::load_model(
        write("cube.obj",
              "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 1 4 3 2\nf 5 6 7 8\n"
              "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"));
    ASSERT_EQ(r.error, "");
    for (const cli::ModelVertex& v : r.model.parts.at(0).vertices) {
        const float largest = std::max({std::abs(v.normal[0]), std::abs(v.normal[1]), std::abs(v.normal[2])});
        EXPECT_NEAR(largest, 1.0f, 1e-5f);
    }
}

TEST_F(Models, BrokenOnesSayWhy) {
    EXPECT_NE(cli::load_model((folder / "none.obj").string()).error.find("no such file"), std::string::npos);
    EXPECT_NE(cli::load_model(write("point.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n")).error, "");
    EXPECT_NE(cli::load_model(write("noise.off", std::string("\0\1\2\377", 4))).error, "");
}

TEST_F(Models, AReaderThatWaitsForEverIsEnded) {
    ASSERT_EQ(mkfifo((folder / "pipe.mtl").c_str(), 0600), 0);
    cli::ReadLimits limits;
    limits.seconds = 1;
    const ModelResult r =
        cli::load_model(write("waits.obj", "mtllib pipe.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
                        cli::usual_texture_size, limits);
    EXPECT_NE(r.error.find("takes longer than 1 s"), std::string::npos) << r.error;
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "the reader is gone";
}

TEST_F(Models, AReaderHandsOverNoMoreThanItMay) {
    cli::ReadLimits limits;
    limits.handed_over = 100;
    const ModelResult r = cli::load_model(write("large.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
                                          cli::usual_texture_size, limits);
    EXPECT_NE(r.error.find("holds more than 0 MiB"), std::string::npos) << r.error;
}

TEST_F(Models, WhateverEndsAReaderIsASentence) {
    std::string answer;
    EXPECT_EQ(cli::run_confined([]() { return std::string(100000, 'x'); }, {}, answer), "");
    EXPECT_EQ(answer, std::string(100000, 'x'));
    EXPECT_EQ(cli::run_confined(
                  []() -> std::string {
                      raise(SIGKILL);
                      return "";
                  },
                  {}, answer),
              "crashes its reader (Killed)");
    EXPECT_EQ(cli::run_confined([]() -> std::string { throw 1; }, {}, answer),
              "crashes its reader (status 2)");
    EXPECT_EQ(cli::run_confined([]() -> std::string { throw std::bad_alloc(); }, {}, answer),
              "asks for more than 2 GiB of memory");
    EXPECT_EQ(cli::run_confined([]() -> std::string { _exit(0); }, {}, answer), "");
    EXPECT_EQ(answer, "");
    const std::string made = (folder / "made").string();
    EXPECT_NE(cli::run_confined(
                  [&made]() -> std::string {
                      std::ofstream(made) << "a reader's file" << std::flush;
                      return "";
                  },
                  {}, answer),
              "")
        << "it may not write files";
    EXPECT_TRUE(!fs::exists(made) || fs::file_size(made) == 0);
}

TEST_F(Models, TextOfFilesIsOneLine) {
    EXPECT_EQ(cli::one_line("a\nb\x1b[2J\x7f"), "a b [2J ");
    EXPECT_EQ(cli::one_line(std::string(1000, 'x')).size(), 403u);
    const ModelResult r = square("map_Kd \x1b[2Jnowhere.png\n");
    ASSERT_EQ(r.model.notes.size(), 1u);
    for (const char c : r.model.notes[0])
        EXPECT_GE(c, 32);
}

TEST_F(Models, NumbersThatAreNoneAreZero) {
    const ModelResult r = square("Kd nan inf -1\nKs nan 1 1\nNs inf\nd nan\n");
    ASSERT_EQ(r.error, "");
    for (const float c : r.model.parts.at(0).diffuse)
        EXPECT_TRUE(std::isfinite(c));
    EXPECT_LE(r.model.parts.at(0).shininess, 128.0f);
}

// AddressSanitizer's own memory exceeds every limit, so sanitized builds have none.
#if defined(__SANITIZE_ADDRESS__)
#define SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SANITIZED
#endif
#endif
#ifndef SANITIZED
TEST_F(Models, AFewBytesCannotTakeAllMemory) {
    const ModelResult r = cli::load_model(write("huge.off", "OFF\n353535235358 6 0\n-0.5 -0.5 0.5\n"));
    EXPECT_NE(r.error.find("2 GiB"), std::string::npos) << r.error;
    EXPECT_EQ(cli::load_model(write("next.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")).error, "")
        << "the limit is lifted";
}
#endif

} // namespace
