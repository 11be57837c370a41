// A screen as an emulator drew it: QEMU's screendump, and whether it shows what the simulated glass does.
#pragma once

#include <string>

#include <spangle/format.hpp>
#include <spangle/sim/image.hpp>

namespace spangle::sim {

/// A binary PPM of eight bits. Empty on success, else what went wrong.
std::string read_ppm(const std::string& path, Image& out);

/// A screen that shows each pixel as `scale` by `scale` equal ones, without them. Empty when it does not.
Image reduced(const Image& screen, int scale);

/// Each pixel shows the same step of the format as the glass. Emulators spread steps over 255ths in their own
/// way.
bool shows(const Image& screen, const Image& glass, PixelFormat format);

} // namespace spangle::sim
