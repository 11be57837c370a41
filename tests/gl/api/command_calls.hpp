// Makes calls from bytes, by the command table. Streams of bytes are read like this, whatever they are drawn
// to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "tests/gl/api/command_table.hpp"

namespace spangle::test {

/// Reads the bytes of a stream, and zeros after its end.
class Bytes {
  public:
    Bytes(const std::uint8_t* data, std::size_t bytes) : at(data), end(data + bytes) {}
    bool more() const { return at != end; }
    std::uint8_t byte() { return at != end ? *at++ : std::uint8_t{0}; }
    std::uint32_t word() {
        std::uint32_t w = byte();
        for (int i = 1; i < 4; ++i)
            w |= static_cast<std::uint32_t>(byte()) << 8 * i;
        return w;
    }

  private:
    const std::uint8_t *at, *end;
};

/// Returns the memory that answers are written to; it holds the largest image.
std::uint8_t* result();

/// Returns the memory that images, arrays and parameters are read from. It is as large, and nothing writes to
/// it.
const std::uint8_t* source();

/// Makes calls of the current context, with client memory of their own. Every argument may be anything,
/// except what GL cannot check: client memory is large enough for the given sizes.
class Calls {
  public:
    explicit Calls(Bytes& stream);

    /// Makes the call of command number `selected`, with arguments from the stream. Only `wanted` commands
    /// are really called; null: all.
    const Command& one(unsigned selected, bool (*wanted)(std::string_view family) = nullptr);

  private:
    static constexpr std::int64_t most_items = 64; ///< items of an array, or of a side of an image

    Value argument(const Command& c, const Arg& arg, std::string_view family, const Pname*& pname);
    static double number(Bytes& in, const Command& c, std::uint8_t how);

    Bytes& in_;
    /// A list under construction that already contains a call of a list.
    struct Called {
        const void* context;
        std::uint32_t list;
        bool operator==(const Called&) const = default;
    };
    bool may_call_a_list(bool& compiling);

    void* elements_[most_items] = {}; ///< addresses of indices for MultiDrawElements
    std::vector<Called> called_;
    std::vector<std::uint8_t> client_ = std::vector<std::uint8_t>(4096);
};

} // namespace spangle::test
