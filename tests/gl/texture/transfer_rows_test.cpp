// Compares the pixel transfer of rectangles, whose rows may be converted at once, with that of single pixels.
#include <functional>
#include <vector>

#include "gl/context/features.hpp"
#include "tests/gl/texture/drawing.hpp"
#include "tests/support/random.hpp"

#if SPANGLE_FEATURE_PIXEL_TRANSFER

namespace {

struct TransferredRows : spangle::test::Drawing {
    static constexpr int side = 4;
    using Bytes = std::vector<GLubyte>;

    TransferredRows() {
        spangle::test::Random random{5};
        for (std::size_t i = 0; i < std::size_t{side} * side * 4; ++i)
            pixels.push_back(static_cast<GLubyte>(random.below(256)));
    }
    static void set_transfer(bool on) {
        glPixelTransferf(GL_RED_SCALE, on ? 0.5f : 1);
        glPixelTransferf(GL_GREEN_BIAS, on ? 0.25f : 0);
        glPixelTransferf(GL_BLUE_SCALE, on ? 2.0f : 1);
    }
    static Bytes texels() {
        Bytes out(std::size_t{side} * side * 4);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, out.data());
        return out;
    }
    static void empty_texture() {
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    }
    /// Calls `one` for every pixel.
    static void each(const std::function<void(int x, int y, std::size_t at)>& one) {
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                one(x, y, static_cast<std::size_t>(y * side + x) * 4);
    }
    void paint() const {
        glDisable(GL_TEXTURE_2D);
        glDisable(GL_DITHER);
        glWindowPos2i(0, 0);
        glDrawPixels(side, side, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    }

    Bytes pixels;
};

TEST_F(TransferredRows, OfTexImage) {
    set_transfer(true);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    set_transfer(false);
    const Bytes whole = texels();
    empty_texture();
    set_transfer(true);
    each([&](int x, int y, std::size_t at) {
        glTexSubImage2D(GL_TEXTURE_2D, 0, x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data() + at);
    });
    set_transfer(false);
    EXPECT_EQ(whole, texels());
    EXPECT_NE(whole, pixels);
}

/// GetTexImage performs no pixel transfer operations (GL 1.3, 6.1.4).
TEST_F(TransferredRows, AreNotOfGetTexImage) {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    set_transfer(true);
    const Bytes whole = texels();
    set_transfer(false);
    EXPECT_EQ(whole, pixels);
}

TEST_F(TransferredRows, OfReadPixels) {
    paint();
    Bytes plain(pixels.size()), whole(pixels.size());
    glReadPixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, plain.data());
    set_transfer(true);
    glReadPixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, whole.data());
    each([&](int x, int y, std::size_t at) {
        GLubyte one[4];
        glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, one);
        for (std::size_t c = 0; c < 4; ++c)
            EXPECT_EQ(whole[at + c], one[c]) << x << " " << y << " " << c;
    });
    set_transfer(false);
    EXPECT_NE(whole, plain);
}

TEST_F(TransferredRows, OfCopyTexImage) {
    paint();
    set_transfer(true);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, side, side, 0);
    set_transfer(false);
    const Bytes whole = texels();
    empty_texture();
    set_transfer(true);
    each([](int x, int y, std::size_t) { glCopyTexSubImage2D(GL_TEXTURE_2D, 0, x, y, x, y, 1, 1); });
    set_transfer(false);
    EXPECT_EQ(whole, texels());
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, side, side, 0);
    EXPECT_NE(whole, texels());
}

TEST_F(TransferredRows, OfDrawPixelsAndCopyPixels) {
    for (const bool copies : {false, true}) {
        const auto draw = [&](int x, int y, int size, std::size_t at) {
            glWindowPos2i(x, y);
            if (copies)
                glCopyPixels(x, y, size, size, GL_COLOR);
            else
                glDrawPixels(size, size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data() + at);
        };
        Bytes plain(pixels.size()), whole(pixels.size()), single(pixels.size());
        paint();
        glReadPixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, plain.data());
        set_transfer(true);
        draw(0, 0, side, 0);
        set_transfer(false);
        glReadPixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, whole.data());
        paint();
        set_transfer(true);
        each([&](int x, int y, std::size_t at) { draw(x, y, 1, at); });
        set_transfer(false);
        glReadPixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, single.data());
        EXPECT_EQ(whole, single) << copies;
        EXPECT_NE(whole, plain) << copies;
    }
}

} // namespace

#endif
