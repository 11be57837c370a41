// Tests surfaces in the panels' own formats. Drawing on them gives what a surface of eight bits a component
// becomes on the wire. Every panel that takes the format shows the surface, in each orientation in which
// bytes can lie as in the panel's memory.
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/boards/boards.hpp>
#include <spangle/native.hpp>
#include <spangle/panels.hpp>
#include <spangle/raster.hpp>
#include <spangle/sim/board.hpp>

#include "tests/support/scene_player.hpp"

namespace {

using namespace spangle;
using hal::WireFormat;

struct Native {
    PixelFormat format;
    hal::Wire wire;
    const char* name;
};
constexpr Native natives[] = {{PixelFormat::rgb666, hal::wires::rgb666, "666"},
                              {PixelFormat::rgb444, hal::wires::rgb444, "444"},
                              {PixelFormat::rgb332, hal::wires::rgb332, "332"},
                              {PixelFormat::grey4, hal::wires::grey4, "grey4"},
                              {PixelFormat::mono, hal::wires::mono, "mono"}};

constexpr int width = 64, height = 48;

/// Makes a surface with the top row first, without gaps.
raster::Surface surface_of(PixelFormat format, std::vector<std::uint8_t>& bytes) {
    const std::int32_t stride = row_bytes(format, width), rows = stored_rows(format, height);
    bytes.assign(static_cast<std::size_t>(stride * rows), 0);
    raster::Surface s;
    s.color = bytes.data() + (rows - 1) * stride;
    s.color_stride = -stride;
    s.width = width;
    s.height = height;
    s.format = format;
    return s;
}

std::vector<std::uint8_t> on_the_wire(const hal::Wire& wire, const std::vector<std::uint8_t>& rgb) {
    std::vector<std::uint8_t> bytes(rgb.size() + 64);
    bytes.resize(wire.convert({rgb.data(), width * 3, height, PixelFormat::rgb888, false},
                              {0, 0, width, height}, bytes.data()));
    return bytes;
}

/// Draws triangles, lines and points of one colour or many, textured and fogged, in every tier. Nothing reads
/// stored colours, of which the narrow surface keeps fewer bits.
TEST(NativeSurfaces, ShowWhatAPresentWouldMakeOfEightBits) {
    std::vector<std::uint8_t> texels(16 * 16 * 3);
    std::mt19937 random(11);
    for (auto& t : texels)
        t = static_cast<std::uint8_t>(random());
    for (const Native& native : natives) {
        if (native.format == PixelFormat::rgb666)
            continue; // dithered from the whole colour, see fixed_reference.cpp
        for (int trial = 0; trial < 120; ++trial) {
            std::vector<std::uint8_t> narrow, wide;
            const raster::Surface a = surface_of(native.format, narrow),
                                  b = surface_of(PixelFormat::rgb888, wide);
            raster::FragmentState state = raster::whole(a);
            state.tier = static_cast<raster::Tier>(trial % 3);
            state.scissor = {trial % 7, trial % 5, width - trial % 11, height - trial % 9};
            state.flat = trial % 4 == 0;
            raster::Texture texture;
            texture.level[0] = {texels.data(), 16, 16, 48};
            texture.level_count = 1;
            texture.format = raster::TexelFormat::rgb888;
            texture.base = raster::BaseFormat::rgb;
            texture.mag = texture.min = trial % 2 == 0 ? raster::Filter::nearest : raster::Filter::linear;
            if (trial % 5 == 0)
                state.unit[0].texture = &texture;
            raster::FragmentState plain = state;
            plain.dither = false;
            plain.tier = raster::Tier::exact; // narrow surfaces are drawn like this in every tier
            const raster::Rasterizer on_narrow(state, a), on_wide(plain, b);
            for (int n = 0; n < 6; ++n) {
                raster::FixedVertex v[3];
                for (auto& p : v) {
                    p = raster::at(static_cast<int>(random() % (width + 20)) - 10,
                                   static_cast<int>(random() % (height + 20)) - 10);
                    p.x += static_cast<std::int32_t>(random() % 256);
                    for (auto& c : p.color)
                        c = random() % (raster::color_one + 1);
                    p.tex[0].s = static_cast<std::int32_t>(random() % (1u << 29));
                    p.tex[0].t = static_cast<std::int32_t>(random() % (1u << 29));
                }
                if (trial % 3 == 1)
                    for (auto& p : v)
                        std::copy(v[0].color, v[0].color + 4, p.color);
                for (const raster::Rasterizer* r : {&on_narrow, &on_wide}) {
                    r->triangle(v[0], v[1], v[2]);
                    r->line(v[0], v[1], 1 + n % 3);
                    r->point(v[2], 1 + n);
                }
            }
            ASSERT_EQ(narrow, on_the_wire(native.wire, wide)) << native.name << ", trial " << trial;
        }
    }
}

struct Case {
    const hal::PanelDesc* panel;
    Native native;
    hal::BusKind bus;
};

std::vector<Case> cases() {
    std::vector<Case> out;
    for (const hal::PanelDesc* panel : hal::panels::all)
        for (const Native& native : natives)
            for (const auto bus : {panel->serial_bus, hal::BusKind::i8080, hal::BusKind::i2c})
                if (hal::format_code(*panel, bus, native.wire.format).taken) {
                    out.push_back({panel, native, bus});
                    break;
                }
    return out;
}

hal::Board board_of(const Case& c, hal::Orientation o) {
    hal::Board board{.name = c.panel->name,
                     .display = {.panel = c.panel, .orientation = o, .format = c.native.format},
                     .bus = c.bus};
    board.write_hz = c.bus == hal::BusKind::i2c     ? std::min(c.panel->timing.i2c_hz, 400000u)
                     : c.bus == hal::BusKind::i8080 ? 1000000000u / c.panel->timing.parallel_write_ns
                                                    : c.panel->timing.practical_serial_mhz * 1000000u;
    return board;
}

/// Returns how many pixels share a byte.
int sharing(PixelFormat format) {
    return format == PixelFormat::mono                                     ? 8
           : format == PixelFormat::grey4 || format == PixelFormat::rgb444 ? 2
                                                                           : 1;
}

std::string name_of(const Case& c) {
    std::string name = std::string(c.panel->name) + "_" + c.native.name;
    for (char& letter : name)
        letter = std::isalnum(static_cast<unsigned char>(letter)) ? letter : '_';
    return name;
}
/// GoogleTest prints cases with this function.
void PrintTo(const Case& c, std::ostream* out) {
    *out << name_of(c);
}

class NativePanels : public testing::TestWithParam<Case> {};

/// Presents three frames, the last two as damage. What GL reads back is what the glass shows.
TEST_P(NativePanels, ShowTheSurface) {
    const Case& c = GetParam();
    const FormatInfo info = format_info(c.native.format);
    const int bits[3] = {info.red_bits, info.green_bits, info.blue_bits};
    int shown = 0;
    for (const hal::Orientation o : hal::orientations)
        for (const std::uint8_t buffers : {std::uint8_t{1}, std::uint8_t{2}}) {
            hal::Board board = board_of(c, o);
            board.display.buffers = buffers;
            const hal::Placement placed = hal::place(*c.panel, o);
            const bool turned = (placed.madctl & hal::dcs::MV) != 0;
            const bool lies = c.native.format == PixelFormat::rgb444
                                  ? placed.size.width % 2 == 0
                                  : !turned || sharing(c.native.format) == 1;
            if (!lies) {
                EXPECT_STREQ(hal::flaw(board),
                             "display: pixels that share bytes lie otherwise in the panel's "
                             "memory; give it a wire");
                sim::SimBoard refused(board);
                EXPECT_EQ(refused.display().init().error().fault, hal::Fault::unsupported);
                continue;
            }
            if (c.panel->glass.width > 200 && ++shown > 2)
                continue; // large panels take a long time
            ASSERT_EQ(hal::flaw(board), nullptr);
            sim::SimBoard sim(board);
            const hal::DisplayInfo size = sim.display().info();
            EXPECT_EQ(size.format, c.native.format);
            std::vector<std::uint8_t> rgb(static_cast<std::size_t>(size.width * size.height * 3));
            ASSERT_TRUE(test::play(sim.display(), *scenes::find(shown % 2 == 0 ? "HUD" : "S6"), 3, [&] {
                glPixelStorei(GL_PACK_ALIGNMENT, 1);
                glReadPixels(0, 0, size.width, size.height, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
            }));
            ASSERT_TRUE(sim.display().finish().ok());
            EXPECT_EQ(sim.violations_text(), "");
            const sim::Image glass = sim.scan_out();
            unsigned lit = 0;
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    for (int i = 0; i < 3; ++i) {
                        const unsigned drawn =
                            rgb[static_cast<std::size_t>(((size.height - 1 - y) * size.width + x) * 3 + i)];
                        lit += drawn;
                        ASSERT_EQ(static_cast<unsigned>(glass.at(x, y)[i]) >> (8 - bits[i]),
                                  drawn >> (8 - bits[i]))
                            << x << ',' << y << " of rotation " << int(o.rotation);
                    }
            EXPECT_GT(lit, 0u);
        }
}

INSTANTIATE_TEST_SUITE_P(All, NativePanels, testing::ValuesIn(cases()),
                         [](const auto& test) { return name_of(test.param); });

TEST(NativeSurfaces, TheRowHashServesRowsAndRefusesPages) {
    hal::Board grey = boards::ssd1327_spi;
    grey.display.format = PixelFormat::grey4;
    grey.display.wire = {};
    std::uint64_t bytes[2];
    sim::Image seen[2];
    for (const bool hashed : {false, true}) {
        grey.display.row_hash = hashed;
        sim::SimBoard sim(grey);
        ASSERT_TRUE(test::play(sim.display(), *scenes::find("HUD"), 6));
        EXPECT_EQ(sim.violations_text(), "");
        bytes[hashed] = sim.counters().bytes;
        seen[hashed] = sim.glass();
    }
    EXPECT_EQ(seen[0], seen[1]);
    EXPECT_LT(bytes[1], bytes[0]);
    hal::Board mono = boards::ssd1306_spi;
    mono.display.format = PixelFormat::mono;
    mono.display.wire = {};
    EXPECT_EQ(hal::flaw(mono), nullptr);
    mono.display.row_hash = true;
    EXPECT_STREQ(hal::flaw(mono), "display: the row hash serves rows, not pages");
    EXPECT_FALSE(sim::SimBoard(mono).display().init().ok());
}

TEST(NativeSurfaces, ConfigsTellTheirBits) {
    hal::Board board = boards::ssd1306_spi;
    board.display.format = PixelFormat::mono;
    board.display.wire = {};
    sim::SimBoard sim(board);
    const EGLDisplay egl = eglGetDisplay(native(sim.display()));
    ASSERT_TRUE(eglInitialize(egl, nullptr, nullptr));
    const EGLint wish[] = {EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0, red = 0, size = 0;
    ASSERT_TRUE(eglChooseConfig(egl, wish, &config, 1, &count));
    ASSERT_EQ(count, 1);
    eglGetConfigAttrib(egl, config, EGL_RED_SIZE, &red);
    eglGetConfigAttrib(egl, config, EGL_BUFFER_SIZE, &size);
    EXPECT_EQ(red, 1);
    EXPECT_EQ(size, 1);
    // Makes a pbuffer whose height is not a multiple of a page.
    const EGLint box[] = {EGL_WIDTH, 21, EGL_HEIGHT, 13, EGL_NONE};
    const EGLSurface buffer = eglCreatePbufferSurface(egl, config, box);
    const EGLContext context = eglCreateContext(egl, config, EGL_NO_CONTEXT, nullptr);
    ASSERT_TRUE(eglMakeCurrent(egl, buffer, buffer, context));
    glClearColor(1, 1, 1, 1);
    glEnable(GL_SCISSOR_TEST);
    glScissor(3, 2, 5, 10);
    glClear(GL_COLOR_BUFFER_BIT);
    std::vector<std::uint8_t> seen(21 * 13);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, 21, 13, GL_GREEN, GL_UNSIGNED_BYTE, seen.data());
    for (int y = 0; y < 13; ++y)
        for (int x = 0; x < 21; ++x)
            ASSERT_EQ(seen[static_cast<std::size_t>(y * 21 + x)],
                      x >= 3 && x < 8 && y >= 2 && y < 12 ? 255 : 0);
    eglMakeCurrent(egl, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglTerminate(egl);
}

/// Overlapping copies with zoom read from a copy of the plane, whatever pixels share a byte.
TEST(NativeSurfaces, PixelsAreCopiedOverThemselves) {
    sim::SimBoard sim(boards::ssd1306_spi);
    const EGLDisplay egl = eglGetDisplay(native(sim.display()));
    ASSERT_TRUE(eglInitialize(egl, nullptr, nullptr));
    for (const Native& one : natives) {
        const EGLint wish[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                               EGL_NONE};
        EGLConfig configs[200];
        EGLint count = 0;
        ASSERT_TRUE(eglChooseConfig(egl, wish, configs, 200, &count));
        EGLConfig config = nullptr;
        for (EGLint i = count - 1; i >= 0; --i) {
            EGLint visual = 0;
            eglGetConfigAttrib(egl, configs[i], EGL_NATIVE_VISUAL_ID, &visual);
            if ((visual & 0xFF) == static_cast<EGLint>(one.format))
                config = configs[i];
        }
        ASSERT_NE(config, nullptr);
        const EGLint box[] = {EGL_WIDTH, 21, EGL_HEIGHT, 19, EGL_NONE};
        const EGLSurface buffer = eglCreatePbufferSurface(egl, config, box);
        const EGLContext context = eglCreateContext(egl, config, EGL_NO_CONTEXT, nullptr);
        ASSERT_TRUE(eglMakeCurrent(egl, buffer, buffer, context));
        glDisable(GL_DITHER);
        glClear(GL_COLOR_BUFFER_BIT);
        glEnable(GL_SCISSOR_TEST);
        glClearColor(1, 1, 1, 1);
        for (int i = 0; i < 6; ++i) { // draws a diagonal
            glScissor(i, i, 1, 1);
            glClear(GL_COLOR_BUFFER_BIT);
        }
        glDisable(GL_SCISSOR_TEST);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glOrtho(0, 21, 0, 19, -1, 1);
        glRasterPos2i(1, 2);
        glPixelZoom(2, 3);
        glCopyPixels(0, 0, 6, 5, GL_COLOR);
        std::vector<std::uint8_t> seen(21 * 19);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, 21, 19, GL_GREEN, GL_UNSIGNED_BYTE, seen.data());
        for (int y = 0; y < 19; ++y)
            for (int x = 0; x < 21; ++x) {
                const bool copied = x >= 1 && x < 13 && y >= 2 && y < 17;
                const bool lit = copied ? (x - 1) / 2 == (y - 2) / 3 : x == y && x < 6;
                ASSERT_EQ(seen[static_cast<std::size_t>(y * 21 + x)], lit ? 255 : 0)
                    << one.name << ' ' << x << ',' << y;
            }
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        eglMakeCurrent(egl, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(egl, context);
        eglDestroySurface(egl, buffer);
    }
    eglTerminate(egl);
}

} // namespace
