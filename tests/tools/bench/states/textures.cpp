#include "tests/tools/bench/states/textures.hpp"

#include "tests/support/random.hpp"

namespace spangle::bench::states {

namespace {

GLubyte texels[texture_size * texture_size * 4];
GLuint names[2];

/// Makes noise of all colours. Alpha is 255 in half of the texels, and at least 32.
void make_noise(std::uint32_t seed, int count) {
    test::Random random{seed};
    for (int i = 0; i < count; ++i) {
        for (int c = 0; c < 3; ++c)
            texels[4 * i + c] = static_cast<GLubyte>(random.below(256));
        texels[4 * i + 3] = static_cast<GLubyte>(random.below(2) == 0 ? 255 : 32 + random.below(224));
    }
}

void image(GLenum target, GLint level, GLint format, int size) {
    constexpr GLenum rgba = GL_RGBA, type = GL_UNSIGNED_BYTE;
    const int depth = target == GL_TEXTURE_3D ? size : 1, height = target == GL_TEXTURE_1D ? 1 : size;
    make_noise(static_cast<std::uint32_t>(size) * 31u + target, size * height * depth);
    if (target == GL_TEXTURE_1D)
        glTexImage1D(target, level, format, size, 0, rgba, type, texels);
    else if (target == GL_TEXTURE_3D)
        glTexImage3D(target, level, format, size, size, size, 0, rgba, type, texels);
    else
        glTexImage2D(target, level, format, size, size, 0, rgba, type, texels);
}

/// Returns the size of a texture. All kinds have about as many texels: a volume has 16 each way, a face 32.
int size_of(const State& state, GLenum target) {
    return target == GL_TEXTURE_3D                                    ? 16
           : target == GL_TEXTURE_CUBE_MAP                            ? 32
           : state[Word::shape] == sprites && target != GL_TEXTURE_1D ? sprite_size
                                                                      : texture_size;
}

void images(const State& state, GLenum target, GLint format, bool levels) {
    const int size = size_of(state, target);
    for (int level = 0; size >> level != 0 && (levels || level == 0); ++level)
        if (target == GL_TEXTURE_CUBE_MAP)
            for (GLenum face = 0; face < 6; ++face)
                image(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, format, size >> level);
        else
            image(target, level, format, size >> level);
}

void set_env(const GLenum* how) {
    const auto set = [](GLenum name, GLenum value) {
        glTexEnvi(GL_TEXTURE_ENV, name, static_cast<GLint>(value));
    };
    const GLfloat color[] = {0.75f, 0.5f, 0.25f, 0.625f};
    set(GL_TEXTURE_ENV_MODE, how[0]);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
    if (how[0] != GL_COMBINE)
        return;
    set(GL_COMBINE_RGB, how[1]);
    set(GL_COMBINE_ALPHA, how[2]);
    set(GL_SOURCE0_RGB, GL_TEXTURE);
    set(GL_SOURCE1_RGB, GL_PREVIOUS);
    set(GL_SOURCE2_RGB, GL_CONSTANT);
    set(GL_OPERAND2_RGB, GL_SRC_ALPHA);
}

void set_texture(const State& state, int unit, GLenum target, const GLenum* format, const GLenum* filter,
                 const GLenum* wrap, const GLenum* env) {
    const auto set = [target](GLenum name, GLenum value) {
        glTexParameteri(target, name, static_cast<GLint>(value));
    };
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glGenTextures(1, &names[unit]);
    glBindTexture(target, names[unit]);
    set(GL_TEXTURE_MIN_FILTER, filter[0]);
    set(GL_TEXTURE_MAG_FILTER, filter[1]);
    set(GL_TEXTURE_WRAP_S, wrap[0]);
    set(GL_TEXTURE_WRAP_T, wrap[1]);
    set(GL_TEXTURE_WRAP_R, wrap[1]);
    images(state, target, static_cast<GLint>(format[0]), filter[0] != GL_NEAREST && filter[0] != GL_LINEAR);
    set_env(env);
    glEnable(target);
    glActiveTexture(GL_TEXTURE0);
}

} // namespace

void set_textures(const State& state) {
    constexpr GLenum repeat[] = {GL_REPEAT, GL_REPEAT};
    if (state.has(Word::texture))
        set_texture(state, 0, state.value(Word::texture)[0], state.value(Word::format),
                    state.value(Word::filter), state.value(Word::wrap), state.value(Word::env));
    if (state.has(Word::texture2))
        set_texture(state, 1, GL_TEXTURE_2D, state.value(Word::texture2), state.value(Word::filter2), repeat,
                    state.value(Word::env2));
}

void forget_textures() {
    glDeleteTextures(2, names);
    names[0] = names[1] = 0;
}

} // namespace spangle::bench::states
