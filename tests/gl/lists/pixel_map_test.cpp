// Pixel maps in display lists have the entries of the time when the list was compiled.
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_LISTS && SPANGLE_FEATURE_PIXEL_TRANSFER

#include "tests/gl/api/recording_context.hpp"

namespace spangle::test {
namespace {

class CapturedPixelMaps : public RecordingContext {};

TEST_F(CapturedPixelMaps, KeepTheirEntries) {
    GLfloat reals[3] = {0.25f, 0.5f, 1};
    GLushort shorts[3] = {1, 2, 0xFFFF};
    GLuint words[2] = {7, 0xFFFFFFFF};
    glNewList(1, GL_COMPILE);
    glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 3, reals);
    glPixelMapusv(GL_PIXEL_MAP_A_TO_A, 3, shorts);
    glPixelMapuiv(GL_PIXEL_MAP_I_TO_I, 2, words);
    glPixelTransferf(GL_MAP_COLOR, GL_TRUE);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_R, 3, reals); // a size that is no power of two is an error at execution
    glEndList();
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    GLint size = 0;
    glGetIntegerv(GL_PIXEL_MAP_R_TO_R_SIZE, &size);
    EXPECT_EQ(size, 1);
    reals[0] = reals[1] = reals[2] = 0;
    shorts[1] = 0;
    words[1] = 0;
    glCallList(1);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    GLboolean maps = GL_FALSE;
    glGetBooleanv(GL_MAP_COLOR, &maps);
    EXPECT_EQ(maps, GL_TRUE);
    glGetIntegerv(GL_PIXEL_MAP_R_TO_R_SIZE, &size);
    EXPECT_EQ(size, 3);
    glGetPixelMapfv(GL_PIXEL_MAP_R_TO_R, reals);
    EXPECT_EQ(reals[0], 0.25f);
    EXPECT_EQ(reals[2], 1.0f);
    glGetPixelMapusv(GL_PIXEL_MAP_A_TO_A, shorts);
    EXPECT_EQ(shorts[1], 2);
    glGetPixelMapuiv(GL_PIXEL_MAP_I_TO_I, words);
    EXPECT_EQ(words[1], 0xFFFFFFFFu);
    glBegin(GL_POINTS);
    glCallList(1); // every command in it is refused there
    glEnd();
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    glGetIntegerv(GL_PIXEL_MAP_I_TO_R_SIZE, &size);
    EXPECT_EQ(size, 1);
}

} // namespace
} // namespace spangle::test

#endif
