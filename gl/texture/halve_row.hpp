// Computes rows of the next mipmap level from rows of this one, many texels at a time (GL 1.4, 3.8.8).
#pragma once

#include "gl/pixel/row_converter.hpp"

namespace spangle::gl {

class RowHalver {
  public:
    explicit RowHalver(const PixelLayout& texels)
        : fields_(fields_of(texels, false)), reader_(fields_, bits_of(fields_)) {}

    /// False when the layout's components are no bit fields; halve() may not be called then.
    bool works() const { return fields_.bytes != 0; }

    /// Writes `count` texels, each the mean of eight: two neighbours in each of four rows. Flat or thin
    /// images pass the same rows several times: {a, b, a, b} or {a, a, a, a}.
    void halve(const std::uint8_t* const (&from)[4], std::int32_t count, std::uint8_t* to);

  private:
    GroupFields fields_;
    FieldReader reader_;
};

} // namespace spangle::gl
