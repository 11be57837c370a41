#include "host_sim/boards/screen.hpp"

#include <algorithm>
#include <fstream>
#include <vector>

namespace spangle::sim {

namespace {

struct ChannelBits {
    int bits[3];
};

ChannelBits bits_of(PixelFormat format) {
    switch (format) {
    case PixelFormat::mono:
        return {{1, 1, 1}};
    case PixelFormat::grey4:
        return {{4, 4, 4}};
    default:
        return {{5, 6, 5}};
    }
}

/// The high bits of a component. There, scales that reach 255 agree with those that leave low bits zero.
int step(int value, int bits) {
    return value >> (8 - bits);
}

} // namespace

std::string read_ppm(const std::string& path, Image& out) {
    std::ifstream file(path, std::ios::binary);
    std::string magic;
    int width = 0, height = 0, most = 0;
    file >> magic >> width >> height >> most;
    if (!file || magic != "P6" || most != 255 || width <= 0 || height <= 0)
        return path + " is no picture";
    file.get();
    std::vector<char> rgb(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    if (!file.read(rgb.data(), static_cast<std::streamsize>(rgb.size())))
        return path + " ends too early";
    out = Image(width, height);
    for (std::size_t i = 0; i < rgb.size() / 3; ++i)
        std::copy_n(&rgb[3 * i], 3, reinterpret_cast<char*>(&out.rgba[4 * i]));
    return "";
}

Image shrink_picture(const Image& screen, int scale) {
    Image out(screen.width / scale, screen.height / scale);
    for (int y = 0; y < screen.height; ++y)
        for (int x = 0; x < screen.width; ++x) {
            const std::uint8_t* const from = screen.at(x, y);
            if (x / scale >= out.width || y / scale >= out.height ||
                !std::equal(from, from + 4, screen.at(x / scale * scale, y / scale * scale)))
                return {};
            std::copy_n(from, 4, out.at(x / scale, y / scale));
        }
    return out;
}

bool shows(const Image& screen, const Image& glass, PixelFormat format) {
    if (screen.width != glass.width || screen.height != glass.height)
        return false;
    const ChannelBits bits = bits_of(format);
    for (int y = 0; y < screen.height; ++y)
        for (int x = 0; x < screen.width; ++x)
            for (int c = 0; c < 3; ++c)
                if (step(screen.at(x, y)[c], bits.bits[c]) != step(glass.at(x, y)[c], bits.bits[c]))
                    return false;
    return true;
}

} // namespace spangle::sim
