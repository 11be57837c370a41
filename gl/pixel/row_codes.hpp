// Codes of a row of colours: one array per component, read from groups whose components are fields, and
// written to such groups, by lanes.
#pragma once

#include "gl/pixel/row_fields.hpp"
#include "gl/pixel/row_scale.hpp"

namespace spangle::gl {

/// Groups that are converted at once; their codes lie on the stack.
inline constexpr std::int32_t row_chunk = 64;

struct CodeRow {
    alignas(16) std::uint16_t code[4][row_chunk]; ///< red, green, blue, alpha
};

/// How many bits the codes of each component have, 0 where nobody asks for it.
struct CodeBits {
    std::uint8_t of[4] = {};
    bool cut = false; ///< they are rounded to eight bits, of which these are the highest
};

/// Reads fields as codes of other bits: each is the nearest one (code_of, component.hpp).
class FieldReader {
  public:
    /// Components that the groups do not have are not read.
    FieldReader(const GroupFields& from, const CodeBits& to);

    void read(const std::uint8_t* from, std::int32_t count, CodeRow& out) const;

  private:
    void blocks(const std::uint8_t* from, std::int32_t count, CodeRow& out, std::int32_t at) const;

    GroupFields from_;
    CodeScale scale_[4] = {}; ///< a factor of 0: not read
};

/// Codes that have the bits of the fields.
void write_fields(const CodeRow& from, const GroupFields& to, std::int32_t count, std::uint8_t* out);

/// Red becomes the sum of red, green and blue, at most 255.
void add_luminance(CodeRow& row);

} // namespace spangle::gl
