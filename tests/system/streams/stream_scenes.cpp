// Sets states in which programs draw.
#include "tests/system/streams/stream_scenes.hpp"

#include <iterator>

#include <spangle/GL/gl.h>

namespace spangle::test {
namespace {

constexpr GLenum compares[] = {GL_LESS,   GL_LEQUAL,   GL_ALWAYS, GL_GREATER,
                               GL_GEQUAL, GL_NOTEQUAL, GL_EQUAL,  GL_NEVER};
constexpr GLenum factors[] = {GL_ONE,
                              GL_ZERO,
                              GL_SRC_ALPHA,
                              GL_ONE_MINUS_SRC_ALPHA,
                              GL_DST_ALPHA,
                              GL_ONE_MINUS_DST_ALPHA,
                              GL_DST_COLOR,
                              GL_ONE_MINUS_DST_COLOR,
                              GL_SRC_COLOR,
                              GL_ONE_MINUS_SRC_COLOR,
                              GL_SRC_ALPHA_SATURATE,
                              GL_CONSTANT_COLOR,
                              GL_ONE_MINUS_CONSTANT_ALPHA};
constexpr GLenum planes[] = {GL_CLIP_PLANE0, GL_CLIP_PLANE1, GL_CLIP_PLANE5};

} // namespace

int Scenes::one(unsigned number) {
    struct Entry {
        Piece piece;
        int cost; ///< how often it may touch each pixel
    };
    static constexpr Entry entries[] = {
        {&Scenes::plain, 0},
        {&Scenes::camera, 0},
        {&Scenes::view, 0},
        {&Scenes::fragments, 0},
        {&Scenes::fragments, 0},
        {&Scenes::lights, 0},
        {&Scenes::texture, 0},
        {&Scenes::texture, 0},
        {&Scenes::environment, 0},
        {&Scenes::vertices, 3},
        {&Scenes::vertices, 3},
        {&Scenes::blit, 2},
        {&Scenes::arrays, 4},
        {&Scenes::arrays, 4},
        {&Scenes::buffers, 4},
        {&Scenes::images, 2},
        {&Scenes::copies, 2},
        {&Scenes::clears, 2},
        {&Scenes::lists, 6},
        {&Scenes::curves, 4},
        {&Scenes::answers, 3},
        {&Scenes::stacks, 0},
        {&Scenes::generated_coordinates, 0},
        {&Scenes::questions, 0},
        {&Scenes::usual, 4},
        {&Scenes::usual, 4},
        {&Scenes::usual, 4},
    };
    const Entry& entry = entries[number % std::size(entries)];
    (this->*entry.piece)();
    return entry.cost;
}

/// Sets a state in which drawing is visible, whatever was set before.
void Scenes::plain() {
    if (in_.byte() % 2 != 0) {
        glEnd();
        glEndList();
    }
    for (const GLenum cap :
         {GL_ALPHA_TEST, GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_FOG, GL_LIGHTING, GL_SCISSOR_TEST,
          GL_STENCIL_TEST, GL_COLOR_LOGIC_OP, GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D,
          GL_TEXTURE_CUBE_MAP, GL_CLIP_PLANE0, GL_CLIP_PLANE1, GL_CLIP_PLANE5, GL_POLYGON_STIPPLE})
        glDisable(cap);
    glRenderMode(GL_RENDER);
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, width_, 0, height_, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glViewport(0, 0, width_, height_);
    glDepthRange(0, 1);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glStencilMask(0xFF);
    glIndexMask(0xFF);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glDrawBuffer(in_.byte() % 8 != 0 ? GL_BACK : GL_FRONT);
    reset_pixel_store();
}

void Scenes::camera() {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    const double near_plane = in_.byte() % 8 == 0 ? 1e-6 : 0.5 + in_.byte() % 4;
    if (in_.byte() % 4 != 0)
        glFrustum(-1, 1, -1, 1, near_plane, near_plane + 1 + in_.byte() * 8.0);
    else
        glOrtho(-2, 2, 2, -2, -near_plane, 100);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(unit_number(in_), unit_number(in_), -3 + unit_number(in_));
    glRotatef(static_cast<float>(in_.byte()), unit_number(in_), unit_number(in_), unit_number(in_));
    const float scale = in_.byte() % 8 == 0 ? odd_number(in_) : 1 + unit_number(in_);
    glScalef(scale / static_cast<float>(width_), scale / static_cast<float>(height_), scale);
}

/// Sets viewports and scissors of a part of the surface, and beyond it.
void Scenes::view() {
    const auto place = [&](std::int32_t all) { return whole_coordinate(in_, all / 2 + 1); };
    const auto side = [&](std::int32_t all) {
        const GLint size = place(2 * all);
        return size < 0 && size > -5000 ? -size : size;
    };
    if (in_.byte() % 2 != 0)
        glViewport(place(width_), place(height_), side(width_), side(height_));
    if (in_.byte() % 2 != 0) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(place(width_), place(height_), side(width_), side(height_));
    }
    if (in_.byte() % 4 == 0)
        glDepthRange(unit_number(in_), unit_number(in_));
    if (in_.byte() % 4 == 0) {
        const GLdouble plane[] = {unit_number(in_), unit_number(in_), unit_number(in_), unit_number(in_)};
        const GLenum which = pick(in_, planes);
        glClipPlane(which, plane);
        glEnable(which);
    }
}

void Scenes::fragments() {
    const auto turn = [&](GLenum cap) { in_.byte() % 4 != 0 ? glEnable(cap) : glDisable(cap); };
    for (unsigned left = 1 + pick(in_, 3); left > 0; --left)
        switch (pick(in_, 20)) {
        case 0:
            turn(GL_BLEND);
            glBlendFunc(pick(in_, factors), pick(in_, factors));
            break;
        case 1:
            glBlendEquation(
                pick(in_, {GL_FUNC_ADD, GL_MIN, GL_MAX, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT}));
            glBlendColor(unit_number(in_), unit_number(in_), unit_number(in_), unit_number(in_));
            break;
        case 2:
            turn(GL_ALPHA_TEST);
            glAlphaFunc(pick(in_, compares), unit_number(in_));
            break;
        case 3:
        case 4:
            turn(GL_DEPTH_TEST);
            glDepthFunc(pick(in_, compares));
            glDepthMask(in_.byte() % 4 != 0);
            break;
        case 5: {
            turn(GL_STENCIL_TEST);
            glStencilFunc(pick(in_, compares), in_.byte(), in_.byte());
            const auto op = [&] {
                return pick(in_, {GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP,
                                  GL_DECR_WRAP});
            };
            const GLenum fail = op(), depth_fail = op();
            glStencilOp(fail, depth_fail, op());
            break;
        }
        case 6: {
            turn(GL_FOG);
            glFogi(GL_FOG_MODE, static_cast<GLint>(pick(in_, {GL_LINEAR, GL_EXP, GL_EXP2})));
            glFogf(GL_FOG_START, unit_number(in_));
            glFogf(GL_FOG_END, unit_number(in_));
            glFogf(GL_FOG_DENSITY, unit_number(in_));
            glFogi(GL_FOG_COORD_SRC, static_cast<GLint>(pick(in_, {GL_FRAGMENT_DEPTH, GL_FOG_COORD})));
            break;
        }
        case 7:
            turn(pick(in_, {GL_COLOR_LOGIC_OP, GL_INDEX_LOGIC_OP}));
            glLogicOp(GL_CLEAR + pick(in_, 16));
            break;
        case 8:
            glColorMask(in_.byte() % 2, in_.byte() % 2, in_.byte() % 2, in_.byte() % 2);
            break;
        case 9:
            turn(pick(in_, {GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT}));
            glPolygonOffset(unit_number(in_), unit_number(in_));
            break;
        case 10:
            turn(pick(in_, {GL_LINE_SMOOTH, GL_POINT_SMOOTH, GL_POLYGON_SMOOTH}));
            glLineWidth(1 + static_cast<float>(in_.byte()) / 16);
            glPointSize(1 + static_cast<float>(in_.byte()) / 8);
            break;
        case 11:
            turn(GL_LINE_STIPPLE);
            glLineStipple(in_.byte(), static_cast<GLushort>(in_.byte() * 257));
            break;
        case 12:
            turn(GL_POLYGON_STIPPLE);
            // Rows of 32 bits lie as the pixel store says (GL 1.3, 3.6.4), which an image before may have
            // changed.
            reset_pixel_store();
            glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
            glPolygonStipple(memory_.make(room(31 * 8 + 4)));
            break;
        case 13:
            turn(GL_CULL_FACE);
            glCullFace(pick(in_, {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}));
            glFrontFace(pick(in_, {GL_CW, GL_CCW}));
            break;
        case 14:
            glPolygonMode(pick(in_, {GL_FRONT_AND_BACK, GL_FRONT, GL_BACK}),
                          pick(in_, {GL_FILL, GL_LINE, GL_POINT}));
            break;
        case 15:
            glShadeModel(pick(in_, {GL_SMOOTH, GL_FLAT}));
            turn(GL_DITHER);
            break;
        case 16:
            glHint(pick(in_, {GL_PERSPECTIVE_CORRECTION_HINT, GL_FOG_HINT, GL_POINT_SMOOTH_HINT}),
                   pick(in_, {GL_FASTEST, GL_NICEST, GL_DONT_CARE}));
            break;
        case 17:
            turn(pick(in_, {GL_MULTISAMPLE, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE,
                            GL_SAMPLE_COVERAGE}));
            glSampleCoverage(unit_number(in_), in_.byte() % 2);
            break;
        case 18:
            turn(GL_POINT_SPRITE);
            glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, in_.byte() % 2);
            glPointParameterf(pick(in_, {GL_POINT_SIZE_MIN, GL_POINT_SIZE_MAX, GL_POINT_FADE_THRESHOLD_SIZE}),
                              unit_number(in_) * 20);
            break;
        default:
            turn(GL_COLOR_SUM);
            glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                          static_cast<GLint>(pick(in_, {GL_SINGLE_COLOR, GL_SEPARATE_SPECULAR_COLOR})));
        }
}

void Scenes::lights() {
    in_.byte() % 4 != 0 ? glEnable(GL_LIGHTING) : glDisable(GL_LIGHTING);
    const GLenum light = GL_LIGHT0 + pick(in_, 8);
    glEnable(light);
    const auto four = [&](auto set, GLenum target, GLenum name) {
        const GLfloat values[] = {unit_number(in_), unit_number(in_), unit_number(in_), unit_number(in_)};
        set(target, name, values);
    };
    for (const GLenum name : {GL_POSITION, GL_DIFFUSE, GL_SPECULAR, GL_SPOT_DIRECTION})
        if (in_.byte() % 2 != 0)
            four(glLightfv, light, name);
    if (in_.byte() % 2 != 0)
        glLightf(light, GL_SPOT_CUTOFF, in_.byte() % 2 != 0 ? 180 : static_cast<float>(in_.byte() % 91));
    if (in_.byte() % 2 != 0)
        glLightf(light,
                 pick(in_, {GL_SPOT_EXPONENT, GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION,
                            GL_QUADRATIC_ATTENUATION}),
                 static_cast<float>(in_.byte()) / 16);
    const GLenum face = pick(in_, {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK});
    four(glMaterialfv, face, pick(in_, {GL_DIFFUSE, GL_SPECULAR, GL_AMBIENT, GL_EMISSION}));
    glMaterialf(face, GL_SHININESS, static_cast<float>(in_.byte() % 129));
    glLightModeli(pick(in_, {GL_LIGHT_MODEL_TWO_SIDE, GL_LIGHT_MODEL_LOCAL_VIEWER}), in_.byte() % 2);
    const GLenum cap = pick(in_, {GL_NORMALIZE, GL_RESCALE_NORMAL, GL_COLOR_MATERIAL});
    in_.byte() % 2 != 0 ? glEnable(cap) : glDisable(cap);
}

void Scenes::environment() {
    glActiveTexture(GL_TEXTURE0 + pick(in_, 2));
    glTexEnvi(
        GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
        static_cast<GLint>(pick(in_, {GL_MODULATE, GL_REPLACE, GL_DECAL, GL_BLEND, GL_ADD, GL_COMBINE})));
    const GLenum names[] = {GL_COMBINE_RGB,  GL_COMBINE_ALPHA,  GL_SOURCE0_RGB,  GL_SOURCE1_RGB,
                            GL_SOURCE2_RGB,  GL_SOURCE0_ALPHA,  GL_OPERAND0_RGB, GL_OPERAND1_RGB,
                            GL_OPERAND2_RGB, GL_OPERAND0_ALPHA, GL_RGB_SCALE,    GL_ALPHA_SCALE};
    const GLenum values[] = {GL_REPLACE,
                             GL_MODULATE,
                             GL_ADD,
                             GL_ADD_SIGNED,
                             GL_INTERPOLATE,
                             GL_SUBTRACT,
                             GL_DOT3_RGB,
                             GL_DOT3_RGBA,
                             GL_TEXTURE,
                             GL_CONSTANT,
                             GL_PREVIOUS,
                             GL_PRIMARY_COLOR,
                             GL_SRC_COLOR,
                             GL_SRC_ALPHA,
                             GL_ONE_MINUS_SRC_COLOR,
                             GL_ONE_MINUS_SRC_ALPHA,
                             1,
                             2,
                             4,
                             GL_TEXTURE0};
    for (int i = 0; i < 6; ++i)
        glTexEnvi(GL_TEXTURE_ENV, pick(in_, names), static_cast<GLint>(pick(in_, values)));
    const GLfloat color[] = {unit_number(in_), unit_number(in_), unit_number(in_), unit_number(in_)};
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
    glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, unit_number(in_));
}

void Scenes::generated_coordinates() {
    glActiveTexture(GL_TEXTURE0 + pick(in_, 2));
    for (const GLenum axis : {GL_S, GL_T, GL_R, GL_Q}) {
        const GLenum cap = GL_TEXTURE_GEN_S + (axis - GL_S);
        in_.byte() % 3 != 0 ? glEnable(cap) : glDisable(cap);
        glTexGeni(axis, GL_TEXTURE_GEN_MODE,
                  static_cast<GLint>(pick(in_, {GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP,
                                                GL_REFLECTION_MAP, GL_NORMAL_MAP})));
        const GLfloat plane[] = {unit_number(in_), unit_number(in_), unit_number(in_), unit_number(in_)};
        glTexGenfv(axis, pick(in_, {GL_OBJECT_PLANE, GL_EYE_PLANE}), plane);
    }
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    if (in_.byte() % 2 != 0)
        glScalef(unit_number(in_) * 8, unit_number(in_) * 8, unit_number(in_));
    glMatrixMode(GL_MODELVIEW);
}

void Scenes::stacks() {
    switch (pick(in_, 6)) {
    case 0:
        return glPushAttrib(in_.byte() % 2 != 0 ? GL_ALL_ATTRIB_BITS : in_.word());
    case 1:
        return glPopAttrib();
    case 2:
        return glPushMatrix();
    case 3:
        return glPopMatrix();
    case 4:
        return glMatrixMode(pick(in_, {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}));
    default: {
        GLfloat m[16];
        for (float& element : m)
            element = unit_number(in_);
        glMultMatrixf(m);
    }
    }
}

} // namespace spangle::test
