// One scene on one simulated board, as the page shows it. The native program of the page's hashes draws it,
// too.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <spangle/EGL/egl.h>
#include <spangle/sim/board.hpp>

#include "boards/scenes/scene.hpp"
#include "host_sim/page/bus_log.hpp"

namespace spangle::page {

/// The format of the surface, and the format on the bus if that differs.
struct Format {
    const char* name;
    PixelFormat surface;
    hal::Wire wire;
};

/// Indices of what the page offers; `format` counts the formats that this board takes (formats_of).
struct Choice {
    int board = 0, scene = 0, tier = 0, format = 0;
};

inline constexpr const char* tiers[] = {"exact", "balanced", "fast"};

int board_count();
const hal::Board& board_of(int index);
/// The formats that the board takes; the format of its description comes first.
std::vector<Format> formats_of(const hal::Board& board);

class View {
  public:
    View() = default;
    ~View() { close(); }
    View(const View&) = delete;
    View& operator=(const View&) = delete;

    /// Builds the board and sets the scene up. Returns what the choice lacks, or an empty string.
    std::string open(const Choice& choice);
    /// Draws the next frame, or the last one again; present() then sends it.
    std::string draw(bool next = true);
    std::string present();

    /// Whether the scene has a perspective, so that a viewer can walk around its object. orbit() takes
    /// degrees.
    bool has_camera() const { return has_camera_; }
    void orbit(float yaw, float pitch);

    sim::Image glass() const { return board_->glass(); }
    sim::Image memory() const { return board_->memory(); }
    sim::BoardCounters counters() const { return board_->counters(); }
    std::string violations() const { return board_->violations_text(); }
    /// The first bytes that the last frame put on the bus.
    const BusLog& log() const { return log_; }
    /// A text made of glass, controller memory and bytes on the bus so far. Equal texts mean equal pictures
    /// and traffic.
    std::string picture_digest() const;

  private:
    BusLog log_;
    std::unique_ptr<sim::SimBoard> board_;
    const scenes::Scene* scene_ = nullptr;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLSurface surface_ = EGL_NO_SURFACE;
    EGLContext context_ = EGL_NO_CONTEXT;
    float yaw_ = 0.0f, pitch_ = 0.0f;
    float distance_ = 0.0f; ///< distance from the eye to the object of the scene
    bool has_camera_ = false;
    int frame_ = -1; ///< the frame drawn last

    void close();
    void find_camera();
    void draw_from_aside();
};

/// The choices that are compared with native ones: each scene in each tier on the first board, then each
/// board in each of its formats.
std::vector<Choice> checked_choices();
/// Draws checked_frames frames and returns the digest, or "error: " and why there is none.
std::string digest_of(const Choice& choice);
inline constexpr int checked_frames = 3;

} // namespace spangle::page
