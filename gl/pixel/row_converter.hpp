// Converts rows of colours between client memory, texels and surfaces when nothing changes the colours. A
// short row of codes is read from one format and written to the other. The result has the same bits as Groups
// and pack_pixel (group.hpp) give for each pixel.
#pragma once

#include "gl/pixel/row_codes.hpp"
#include "raster/surface/surface.hpp"

namespace spangle::gl {

/// Whether a converter saves time for an image of `groups` groups. Its set-up takes as long as the conversion
/// of a few single groups.
constexpr bool pays_converter(std::int64_t groups) {
    return groups >= 4;
}

/// The format at one end of a conversion. The object must not outlive the layout.
struct GroupForm {
    GroupForm() = default;
    GroupForm(const PixelLayout& of, bool swap_bytes)
        : fields(fields_of(of, swap_bytes)), layout(&of), swap(swap_bytes) {}
    explicit GroupForm(PixelFormat surface) : fields(fields_of(surface)) {}
    explicit GroupForm(const GroupFields& of) : fields(of) {}

    std::uint32_t bytes() const { return fields.bytes != 0 ? fields.bytes : layout->group_bytes(); }

    GroupFields fields;                  ///< bytes 0: groups are elements of the layout
    const PixelLayout* layout = nullptr; ///< null: groups are fields
    bool swap = false;
};

/// bits_of() returns the bits of each field. own_bits() returns the same, but eight bits for components that
/// are missing.
CodeBits bits_of(const GroupFields& fields);
CodeBits own_bits(const GroupFields& fields);

/// Reads rows of groups as codes. A reader is set up once for each image. Colours that the groups lack are
/// read as 0, and a missing alpha as 1.
class RowReader {
  public:
    RowReader(const GroupForm& from, const CodeBits& to);

    /// Reads `count` groups, at most row_chunk. The result is valid until the next call.
    CodeRow& read(const std::uint8_t* from, std::int32_t count);

    const CodeBits& bits() const { return bits_; }

  private:
    GroupForm source_form_;
    CodeBits bits_;
    FieldReader fields_;
    CodeRow row_{};
};

class RowConverter {
  public:
    /// Luminance is written as the sum of red, green and blue (GL 1.3, 4.3.2).
    RowConverter(const GroupForm& from, const GroupForm& to);

    /// False when this pair of formats is not supported; no other member may be called then.
    bool is_supported() const { return is_supported_; }
    /// Converts `count` groups, at most row_chunk.
    void convert(const std::uint8_t* from, std::uint8_t* to, std::int32_t count);
    /// Converts any number of groups.
    void convert_row(const std::uint8_t* from, std::uint8_t* to, std::int32_t count);

  private:
    GroupForm source_form_, target_form_;
    bool adds_luminance_, is_supported_;
    RowReader reader_;
};

/// The groups of a row of a surface, as fields_of(PixelFormat) describes them.
class SurfaceRow {
  public:
    /// Returns the groups of `count` pixels from (x, y) on, at most row_chunk. Valid until the next call.
    const std::uint8_t* at(const raster::Surface& surface, std::int32_t x, std::int32_t y,
                           std::int32_t count);

  private:
    std::uint16_t unpacked_pixels_[row_chunk]; ///< unpacked pixels of formats whose pixels share bytes
};

/// Converts rows of a surface to groups.
class SurfaceConverter {
  public:
    /// The surface must hold RGBA colours.
    SurfaceConverter(PixelFormat surface, const GroupForm& to)
        : converter_(GroupForm(surface), to), bytes_(to.bytes()) {}

    bool is_supported() const { return converter_.is_supported(); }
    /// Converts any number of pixels from (x, y) on.
    void convert(const raster::Surface& surface, std::int32_t x, std::int32_t y, std::int32_t count,
                 std::uint8_t* to);

  private:
    SurfaceRow row_;
    RowConverter converter_;
    std::uint32_t bytes_;
};

} // namespace spangle::gl
