#include <random>

#include "tests/unit/hal_usb/gud_stream.hpp"

namespace gud_test {

std::vector<std::vector<std::uint8_t>> gud_seeds() {
    std::vector<std::vector<std::uint8_t>> seeds;
    for (unsigned seed = 0; seed < 32; ++seed) {
        std::mt19937 random(seed);
        std::vector<std::uint8_t> data(3 * (16 + random() % 40));
        // Most answers are honest, because otherwise no device would start.
        for (std::size_t i = 0; i < data.size(); ++i) {
            const bool answer = i >= data.size() / 3 && i < data.size() / 3 * 2;
            const unsigned lot = static_cast<unsigned>(random() >> 9);
            data[i] = static_cast<std::uint8_t>(answer && lot % 32 >= seed % 8 ? 0 : lot / 32);
        }
        seeds.push_back(data);
    }
    return seeds;
}

} // namespace gud_test
