// Runs with the definitions of a profile. What the profile holds must draw; what it leaves out must be an
// error with a message that names the setting. Prints what is wrong, and then exits with status 1.
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/hal/display.hpp>
#include <spangle/message.hpp>
#include <spangle/native.hpp>
#include <spangle/raster/fragment_state.hpp>

#include "boards/scenes/models/rocket.hpp"
#include "gl/context/features.hpp"
#include "gl/context/limits.hpp"

namespace {

using namespace spangle;

int wrong = 0;
std::string said;

void check(bool good, const char* what) {
    if (good)
        return;
    std::printf("%s (said: %s)\n", what, said.c_str());
    wrong = 1;
}

/// Returns whether this error is pending, and a message holds the word.
bool refused(GLenum code, const char* word) {
    return glGetError() == code && said.find(word) != std::string::npos;
}

EGLint count_configs(EGLDisplay display, std::vector<EGLint> wish) {
    wish.insert(wish.end(), {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE});
    EGLint n = 0;
    eglChooseConfig(display, wish.data(), nullptr, 0, &n);
    return n;
}

/// There must be one config for each precision, format and depth of the build.
void configs(EGLDisplay display) {
    const struct {
        EGLint token;
        raster::Tier tier;
    } tiers[] = {{EGL_PRECISION_EXACT_SPANGLE, raster::Tier::exact},
                 {EGL_PRECISION_BALANCED_SPANGLE, raster::Tier::balanced},
                 {EGL_PRECISION_FAST_SPANGLE, raster::Tier::fast}};
    for (const auto& t : tiers)
        check((count_configs(display, {EGL_PRECISION_SPANGLE, t.token, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT}) >
               0) == raster::has_tier(t.tier),
              "configs of a tier");
    check((count_configs(display, {EGL_DEPTH_SIZE, 24, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT}) > 0) ==
              raster::has_format(DepthFormat::z24s8),
          "configs of 24-bit depth");
    check((count_configs(display, {EGL_RED_SIZE, 8, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT}) > 0) ==
              (raster::has_format(PixelFormat::rgb888) || raster::has_format(PixelFormat::rgba8888)),
          "configs of 8 bits a component");
}

void open(EGLDisplay display) {
    EGLConfig config = nullptr;
    EGLint n = 0;
    const EGLint wish[] = {EGL_SURFACE_TYPE,    EGL_PBUFFER_BIT, EGL_DEPTH_SIZE, 16,
                           EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,  EGL_NONE};
    eglChooseConfig(display, wish, &config, 1, &n);
    const EGLint size[] = {EGL_WIDTH, 64, EGL_HEIGHT, 64, EGL_NONE};
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    check(n == 1 && eglMakeCurrent(display, surface, surface, context) == EGL_TRUE, "a context");
}

void textures() {
    static constexpr GLubyte texel[4] = {1, 2, 3, 4};
    const struct {
        GLint format;
        raster::TexelFormat kept;
    } formats[] = {
        {GL_RGB565, raster::TexelFormat::rgb565},  {GL_RGB8, raster::TexelFormat::rgb888},
        {GL_RGBA8, raster::TexelFormat::rgba8888}, {GL_ALPHA8, raster::TexelFormat::a8},
        {GL_LUMINANCE8, raster::TexelFormat::l8},  {GL_LUMINANCE8_ALPHA8, raster::TexelFormat::la88},
        {GL_RGBA4, raster::TexelFormat::rgba4444}, {GL_RGB5_A1, raster::TexelFormat::rgba5551},
        {GL_R3_G3_B2, raster::TexelFormat::rgb332}};
    for (const auto& f : formats) {
        said.clear();
        glTexImage2D(GL_TEXTURE_2D, 0, f.format, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
        check(raster::has_format(f.kept) ? glGetError() == GL_NO_ERROR
                                         : refused(GL_INVALID_VALUE, "SPANGLE_TEXTURE_FORMATS"),
              "a format of textures");
    }
}

/// Returns the number of pixels that differ from the clear colour.
int drawn() {
    std::vector<GLubyte> pixels(64 * 64 * 3);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, 64, 64, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    int n = 0;
    for (std::size_t i = 3; i < pixels.size(); i += 3)
        n += std::memcmp(&pixels[i], pixels.data(), 3) != 0 ? 1 : 0;
    return n;
}

/// Every profile draws the lit, textured model. Profiles with the chain or its span also draw a flat
/// triangle.
void draws() {
    const baked::Part& part = baked::rocket::parts[0];
    glDisable(GL_DITHER);
    baked::load(baked::rocket::textures[0]);
    baked::scale_texcoords(baked::rocket::mesh);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    if (gl::has_full_lighting)
        glEnable(GL_RESCALE_NORMAL);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    baked::scale_positions(baked::rocket::mesh);
    baked::material(part);
    baked::point_arrays(part);
    baked::draw(part);
    check(glGetError() == GL_NO_ERROR && drawn() > 300, "the model is drawn");

    const auto draw_without_span = [&] {
        said.clear();
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        baked::draw(part);
        if (raster::has_chain)
            check(glGetError() == GL_NO_ERROR && drawn() > 300, "what has no span runs in the chain");
        else
            check(refused(GL_INVALID_OPERATION, "SPANGLE_FUSED") && drawn() == 0,
                  "what has no span is refused");
    };
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    draw_without_span();
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SINGLE_COLOR);
    glDisable(GL_TEXTURE_2D);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    draw_without_span();
}

/// Tests a state for which a build without the chain has no span: it is an error, and nothing is drawn.
template <class Set, class Reset> void needs_chain(const char* what, Set set, Reset reset) {
    if (raster::has_chain)
        return;
    said.clear();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    set();
    baked::draw(baked::rocket::parts[0]);
    check(refused(GL_INVALID_OPERATION, "SPANGLE_FUSED") && drawn() == 0, what);
    reset();
    baked::draw(baked::rocket::parts[0]);
    check(glGetError() == GL_NO_ERROR && drawn() > 300, "the model is drawn again");
}

void states() {
    const auto capability = [](const char* what, GLenum cap) {
        needs_chain(
            what, [cap] { glEnable(cap); }, [cap] { glDisable(cap); });
    };
    const auto parameter = [](const char* what, GLenum name, GLint set, GLint reset) {
        needs_chain(
            what, [=] { glTexParameteri(GL_TEXTURE_2D, name, set); },
            [=] { glTexParameteri(GL_TEXTURE_2D, name, reset); });
    };
    glDisable(GL_BLEND);
    glEnable(GL_TEXTURE_2D);
    glAlphaFunc(GL_LESS, 0.5f);
    glLogicOp(GL_XOR);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    capability("blending", GL_BLEND);
    capability("the test of alpha", GL_ALPHA_TEST);
    capability("logical operations", GL_COLOR_LOGIC_OP);
    capability("dithering", GL_DITHER);
    parameter("clamped coordinates", GL_TEXTURE_WRAP_S, GL_CLAMP, GL_REPEAT);
    parameter("mirrored ones", GL_TEXTURE_WRAP_T, GL_MIRRORED_REPEAT, GL_REPEAT);
    parameter("filtered textures", GL_TEXTURE_MAG_FILTER, GL_LINEAR, GL_NEAREST);
    parameter("mipmaps", GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST);
    const auto environment = [](GLint mode) { glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mode); };
    needs_chain(
        "an environment", [=] { environment(GL_BLEND); }, [=] { environment(GL_MODULATE); });
}

/// Tests the lights and materials that this build leaves out.
void lights() {
    const auto expect = [](bool there, const char* what) {
        check(there ? glGetError() == GL_NO_ERROR : refused(GL_INVALID_OPERATION, "SPANGLE_LIGHT_KINDS"),
              what);
        said.clear();
    };
    said.clear();
    static constexpr GLfloat near[4] = {0, 0, 1, 1}, far[4] = {0, 0, 1, 0}, black[4] = {0, 0, 0, 1};
    glLightfv(GL_LIGHT0, GL_POSITION, near);
    expect(gl::has_local_lights, "lights with a position");
    glLightfv(GL_LIGHT0, GL_POSITION, far);
    expect(true, "far lights");
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 45);
    expect(gl::has_local_lights, "spots");
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 180);
    expect(true, "no spots");
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    expect(gl::has_local_lights, "a local viewer");
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    expect(SPANGLE_TWO_SIDES, "two sides");
    glMaterialfv(GL_FRONT, GL_SPECULAR, near);
    expect(gl::has_specular, "materials that shine");
    glMaterialfv(GL_FRONT, GL_SPECULAR, black);
    expect(true, "materials that do not");
    glEnable(GL_COLOR_MATERIAL);
    expect(gl::has_color_material, "materials that follow colours");
    static constexpr GLfloat bright[4] = {1, 16, 1, 1}, less[4] = {15.9f, -15.9f, 15.9f, 1};
    glLightfv(GL_LIGHT0, GL_DIFFUSE, bright);
    expect(gl::has_full_lighting, "bright lights");
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, bright);
    expect(gl::has_full_lighting, "materials that reflect more than they get");
    glLightfv(GL_LIGHT0, GL_DIFFUSE, less);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, less);
    glMaterialfv(GL_FRONT, GL_EMISSION, bright);
    expect(true, "other lights");
    for (const GLenum lengths : {GL_NORMALIZE, GL_RESCALE_NORMAL}) {
        said.clear();
        glEnable(lengths);
        check(gl::has_full_lighting ? glGetError() == GL_NO_ERROR
                                    : refused(GL_INVALID_OPERATION, "SPANGLE_FULL_LIGHTING"),
              "normals that are given another length");
        if (gl::has_full_lighting)
            glDisable(lengths);
    }
}

void primitives() {
    static constexpr GLshort corner[2] = {};
    glVertexPointer(2, GL_SHORT, 0, corner);
    for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
        const bool there = mode == GL_POINTS       ? gl::has_points
                           : mode <= GL_LINE_STRIP ? gl::has_lines
                                                   : mode < GL_QUADS || gl::has_polygons;
        for (const bool array : {false, true}) {
            said.clear();
            if (array)
                glDrawArrays(mode, 0, 1);
            else
                glBegin(mode);
            check(there ? said.empty() : refused(GL_INVALID_OPERATION, "SPANGLE_PRIMITIVES"),
                  "a kind of primitives");
            if (there && !array)
                glEnd();
            check(glGetError() == GL_NO_ERROR, "primitives that there are");
        }
    }
}

/// Tests arrays whose components have a type that the build leaves out.
void arrays() {
    static constexpr GLdouble nothing[4] = {};
    for (const int name : {GL_BYTE, GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE, GL_FIXED}) {
        const auto type = static_cast<GLenum>(name);
        said.clear();
        glVertexPointer(3, type, 0, nothing);
        check(gl::has_array_type(type) ? glGetError() == GL_NO_ERROR
                                       : refused(GL_INVALID_OPERATION, "SPANGLE_ARRAY_TYPES"),
              "a type of arrays");
    }
}

/// Draws one triangle in a state that every profile draws, between these depths and moved to the right.
bool draws_triangle(GLfloat right, GLfloat first, GLfloat last) {
    const GLfloat corners[3][3] = {
        {right - 0.5f, -0.5f, first}, {right + 0.5f, -0.5f, first}, {right, 0.5f, last}};
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    said.clear();
    glBegin(GL_TRIANGLES);
    for (const GLfloat(&corner)[3] : corners)
        glVertex3fv(corner);
    glEnd();
    return drawn() > 0;
}

/// Tests primitives that a plane of the view volume clips.
void clipping() {
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glEnable(GL_CULL_FACE);
    check(draws_triangle(0, 0, 0.5f) && glGetError() == GL_NO_ERROR, "what is in front of the eye");
    check(draws_triangle(1, 0, 0.5f) && glGetError() == GL_NO_ERROR, "what the window cuts");
    check(!draws_triangle(3, 0, 0.5f) && glGetError() == GL_NO_ERROR, "what is beside the window");
    check(!draws_triangle(0, -2, -3) && glGetError() == GL_NO_ERROR, "what is before the near plane");
    check(draws_triangle(0, 0, -3) == gl::has_clipping, "what crosses the near plane");
    check(gl::has_clipping ? glGetError() == GL_NO_ERROR : refused(GL_INVALID_OPERATION, "SPANGLE_CLIPPING"),
          "clipping");
    check(draws_triangle(0, 0, 3) == gl::has_clipping, "what crosses the far plane");
    check(gl::has_clipping ? glGetError() == GL_NO_ERROR : refused(GL_INVALID_OPERATION, "SPANGLE_CLIPPING"),
          "clipping");
}

/// Tests primitives that are farther away, or have a w or a q of their own.
void perspective() {
    const auto expect = [](bool drawn, const char* what) {
        check(drawn == raster::has_perspective, what);
        check(raster::has_perspective ? glGetError() == GL_NO_ERROR
                                      : refused(GL_INVALID_OPERATION, "SPANGLE_PERSPECTIVE"),
              what);
    };
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-1, 1, -1, 1, 1, 4);
    expect(draws_triangle(0, -2, -3), "a perspective");
    glLoadIdentity();
    glOrtho(-2, 2, -2, 2, -2, 2);
    check(draws_triangle(0, 0.5f, 0.5f) && glGetError() == GL_NO_ERROR, "a parallel projection");
    const GLfloat twice[16] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2};
    glLoadMatrixf(twice);
    expect(draws_triangle(0, 0.5f, 0.5f), "a w of 2");
    const GLfloat more[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1.5f};
    glLoadMatrixf(more);
    expect(draws_triangle(0, 0.5f, 0.5f), "a w of 1.5");
    glLoadIdentity();
    glMatrixMode(GL_TEXTURE);
    glLoadMatrixf(twice);
    expect(draws_triangle(0, 0.5f, 0.5f), "a q of 2");
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
}

/// A panel that asks what was drawn of a frame, or gets all of it.
class Panel final : public hal::Display {
  public:
    explicit Panel(bool asks) : asks_(asks) { extents_.rows = rows_; }
    hal::DisplayInfo info() const override { return {"panel", 16, height, PixelFormat::rgb565_be, true}; }
    hal::Result<void> init() override { return {}; }
    hal::Result<hal::Frame> acquire() override {
        return hal::Frame{pixels_, 32, 0, asks_ ? &extents_ : nullptr};
    }
    hal::Result<void> present() override { return {}; }

  private:
    static constexpr std::int32_t height = 8;
    bool asks_;
    std::uint8_t pixels_[32 * height] = {};
    RowSpan rows_[height];
    RowExtents extents_{nullptr, height, false, 0};
};

void windows() {
    for (const bool asks : {false, true}) {
        Panel panel(asks);
        const EGLDisplay display = eglGetDisplay(native(panel));
        EGLConfig config = nullptr;
        EGLint n = 0;
        const EGLint wish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        check(eglInitialize(display, nullptr, nullptr) == EGL_TRUE &&
                  eglChooseConfig(display, wish, &config, 1, &n) == EGL_TRUE && n == 1,
              "a config of a panel");
        said.clear();
        const bool there = eglCreateWindowSurface(display, config, 0, nullptr) != EGL_NO_SURFACE;
        check(there == (raster::has_extents || !asks), "a window");
        check(there || (eglGetError() == EGL_BAD_MATCH && said.find("SPANGLE_EXTENTS") != std::string::npos),
              "the extents of what is drawn");
        eglTerminate(display);
    }
}

} // namespace

int main() {
    on_message([](unsigned, const char* text) { said = text; });
    const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    eglInitialize(display, nullptr, nullptr);
    configs(display);
    open(display);
    textures();
    draws();
    states();
    clipping();
    perspective();
    arrays();
    primitives();
    lights();
    // A hint for a tier that the build does not have chooses the config's tier.
    glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_NICEST);
    check(glGetError() == GL_NO_ERROR, "hints are taken");
    // Only profiles that leave out states or texture formats are not GL 1.3. Of the others, gl13 has no
    // buffer objects (GL 1.5), and no system of GL 1.4 either.
    const std::string version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    const bool whole = raster::has_chain && raster::texture_formats == 32767;
    check(version.starts_with(!whole ? "1.0 " : SPANGLE_FEATURE_BUFFERS ? "1.5 " : "1.3 "), version.c_str());
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglTerminate(display);
    windows();
    return wrong;
}
