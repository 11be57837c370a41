#include "host_sim/page/view.hpp"

#include <iterator>

#include <spangle/GL/gl.h>
#include <spangle/boards/boards.hpp>
#include <spangle/message.hpp>
#include <spangle/native.hpp>

#include "host_sim/bus/sim_bus.hpp"

namespace spangle::page {

namespace {

constexpr Format formats[] = {
    {"RGB565", PixelFormat::rgb565_be, {}},
    {"RGB666", PixelFormat::rgb666, {}},
    {"RGB444", PixelFormat::rgb444, {}},
    {"RGB332", PixelFormat::rgb332, {}},
    {"16 greys", PixelFormat::grey4, {}},
    {"black and white", PixelFormat::mono, {}},
    {"RGB888, sent as RGB666", PixelFormat::rgb888, {}},
    {"RGB888, dithered to RGB565", PixelFormat::rgb888, hal::wires::rgb565},
    {"RGB888, dithered to RGB444", PixelFormat::rgb888, hal::wires::rgb444},
    {"RGB888, dithered to RGB332", PixelFormat::rgb888, hal::wires::rgb332},
    {"RGB888, dithered to 16 greys", PixelFormat::rgb888, hal::wires::grey4},
    {"RGB888, dithered to black and white", PixelFormat::rgb888, hal::wires::mono},
    {"RGB565, sent as RGB666", PixelFormat::rgb565_be, hal::wires::rgb666},
    {"RGB565, dithered to RGB444", PixelFormat::rgb565_be, hal::wires::rgb444},
    {"RGB565, dithered to 16 greys", PixelFormat::rgb565_be, hal::wires::grey4},
    {"RGB565, dithered to black and white", PixelFormat::rgb565_be, hal::wires::mono},
};

hal::Board with(const hal::Board& board, const Format& format) {
    hal::Board other = board;
    other.display.format = format.surface;
    other.display.wire = format.wire;
    if (format.wire.converts())
        other.display.buffers = 1;
    return other;
}

bool is_format_of(const hal::Board& board, const Format& format) {
    return board.display.format == format.surface && board.display.wire.format == format.wire.format;
}

std::string& last_message() {
    static std::string text;
    return text;
}

std::string problem(const char* call) {
    return std::string(call) + ": " + (last_message().empty() ? "failed" : last_message());
}

} // namespace

int board_count() {
    return static_cast<int>(std::size(boards::all));
}

const hal::Board& board_of(int index) {
    return *boards::all[index];
}

std::vector<Format> formats_of(const hal::Board& board) {
    std::vector<Format> taken;
    for (const Format& format : formats) {
        if (hal::flaw(with(board, format)) == nullptr)
            taken.insert(is_format_of(board, format) ? taken.begin() : taken.end(), format);
    }
    return taken;
}

void View::close() {
    if (board_ == nullptr)
        return;
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT)
        eglDestroyContext(display_, context_);
    if (surface_ != EGL_NO_SURFACE)
        eglDestroySurface(display_, surface_);
    if (display_ != EGL_NO_DISPLAY)
        eglTerminate(display_);
    context_ = EGL_NO_CONTEXT;
    surface_ = EGL_NO_SURFACE;
    display_ = EGL_NO_DISPLAY;
    board_.reset();
}

std::string View::open(const Choice& choice) {
    close();
    last_message().clear();
    on_message([](unsigned, const char* text) { last_message() = text; });
    const hal::Board& plain = board_of(choice.board);
    const std::vector<Format> taken = formats_of(plain);
    if (choice.format >= static_cast<int>(taken.size()))
        return "the board does not take this format";
    board_ = std::make_unique<sim::SimBoard>(with(plain, taken[static_cast<std::size_t>(choice.format)]));
    static_cast<sim::SimBus&>(board_->bus()).listen(&log_);
    display_ = eglGetDisplay(native(board_->display()));
    if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr))
        return problem("eglInitialize");
    const EGLint wish[] = {EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_SURFACE_TYPE,
                           EGL_WINDOW_BIT,
                           EGL_DEPTH_SIZE,
                           16,
                           EGL_PRECISION_SPANGLE,
                           EGL_PRECISION_EXACT_SPANGLE + choice.tier,
                           EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display_, wish, &config, 1, &count) || count == 0)
        return problem("eglChooseConfig");
    surface_ = eglCreateWindowSurface(display_, config, 0, nullptr);
    if (surface_ == EGL_NO_SURFACE)
        return problem("eglCreateWindowSurface");
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, nullptr);
    if (context_ == EGL_NO_CONTEXT || !eglMakeCurrent(display_, surface_, surface_, context_))
        return problem("eglCreateContext");
    EGLint width = 0, height = 0;
    eglQuerySurface(display_, surface_, EGL_WIDTH, &width);
    eglQuerySurface(display_, surface_, EGL_HEIGHT, &height);
    scene_ = scenes::all().begin() + choice.scene;
    scene_->setup(width, height);
    glDisable(GL_DITHER); // `spangle run` does the same unless it is asked to dither
    frame_ = -1;
    find_camera();
    return "";
}

/// Finds out whether the scene has a perspective. In a perspective w is the distance from the eye: row 3 of
/// the projection is (0, 0, -1, 0).
void View::find_camera() {
    float projection[16];
    glGetFloatv(GL_PROJECTION_MATRIX, projection);
    has_camera_ = projection[11] < 0.0f;
    yaw_ = pitch_ = distance_ = 0.0f;
}

void View::orbit(float yaw, float pitch) {
    yaw_ = yaw;
    pitch_ = pitch;
}

/// Draws the scene as a viewer sees it who walks around its object. Scenes set their modelview matrix anew in
/// each frame, so the viewer's place goes into the projection. The modelview matrix that the frame before
/// left tells how far away the object is.
void View::draw_from_aside() {
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glTranslatef(0.0f, 0.0f, -distance_);
    glRotatef(pitch_, 1.0f, 0.0f, 0.0f);
    glRotatef(yaw_, 0.0f, 1.0f, 0.0f);
    glTranslatef(0.0f, 0.0f, distance_);
    glMatrixMode(GL_MODELVIEW);
    scene_->draw(frame_);
    glMatrixMode(GL_PROJECTION);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
}

std::string View::draw(bool next) {
    if (!eglMakeCurrent(display_, surface_, surface_, context_))
        return problem("eglMakeCurrent");
    log_.clear();
    frame_ += next || frame_ < 0 ? 1 : 0;
    if (has_camera_ && (yaw_ != 0.0f || pitch_ != 0.0f))
        draw_from_aside();
    else
        scene_->draw(frame_);
    if (has_camera_) {
        float modelview[16];
        glGetFloatv(GL_MODELVIEW_MATRIX, modelview);
        distance_ = -modelview[14];
    }
    const GLenum error = glGetError();
    return error == GL_NO_ERROR ? "" : problem("the scene");
}

std::string View::present() {
    return eglSwapBuffers(display_, surface_) ? "" : problem("eglSwapBuffers");
}

std::string View::picture_digest() const {
    return sim::hash(glass()) + "-" + sim::hash(memory()) + "-" + std::to_string(counters().bytes);
}

std::vector<Choice> checked_choices() {
    std::vector<Choice> choices;
    const int scenes = scenes::all().count;
    for (int scene = 0; scene < scenes; ++scene)
        for (int tier = 0; tier < static_cast<int>(std::size(tiers)); ++tier)
            choices.push_back({0, scene, tier, 0});
    const int gears = static_cast<int>(scenes::find("S5") - scenes::all().begin());
    for (int board = 0; board < board_count(); ++board) {
        const int taken = static_cast<int>(formats_of(board_of(board)).size());
        for (int format = board == 0 ? 1 : 0; format < taken; ++format)
            choices.push_back({board, gears, 0, format});
    }
    return choices;
}

std::string digest_of(const Choice& choice) {
    View view;
    std::string wrong = view.open(choice);
    for (int frame = 0; frame < checked_frames && wrong.empty(); ++frame) {
        wrong = view.draw();
        if (wrong.empty())
            wrong = view.present();
    }
    return wrong.empty() ? view.picture_digest() : "error: " + wrong;
}

} // namespace spangle::page
