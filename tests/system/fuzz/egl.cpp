// Runs EGL and GL on several displays, contexts and surfaces under libFuzzer. Streams are mutated by steps,
// so that the steps behind a change keep their meaning.
#include <algorithm>
#include <cstring>
#include <random>
#include <vector>

#include "tests/system/streams/egl_stream.hpp"

extern "C" {

std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t bytes) {
    spangle::test::run_egl_stream(data, bytes);
    return 0;
}

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    constexpr std::size_t unit = spangle::test::stream_step;
    std::minstd_rand random(seed);
    const std::size_t steps = size / unit, room = most / unit;
    const auto at = [&](std::size_t count) { return random() % count * unit; };
    if (steps == 0 || room == 0) {
        for (std::size_t i = 0; i < std::min(unit, most); ++i)
            data[i] = static_cast<std::uint8_t>(random() >> 9);
        return std::min(unit, most);
    }
    const unsigned how = random() % 8;
    if (how <= 1 && steps > 1) { // mutation: removes some steps
        const std::size_t from = at(steps),
                          count = std::min<std::size_t>(1 + random() % 3, steps - from / unit);
        if (count < steps) {
            std::memmove(data + from, data + from + count * unit, steps * unit - from - count * unit);
            return (steps - count) * unit;
        }
    }
    if (how <= 4 && steps < room) { // mutation: adds a new step or a copy
        const std::size_t to = at(steps + 1), from = at(steps);
        std::uint8_t step[unit];
        std::memcpy(step, data + from, unit);
        if (how == 2)
            for (std::uint8_t& byte : step)
                byte = static_cast<std::uint8_t>(random() >> 9);
        std::memmove(data + to + unit, data + to, steps * unit - to);
        std::memcpy(data + to, step, unit);
        return (steps + 1) * unit;
    }
    if (how == 5) { // mutation: exchanges two steps
        const std::size_t a = at(steps), b = at(steps);
        for (std::size_t i = 0; i < unit && a != b; ++i)
            std::swap(data[a + i], data[b + i]);
        return steps * unit;
    }
    std::uint8_t* const step = data + at(steps); // mutation: changes a byte or word of a step
    std::vector<std::uint8_t> mutated(step, step + unit);
    const std::size_t left = LLVMFuzzerMutate(mutated.data(), unit, unit);
    std::copy_n(mutated.begin(), left, step);
    return steps * unit;
}

/// Joins the first steps of one stream and the last steps of another.
std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* one, std::size_t one_size,
                                      const std::uint8_t* other, std::size_t other_size, std::uint8_t* out,
                                      std::size_t most, unsigned seed) {
    constexpr std::size_t unit = spangle::test::stream_step;
    std::minstd_rand random(seed);
    const std::size_t head = random() % (one_size / unit + 1) * unit,
                      tail = random() % (other_size / unit + 1) * unit;
    const std::size_t first = std::min(head, most), second = std::min(tail, most - first);
    std::memcpy(out, one, first);
    std::memcpy(out + first, other + other_size / unit * unit - tail, second);
    return first + second;
}
}
