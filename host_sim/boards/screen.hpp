// A screen as an emulator drew it: reads QEMU's screendump, and tells whether it shows what the simulated
// glass does.
#pragma once

#include <string>

#include <spangle/format.hpp>
#include <spangle/sim/image.hpp>

namespace spangle::sim {

/// Reads a binary PPM of eight bits. Returns what went wrong, or an empty string.
std::string read_ppm(const std::string& path, Image& out);

/// The screen without magnification, if each of its pixels is drawn as `scale` by `scale` equal pixels; else
/// empty.
Image shrink_picture(const Image& screen, int scale);

/// Whether each pixel of the screen shows the same step of the format as the glass. Emulators spread steps
/// over 255ths in their own way.
bool shows(const Image& screen, const Image& glass, PixelFormat format);

} // namespace spangle::sim
