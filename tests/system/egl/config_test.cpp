// Tests eglGetConfigs, eglChooseConfig and eglGetConfigAttrib against tables 3.1 and 3.4 and the sorting
// rules of EGL 1.4 (3.4.1).
#include <gtest/gtest.h>

#include <algorithm>
#include <climits>
#include <cstdint>
#include <random>
#include <set>
#include <string>

#include <spangle/message.hpp>

#include "tests/system/egl/fake_display.hpp"

namespace spangle::test {
namespace {

struct Configs : testing::Test {
    FakeDisplay panel;
    EGLDisplay display = eglGetDisplay(native(panel));

    void SetUp() override { ASSERT_EQ(eglInitialize(display, nullptr, nullptr), EGLBoolean{EGL_TRUE}); }
    void TearDown() override { EXPECT_EQ(eglTerminate(display), EGLBoolean{EGL_TRUE}); }

    EGLint get(EGLConfig config, EGLint name) {
        EGLint value = -12345;
        EXPECT_EQ(eglGetConfigAttrib(display, config, name, &value), EGLBoolean{EGL_TRUE})
            << std::hex << name;
        return value;
    }
    std::vector<EGLConfig> all() {
        EGLint n = 0;
        EXPECT_EQ(eglGetConfigs(display, nullptr, 0, &n), EGLBoolean{EGL_TRUE});
        std::vector<EGLConfig> out(static_cast<std::size_t>(n));
        EXPECT_EQ(eglGetConfigs(display, out.data(), n, &n), EGLBoolean{EGL_TRUE});
        EXPECT_EQ(static_cast<std::size_t>(n), out.size());
        return out;
    }
    /// Returns the chosen configs of OpenGL, unless the wishes name another renderable type.
    std::vector<EGLConfig> choose(std::vector<EGLint> wishes) {
        wishes.insert(wishes.begin(), {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT});
        return choose_of(wishes.data());
    }
    std::vector<EGLConfig> choose_of(const EGLint* wishes) {
        std::vector<EGLConfig> out(500);
        EGLint n = 0;
        EXPECT_EQ(eglChooseConfig(display, wishes, out.data(), 500, &n), EGLBoolean{EGL_TRUE});
        out.resize(static_cast<std::size_t>(n));
        return out;
    }
};

TEST_F(Configs, AllAreDistinctAndConsistent) {
    std::set<EGLint> ids;
    std::set<std::vector<EGLint>> kinds;
    for (EGLConfig c : all()) {
        const EGLint r = get(c, EGL_RED_SIZE), g = get(c, EGL_GREEN_SIZE), b = get(c, EGL_BLUE_SIZE);
        const EGLint a = get(c, EGL_ALPHA_SIZE);
        EXPECT_EQ(get(c, EGL_BUFFER_SIZE),
                  format_info(static_cast<PixelFormat>(get(c, EGL_NATIVE_VISUAL_ID) & 0xFF)).grey
                      ? r
                      : r + g + b + a + get(c, EGL_INDEX_SIZE_SPANGLE));
        EXPECT_TRUE(ids.insert(get(c, EGL_CONFIG_ID)).second);
        EXPECT_EQ(get(c, EGL_COLOR_BUFFER_TYPE),
                  get(c, EGL_INDEX_SIZE_SPANGLE) == 0 ? EGL_RGB_BUFFER : EGL_INDEX_BUFFER_SPANGLE);
        EXPECT_EQ(get(c, EGL_RENDERABLE_TYPE), EGL_OPENGL_BIT);
        EXPECT_NE(get(c, EGL_SURFACE_TYPE) & EGL_PBUFFER_BIT, 0);
        const EGLint samples = get(c, EGL_SAMPLES);
        EXPECT_TRUE(samples == 0 || samples == 4);
        EXPECT_EQ(get(c, EGL_SAMPLE_BUFFERS), samples / 4);
        EXPECT_EQ(get(c, EGL_LUMINANCE_SIZE), 0);
        EXPECT_EQ(get(c, EGL_MAX_PBUFFER_WIDTH), 2048);
        EXPECT_EQ(get(c, EGL_MAX_SWAP_INTERVAL), 1);
        const EGLint stencil = get(c, EGL_STENCIL_SIZE), depth = get(c, EGL_DEPTH_SIZE);
        EXPECT_TRUE(stencil == 0 || (stencil == 8 && depth == 24));
        kinds.insert({r, g, b, a, depth, stencil, samples, get(c, EGL_PRECISION_SPANGLE),
                      get(c, EGL_NATIVE_VISUAL_ID)});
        if ((get(c, EGL_SURFACE_TYPE) & EGL_WINDOW_BIT) != 0) {
            EXPECT_EQ(r, 5); // the panel's own format is the only one
            EXPECT_EQ(get(c, EGL_NATIVE_VISUAL_ID), static_cast<EGLint>(PixelFormat::rgb565_be));
        }
    }
    EXPECT_EQ(kinds.size(), ids.size());
    // Programs and tools of the project rely on these configs.
    for (EGLint precision :
         {EGL_PRECISION_EXACT_SPANGLE, EGL_PRECISION_BALANCED_SPANGLE, EGL_PRECISION_FAST_SPANGLE}) {
        EXPECT_FALSE(choose({EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_DEPTH_SIZE, 16, EGL_PRECISION_SPANGLE,
                             precision, EGL_NONE})
                         .empty());
        EXPECT_FALSE(choose({EGL_SURFACE_TYPE,
                             EGL_PBUFFER_BIT,
                             EGL_RED_SIZE,
                             8,
                             EGL_GREEN_SIZE,
                             8,
                             EGL_BLUE_SIZE,
                             8,
                             EGL_ALPHA_SIZE,
                             8,
                             EGL_DEPTH_SIZE,
                             24,
                             EGL_STENCIL_SIZE,
                             1,
                             EGL_BUFFER_SIZE,
                             32,
                             EGL_RENDERABLE_TYPE,
                             EGL_OPENGL_BIT,
                             EGL_PRECISION_SPANGLE,
                             precision,
                             EGL_NONE})
                         .empty());
    }
}

TEST_F(Configs, FirstChoicesAreTheSmallestThatDo) {
    const struct {
        std::vector<EGLint> wishes;
        EGLint red, alpha, depth, stencil;
    } cases[] = {
        {{EGL_NONE}, 5, 0, 0, 0},
        {{EGL_DEPTH_SIZE, 1, EGL_NONE}, 5, 0, 16, 0},
        {{EGL_DEPTH_SIZE, 17, EGL_NONE}, 5, 0, 24, 8},
        {{EGL_STENCIL_SIZE, 1, EGL_NONE}, 5, 0, 24, 8},
        {{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE}, 5, 0, 0, 0},
        // Configs are sorted first by the number of colour bits that are asked for (EGL 1.4, 3.4.1.2, rule
        // 3).
        {{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RED_SIZE, 1, EGL_NONE}, 8, 0, 0, 0},
        {{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_ALPHA_SIZE, 1, EGL_NONE}, 8, 8, 0, 0},
        {{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_BUFFER_SIZE, 17, EGL_NONE}, 8, 0, 0, 0},
        {{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_BUFFER_SIZE, 25, EGL_DEPTH_SIZE, 24, EGL_NONE}, 8, 8, 24, 8},
        {{EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_NONE}, 5, 0, 0, 0},
    };
    for (const auto& c : cases) {
        const auto found = choose(c.wishes);
        ASSERT_FALSE(found.empty()) << &c - cases;
        EXPECT_EQ(get(found[0], EGL_RED_SIZE), c.red) << &c - cases;
        EXPECT_EQ(get(found[0], EGL_ALPHA_SIZE), c.alpha) << &c - cases;
        EXPECT_EQ(get(found[0], EGL_DEPTH_SIZE), c.depth) << &c - cases;
        EXPECT_EQ(get(found[0], EGL_STENCIL_SIZE), c.stencil) << &c - cases;
        EXPECT_EQ(get(found[0], EGL_PRECISION_SPANGLE), EGL_PRECISION_EXACT_SPANGLE);
    }
}

TEST_F(Configs, NothingMatchesWhatDoesNotExist) {
    for (const std::vector<EGLint>& wishes :
         std::vector<std::vector<EGLint>>{{EGL_RED_SIZE, 9, EGL_NONE},
                                          {EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_ALPHA_SIZE, 8, EGL_NONE},
                                          {EGL_SURFACE_TYPE, EGL_PIXMAP_BIT, EGL_NONE},
                                          {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES_BIT, EGL_NONE},
                                          {EGL_SAMPLES, 5, EGL_NONE},
                                          {EGL_LEVEL, 1, EGL_NONE},
                                          {EGL_COLOR_BUFFER_TYPE, EGL_LUMINANCE_BUFFER, EGL_NONE},
                                          {EGL_CONFIG_CAVEAT, EGL_SLOW_CONFIG, EGL_NONE},
                                          {EGL_CONFIG_ID, 100000, EGL_NONE}})
        EXPECT_TRUE(choose(wishes).empty()) << std::hex << wishes[0];
}

/// Without a wish the renderable type is OpenGL ES (EGL 1.4, table 3.4), and no config here supports it.
TEST_F(Configs, WhoeverDoesNotAskForOpenGLAsksForOpenGLES) {
    static std::string told;
    on_message([](unsigned, const char* text) { told = text; });
    const EGLint empty[] = {EGL_NONE}, depth[] = {EGL_DEPTH_SIZE, 16, EGL_NONE},
                 any[] = {EGL_RENDERABLE_TYPE, EGL_DONT_CARE, EGL_NONE},
                 both[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT | EGL_OPENGL_ES_BIT, EGL_NONE};
    EXPECT_TRUE(choose_of(nullptr).empty());
    EXPECT_NE(told.find("EGL_OPENGL_BIT"), std::string::npos); // the message names the bit
    EXPECT_TRUE(choose_of(empty).empty());
    EXPECT_TRUE(choose_of(depth).empty());
    EXPECT_TRUE(choose_of(both).empty());
    told.clear();
    EXPECT_EQ(choose_of(any), choose({EGL_NONE}));
    EXPECT_FALSE(choose({EGL_NONE}).empty());
    EXPECT_EQ(told, "");
    EXPECT_EQ(eglGetError(), EGL_SUCCESS); // to find no config is not an error
    on_message(nullptr);
}

TEST_F(Configs, AConfigIdDecidesAlone) {
    for (EGLConfig c : all()) {
        const auto found = choose({EGL_CONFIG_ID, get(c, EGL_CONFIG_ID), EGL_RED_SIZE, 31, EGL_NONE});
        ASSERT_EQ(found.size(), 1u);
        EXPECT_EQ(found[0], c);
    }
}

/// Compares the answers to random wishes with a plain reading of the tables over the values of
/// eglGetConfigAttrib.
TEST_F(Configs, RandomWishesMatchAndSort) {
    std::mt19937 random(5);
    const EGLint sizes[] = {EGL_RED_SIZE,   EGL_GREEN_SIZE,   EGL_BLUE_SIZE,   EGL_ALPHA_SIZE,
                            EGL_DEPTH_SIZE, EGL_STENCIL_SIZE, EGL_BUFFER_SIZE, EGL_SAMPLES};
    const EGLint values[] = {0, 1, 5, 6, 8, 16, 24, 32, EGL_DONT_CARE, 4};
    for (int round = 0; round < 2000; ++round) {
        std::vector<EGLint> wishes = {EGL_SURFACE_TYPE,
                                      (random() & 1) != 0 ? EGL_PBUFFER_BIT : EGL_WINDOW_BIT};
        for (EGLint size : sizes)
            if (random() % 4 == 0)
                wishes.insert(wishes.end(), {size, values[random() % 10]});
        if (random() % 3 == 0)
            wishes.insert(wishes.end(), {EGL_PRECISION_SPANGLE,
                                         EGL_PRECISION_EXACT_SPANGLE + static_cast<EGLint>(random() % 3)});
        const bool any_type = random() % 4 == 0;
        const EGLint type = random() % 2 == 0 ? EGL_INDEX_BUFFER_SPANGLE : EGL_DONT_CARE;
        if (any_type)
            wishes.insert(wishes.end(), {EGL_COLOR_BUFFER_TYPE, type});
        wishes.push_back(EGL_NONE);
        std::vector<EGLConfig> wanted;
        for (EGLConfig c : all()) {
            bool good = any_type || get(c, EGL_COLOR_BUFFER_TYPE) == EGL_RGB_BUFFER;
            for (std::size_t i = 0; wishes[i] != EGL_NONE; i += 2) {
                const EGLint has = get(c, wishes[i]), wish = wishes[i + 1];
                if (wish == EGL_DONT_CARE)
                    continue;
                good = good && (wishes[i] == EGL_SURFACE_TYPE        ? (has & wish) == wish
                                : wishes[i] == EGL_PRECISION_SPANGLE ? has == wish
                                : wishes[i] == EGL_COLOR_BUFFER_TYPE ? has == wish
                                                                     : has >= wish);
            }
            if (good)
                wanted.push_back(c);
        }
        const auto asked_bits = [&](EGLConfig c) {
            EGLint bits = 0;
            for (std::size_t i = 0; wishes[i] != EGL_NONE; i += 2)
                if (std::find(sizes, sizes + 4, wishes[i]) != sizes + 4 && wishes[i + 1] > 0)
                    bits += get(c, wishes[i]);
            return bits;
        };
        const auto found = choose(wishes);
        ASSERT_TRUE(std::is_permutation(found.begin(), found.end(), wanted.begin(), wanted.end())) << round;
        for (std::size_t i = 1; i < found.size(); ++i) {
            const auto key = [&](EGLConfig c) {
                return std::vector<EGLint>{get(c, EGL_CONFIG_CAVEAT) == EGL_SLOW_CONFIG,
                                           -asked_bits(c),
                                           get(c, EGL_BUFFER_SIZE),
                                           get(c, EGL_SAMPLES),
                                           get(c, EGL_DEPTH_SIZE),
                                           get(c, EGL_STENCIL_SIZE)};
            };
            ASSERT_LE(key(found[i - 1]), key(found[i])) << round;
        }
    }
}

TEST_F(Configs, Errors) {
    EGLint n = 77, value = 77;
    const auto refused = [&](EGLBoolean result, EGLint error) {
        EXPECT_EQ(result, EGLBoolean{EGL_FALSE});
        EXPECT_EQ(eglGetError(), error);
        EXPECT_EQ(eglGetError(), EGL_SUCCESS);
        EXPECT_EQ(n, 77);
        EXPECT_EQ(value, 77);
    };
    const EGLint unknown[] = {0x1234, 1, EGL_NONE}, below[] = {EGL_RED_SIZE, -2, EGL_NONE},
                 level[] = {EGL_LEVEL, EGL_DONT_CARE, EGL_NONE};
    const EGLConfig good = all()[0];
    refused(eglGetConfigs(display, nullptr, 0, nullptr), EGL_BAD_PARAMETER);
    refused(eglChooseConfig(display, nullptr, nullptr, 0, nullptr), EGL_BAD_PARAMETER);
    refused(eglChooseConfig(display, unknown, nullptr, 0, &n), EGL_BAD_ATTRIBUTE);
    refused(eglChooseConfig(display, below, nullptr, 0, &n), EGL_BAD_ATTRIBUTE);
    refused(eglChooseConfig(display, level, nullptr, 0, &n), EGL_BAD_ATTRIBUTE);
    refused(eglGetConfigAttrib(display, good, 0x1234, &value), EGL_BAD_ATTRIBUTE);
    refused(eglGetConfigAttrib(display, good, EGL_MATCH_NATIVE_PIXMAP, &value), EGL_BAD_ATTRIBUTE);
    refused(eglGetConfigAttrib(display, good, EGL_RED_SIZE, nullptr), EGL_BAD_PARAMETER);
    for (std::uintptr_t garbage : {std::uintptr_t{0}, std::uintptr_t{5000}, ~std::uintptr_t{0}})
        refused(eglGetConfigAttrib(display, reinterpret_cast<EGLConfig>(garbage), EGL_RED_SIZE, &value),
                EGL_BAD_CONFIG);
    for (EGLDisplay garbage : {EGLDisplay{nullptr}, EGLDisplay{&n}}) {
        refused(eglGetConfigs(garbage, nullptr, 0, &n), EGL_BAD_DISPLAY);
        refused(eglChooseConfig(garbage, nullptr, nullptr, 0, &n), EGL_BAD_DISPLAY);
        refused(eglGetConfigAttrib(garbage, good, EGL_RED_SIZE, &value), EGL_BAD_DISPLAY);
    }
}

TEST_F(Configs, SmallArraysTakeWhatFits) {
    EGLConfig out[3] = {nullptr, nullptr, &panel};
    EGLint n = 0;
    ASSERT_EQ(eglGetConfigs(display, out, 2, &n), EGLBoolean{EGL_TRUE});
    EXPECT_EQ(n, 2);
    EXPECT_EQ(out[2], &panel);
    const EGLint wish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    ASSERT_EQ(eglChooseConfig(display, wish, out, 1, &n), EGLBoolean{EGL_TRUE});
    EXPECT_EQ(n, 1);
    ASSERT_EQ(eglChooseConfig(display, wish, nullptr, 0, &n), EGLBoolean{EGL_TRUE});
    EXPECT_GT(n, 2); // the number of configs
}

/// A program may pass any number as a handle. Only those of configs are accepted.
TEST_F(Configs, NumbersThatAreNoConfigs) {
    const auto handle = [](std::uintptr_t number) { return reinterpret_cast<EGLConfig>(number); };
    const std::vector<EGLConfig> configs = all();
    EGLint count = 0;
    constexpr std::uintptr_t edges[] = {0,          0x7FFFFFFF,      0x80000000,          0x80000001,
                                        0xFFFFFFFF, UINTPTR_MAX / 2, UINTPTR_MAX / 2 + 1, UINTPTR_MAX};
    std::vector<EGLConfig> wrong;
    for (const std::uintptr_t edge : edges)
        for (std::uintptr_t near = edge - 3; near != edge + 4; ++near)
            wrong.push_back(handle(near));
    for (const EGLConfig good : configs)
        for (const std::uintptr_t bit : {std::uintptr_t{1} << 31, ~(UINTPTR_MAX >> 1), UINTPTR_MAX / 4 + 1})
            wrong.push_back(handle(reinterpret_cast<std::uintptr_t>(good) | bit));
    for (const EGLConfig config : wrong) {
        if (std::find(configs.begin(), configs.end(), config) != configs.end())
            continue;
        EGLint value = 0;
        EXPECT_EQ(eglGetConfigAttrib(display, config, EGL_CONFIG_ID, &value), EGLBoolean{EGL_FALSE})
            << config;
        EXPECT_EQ(eglGetError(), EGL_BAD_CONFIG);
        EXPECT_EQ(eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr), EGL_NO_CONTEXT);
        EXPECT_EQ(eglGetError(), EGL_BAD_CONFIG);
        EXPECT_EQ(eglCreatePbufferSurface(display, config, nullptr), EGL_NO_SURFACE);
        EXPECT_EQ(eglGetError(), EGL_BAD_CONFIG);
        EXPECT_EQ(eglCreateWindowSurface(display, config, 0, nullptr), EGL_NO_SURFACE);
        EXPECT_EQ(eglGetError(), EGL_BAD_CONFIG);
        const EGLint by_id[] = {EGL_CONFIG_ID, static_cast<EGLint>(reinterpret_cast<std::uintptr_t>(config)),
                                EGL_NONE};
        (void)eglChooseConfig(display, by_id, nullptr, 0, &count);
    }
}

/// Whatever a list wishes for, the result is an error or an object, without undefined behaviour.
TEST_F(Configs, AnyWishOfAnyAttribute) {
    constexpr EGLint values[] = {INT_MIN, INT_MIN + 1, -65536, -2,    -1,          0,
                                 1,       8,           32767,  65536, INT_MAX - 1, INT_MAX};
    std::vector<EGLConfig> room = all();
    EGLint count = 0;
    const EGLConfig config = room.front();
    const std::size_t before = memory_use().used;
    std::vector<EGLint> names;
    for (EGLint name = 0x3020; name < 0x30C0; ++name)
        names.push_back(name);
    names.insert(names.end(), {EGL_PRECISION_SPANGLE, EGL_ACCUM_SIZE_SPANGLE, EGL_BAND_HEIGHT_SPANGLE,
                               EGL_BAND_RECORD_SPANGLE, EGL_INDEX_SIZE_SPANGLE, INT_MIN, -1, INT_MAX});
    for (const EGLint name : names)
        for (const EGLint value : values) {
            if (name == EGL_NONE)
                continue;
            const EGLint list[] = {name, value, EGL_NONE};
            (void)eglChooseConfig(display, list, room.data(), value, &count);
            for (const EGLSurface surface : {eglCreatePbufferSurface(display, config, list),
                                             eglCreateWindowSurface(display, config, 0, list)})
                if (surface != EGL_NO_SURFACE) {
                    EXPECT_EQ(eglDestroySurface(display, surface), EGLBoolean{EGL_TRUE});
                }
            if (const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, list);
                context != EGL_NO_CONTEXT) {
                EXPECT_EQ(eglDestroyContext(display, context), EGLBoolean{EGL_TRUE});
            }
            (void)eglSwapInterval(display, value);
            (void)eglQueryString(display, value);
            (void)eglGetCurrentSurface(value);
            (void)eglWaitNative(value);
            EGLint out = 0;
            (void)eglGetConfigAttrib(display, config, value, &out);
        }
    EXPECT_EQ(memory_use().used, before);
}

} // namespace
} // namespace spangle::test
