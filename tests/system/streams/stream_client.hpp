// Data with which streams draw: numbers that a program or an attacker would choose, and client memory that
// ends where GL may read no further.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

#include "tests/gl/api/command_calls.hpp"

namespace spangle::test {

/// Memory blocks of exact size, kept until the stream ends, because GL keeps some of their addresses.
class Memory {
  public:
    std::uint8_t* make(std::size_t bytes) {
        blocks_.emplace_back(new std::uint8_t[bytes]);
        std::memcpy(blocks_.back().get(), source(), bytes < usual ? bytes : usual);
        if (bytes > usual)
            std::memset(blocks_.back().get() + usual, 0x5A, bytes - usual);
        return blocks_.back().get();
    }
    /// Frees all blocks after the first `blocks`, whose addresses GL no longer has.
    void drop_to(std::size_t blocks) { blocks_.resize(blocks); }
    std::size_t blocks() const { return blocks_.size(); }

  private:
    static constexpr std::size_t usual = 1u << 20; ///< bytes; the source is larger
    std::vector<std::unique_ptr<std::uint8_t[]>> blocks_;
};

/// Returns the bytes that an image may take, which takes `exact` of them with the pixel store that was set.
///
/// Between Begin and End the store cannot be set, but a list that compiles takes images even so, and reads
/// them by the store that is in force. That has gaps of a few groups and rows at most.
inline std::size_t room(std::size_t exact) {
    GLint alignment = -1;
    glGetIntegerv(GL_UNPACK_ALIGNMENT, &alignment); // between Begin and End it gives nothing
    return alignment != -1 ? exact : exact + (std::size_t{1} << 19);
}

/// Returns the number of one of `count` things, as the stream chooses.
inline unsigned pick(Bytes& in, unsigned count) {
    return count <= 1 ? 0 : count <= 256 ? in.byte() % count : (in.byte() | in.byte() * 256u) % count;
}

template <class T, std::size_t count> T pick(Bytes& in, const T (&from)[count]) {
    return from[pick(in, static_cast<unsigned>(count))];
}

/// Returns a number at which arithmetic may fail.
inline float odd_number(Bytes& in) {
    constexpr std::uint32_t odd[] = {0x7FC00000, 0x7F800000, 0xFF800000, 0x00000001, 0x80000000, 0x7F7FFFFF,
                                     0xFF7FFFFF, 0x4A800000, 0x4B800000, 0xCB800000, 0x4F000000, 0xCF000000,
                                     0x4D800000, 0x53800000, 0x33800000, 0x00800000, 0x46FFFE00, 0x47000000,
                                     0xC7000000, 0x44FFE000, 0x45000000, 0x45001000, 0x3F7FFFFF, 0x3F800001};
    const unsigned which = pick(in, 32);
    const std::uint32_t bits = which < 24 ? odd[which] : in.word();
    float number;
    std::memcpy(&number, &bits, sizeof number);
    return number;
}

/// Returns a coordinate for a side of so many pixels: mostly at or between pixels, sometimes beside the side,
/// or anywhere.
inline float coordinate(Bytes& in, std::int32_t side) {
    const unsigned how = in.byte();
    const auto part = static_cast<std::int32_t>(in.byte());
    const float whole = static_cast<float>(part * side / 255);
    if (how < 120)
        return whole;
    if (how < 160)
        return whole + 0.5f;
    if (how < 215)
        return static_cast<float>(part) * static_cast<float>(side) / 255.0f + static_cast<float>(how) / 256;
    if (how < 248)
        return static_cast<float>((part - 128) * side) / 32.0f;
    return odd_number(in);
}

/// Returns a coordinate for commands that take integers.
inline std::int32_t whole_coordinate(Bytes& in, std::int32_t side) {
    const float at = coordinate(in, side);
    return at > -5000 && at < 5000 ? static_cast<std::int32_t>(at)
           : in.byte() % 2 != 0    ? INT32_MAX
                                   : INT32_MIN;
}

/// Returns a number between -1 and 1, or sometimes far beyond.
inline float unit_number(Bytes& in) {
    const unsigned how = in.byte();
    if (how < 40)
        return static_cast<float>(how % 3) - 1;
    if (how < 246)
        return static_cast<float>(static_cast<int>(in.byte()) - 128) / 127.0f;
    return how < 252 ? static_cast<float>(static_cast<int>(in.byte()) - 128) : odd_number(in);
}

} // namespace spangle::test
