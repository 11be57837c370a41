// Rows of colours as integer codes, one array per component. They are read from groups whose components are
// bit fields, and written to such groups, by vector lanes.
#pragma once

#include "gl/pixel/row_fields.hpp"
#include "gl/pixel/row_scale.hpp"

namespace spangle::gl {

/// Groups that are converted at a time; their codes lie on the stack.
inline constexpr std::int32_t row_chunk = 64;

struct CodeRow {
    alignas(16) std::uint16_t code[4][row_chunk]; ///< red, green, blue, alpha
};

/// Bits of each component's codes; 0: the component is not used.
struct CodeBits {
    std::uint8_t of[4] = {};
    bool cut = false; ///< codes are rounded to eight bits, and then cut to their highest bits
};

/// Reads fields as codes of other sizes. Each code is the nearest one (code_of, component.hpp).
class FieldReader {
  public:
    /// Components that the groups do not have are not read.
    FieldReader(const GroupFields& from, const CodeBits& to);

    void read(const std::uint8_t* from, std::int32_t count, CodeRow& out) const;

  private:
    void blocks(const std::uint8_t* from, std::int32_t count, CodeRow& out, std::int32_t at) const;

    GroupFields source_fields_;
    CodeScale scale_[4] = {}; ///< factor 0: the component is not read
};

/// Writes codes that have the same bits as the fields.
void write_fields(const CodeRow& from, const GroupFields& to, std::int32_t count, std::uint8_t* out);

/// Red becomes the sum of red, green and blue, at most 255.
void add_luminance(CodeRow& row);

} // namespace spangle::gl
