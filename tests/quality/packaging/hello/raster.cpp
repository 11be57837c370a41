// Uses the rasterizer without GL, through the installed library and its only public header.
#include <cstdio>

#include <spangle/raster.hpp>

using namespace spangle;
using namespace spangle::raster;

int main() {
    static std::uint8_t pixels[120][160][2]; // RGB565 as a panel takes it, top row first
    Surface surface;
    surface.width = 160;
    surface.height = 120;
    surface.color = &pixels[119][0][0]; // rows count from the bottom
    surface.color_stride = -int{sizeof pixels[0]};
    ClearRequest blue;
    blue.area = {0, 0, 160, 120};
    blue.channels = 0xF;
    blue.color[2] = color_one;
    clear(surface, blue);
    FixedVertex corner[3] = {at(10, 10), at(150, 10), at(80, 110)};
    for (int i = 0; i < 3; ++i)
        for (int c = 0; c < 3; ++c)
            corner[i].color[c] = c == i ? color_one : 0;
    const Rasterizer draw(whole(surface), surface);
    draw.triangle(corner[0], corner[1], corner[2]);
    draw.line(at(0, 0), at(160, 120), 3);
    const std::uint8_t* const middle = pixels[60][80];
    std::printf("middle: %02X%02X, corner: %02X%02X\n", middle[0], middle[1], pixels[0][0][0],
                pixels[0][0][1]);
    return middle[0] == 0xFF && middle[1] == 0xFF && pixels[0][0][1] == 0x1F ? 0 : 1;
}
