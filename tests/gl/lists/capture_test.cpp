// Tests client data in display lists: images under every pixel storage, and interleaved arrays.
#include "gl/context/features.hpp"

#include <array>
#include <cstring>
#include <random>

#include "tests/gl/api/recording_context.hpp"

namespace spangle::test {
namespace {

#if SPANGLE_FEATURE_LISTS

class CapturedImages : public RecordingContext {
  protected:
    std::vector<unsigned char> texels() {
        const gl::TextureObject& t = context->texture.bound(0);
        if (t.level[0] == nullptr)
            return {};
        return {t.level[0]->texels, t.level[0]->texels + t.level[0]->bytes};
    }
};

TEST_F(CapturedImages, EqualImmediateOnes) {
    std::vector<std::uint32_t> storage(4096);
    std::mt19937 random(3);
    for (std::uint32_t& word : storage)
        word = random();
    const auto* pixels = reinterpret_cast<const unsigned char*>(storage.data());
    const std::pair<GLenum, GLenum> kinds[] = {
        {GL_RGB, GL_UNSIGNED_BYTE},
        {GL_RGBA, GL_UNSIGNED_BYTE},
        {GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE},
        {GL_ALPHA, GL_UNSIGNED_SHORT},
        {GL_RGB, GL_UNSIGNED_SHORT_5_6_5},
        {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4},
        {GL_BGRA, GL_UNSIGNED_INT_8_8_8_8},
        {GL_RGBA, GL_UNSIGNED_INT},
        {GL_LUMINANCE, GL_BYTE},
        {GL_BGR, GL_UNSIGNED_BYTE},
        {GL_RGB, GL_UNSIGNED_BYTE_3_3_2},
        {GL_RED, GL_SHORT},
    };
    for (const auto& [format, type] : kinds)
        for (int trial = 0; trial < 40; ++trial) {
            const GLsizei width = 1 << random() % 4, height = 1 << random() % 4;
            glPixelStorei(GL_UNPACK_ALIGNMENT, 1 << random() % 4);
            glPixelStorei(GL_UNPACK_ROW_LENGTH,
                          random() % 2 == 0 ? 0 : width + static_cast<GLint>(random() % 5));
            glPixelStorei(GL_UNPACK_SKIP_ROWS, static_cast<GLint>(random() % 3));
            glPixelStorei(GL_UNPACK_SKIP_PIXELS, static_cast<GLint>(random() % 3));
            glPixelStorei(GL_UNPACK_SWAP_BYTES, static_cast<GLint>(random() % 2));
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, format, type, pixels);
            const auto expected = texels();
            ASSERT_FALSE(expected.empty());
            glNewList(1, GL_COMPILE);
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, format, type, pixels);
            glEndList();
            glNewList(2, GL_COMPILE);
            glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, format, type, pixels);
            glEndList();
            const gl::PixelStore store = context->pixel_store.unpack;
            for (GLuint list : {1u, 2u}) {
                const std::uint32_t black[64] = {};
                glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
                glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
                glPixelStorei(GL_UNPACK_SKIP_ROWS, 0);
                glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
                glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, black);
                glPixelStorei(GL_UNPACK_SKIP_ROWS, 1000); // the storage at execution must not matter
                glCallList(list);
                ASSERT_EQ(texels(), expected) << std::hex << format << " " << type << " list " << list;
                EXPECT_EQ(context->pixel_store.unpack.skip_rows, 1000);
            }
            context->pixel_store.unpack = store;
            ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        }
}

TEST_F(CapturedImages, ProxiesAreNotCompiled) {
    glNewList(1, GL_COMPILE);
    glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, 8, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    GLint width = 0;
    glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    EXPECT_EQ(width, 8);
    glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, 1 << 20, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glEndList();
    glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, 16, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glCallList(1);
    glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    EXPECT_EQ(width, 16);
}

TEST_F(CapturedImages, AnImageWithoutPixels) {
    glNewList(1, GL_COMPILE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glEndList();
    glCallList(1);
    GLint width = 0;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    EXPECT_EQ(width, 4);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

#endif

using Interleaved = RecordingContext;

// Interleaved arrays draw the same as the separate pointers of GL 1.3, table 2.5.
TEST_F(Interleaved, EqualsSeparatePointers) {
    struct Row {
        GLenum format;
        int tex, color; // number of components; colour 5 means four bytes
        bool normal;
        int position;
    };
    const Row table[] = {
        {GL_V2F, 0, 0, false, 2},
        {GL_V3F, 0, 0, false, 3},
        {GL_C4UB_V2F, 0, 5, false, 2},
        {GL_C4UB_V3F, 0, 5, false, 3},
        {GL_C3F_V3F, 0, 3, false, 3},
        {GL_N3F_V3F, 0, 0, true, 3},
        {GL_C4F_N3F_V3F, 0, 4, true, 3},
        {GL_T2F_V3F, 2, 0, false, 3},
        {GL_T4F_V4F, 4, 0, false, 4},
        {GL_T2F_C4UB_V3F, 2, 5, false, 3},
        {GL_T2F_C3F_V3F, 2, 3, false, 3},
        {GL_T2F_N3F_V3F, 2, 0, true, 3},
        {GL_T2F_C4F_N3F_V3F, 2, 4, true, 3},
        {GL_T4F_C4F_N3F_V4F, 4, 4, true, 4},
    };
    std::vector<GLfloat> data(400);
    for (std::size_t i = 0; i < data.size(); ++i)
        data[i] = static_cast<GLfloat>(i) * 0.375f;
    for (const Row& row : table)
        for (GLsizei stride : {0, 80}) {
            const auto* at = reinterpret_cast<const unsigned char*>(data.data());
            const int bytes =
                4 * (row.tex + (row.color == 5 ? 1 : row.color) + (row.normal ? 3 : 0) + row.position);
            const GLsizei step = stride != 0 ? stride : bytes;
            const auto toggle = [](GLenum array, bool on) {
                (on ? glEnableClientState : glDisableClientState)(array);
            };
            toggle(GL_TEXTURE_COORD_ARRAY, row.tex != 0);
            toggle(GL_COLOR_ARRAY, row.color != 0);
            toggle(GL_NORMAL_ARRAY, row.normal);
            toggle(GL_VERTEX_ARRAY, true);
            if (row.tex != 0)
                glTexCoordPointer(row.tex, GL_FLOAT, step, at);
            at += 4 * row.tex;
            if (row.color != 0)
                glColorPointer(row.color == 5 ? 4 : row.color, row.color == 5 ? GL_UNSIGNED_BYTE : GL_FLOAT,
                               step, at);
            at += row.color == 5 ? 4 : 4 * row.color;
            if (row.normal)
                glNormalPointer(GL_FLOAT, step, at);
            at += row.normal ? 12 : 0;
            glVertexPointer(row.position, GL_FLOAT, step, at);
            events().clear();
            glDrawArrays(GL_TRIANGLES, 0, 4);
            const auto expected = events();
            // Begins with the opposite state.
            toggle(GL_TEXTURE_COORD_ARRAY, row.tex == 0);
            toggle(GL_COLOR_ARRAY, row.color == 0);
            toggle(GL_NORMAL_ARRAY, !row.normal);
            toggle(GL_VERTEX_ARRAY, false);
            glInterleavedArrays(row.format, stride, data.data());
            EXPECT_EQ(glIsEnabled(GL_COLOR_ARRAY), row.color != 0) << std::hex << row.format;
            EXPECT_EQ(glIsEnabled(GL_NORMAL_ARRAY), row.normal);
            EXPECT_EQ(glIsEnabled(GL_TEXTURE_COORD_ARRAY), row.tex != 0);
            events().clear();
            glDrawArrays(GL_TRIANGLES, 0, 4);
            EXPECT_EQ(events(), expected) << std::hex << row.format << " stride " << stride;
            EXPECT_EQ(events().size(), 6u);
        }
}

} // namespace
} // namespace spangle::test
