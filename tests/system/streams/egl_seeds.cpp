#include <random>

#include "tests/system/streams/egl_stream.hpp"

namespace spangle::test {

std::vector<std::vector<std::uint8_t>> egl_seeds() {
    std::vector<std::vector<std::uint8_t>> seeds;
    for (unsigned seed = 0; seed < 64; ++seed) {
        std::mt19937 random(seed);
        const auto steps = 4 + random() % 60;
        std::vector<std::uint8_t> data(steps * stream_step);
        for (std::uint8_t& byte : data)
            byte = static_cast<std::uint8_t>(random() >> 9);
        // Most steps are pieces; later seeds have more single calls, and calls of EGL.
        for (std::size_t at = stream_step; at < data.size(); at += stream_step)
            if (random() % 64 >= seed)
                data[at] = static_cast<std::uint8_t>(100 + random() % 110);
        seeds.push_back(data);
    }
    return seeds;
}

} // namespace spangle::test
