#include "host_sim/cli/window.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include <SDL2/SDL.h>
#include <fmt/format.h>

#include "host_sim/cli/say.hpp"

namespace spangle::cli {

Window::~Window() {
    if (window_ != nullptr)
        SDL_DestroyWindow(window_);
}

void Window::open(const std::string& title, int width, int height) {
    title_ = title;
    scale_ = width <= 400 ? 2 : 1;
    SDL_SetMainReady();
    // SDL's own choice ends at drivers that show nothing, and Wayland's library complains without this
    // variable. SDL_VIDEODRIVER has precedence over the hint.
    SDL_SetHintWithPriority(SDL_HINT_VIDEODRIVER,
                            std::getenv("XDG_RUNTIME_DIR") != nullptr ? "x11,wayland,KMSDRM" : "x11,KMSDRM",
                            SDL_HINT_DEFAULT);
    if (SDL_Init(SDL_INIT_VIDEO) == 0)
        window_ = SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED,
                                   width * scale_ * 2, height * scale_, 0);
    if (window_ == nullptr)
        tell(fmt::format("spangle: no window, for there is no display to open it on ({}); going on without\n",
                         SDL_GetError()));
}

bool Window::can_be_closed() const {
    const char* const driver = SDL_GetCurrentVideoDriver();
    return is_open() && driver != nullptr && driver != std::string_view("dummy") &&
           driver != std::string_view("offscreen");
}

namespace {

/// Draws a picture into a rectangle of the window, as large as fits with the picture's proportions.
void copy_scaled(const sim::Image& image, SDL_Surface* to, int x, int room_width, int room_height) {
    if (image.width == 0)
        return;
    SDL_Surface* const from =
        SDL_CreateRGBSurfaceWithFormatFrom(const_cast<std::uint8_t*>(image.rgba.data()), image.width,
                                           image.height, 32, image.width * 4, SDL_PIXELFORMAT_RGBA32);
    if (from == nullptr)
        return;
    const int scale_1000 = std::min(room_width * 1000 / image.width, room_height * 1000 / image.height);
    SDL_Rect area{x, 0, image.width * scale_1000 / 1000, image.height * scale_1000 / 1000};
    SDL_SetSurfaceBlendMode(from, SDL_BLENDMODE_BLEND); // outside round glass the picture is transparent
    SDL_BlitScaled(from, nullptr, to, &area);
    SDL_FreeSurface(from);
}

} // namespace

void Window::show(const sim::Image& glass, const sim::Image& memory, const sim::BoardCounters& counters) {
    SDL_Event event;
    while (SDL_PollEvent(&event) != 0)
        if (event.type == SDL_QUIT)
            is_closed_ = true;
    SDL_Surface* const screen = SDL_GetWindowSurface(window_);
    if (screen == nullptr)
        return;
    constexpr Uint8 bezel = 40;
    SDL_FillRect(screen, nullptr, SDL_MapRGB(screen->format, bezel, bezel, bezel));
    copy_scaled(glass, screen, 0, screen->w / 2, screen->h);
    copy_scaled(memory, screen, screen->w / 2, screen->w / 2, screen->h);
    SDL_SetWindowTitle(window_, fmt::format("{}: glass | controller memory | {} bytes, {} commands", title_,
                                            counters.bytes, counters.commands)
                                    .c_str());
    SDL_UpdateWindowSurface(window_);
    SDL_Delay(16);
}

} // namespace spangle::cli
