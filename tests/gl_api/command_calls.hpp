// Bytes to calls, by the command table: what spells a stream, whatever it is drawn to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "tests/gl_api/command_table.hpp"

namespace spangle::test {

/// The stream; zeros when it has ended.
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

/// What answers are written to; holds the largest image.
std::uint8_t* result();

/// What images, arrays and parameters are read from; as large, and nobody writes to it.
const std::uint8_t* source();

/// Calls of the context that is current, with client memory of their own. Every argument may be anything, but
/// for what GL cannot check: client memory is large enough for the sizes that are given.
class Calls {
  public:
    explicit Calls(Bytes& stream);

    /// The command that a number names, with the arguments that come next. `wanted`: those that are really
    /// called; null: all.
    const Command& one(unsigned selected, bool (*wanted)(std::string_view family) = nullptr);

  private:
    static constexpr std::int64_t most_items = 64; ///< of an array or a side of an image

    Value argument(const Command& c, const Arg& arg, std::string_view family, const Pname*& pname);
    static double number(Bytes& in, const Command& c, std::uint8_t how);

    Bytes& in_;
    /// A list being compiled that has had its call.
    struct Called {
        const void* context;
        std::uint32_t list;
        bool operator==(const Called&) const = default;
    };
    bool may_call_a_list(bool& compiling);

    void* elements_[most_items] = {}; ///< of MultiDrawElements
    std::vector<Called> called_;
    std::vector<std::uint8_t> client_ = std::vector<std::uint8_t>(4096);
};

} // namespace spangle::test
