// Reads pictures back from GL and measures how much two of them differ.
#include <spangle/reference.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>

#include "gl/context/features.hpp"

namespace spangle {

namespace {

/// While this object lives, the state that affects glReadPixels has its initial values (GL 1.3, 3.6.1 and
/// 4.3.2).
class DefaultPixelState {
  public:
    DefaultPixelState() {
        for (int i = 0; i < transfers; ++i) {
            glGetFloatv(transfer_[i].name, &saved_transfer_[i]);
            glPixelTransferf(transfer_[i].name, transfer_[i].initial);
        }
        for (int i = 0; i < stores; ++i) {
            glGetIntegerv(store_[i].name, &saved_store_[i]);
            glPixelStorei(store_[i].name, store_[i].initial);
        }
        if (has_transfer) {
            glGetIntegerv(GL_MAP_COLOR, &saved_map_color_);
            glPixelTransferi(GL_MAP_COLOR, GL_FALSE);
        }
    }
    ~DefaultPixelState() {
        for (int i = 0; i < transfers; ++i)
            glPixelTransferf(transfer_[i].name, saved_transfer_[i]);
        for (int i = 0; i < stores; ++i)
            glPixelStorei(store_[i].name, saved_store_[i]);
        if (has_transfer)
            glPixelTransferi(GL_MAP_COLOR, saved_map_color_);
    }
    DefaultPixelState(const DefaultPixelState&) = delete;
    DefaultPixelState& operator=(const DefaultPixelState&) = delete;

  private:
    template <class Value> struct Named {
        GLenum name;
        Value initial;
    };
    /// If false, the state of pixel transfers never changes.
    static constexpr bool has_transfer = SPANGLE_FEATURE_PIXEL_TRANSFER;
    static constexpr int transfers = has_transfer ? 10 : 0, known_transfers = 10, stores = 5;
    static constexpr Named<GLfloat> transfer_[known_transfers] = {
        {GL_RED_SCALE, 1}, {GL_GREEN_SCALE, 1}, {GL_BLUE_SCALE, 1}, {GL_ALPHA_SCALE, 1}, {GL_DEPTH_SCALE, 1},
        {GL_RED_BIAS, 0},  {GL_GREEN_BIAS, 0},  {GL_BLUE_BIAS, 0},  {GL_ALPHA_BIAS, 0},  {GL_DEPTH_BIAS, 0}};
    static constexpr Named<GLint> store_[stores] = {{GL_PACK_ALIGNMENT, 1},
                                                    {GL_PACK_ROW_LENGTH, 0},
                                                    {GL_PACK_SKIP_ROWS, 0},
                                                    {GL_PACK_SKIP_PIXELS, 0},
                                                    {GL_PACK_SWAP_BYTES, 0}};
    GLfloat saved_transfer_[known_transfers] = {};
    GLint saved_store_[stores] = {}, saved_map_color_ = 0;
};

double psnr_of(double squares, std::uint64_t pixels) {
    return squares > 0 ? 10 * std::log10(255.0 * 255.0 * 3.0 * static_cast<double>(pixels) / squares)
                       : PictureError::alike;
}

void add_color(const std::uint8_t* a, const std::uint8_t* b, PictureError& e) {
    bool same = true;
    for (int c = 0; c < 3; ++c) {
        const int drop = c == 1 ? 2 : 3, most = 255 >> drop;
        const int whole = std::abs(a[c] - b[c]), steps = std::abs((a[c] >> drop) - (b[c] >> drop));
        same = same && steps == 0;
        e.max_lsb = std::max(e.max_lsb, steps);
        e.max_255 = std::max(e.max_255, whole);
        const double scaled = 255.0 * steps / most;
        e.squares_565 += scaled * scaled;
        e.squares_888 += whole * whole;
    }
    e.identical += same ? 1 : 0;
}

} // namespace

DrawnPicture read_picture() {
    const EGLDisplay display = eglGetCurrentDisplay();
    const EGLSurface surface = eglGetCurrentSurface(EGL_DRAW);
    DrawnPicture out;
    eglQuerySurface(display, surface, EGL_WIDTH, &out.width);
    eglQuerySurface(display, surface, EGL_HEIGHT, &out.height);
    glGetIntegerv(GL_DEPTH_BITS, &out.depth_bits);
    const DefaultPixelState plain;
    const auto pixels = static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height);
    out.rgba.resize(4 * pixels);
    glReadPixels(0, 0, out.width, out.height, GL_RGBA, GL_UNSIGNED_BYTE, out.rgba.data());
    if (out.depth_bits == 0)
        return out;
    out.depth.resize(pixels);
    glReadPixels(0, 0, out.width, out.height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, out.depth.data());
    for (std::uint32_t& code : out.depth)
        code >>= 32 - out.depth_bits;
    return out;
}

double PictureError::identical_percent() const {
    return pixels == 0 ? 100 : 100 * static_cast<double>(identical) / static_cast<double>(pixels);
}
double PictureError::psnr_565() const {
    return psnr_of(squares_565, pixels);
}
double PictureError::psnr_888() const {
    return psnr_of(squares_888, pixels);
}

void PictureError::add(const PictureError& o) {
    pixels += o.pixels;
    identical += o.identical;
    max_lsb = std::max(max_lsb, o.max_lsb);
    max_255 = std::max(max_255, o.max_255);
    squares_565 += o.squares_565;
    squares_888 += o.squares_888;
    depth_steps = std::max(depth_steps, o.depth_steps);
    order_flips += o.order_flips;
    compared_depths += o.compared_depths;
}

PictureError compare(const DrawnPicture& drawn, const DrawnPicture& reference,
                     const std::vector<bool>* mask) {
    PictureError e;
    if (drawn.width != reference.width || drawn.height != reference.height)
        return e;
    const bool depths = !drawn.depth.empty() && drawn.depth_bits == reference.depth_bits;
    for (std::size_t i = 0; i < drawn.rgba.size() / 4; ++i) {
        if (mask != nullptr && !(*mask)[i])
            continue;
        ++e.pixels;
        add_color(drawn.rgba.data() + 4 * i, reference.rgba.data() + 4 * i, e);
        if (!depths)
            continue;
        ++e.compared_depths;
        const std::uint32_t a = drawn.depth[i], b = reference.depth[i], steps = a < b ? b - a : a - b;
        if (steps > one_surface)
            ++e.order_flips;
        else
            e.depth_steps = std::max(e.depth_steps, steps);
    }
    return e;
}

} // namespace spangle
