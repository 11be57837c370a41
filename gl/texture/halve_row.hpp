// Computes rows of the next mipmap level from rows of this one, many texels at a time (GL 1.4, 3.8.8).
#pragma once

#include "gl/pixel/row_converter.hpp"

namespace spangle::gl {

class RowHalver {
  public:
    explicit RowHalver(const PixelLayout& texels)
        : fields_(fields_of(texels, false)), reader_(fields_, bits_of(fields_)) {}

    /// Whether the components of the layout are bit fields. If not, halve() must not be called.
    bool works() const { return fields_.bytes != 0; }

    /// Writes `count` texels. Each is the mean of eight texels, two neighbours in each of four rows. For an
    /// image of one slice, the caller passes two rows twice, in the order a, b, a, b. For an image of one
    /// row, it passes that row four times.
    void halve(const std::uint8_t* const (&from)[4], std::int32_t count, std::uint8_t* to);

  private:
    GroupFields fields_;
    FieldReader reader_;
};

} // namespace spangle::gl
