// Tests what is recorded of programs that use few systems, and the profile that is made of it.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gl/context/context.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "host_sim/profile/emit.hpp"
#include "host_sim/profile/record_text.hpp"
#include "host_sim/profile/recorder.hpp"
#include "tests/tools/bench/headless.hpp"
#include "tests/tools/bench/picture_hash.hpp"
#include "tests/tools/profile/programs/program.hpp"

#if SPANGLE_WATCHED

namespace spangle::profile {

namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr int width = 160, height = 120;

Record record(const programs::Program& program, EGLint precision = EGL_PRECISION_BALANCED_SPANGLE) {
    bench::Headless gl;
    EXPECT_TRUE(gl.open(width, height, precision));
    Record out;
    {
        Recorder recorder(*gl::current_context());
        program.setup(width, height);
        program.draw(1);
        out = recorder.finish();
    }
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    gl.close();
    return out;
}

std::uint32_t hash_of(const programs::Program& program, bool watched) {
    bench::Headless gl;
    EXPECT_TRUE(gl.open(width, height, EGL_PRECISION_BALANCED_SPANGLE));
    std::uint32_t hash = 0;
    const auto draw = [&] {
        program.setup(width, height);
        program.draw(1);
        hash = bench::picture_hash(width, height);
    };
    if (watched) {
        Recorder recorder(*gl::current_context());
        draw();
    } else {
        draw();
    }
    gl.close();
    return hash;
}

std::string limit(const Profile& profile, const char* name) {
    for (const auto& [limit, value] : profile.limits)
        if (limit == name)
            return value;
    return "as usual";
}

TEST(Recorder, ChangesNoPixel) {
    for (const programs::Program* program : programs::all)
        EXPECT_EQ(hash_of(*program, true), hash_of(*program, false)) << program->name;
}

TEST(Recorder, CountsCommandsAndPixels) {
    const Record cube = record(programs::gouraud_cube);
    EXPECT_EQ(cube.commands.at("glVertex"), 24u);
    EXPECT_EQ(cube.commands.at("glClear"), 1u);
    EXPECT_EQ(cube.commands.count("glFog"), 0u);
    for (const programs::Program* program : {&programs::sprites_only, &programs::cutaway, &programs::wires}) {
        bench::Headless gl;
        ASSERT_TRUE(gl.open(width, height, EGL_PRECISION_BALANCED_SPANGLE));
        raster::Counters counters;
        gl::observe(*gl::current_context(), &counters, false);
        {
            Recorder recorder(*gl::current_context());
            program->setup(width, height);
            program->draw(1);
            EXPECT_EQ(recorder.finish().pixels(), counters.fragments) << program->name;
            EXPECT_NE(counters.fragments, 0u);
        }
        gl::observe(*gl::current_context(), nullptr, false);
        gl.close();
    }
}

TEST(Recorder, NamesTheSystems) {
    EXPECT_TRUE(record(programs::gouraud_cube).features.empty());
    EXPECT_THAT(record(programs::terrain_fog).features, ElementsAre("FOG"));
    EXPECT_THAT(record(programs::cutaway).features, ElementsAre("CLIP_PLANES", "LIGHTING", "LISTS"));
    EXPECT_THAT(record(programs::wires).features, ElementsAre("BITMAPS", "RASTER_POS", "STIPPLE"));
    EXPECT_THAT(record(programs::foliage).features, ElementsAre("ATTRIB_STACKS"));
    EXPECT_THAT(record(programs::chrome).features, ElementsAre("LIGHTING", "TEXGEN"));
}

TEST(Recorder, ReachesLimits) {
    const Record chrome = record(programs::chrome);
    EXPECT_EQ(chrome.lights, 3) << "LIGHT2";
    EXPECT_EQ(chrome.light_kinds, 3u) << "a position and a specular material";
    EXPECT_TRUE(chrome.full_lighting) << "NORMALIZE";
    EXPECT_EQ(chrome.texture_levels, 7) << "64 texels";
    EXPECT_EQ(chrome.texture_formats, 1u << static_cast<unsigned>(raster::TexelFormat::l8));
    const Record cutaway = record(programs::cutaway);
    EXPECT_EQ(cutaway.modelview_stack, 3);
    EXPECT_EQ(cutaway.light_kinds, 4u) << "two sides";
    const Record two = record(programs::two_textures);
    EXPECT_EQ(two.texture_units, 2);
    EXPECT_EQ(two.texture_levels, 7);
    const Record lit = record(programs::lit_parallel);
    EXPECT_EQ(lit.light_kinds, 0u);
    EXPECT_FALSE(lit.full_lighting);
    EXPECT_EQ(lit.texture_units, 0);
    EXPECT_EQ(record(programs::wires).primitives, 2u) << "lines";
    EXPECT_EQ(record(programs::particles).primitives, 1u) << "points";
    EXPECT_EQ(record(programs::foliage).primitives, 4u) << "quads";
    EXPECT_EQ(lit.tiers, 2u);
}

TEST(Recorder, KeepsSwitchesThatAreOnlyTurnedOff) {
    const auto light_kinds = [](void (*setup)(int, int)) {
        return record(programs::Program{"off", setup, [](int) { glDisable(GL_LIGHT0); }});
    };
    const Record color = light_kinds([](int, int) { glDisable(GL_COLOR_MATERIAL); });
    EXPECT_EQ(color.light_kinds, light_follows_colors);
    EXPECT_TRUE(color.full_lighting);
    const Record normal = light_kinds([](int, int) { glDisable(GL_NORMALIZE); });
    EXPECT_EQ(normal.light_kinds, 0u);
    EXPECT_TRUE(normal.full_lighting);
    EXPECT_TRUE(light_kinds([](int, int) { glDisable(GL_RESCALE_NORMAL); }).full_lighting);
    const Record none = light_kinds([](int, int) { glDisable(GL_LIGHTING); });
    EXPECT_EQ(none.light_kinds, 0u);
    EXPECT_FALSE(none.full_lighting);
}

TEST(Recorder, MeasuresHowFarProgramsGo) {
    using gl::Range;
    const Record sprites = record(programs::sprites_only);
    EXPECT_EQ(sprites.reach(Range::SURFACE_WIDTH), unsigned{width});
    EXPECT_EQ(sprites.reach(Range::SURFACE_HEIGHT), unsigned{height});
    EXPECT_EQ(sprites.reach(Range::BAND_ROWS), unsigned{height});
    EXPECT_EQ(sprites.reach(Range::POSITION_BITS), 9u) << "312 is the largest coordinate";
    EXPECT_EQ(sprites.reach(Range::TEXTURE_BITS), 1u) << "1 is";
    EXPECT_EQ(sprites.reach(Range::PERSPECTIVE), 0u);
    EXPECT_EQ(sprites.reach(Range::LIST_VERTICES), 0u);
    EXPECT_EQ(record(programs::gouraud_cube).reach(Range::PERSPECTIVE), 1u);
    EXPECT_EQ(record(programs::gouraud_cube).reach(Range::CUTS), 0u);
    EXPECT_NE(record(programs::cutaway).reach(Range::LIST_VERTICES), 0u);
    EXPECT_EQ(record(programs::foliage).reach(Range::ATTRIB_STACK), 1u);
    EXPECT_GE(record(programs::wires).reach(Range::LINE_WIDTH), 1u);
    EXPECT_GE(record(programs::particles).reach(Range::POINT_SIZE), 1u);
    // The far plane clips the triangle, and a smaller point size comes after the larger one.
    constexpr programs::Program cut{"cut", [](int, int) {},
                                    [](int) {
                                        glPointSize(7.0f);
                                        glBegin(GL_POINTS);
                                        glEnd();
                                        glPointSize(2.0f);
                                        glBegin(GL_POINTS);
                                        glEnd();
                                        glBegin(GL_TRIANGLES);
                                        glVertex3f(-0.5f, -0.5f, 0.0f);
                                        glVertex3f(0.5f, -0.5f, 2.0f);
                                        glVertex3f(0.0f, 0.5f, 0.0f);
                                        glEnd();
                                    }};
    EXPECT_EQ(record(cut).reach(Range::CUTS), 1u);
    EXPECT_EQ(record(cut).reach(Range::POINT_SIZE), 7u);
    EXPECT_EQ(limit(make(record(cut), {"cut", "cut.inc", false, true}), "CLIPPING"), "as usual");
}

TEST(Profile, LeavesClippingOutWhereNothingNeedsIt) {
    const Choice usual{"it", "it.inc"}, choice{"it", "it.inc", false, true};
    const Record sprites = record(programs::sprites_only), lit = record(programs::lit_perspective);
    EXPECT_EQ(limit(make(sprites, choice), "CLIPPING"), "0");
    EXPECT_EQ(limit(make(sprites, choice), "PERSPECTIVE"), "0");
    EXPECT_EQ(limit(make(lit, choice), "CLIPPING"), "0");
    EXPECT_EQ(limit(make(lit, choice), "PERSPECTIVE"), "as usual");
    EXPECT_EQ(limit(make(record(programs::cutaway), choice), "CLIPPING"), "as usual")
        << "the user's plane cuts";
    EXPECT_EQ(limit(make(sprites, usual), "CLIPPING"), "as usual") << "nobody asked";
    EXPECT_THAT(settings(make(sprites, choice), sprites, choice),
                HasSubstr("\nset(SPANGLE_RANGES SURFACE_WIDTH=160 SURFACE_HEIGHT=120 "));
}

TEST(Profile, LeavesTheChainOutWhereEveryKeyHasALoop) {
    const Record lit = record(programs::lit_perspective);
    const Profile profile = make(lit, {"lit", "lit.inc"});
    EXPECT_FALSE(profile.chain);
    EXPECT_EQ(limit(profile, "CHAIN"), "0");
    EXPECT_THAT(fused_lines(profile), AllOf(HasSubstr("Kind::affine"), HasSubstr("Kind::full")));
    EXPECT_THAT(settings(profile, lit, {"lit", "lit.inc"}), HasSubstr("set(SPANGLE_FUSED lit.inc)\n"));
    // The fast tier divides colours in strong perspective only.
    const Profile fast =
        make(record(programs::lit_perspective, EGL_PRECISION_FAST_SPANGLE), {"lit", "lit.inc"});
    EXPECT_THAT(fused_lines(fast), Not(HasSubstr("Kind::full")));
}

TEST(Profile, KeepsTheChainWhereSomeKeyHasNone) {
    for (const programs::Program* program :
         {&programs::terrain_fog, &programs::particles, &programs::two_textures, &programs::foliage}) {
        const Profile profile = make(record(*program), {program->name, "list.inc"});
        EXPECT_TRUE(profile.chain) << program->name;
        EXPECT_TRUE(profile.fused.empty()) << program->name;
        EXPECT_EQ(limit(profile, "FUSED_SPANS"), "0") << program->name;
        EXPECT_EQ(limit(profile, "CHAIN"), "as usual") << program->name;
    }
}

TEST(Profile, TexelsOfOneByteAreTheChains) {
    raster::Key key;
    key.number = raster::Number::balanced;
    key.unit[0] = {
        true, false, raster::TexelFormat::rgb565, raster::BaseFormat::rgb, {}, raster::TexEnv::modulate};
    EXPECT_TRUE(is_fusible(key));
    key.unit[0].texels = raster::TexelFormat::a8;
    key.unit[0].base = raster::BaseFormat::alpha;
    EXPECT_FALSE(is_fusible(key));
}

TEST(Profile, DividedFilteredTexelsOfTheExactTierAreTheChains) {
    raster::Key key;
    key.number = raster::Number::exact;
    key.kind = raster::Kind::full;
    key.unit[0] = {true,
                   false,
                   raster::TexelFormat::rgb565,
                   raster::BaseFormat::rgb,
                   raster::Filter::linear,
                   raster::TexEnv::modulate};
    EXPECT_FALSE(is_fusible(key));
    key.kind = raster::Kind::affine;
    EXPECT_TRUE(is_fusible(key)) << "nothing divides";
    key.fog = true;
    key.fog_mode = raster::FogMode::linear;
    key.kind = raster::Kind::textured;
    EXPECT_FALSE(is_fusible(key));
    key.unit[0].filter = raster::Filter::nearest;
    EXPECT_TRUE(is_fusible(key)) << "one texel";
    key.unit[0].filter = raster::Filter::linear;
    key.number = raster::Number::balanced;
    EXPECT_TRUE(is_fusible(key)) << "of another tier";
    key.number = raster::Number::exact;
    key.unit[0] = {};
    EXPECT_TRUE(is_fusible(key)) << "without texture";
}

TEST(Profile, HoldsWhatTheBuildHasAndTheProgramAskedFor) {
    const Profile profile = make(record(programs::sprites_only), {"sprites", "sprites.inc"});
    EXPECT_THAT(profile.features, ElementsAre("FIXED_POINT")) << "free where nobody calls it";
    EXPECT_EQ(limit(profile, "TEXTURE_UNITS"), "1");
    EXPECT_EQ(limit(profile, "TEXTURE_LEVELS"), "5");
    EXPECT_EQ(limit(profile, "TEXTURE_FORMATS"), "rgba8888");
    EXPECT_EQ(limit(profile, "OPTIMIZE"), "as usual");
    Choice small{"sprites", "sprites.inc"};
    small.small = true;
    EXPECT_EQ(limit(make(record(programs::sprites_only), small), "OPTIMIZE"), "size");
}

/// Opens a context on a picture that has depth with stencil.
void open_with_stencils(bench::Headless& gl, EGLint red) {
    gl.display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    eglInitialize(gl.display, nullptr, nullptr);
    const EGLint wish[] = {EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_STENCIL_SIZE,
                           8,
                           EGL_RED_SIZE,
                           red,
                           EGL_PRECISION_SPANGLE,
                           EGL_PRECISION_BALANCED_SPANGLE,
                           EGL_NONE};
    constexpr EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    ASSERT_TRUE(eglChooseConfig(gl.display, wish, &config, 1, &count) != EGL_FALSE && count != 0);
    gl.surface = eglCreatePbufferSurface(gl.display, config, size);
    gl.context = eglCreateContext(gl.display, config, nullptr, nullptr);
    ASSERT_TRUE(eglMakeCurrent(gl.display, gl.surface, gl.surface, gl.context));
}

/// Records what a program draws with depth and stencil, for a surface of another format.
Record record_for(PixelFormat format, const programs::Program& program, bool tests_stencils, EGLint red = 0) {
    bench::Headless gl;
    open_with_stencils(gl, red);
    Record out;
    {
        Recorder recorder(format);
        recorder.add(*gl::current_context());
        program.setup(width, height);
        if (tests_stencils)
            glEnable(GL_STENCIL_TEST);
        program.draw(1);
        out = recorder.finish();
        gl::watch(*gl::current_context(), nullptr);
    }
    gl.close();
    return out;
}

TEST(Recorder, RecordsForOtherSurfaces) {
    const Record rgb888 = record_for(PixelFormat::rgb888, programs::gouraud_cube, false);
    EXPECT_EQ(rgb888.color_formats, 1u << static_cast<unsigned>(PixelFormat::rgb888));
    EXPECT_EQ(rgb888.depth_formats, 3u) << "no depth, and 16 bits";
    for (const KeyUse& use : rgb888.keys) {
        EXPECT_EQ(use.key.format, PixelFormat::rgb888);
        EXPECT_FALSE(use.key.dither) << "nothing is lost in 888";
    }
    EXPECT_EQ(rgb888.pixels(), record(programs::gouraud_cube).pixels());
    const Record stencils = record_for(PixelFormat::rgb565_be, programs::gouraud_cube, true);
    EXPECT_EQ(stencils.depth_formats, 5u) << "no depth, and 24 bits";
    for (const KeyUse& use : stencils.keys)
        EXPECT_EQ(use.key.depth_format, DepthFormat::z24s8);
}

/// What was drawn before the first stencil test has depths of 24 bits, too. What uses no depth still has
/// none.
TEST(Recorder, StencilsGiveAllDepths24Bits) {
    constexpr programs::Program late{"late", [](int, int) {},
                                     [](int) {
                                         for (const GLenum test : {GL_NONE, GL_DEPTH_TEST, GL_STENCIL_TEST}) {
                                             if (test != GL_NONE)
                                                 glEnable(test);
                                             glRectf(-0.5f, -0.5f, 0.5f, 0.5f);
                                         }
                                     }};
    const Record stencils = record_for(PixelFormat::rgb565_be, late, false);
    int without = 0, with = 0;
    for (const KeyUse& use : stencils.keys) {
        EXPECT_NE(use.key.depth_format, DepthFormat::z16);
        ++(use.key.depth_format == DepthFormat::none ? without : with);
    }
    EXPECT_GT(without, 0);
    EXPECT_GT(with, 1);
}

TEST(Recorder, KeepsTheLoopOfOneColourThatOtherSurfacesHave) {
    const auto flat = [](const Record& record) {
        return std::any_of(record.keys.begin(), record.keys.end(), [](const KeyUse& use) {
            return use.key.kind == raster::Kind::flat && use.needed;
        });
    };
    // Surfaces of 888 are recorded for other surfaces.
    constexpr programs::Program plain{"plain", [](int, int) {},
                                      [](int) { glRectf(-0.5f, -0.5f, 0.5f, 0.5f); }};
    EXPECT_TRUE(flat(record_for(PixelFormat::rgb565_be, plain, false, 8)));
    EXPECT_FALSE(flat(record_for(PixelFormat::rgb888, plain, false, 8))) << "no surface of 16 bits";
    EXPECT_FALSE(flat(record_for(PixelFormat::rgb565_be, programs::sprites_only, false, 8))) << "textures";
}

TEST(RecordText, ComesBackAsItWas) {
    for (const programs::Program* program : programs::all) {
        const Record there = record(*program);
        Record back;
        ASSERT_EQ(from_text(to_text(there), back), "") << program->name;
        EXPECT_EQ(to_text(back), to_text(there)) << program->name;
        ASSERT_EQ(back.keys.size(), there.keys.size());
        for (std::size_t i = 0; i < back.keys.size(); ++i)
            EXPECT_EQ(back.keys[i].key, there.keys[i].key) << words(there.keys[i].key);
        const Choice choice{"it", "it.inc"};
        EXPECT_EQ(settings(make(back, choice), back, choice), settings(make(there, choice), there, choice));
    }
}

/// Each word of a key is written, whatever its value is.
TEST(RecordText, KeepsEachWordOfAKey) {
    using raster::Key;
    for (bool Key::*const word :
         {&Key::cubic, &Key::coarse, &Key::blend_general, &Key::color_alpha, &Key::color_sum, &Key::fog,
          &Key::stencil, &Key::dither, &Key::masked, &Key::polygon_stipple, &Key::depth_offset}) {
        Record there, back;
        there.keys.emplace_back().key.*word = true;
        ASSERT_EQ(from_text(to_text(there), back), "");
        ASSERT_EQ(back.keys.size(), 1U);
        EXPECT_EQ(back.keys[0].key, there.keys[0].key) << words(there.keys[0].key);
    }
}

TEST(RecordText, RefusesWhatIsNoRecord) {
    Record out;
    const std::string text = to_text(record(programs::gouraud_cube));
    EXPECT_THAT(from_text("", out), HasSubstr("no record"));
    EXPECT_THAT(from_text(text.substr(0, text.size() - 4), out), HasSubstr("without its end"));
    EXPECT_THAT(from_text("spangle record 2\nlimit depth_of_sea 3\nend\n", out), HasSubstr("depth_of_sea"));
    EXPECT_THAT(from_text("spangle record 2\nkey 1 2\nend\n", out), HasSubstr("key 1 2"));
}

} // namespace

} // namespace spangle::profile

#endif
