// Reads PNG files under libFuzzer, because golden pictures are read in the test's own process.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <spangle/sim/image.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t bytes) {
    spangle::sim::Image image;
    const bool read = spangle::sim::decode_png({reinterpret_cast<const char*>(data), bytes}, image).empty();
    const std::size_t size =
        std::size_t{4} * static_cast<unsigned>(image.width) * static_cast<unsigned>(image.height);
    if (image.rgba.size() != size || (read && size == 0))
        std::abort();
    return 0;
}
