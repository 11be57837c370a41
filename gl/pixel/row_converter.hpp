// Rows of colours between client memory, texels and surfaces, where nothing changes the colours on their way:
// through a short row of codes, read from the one format and written to the other. What comes out is what
// Groups and pack_pixel (group.hpp) make of each pixel, to the bit.
#pragma once

#include "gl/pixel/row_codes.hpp"
#include "raster/surface/surface.hpp"

namespace spangle::gl {

/// Whether an image of so many groups is worth the set-up of a converter, which takes as long as some groups
/// one by one.
constexpr bool pays_converter(std::int64_t groups) {
    return groups >= 4;
}

/// One end of a conversion. Lives no longer than the layout.
struct GroupForm {
    GroupForm() = default;
    GroupForm(const PixelLayout& of, bool swap_bytes)
        : fields(fields_of(of, swap_bytes)), layout(&of), swap(swap_bytes) {}
    explicit GroupForm(PixelFormat surface) : fields(fields_of(surface)) {}
    explicit GroupForm(const GroupFields& of) : fields(of) {}

    std::uint32_t bytes() const { return fields.bytes != 0 ? fields.bytes : layout->group_bytes(); }

    GroupFields fields;                  ///< without bytes: the groups are elements of the layout
    const PixelLayout* layout = nullptr; ///< null: there are fields
    bool swap = false;
};

/// The bits that these fields have, or those that the groups have; eight of what these lack.
CodeBits bits_of(const GroupFields& fields);
CodeBits own_bits(const GroupFields& fields);

/// Looked at once per image. What the groups lack is 0, alpha 1.
class RowReader {
  public:
    RowReader(const GroupForm& from, const CodeBits& to);

    /// At most row_chunk groups. Valid until the next call.
    CodeRow& read(const std::uint8_t* from, std::int32_t count);

    const CodeBits& bits() const { return bits_; }

  private:
    GroupForm from_;
    CodeBits bits_;
    FieldReader fields_;
    CodeRow row_{};
};

class RowConverter {
  public:
    /// What is written as luminance is the sum of red, green and blue (GL 1.3, 4.3.2).
    RowConverter(const GroupForm& from, const GroupForm& to);

    /// False: these two do not go together here, and nothing else may be called.
    bool works() const { return works_; }
    /// At most row_chunk groups.
    void convert(const std::uint8_t* from, std::uint8_t* to, std::int32_t count);
    /// Any number of groups.
    void convert_row(const std::uint8_t* from, std::uint8_t* to, std::int32_t count);

  private:
    GroupForm from_, to_;
    bool luminance_, works_;
    RowReader reader_;
};

/// The groups of a row of a surface, as fields_of(PixelFormat) describes them.
class SurfaceRow {
  public:
    /// `count` pixels from (x, y) on, at most row_chunk. Valid until the next call.
    const std::uint8_t* at(const raster::Surface& surface, std::int32_t x, std::int32_t y,
                           std::int32_t count);

  private:
    std::uint16_t words_[row_chunk]; ///< of pixels that share bytes
};

/// Rows of a surface to groups.
class SurfaceConverter {
  public:
    /// A surface of colours.
    SurfaceConverter(PixelFormat surface, const GroupForm& to)
        : converter_(GroupForm(surface), to), bytes_(to.bytes()) {}

    bool works() const { return converter_.works(); }
    /// Any number of pixels from (x, y) on.
    void convert(const raster::Surface& surface, std::int32_t x, std::int32_t y, std::int32_t count,
                 std::uint8_t* to);

  private:
    SurfaceRow row_;
    RowConverter converter_;
    std::uint32_t bytes_;
};

} // namespace spangle::gl
