// A window that shows the glass, the controller's memory and the bus counters. It stays open until the user
// closes it. Without a screen, a message says so once and the run goes on.
#pragma once

#include <string>

#include <spangle/sim/board.hpp>
#include <spangle/sim/image.hpp>

struct SDL_Window;

namespace spangle::cli {

class Window {
  public:
    Window() = default;
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    void open(const std::string& title, int width, int height);
    bool is_open() const { return window_ != nullptr; }
    /// Whether the user sees the window. Drivers that show nothing open windows that nobody can close.
    bool can_be_closed() const;
    /// Whether the user has closed the window.
    bool is_closed() const { return is_closed_; }
    void show(const sim::Image& glass, const sim::Image& memory, const sim::BoardCounters& counters);

  private:
    SDL_Window* window_ = nullptr;
    bool is_closed_ = false;
    std::string title_;
    int scale_ = 2;
};

} // namespace spangle::cli
