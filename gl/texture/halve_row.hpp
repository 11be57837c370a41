// Texels of the next level from rows of this one, many at a time (GL 1.4, 3.8.8).
#pragma once

#include "gl/pixel/row_converter.hpp"

namespace spangle::gl {

class RowHalver {
  public:
    explicit RowHalver(const PixelLayout& texels)
        : fields_(fields_of(texels, false)), reader_(fields_, bits_of(fields_)) {}

    /// False: texels of the layout are no fields, and nothing else may be called.
    bool works() const { return fields_.bytes != 0; }

    /// `count` means of eight texels: of two that follow each other in each of four rows. Rows of images that
    /// are flat or thin come several times: {a, b, a, b} or {a, a, a, a}.
    void halve(const std::uint8_t* const (&from)[4], std::int32_t count, std::uint8_t* to);

  private:
    GroupFields fields_;
    FieldReader reader_;
};

} // namespace spangle::gl
