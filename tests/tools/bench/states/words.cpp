#include "tests/tools/bench/states/words.hpp"

namespace spangle::bench::states {

namespace {

constexpr Choice surface[] = {{"565 z16", 1, unordered, {}}, {"8888 z24s8", 1, unordered, {}}};
constexpr Choice tier[] = {{"exact", 1, 3, {}}, {"balanced", 1, 1, {}}, {"fast", 1, 0, {}}};
constexpr Choice samples[] = {{"", 19, 0, {}}, {"4 samples", 1, 1, {}}};

constexpr Choice shape[] = {{"triangles", 42, unordered, {}}, {"small triangles", 20, unordered, {}},
                            {"lines", 8, unordered, {}},      {"wide lines", 4, unordered, {}},
                            {"points", 4, unordered, {}},     {"large points", 6, unordered, {}},
                            {"sprites", 16, unordered, {}}};
constexpr Choice view[] = {
    {"parallel", 25, 0, {}}, {"mild perspective", 40, 1, {}}, {"harsh perspective", 35, 1, {}}};
// Lit vertices take longer, too, so their states are compared with each other only.
constexpr Choice shade[] = {{"one colour", 3, 0, {}},
                            {"flat", 2, 1, {}},
                            {"smooth", 5, 3, {}},
                            {"lit", 3, 7, {}},
                            {"lit with separate specular", 1, 15, {}}};
constexpr Choice alpha[] = {{"opaque", 3, unordered, {}}, {"translucent", 2, unordered, {}}};

constexpr Choice texture[] = {{"", 30, 0, {}},
                              {"2D", 55, 3, {GL_TEXTURE_2D}},
                              {"1D", 5, 1, {GL_TEXTURE_1D}},
                              {"3D", 5, 7, {GL_TEXTURE_3D}},
                              {"cube", 5, 11, {GL_TEXTURE_CUBE_MAP}}};
constexpr Choice format[] = {
    {"RGB8", 5, unordered, {GL_RGB8}},       {"RGBA8", 6, unordered, {GL_RGBA8}},
    {"RGB5", 3, unordered, {GL_RGB5}},       {"A8", 2, unordered, {GL_ALPHA8}},
    {"L8", 2, unordered, {GL_LUMINANCE8}},   {"LA8", 2, unordered, {GL_LUMINANCE8_ALPHA8}},
    {"I8", 1, unordered, {GL_INTENSITY8}},   {"RGBA4", 1, unordered, {GL_RGBA4}},
    {"RGB5_A1", 1, unordered, {GL_RGB5_A1}},
};
// Bits of work: four texels, a chosen level, two levels. Values: minification, magnification.
constexpr Choice filter[] = {
    {"NEAREST", 8, 0, {GL_NEAREST, GL_NEAREST}},
    {"LINEAR", 8, 1, {GL_LINEAR, GL_LINEAR}},
    {"NEAREST_MIPMAP_NEAREST", 1, 2, {GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST}},
    {"LINEAR_MIPMAP_NEAREST", 2, 3, {GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR}},
    {"NEAREST_MIPMAP_LINEAR", 1, 6, {GL_NEAREST_MIPMAP_LINEAR, GL_NEAREST}},
    {"LINEAR_MIPMAP_LINEAR", 2, 7, {GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR}},
};
// Value: texels in 16 pixels.
constexpr Choice scale[] = {
    {"magnified", 2, unordered, {4}}, {"1:1", 2, unordered, {16}}, {"minified", 1, unordered, {40}}};
constexpr Choice wrap[] = {{"REPEAT", 5, unordered, {GL_REPEAT, GL_REPEAT}},
                           {"CLAMP", 1, unordered, {GL_CLAMP, GL_CLAMP}},
                           {"CLAMP_TO_EDGE", 3, unordered, {GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE}},
                           {"CLAMP_TO_BORDER", 1, unordered, {GL_CLAMP_TO_BORDER, GL_CLAMP_TO_BORDER}},
                           {"REPEAT and CLAMP_TO_EDGE", 1, unordered, {GL_REPEAT, GL_CLAMP_TO_EDGE}}};
// Values: the mode; if it is COMBINE, also the functions of RGB and of alpha.
constexpr Choice env[] = {
    {"MODULATE", 8, 1, {GL_MODULATE}},
    {"REPLACE", 5, 0, {GL_REPLACE}},
    {"DECAL", 1, 2, {GL_DECAL}},
    {"BLEND", 1, 4, {GL_BLEND}},
    {"ADD", 1, 8, {GL_ADD}},
    {"COMBINE MODULATE", 1, 1, {GL_COMBINE, GL_MODULATE, GL_MODULATE}},
    {"COMBINE INTERPOLATE", 1, 16, {GL_COMBINE, GL_INTERPOLATE, GL_MODULATE}},
    {"COMBINE ADD_SIGNED", 1, 32, {GL_COMBINE, GL_ADD_SIGNED, GL_REPLACE}},
    {"COMBINE SUBTRACT", 1, 64, {GL_COMBINE, GL_SUBTRACT, GL_ADD}},
    {"COMBINE DOT3_RGB", 1, 128, {GL_COMBINE, GL_DOT3_RGB, GL_MODULATE}},
};
constexpr Choice texture2[] = {
    {"", 17, 0, {}}, {"RGB8", 1, 1, {GL_RGB8}}, {"RGBA8", 1, 1, {GL_RGBA8}}, {"L8", 1, 1, {GL_LUMINANCE8}}};

// Values: the function, and its reference in 16ths. Texels and colours have at least 1/8 of alpha.
constexpr Choice alpha_test[] = {{"", 24, 0, {}},
                                 {"GREATER 0", 3, 1, {GL_GREATER, 0}},
                                 {"GEQUAL 1/2", 1, unordered, {GL_GEQUAL, 8}},
                                 {"LESS 1/2", 1, unordered, {GL_LESS, 8}},
                                 {"EQUAL 1", 1, unordered, {GL_EQUAL, 16}},
                                 {"NOTEQUAL 1", 1, unordered, {GL_NOTEQUAL, 16}},
                                 {"LEQUAL 1", 1, 1, {GL_LEQUAL, 16}},
                                 {"NEVER", 1, unordered, {GL_NEVER, 0}}};
// Values: the function, the operation if depth fails, and the operation if it passes. The buffer holds 0, and
// the reference is 0.
constexpr Choice stencil[] = {{"", 32, 0, {}},
                              {"EQUAL KEEP", 1, 1, {GL_EQUAL, GL_KEEP, GL_KEEP}},
                              {"ALWAYS REPLACE", 1, 2, {GL_ALWAYS, GL_REPLACE, GL_REPLACE}},
                              {"ALWAYS INCR", 1, 4, {GL_ALWAYS, GL_KEEP, GL_INCR}},
                              {"ALWAYS DECR on failure", 1, 8, {GL_ALWAYS, GL_DECR, GL_KEEP}},
                              {"ALWAYS INVERT", 1, 16, {GL_ALWAYS, GL_INVERT, GL_INVERT}},
                              {"EQUAL INCR", 1, unordered, {GL_EQUAL, GL_INCR, GL_INCR}},
                              {"GREATER KEEP", 1, unordered, {GL_GREATER, GL_KEEP, GL_KEEP}}};
// Values: the function, and the value to which the buffer is cleared. For EQUAL the depths are drawn before.
constexpr Choice depth[] = {{"", 12, 0, {}},
                            {"LESS", 12, unordered, {GL_LESS, 1}},
                            {"LEQUAL", 5, unordered, {GL_LEQUAL, 1}},
                            {"GREATER", 1, unordered, {GL_GREATER, 0}},
                            {"GEQUAL", 1, unordered, {GL_GEQUAL, 0}},
                            {"EQUAL", 1, unordered, {GL_EQUAL, 1}},
                            {"NOTEQUAL", 1, unordered, {GL_NOTEQUAL, 1}},
                            {"ALWAYS", 2, 1, {GL_ALWAYS, 1}},
                            {"NEVER", 1, unordered, {GL_NEVER, 1}}};
constexpr Choice depth_write[] = {{"written", 4, unordered, {GL_TRUE}}, {"kept", 1, unordered, {GL_FALSE}}};

constexpr Choice logic[] = {{"", 36, 0, {}},
                            {"XOR", 1, 1, {GL_XOR}},
                            {"AND", 1, 2, {GL_AND}},
                            {"INVERT", 1, 4, {GL_INVERT}},
                            {"OR_REVERSE", 1, 8, {GL_OR_REVERSE}}};
// Values: the factors and the equation.
constexpr Choice blend[] = {
    {"", 26, 0, {}},
    {"SRC_ALPHA, ONE_MINUS_SRC_ALPHA", 10, 1, {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_FUNC_ADD}},
    {"SRC_ALPHA, ONE", 4, 2, {GL_SRC_ALPHA, GL_ONE, GL_FUNC_ADD}},
    {"ONE, ONE", 2, 4, {GL_ONE, GL_ONE, GL_FUNC_ADD}},
    {"ONE, ONE_MINUS_SRC_ALPHA", 2, 8, {GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_FUNC_ADD}},
    {"DST_COLOR, ZERO", 2, 16, {GL_DST_COLOR, GL_ZERO, GL_FUNC_ADD}},
    {"ONE_MINUS_DST_COLOR, ONE", 1, 32, {GL_ONE_MINUS_DST_COLOR, GL_ONE, GL_FUNC_ADD}},
    {"DST_ALPHA, ONE_MINUS_DST_ALPHA", 1, 64, {GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_FUNC_ADD}},
    {"SRC_ALPHA_SATURATE, ONE", 1, 128, {GL_SRC_ALPHA_SATURATE, GL_ONE, GL_FUNC_ADD}},
    {"CONSTANT_ALPHA, ONE_MINUS_CONSTANT_ALPHA",
     1,
     256,
     {GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA, GL_FUNC_ADD}},
    {"SRC_COLOR, ONE_MINUS_SRC_COLOR", 1, 512, {GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_FUNC_ADD}},
    {"ONE, ONE, FUNC_REVERSE_SUBTRACT", 1, 1024, {GL_ONE, GL_ONE, GL_FUNC_REVERSE_SUBTRACT}},
    {"ONE, ONE, MIN", 1, 2048, {GL_ONE, GL_ONE, GL_MIN}},
    {"ONE, ONE, MAX", 1, 4096, {GL_ONE, GL_ONE, GL_MAX}},
    {"ONE, ZERO", 1, 8192, {GL_ONE, GL_ZERO, GL_FUNC_ADD}},
};
// Value: bits of red, green, blue and alpha. If some channels are masked, the stored colour is read as well.
constexpr Choice mask[] = {{"", 30, 1, {15}},
                           {"no alpha", 2, unordered, {7}},
                           {"no red", 1, 3, {14}},
                           {"green only", 1, 3, {2}},
                           {"nothing", 1, 0, {0}}};
constexpr Choice fog[] = {
    {"", 14, 0, {}}, {"LINEAR", 3, 1, {GL_LINEAR}}, {"EXP", 1, 3, {GL_EXP}}, {"EXP2", 1, 7, {GL_EXP2}}};
constexpr Choice dither[] = {{"", 1, 0, {}}, {"on", 1, 1, {}}};
constexpr Choice scissor[] = {{"", 6, unordered, {}}, {"on", 1, unordered, {}}};
constexpr Choice stipple[] = {{"", 15, unordered, {}}, {"on", 1, unordered, {}}};
constexpr Choice smooth[] = {{"", 4, 0, {}}, {"on", 1, 1, {}}};
constexpr Choice offset[] = {{"", 11, 0, {}}, {"on", 1, 1, {}}};

template <int N> constexpr WordInfo word(const char* name, const Choice (&choices)[N], bool pass = false) {
    return {name, pass, choices, N};
}

constexpr WordInfo all[] = {
    word("surface", surface),
    word("tier", tier),
    word("samples", samples, true),
    word("shape", shape),
    word("view", view),
    word("shade", shade),
    word("alpha", alpha),
    word("texture", texture, true),
    word("format", format),
    word("filter", filter, true),
    word("scale", scale),
    word("wrap", wrap),
    word("environment", env),
    word("second texture", texture2, true),
    word("second filter", filter, true),
    word("second environment", env),
    word("alpha test", alpha_test),
    word("stencil", stencil),
    word("depth", depth),
    word("depth mask", depth_write),
    word("polygon offset", offset),
    word("logic op", logic),
    word("blend", blend),
    word("colour mask", mask),
    word("fog", fog),
    word("dither", dither),
    word("scissor", scissor),
    word("stipple", stipple),
    word("smooth", smooth, true),
};
static_assert(sizeof all / sizeof all[0] == word_count);

} // namespace

const WordInfo& info(Word word) {
    return all[static_cast<int>(word)];
}

} // namespace spangle::bench::states
