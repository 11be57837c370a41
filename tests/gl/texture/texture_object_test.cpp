// Tests texture objects: names, bindings, sharing, memory, completeness, parameters (GL 1.3, 3.8.4, 3.8.9 to
// 3.8.12; docs/features.md F09, F14, F16, F18).
#include <gtest/gtest.h>

#include <bit>
#include <climits>

#include "gl/api/generated/commands.hpp"
#include "gl/context/hooks.hpp"
#include "gl/texture/complete.hpp"
#include "tests/gl/pixel/bare_context.hpp"
#include "tests/gl/texture/client_image.hpp"

namespace spangle::gl {
namespace {

using test::BareContext;
using test::SharedMemory;

Params integer(std::int64_t value) {
    Params params;
    params.v[0] = Param::from_integer(static_cast<std::uint32_t>(value));
    params.count = 1;
    return params;
}
Params reals(std::initializer_list<float> values) {
    Params params;
    for (float value : values)
        params.v[params.count++] = Param::from(numeric::from_float(value));
    return params;
}

void image(BareContext& b, GLint level, GLsizei width, GLsizei height, GLint border = 0,
           GLint format = GL_RGBA) {
    tex_image_2d(b.context, GL_TEXTURE_2D, level, format, width + 2 * border, height + 2 * border, border,
                 GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    ASSERT_EQ(b.take_error(), GLenum{GL_NO_ERROR});
}
void parameter(BareContext& b, GLenum pname, std::int64_t value) {
    cmd::TexParameter(b.context, GL_TEXTURE_2D, pname, integer(value));
}
int levels(BareContext& b) {
    const raster::Texture* t = complete_texture(b.context.texture.bound(0));
    return t == nullptr ? 0 : t->level_count;
}

TEST(TextureObject, LifeCycle) {
    SharedMemory memory(1 << 18);
    BareContext b(memory);
    const std::size_t start = memory.arena.used();
    GLuint names[3] = {};
    cmd::GenTextures(b.context, 3, names);
    EXPECT_NE(names[0], 0u);
    EXPECT_NE(names[0], names[1]);
    EXPECT_NE(names[1], names[2]);
    EXPECT_EQ(cmd::IsTexture(b.context, names[0]), GL_FALSE); // the name is only reserved
    cmd::BindTexture(b.context, GL_TEXTURE_2D, names[0]);
    EXPECT_EQ(cmd::IsTexture(b.context, names[0]), GL_TRUE);
    EXPECT_EQ(texture_binding(b.context, TextureKind::two), names[0]);
    image(b, 0, 4, 4);
    cmd::BindTexture(b.context, GL_TEXTURE_2D, 777); // names need not come from GenTextures
    EXPECT_EQ(cmd::IsTexture(b.context, 777), GL_TRUE);
    EXPECT_EQ(levels(b), 0);
    image(b, 0, 2, 2);
    GLuint more[2];
    cmd::GenTextures(b.context, 2, more);
    for (GLuint name : more)
        EXPECT_TRUE(name != names[0] && name != names[1] && name != names[2] && name != 777);
    cmd::BindTexture(b.context, GL_TEXTURE_2D, names[0]);
    parameter(b, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    EXPECT_EQ(complete_texture(b.context.texture.bound(0))->level[0].width, 4); // the object kept its image
    const GLuint gone[] = {0, 12345, names[0], 777, names[1], names[2], more[0], more[1]};
    cmd::DeleteTextures(b.context, 8, gone); // zero and unused names are ignored
    EXPECT_EQ(b.take_error(), GLenum{GL_NO_ERROR});
    EXPECT_EQ(texture_binding(b.context, TextureKind::two), 0u); // the binding becomes 0
    EXPECT_EQ(cmd::IsTexture(b.context, names[0]), GL_FALSE);
    EXPECT_EQ(cmd::IsTexture(b.context, 0), GL_FALSE);
    memory.share.textures.clear(memory.arena);
    EXPECT_EQ(memory.arena.used(), start);
    EXPECT_TRUE(memory.arena.consistent());
}

TEST(TextureObject, DefaultObjectIsNameZero) {
    SharedMemory memory(1 << 18);
    BareContext b(memory);
    const std::size_t start = memory.arena.used();
    image(b, 0, 8, 8);
    parameter(b, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    cmd::BindTexture(b.context, GL_TEXTURE_2D, 5);
    EXPECT_EQ(levels(b), 0);
    cmd::BindTexture(b.context, GL_TEXTURE_2D, 0);
    EXPECT_EQ(levels(b), 1);
    const GLuint names[] = {0, 5};
    cmd::DeleteTextures(b.context, 2, names);
    EXPECT_EQ(levels(b), 1); // texture 0 is not deleted
    release_textures(b.context);
    EXPECT_EQ(levels(b), 0);
    memory.share.textures.clear(memory.arena);
    EXPECT_EQ(memory.arena.used(), start);
}

TEST(TextureObject, Errors) {
    SharedMemory memory(1 << 18);
    BareContext b(memory);
    GLuint name = 9;
    cmd::GenTextures(b.context, -1, &name);
    EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(name, 9u);
    cmd::DeleteTextures(b.context, -1, &name);
    EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_VALUE});
    cmd::GenTextures(b.context, 1, nullptr);
    EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_VALUE});
    cmd::GenTextures(b.context, 0, nullptr);
    cmd::DeleteTextures(b.context, 0, nullptr);
    EXPECT_EQ(b.take_error(), GLenum{GL_NO_ERROR});
    for (GLenum target : {GLenum{GL_PROXY_TEXTURE_2D}, GLenum{0}, GLenum{GL_TEXTURE}}) {
        cmd::BindTexture(b.context, target, 3);
        EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
    }
    EXPECT_EQ(cmd::IsTexture(b.context, 3), GL_FALSE);
    cmd::GenTextures(b.context, INT_MAX, &name); // more names than any arena has room for
    EXPECT_EQ(b.take_error(), GLenum{GL_OUT_OF_MEMORY});
    EXPECT_EQ(name, 9u);
}

TEST(TextureObject, SharedObjectsOutliveTheirNameWhileBound) {
    SharedMemory memory(1 << 18);
    BareContext a(memory), b(memory);
    const std::size_t start = memory.arena.used();
    cmd::BindTexture(a.context, GL_TEXTURE_2D, 4);
    image(a, 0, 16, 16);
    parameter(a, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    cmd::BindTexture(b.context, GL_TEXTURE_2D, 4);
    EXPECT_EQ(complete_texture(b.context.texture.bound(0)),
              complete_texture(a.context.texture.bound(0))); // both contexts have the same object
    const GLuint name = 4;
    cmd::DeleteTextures(a.context, 1, &name);
    EXPECT_EQ(levels(a), 0);
    EXPECT_EQ(cmd::IsTexture(b.context, 4), GL_FALSE);
    EXPECT_EQ(levels(b), 1); // b still holds the object
    EXPECT_EQ(complete_texture(b.context.texture.bound(0))->level[0].width, 16);
    cmd::BindTexture(a.context, GL_TEXTURE_2D, 4); // a new object of the freed name
    EXPECT_EQ(levels(a), 0);
    EXPECT_EQ(levels(b), 1);
    release_textures(b.context); // the last holder frees the object
    cmd::DeleteTextures(a.context, 1, &name);
    memory.share.textures.clear(memory.arena);
    EXPECT_EQ(memory.arena.used(), start);
}

TEST(TextureObject, Completeness) {
    SharedMemory memory(1 << 20);
    const auto fresh = [&](BareContext& b) {
        static GLuint name = 100;
        cmd::BindTexture(b.context, GL_TEXTURE_2D, ++name);
    };
    BareContext b(memory);
    EXPECT_EQ(levels(b), 0);
    image(b, 0, 8, 2);
    EXPECT_EQ(levels(b), 0); // the default MIN_FILTER wants mipmaps, so textures without them are incomplete
    image(b, 1, 4, 1);
    image(b, 2, 2, 1);
    EXPECT_EQ(levels(b), 0);
    image(b, 3, 1, 1);
    EXPECT_EQ(levels(b), 4);
    image(b, 2, 2, 2); // gives the level a wrong size
    EXPECT_EQ(levels(b), 0);
    parameter(b, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    EXPECT_EQ(levels(b), 1);
    parameter(b, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    EXPECT_EQ(levels(b), 0);
    parameter(b, GL_TEXTURE_MAX_LEVEL, 1); // levels beyond the last one, q, do not matter
    EXPECT_EQ(levels(b), 2);
    parameter(b, GL_TEXTURE_MAX_LEVEL, 0);
    EXPECT_EQ(levels(b), 1);
    parameter(b, GL_TEXTURE_BASE_LEVEL, 1); // the base level is above the maximum
    EXPECT_EQ(levels(b), 0);
    // The base level is too large by more than one, also if it is the last of its chain.
    for (const GLint base : {2, 3})
        for (GLint max = 0; max < base; ++max) {
            parameter(b, GL_TEXTURE_BASE_LEVEL, base);
            parameter(b, GL_TEXTURE_MAX_LEVEL, max);
            EXPECT_EQ(levels(b), 0) << base << ' ' << max;
            EXPECT_EQ(complete_texture(b.context.texture.bound(0)), nullptr);
        }
    parameter(b, GL_TEXTURE_MAX_LEVEL, 3);
    EXPECT_EQ(levels(b), 1);
    parameter(b, GL_TEXTURE_BASE_LEVEL, 1);
    parameter(b, GL_TEXTURE_MAX_LEVEL, 0);
    parameter(b, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    EXPECT_EQ(levels(b), 1);
    EXPECT_EQ(complete_texture(b.context.texture.bound(0))->level[0].width, 4);
    for (GLint far : {4, 11, 12, 1000, INT_MAX}) {
        parameter(b, GL_TEXTURE_BASE_LEVEL, far);
        parameter(b, GL_TEXTURE_MAX_LEVEL, INT_MAX);
        EXPECT_EQ(levels(b), 0) << far;
    }
    fresh(b); // next: a level with another internal format
    image(b, 0, 2, 2);
    image(b, 1, 1, 1, 0, GL_RGB);
    EXPECT_EQ(levels(b), 0);
    image(b, 1, 1, 1, 0, GL_RGBA8); // asks for another format with the same bits
    EXPECT_EQ(levels(b), 0);
    image(b, 1, 1, 1);
    EXPECT_EQ(levels(b), 2);
    image(b, 1, 1, 1, 1); // gives the level another border
    EXPECT_EQ(levels(b), 0);
    image(b, 0, 2, 2, 1);
    EXPECT_EQ(levels(b), 2);
    EXPECT_EQ(complete_texture(b.context.texture.bound(0))->border_texels, 1);
    fresh(b); // next: a texture without texels
    parameter(b, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    image(b, 0, 0, 4);
    EXPECT_EQ(levels(b), 0);
    fresh(b); // next: a base level above 0
    image(b, 3, 4, 4);
    image(b, 4, 2, 2);
    image(b, 5, 1, 1);
    parameter(b, GL_TEXTURE_BASE_LEVEL, 3);
    EXPECT_EQ(levels(b), 3);
    parameter(b, GL_TEXTURE_MAX_LEVEL, 4);
    EXPECT_EQ(levels(b), 2);
    fresh(b); // next: the longest chain of levels
    for (GLint l = 0; l < 12; ++l)
        image(b, l, 2048 >> l, 1, 0, GL_ALPHA);
    EXPECT_EQ(levels(b), 12);
}

TEST(TextureObject, ViewSaysWhatTheParametersSay) {
    SharedMemory memory(1 << 18);
    BareContext b(memory);
    for (GLint l = 0; l < 3; ++l)
        image(b, l, 4 >> l, 4 >> l);
    const struct {
        GLenum token;
        raster::Filter filter;
        raster::MipFilter mip;
    } filters[] = {
        {GL_NEAREST, raster::Filter::nearest, raster::MipFilter::none},
        {GL_LINEAR, raster::Filter::linear, raster::MipFilter::none},
        {GL_NEAREST_MIPMAP_NEAREST, raster::Filter::nearest, raster::MipFilter::nearest},
        {GL_LINEAR_MIPMAP_NEAREST, raster::Filter::linear, raster::MipFilter::nearest},
        {GL_NEAREST_MIPMAP_LINEAR, raster::Filter::nearest, raster::MipFilter::linear},
        {GL_LINEAR_MIPMAP_LINEAR, raster::Filter::linear, raster::MipFilter::linear},
    };
    for (const auto& f : filters) {
        parameter(b, GL_TEXTURE_MIN_FILTER, f.token);
        const raster::Texture* t = complete_texture(b.context.texture.bound(0));
        EXPECT_EQ(t->min, f.filter);
        EXPECT_EQ(t->mip, f.mip);
        EXPECT_EQ(t->mag, raster::Filter::linear);
    }
    parameter(b, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    EXPECT_EQ(complete_texture(b.context.texture.bound(0))->mag, raster::Filter::nearest);
    const struct {
        GLenum token;
        raster::Wrap wrap;
    } wraps[] = {{GL_CLAMP, raster::Wrap::clamp},
                 {GL_CLAMP_TO_EDGE, raster::Wrap::clamp_to_edge},
                 {GL_CLAMP_TO_BORDER, raster::Wrap::clamp_to_border},
                 {GL_REPEAT, raster::Wrap::repeat}};
    for (const auto& w : wraps) {
        parameter(b, GL_TEXTURE_WRAP_S, w.token);
        parameter(b, GL_TEXTURE_WRAP_T, GL_CLAMP);
        EXPECT_EQ(complete_texture(b.context.texture.bound(0))->wrap_s, w.wrap);
        EXPECT_EQ(complete_texture(b.context.texture.bound(0))->wrap_t, raster::Wrap::clamp);
    }
    EXPECT_EQ(complete_texture(b.context.texture.bound(0))->min_lod, -256000);
    EXPECT_EQ(complete_texture(b.context.texture.bound(0))->max_lod, 256000);
    cmd::TexParameter(b.context, GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, reals({0.5f}));
    cmd::TexParameter(b.context, GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, reals({1e30f}));
    cmd::TexParameter(b.context, GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, reals({0, 1, 0.5f, 2}));
    const raster::Texture* t = complete_texture(b.context.texture.bound(0));
    EXPECT_EQ(t->min_lod, 128);
    EXPECT_EQ(t->max_lod, INT_MAX);
    EXPECT_EQ(t->border_color[0], 0);
    EXPECT_EQ(t->border_color[1], 255);
    EXPECT_EQ(t->border_color[2], 128);
    EXPECT_EQ(t->border_color[3], 255);
}

TEST(TextureParameters, InitialValues) {
    SharedMemory memory(1 << 16);
    BareContext b(memory);
    const struct {
        GLenum pname, value;
    } tokens[] = {{GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_LINEAR},
                  {GL_TEXTURE_MAG_FILTER, GL_LINEAR},
                  {GL_TEXTURE_WRAP_S, GL_REPEAT},
                  {GL_TEXTURE_WRAP_T, GL_REPEAT},
                  {GL_TEXTURE_BASE_LEVEL, 0},
                  {GL_TEXTURE_MAX_LEVEL, 1000},
                  {GL_TEXTURE_RESIDENT, GL_TRUE}};
    Params got;
    for (GLuint name : {0u, 42u}) {
        cmd::BindTexture(b.context, GL_TEXTURE_2D, name);
        for (const auto& t : tokens) {
            cmd::GetTexParameter(b.context, GL_TEXTURE_2D, t.pname, got);
            ASSERT_EQ(got.count, 1u);
            EXPECT_EQ(got.v[0].token(), t.value) << std::hex << t.pname;
        }
        const struct {
            GLenum pname;
            float value;
        } numbers[] = {{GL_TEXTURE_PRIORITY, 1}, {GL_TEXTURE_MIN_LOD, -1000}, {GL_TEXTURE_MAX_LOD, 1000}};
        for (const auto& n : numbers) {
            cmd::GetTexParameter(b.context, GL_TEXTURE_2D, n.pname, got);
            EXPECT_EQ(numeric::to_float(got.v[0].real()), n.value);
        }
        cmd::GetTexParameter(b.context, GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, got);
        ASSERT_EQ(got.count, 4u);
        for (const Param& c : got.v)
            EXPECT_EQ(c.word, 0u);
    }
}

TEST(TextureParameters, ValuesAreKeptAndBadOnesRefused) {
    SharedMemory memory(1 << 16);
    BareContext b(memory);
    const struct {
        GLenum pname;
        std::int64_t value;
        GLenum wanted;
    } cases[] = {
        {GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR, GL_NO_ERROR},
        {GL_TEXTURE_MIN_FILTER, 0, GL_INVALID_ENUM},
        {GL_TEXTURE_MIN_FILTER, 0x2704, GL_INVALID_ENUM},
        {GL_TEXTURE_MIN_FILTER, 0x26FF, GL_INVALID_ENUM},
        {GL_TEXTURE_MAG_FILTER, GL_NEAREST, GL_NO_ERROR},
        {GL_TEXTURE_MAG_FILTER, GL_NEAREST_MIPMAP_NEAREST, GL_INVALID_ENUM},
        {GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER, GL_NO_ERROR},
        {GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE, GL_NO_ERROR},
        {GL_TEXTURE_WRAP_S, GL_NEAREST, GL_INVALID_ENUM},
        {GL_TEXTURE_WRAP_T, GL_CLAMP, GL_NO_ERROR},
        {GL_TEXTURE_WRAP_T, GL_MIRRORED_REPEAT, GL_NO_ERROR},
        {GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE, GL_NO_ERROR},
        {GL_TEXTURE_WRAP_R, GL_LINEAR, GL_INVALID_ENUM},
        {GL_TEXTURE_BASE_LEVEL, 3, GL_NO_ERROR},
        {GL_TEXTURE_BASE_LEVEL, -1, GL_INVALID_VALUE},
        {GL_TEXTURE_MAX_LEVEL, INT_MAX, GL_NO_ERROR},
        {GL_TEXTURE_MAX_LEVEL, INT_MIN, GL_INVALID_VALUE},
    };
    for (const auto& c : cases) {
        Params before, after;
        cmd::GetTexParameter(b.context, GL_TEXTURE_2D, c.pname, before);
        parameter(b, c.pname, c.value);
        EXPECT_EQ(b.take_error(), c.wanted) << std::hex << c.pname << " " << c.value;
        cmd::GetTexParameter(b.context, GL_TEXTURE_2D, c.pname, after);
        EXPECT_EQ(after.v[0].integer(), c.wanted == GL_NO_ERROR ? c.value : before.v[0].integer());
    }
    parameter(b, GL_TEXTURE_RESIDENT, 0); // this parameter can only be queried
    EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
    cmd::TexParameter(b.context, GL_PROXY_TEXTURE_2D, GL_TEXTURE_WRAP_S, integer(GL_CLAMP));
    EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
    cmd::TexParameter(b.context, GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR,
                      Params{}); // a vector parameter in the scalar form
    EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
    Params got;
    for (GLenum target : {GL_PROXY_TEXTURE_2D, GL_TEXTURE_ENV}) {
        cmd::GetTexParameter(b.context, target, GL_TEXTURE_WRAP_S, got);
        EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
        EXPECT_EQ(got.count, 0u);
    }
    cmd::GetTexParameter(b.context, GL_TEXTURE_2D, GL_TEXTURE_WIDTH, got);
    EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
    cmd::TexParameter(b.context, GL_TEXTURE_2D, GL_TEXTURE_PRIORITY, reals({-2}));
    cmd::GetTexParameter(b.context, GL_TEXTURE_2D, GL_TEXTURE_PRIORITY, got);
    EXPECT_EQ(numeric::to_float(got.v[0].real()), 0);
    cmd::TexParameter(b.context, GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, reals({-0.1f}));
    cmd::GetTexParameter(b.context, GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, got);
    EXPECT_EQ(numeric::to_float(got.v[0].real()), -0.1f);
    cmd::TexParameter(b.context, GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, reals({0.1f, -1, 3, 1}));
    cmd::GetTexParameter(b.context, GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, got);
    const float wanted[4] = {0.1f, 0, 1, 1}; // clamped when it is set (GL 1.3, 3.8.4)
    for (int c = 0; c < 4; ++c)
        EXPECT_EQ(numeric::to_float(got.v[c].real()), wanted[c]);
}

TEST(TextureEnvironment, ModesColourAndErrors) {
    SharedMemory memory(1 << 16);
    BareContext b(memory);
    Params got;
    cmd::GetTexEnv(b.context, GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, got);
    EXPECT_EQ(got.v[0].token(), GLenum{GL_MODULATE});
    cmd::GetTexEnv(b.context, GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, got);
    ASSERT_EQ(got.count, 4u);
    EXPECT_EQ(got.v[3].word, 0u);
    for (GLenum mode : {GL_REPLACE, GL_MODULATE, GL_DECAL, GL_BLEND, GL_COMBINE, GL_ADD}) {
        cmd::TexEnv(b.context, GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, integer(mode));
        EXPECT_EQ(b.take_error(), GLenum{GL_NO_ERROR});
        cmd::GetTexEnv(b.context, GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, got);
        EXPECT_EQ(got.v[0].token(), mode);
    }
    const struct {
        GLenum target, pname;
        Params params;
    } bad[] = {{GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, integer(GL_REPLACE)},
               {GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, integer(GL_KEEP)},
               {GL_TEXTURE_ENV, GL_TEXTURE_LOD_BIAS, reals({1})},
               {GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_ENV_MODE, integer(GL_REPLACE)},
               {GL_TEXTURE_ENV, GL_TEXTURE_WRAP_S, integer(GL_REPLACE)},
               {GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, Params{}}};
    for (const auto& c : bad) {
        cmd::TexEnv(b.context, c.target, c.pname, c.params);
        EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
    }
    cmd::GetTexEnv(b.context, GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, got);
    EXPECT_EQ(got.v[0].token(), GLenum{GL_ADD});
    cmd::GetTexEnv(b.context, GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, got);
    EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(got.count, 0u);
    cmd::GetTexEnv(b.context, GL_TEXTURE_ENV, GL_TEXTURE_WIDTH, got);
    EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
    cmd::TexEnv(b.context, GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, reals({0.25f, -1, 2, 1}));
    cmd::GetTexEnv(b.context, GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, got);
    const float wanted[4] = {0.25f, 0, 1, 1};
    for (int c = 0; c < 4; ++c)
        EXPECT_EQ(numeric::to_float(got.v[c].real()), wanted[c]);
}

/// Runs a small program. Whichever allocation fails, everything stays as it was.
TEST(TextureMemory, ExhaustionLeavesTheStateIntact) {
    bool finished = false;
    unsigned failures = 0;
    for (std::size_t bytes = 128; !finished; bytes += 40) {
        SharedMemory memory(bytes);
        BareContext b(memory);
        finished = true;
        const auto failed = [&] {
            const GLenum code = b.take_error();
            if (code != GL_NO_ERROR) {
                EXPECT_EQ(code, GLenum{GL_OUT_OF_MEMORY});
                finished = false;
                ++failures;
            }
            EXPECT_TRUE(memory.arena.consistent());
            return code != GL_NO_ERROR;
        };
        GLuint names[20] = {};
        cmd::GenTextures(b.context, 20, names);
        if (failed()) {
            EXPECT_EQ(names[0], 0u);
        }
        cmd::BindTexture(b.context, GL_TEXTURE_2D, 900);
        if (failed()) {
            EXPECT_EQ(texture_binding(b.context, TextureKind::two), 0u);
        }
        const std::uint8_t pixels[4 * 4 * 4] = {1, 2, 3, 4, 5};
        tex_image_2d(b.context, GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
        const bool first_failed = failed();
        parameter(b, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        const std::size_t used = memory.arena.used();
        tex_image_2d(b.context, GL_TEXTURE_2D, 0, GL_RGBA, 16, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        if (failed()) {
            EXPECT_EQ(memory.arena.used(), used);
            const raster::Texture* t = complete_texture(b.context.texture.bound(0));
            ASSERT_EQ(t == nullptr, first_failed);
            if (t != nullptr) {
                EXPECT_EQ(t->level[0].width, 4);
                EXPECT_EQ(t->level[0].texels[4], 5);
            }
        }
        ASSERT_LT(bytes, std::size_t{1} << 16);
    }
    EXPECT_GE(failures, 10u);
}

} // namespace
} // namespace spangle::gl
