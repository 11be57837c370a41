// Returns the meaning of a client image in double, written from the tables of GL 1.3 only (3.6.1, 3.6.4,
// 3.6.5; tables 2.6, 3.5 to 3.12).
#pragma once

#include <bit>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include <spangle/GL/gl.h>

namespace spangle::gl::test {

struct Store {
    bool swap = false, lsb = false;
    int row_length = 0, skip_rows = 0, skip_pixels = 0, alignment = 1;

    static Store random(std::mt19937& r, int width) {
        Store s;
        s.swap = r() % 2 != 0;
        s.lsb = r() % 2 != 0;
        s.row_length = r() % 2 != 0 ? width + static_cast<int>(r() % 5) : 0;
        s.skip_rows = static_cast<int>(r() % 3);
        s.skip_pixels = static_cast<int>(r() % 11);
        s.alignment = 1 << r() % 4;
        return s;
    }
    void apply(bool pack = false) const {
        const auto set = [pack](GLenum unpack, int v) {
            glPixelStorei(pack ? unpack - GL_UNPACK_SWAP_BYTES + GL_PACK_SWAP_BYTES : unpack, v);
        };
        set(GL_UNPACK_SWAP_BYTES, swap);
        set(GL_UNPACK_LSB_FIRST, lsb);
        set(GL_UNPACK_ROW_LENGTH, row_length);
        set(GL_UNPACK_SKIP_ROWS, skip_rows);
        set(GL_UNPACK_SKIP_PIXELS, skip_pixels);
        set(GL_UNPACK_ALIGNMENT, alignment);
    }
};

inline int groups_of(GLenum format) {
    return format == GL_RGB || format == GL_BGR     ? 3
           : format == GL_RGBA || format == GL_BGRA ? 4
           : format == GL_LUMINANCE_ALPHA           ? 2
                                                    : 1;
}

struct PackedType {
    GLenum type;
    int bytes, fields[4];
    bool reversed;
};
inline constexpr PackedType packed_types[] = {{GL_UNSIGNED_BYTE_3_3_2, 1, {3, 3, 2, 0}, false},
                                              {GL_UNSIGNED_BYTE_2_3_3_REV, 1, {3, 3, 2, 0}, true},
                                              {GL_UNSIGNED_SHORT_5_6_5, 2, {5, 6, 5, 0}, false},
                                              {GL_UNSIGNED_SHORT_5_6_5_REV, 2, {5, 6, 5, 0}, true},
                                              {GL_UNSIGNED_SHORT_4_4_4_4, 2, {4, 4, 4, 4}, false},
                                              {GL_UNSIGNED_SHORT_4_4_4_4_REV, 2, {4, 4, 4, 4}, true},
                                              {GL_UNSIGNED_SHORT_5_5_5_1, 2, {5, 5, 5, 1}, false},
                                              {GL_UNSIGNED_SHORT_1_5_5_5_REV, 2, {5, 5, 5, 1}, true},
                                              {GL_UNSIGNED_INT_8_8_8_8, 4, {8, 8, 8, 8}, false},
                                              {GL_UNSIGNED_INT_8_8_8_8_REV, 4, {8, 8, 8, 8}, true},
                                              {GL_UNSIGNED_INT_10_10_10_2, 4, {10, 10, 10, 2}, false},
                                              {GL_UNSIGNED_INT_2_10_10_10_REV, 4, {10, 10, 10, 2}, true}};
inline constexpr GLenum plain_types[] = {GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_SHORT,
                                         GL_UNSIGNED_INT,  GL_INT,  GL_FLOAT};

inline const PackedType* packed(GLenum type) {
    for (const PackedType& p : packed_types)
        if (p.type == type)
            return &p;
    return nullptr;
}
inline int element_bytes(GLenum type) {
    if (const PackedType* const p = packed(type))
        return p->bytes;
    switch (type) {
    case GL_UNSIGNED_BYTE:
    case GL_BYTE:
    case GL_BITMAP:
        return 1;
    case GL_UNSIGNED_SHORT:
    case GL_SHORT:
        return 2;
    default:
        return 4;
    }
}
/// Whether a format and a type may be combined: packed types have their own formats, BITMAP has indices
/// (tables 3.8 and 3.6).
inline bool goes_together(GLenum format, GLenum type) {
    const bool index = format == GL_COLOR_INDEX || format == GL_STENCIL_INDEX;
    if (type == GL_BITMAP)
        return index;
    const PackedType* const p = packed(type);
    return p == nullptr || (p->fields[3] == 0 ? format == GL_RGB : groups_of(format) == 4);
}

class ClientOracle {
  public:
    ClientOracle(GLenum format, GLenum type, int width, int height, const Store& store)
        : format_(format), type_(type), store_(store),
          length_(store.row_length > 0 ? store.row_length : width),
          size_(static_cast<std::size_t>((height + store.skip_rows + 1) * stride() + 16 +
                                         (length_ + store.skip_pixels + width) * 16)) {}

    std::size_t bytes() const { return size_; }

    /// Returns component or index i of a group: an index as a number, a component as a fraction.
    double value(const unsigned char* memory, int n, int m, int i) const {
        const unsigned char* row = memory + static_cast<std::ptrdiff_t>(store_.skip_rows + m) * stride();
        const int pixel = store_.skip_pixels + n;
        if (type_ == GL_BITMAP) {
            const int byte = row[pixel / 8];
            return byte >> (store_.lsb ? pixel % 8 : 7 - pixel % 8) & 1;
        }
        const int s = element_bytes(type_);
        const PackedType* const p = packed(type_);
        const int elements = p != nullptr ? 1 : groups_of(format_);
        const unsigned char* at =
            row + (static_cast<std::ptrdiff_t>(pixel) * elements + (p != nullptr ? 0 : i)) * s;
        unsigned char b[4] = {};
        for (int k = 0; k < s; ++k)
            b[k] = at[store_.swap ? s - 1 - k : k];
        std::uint64_t word = 0; // this machine is little-endian
        for (int k = 0; k < s; ++k)
            word |= static_cast<std::uint64_t>(b[k]) << 8 * k;
        if (p != nullptr) {
            int low = p->reversed ? 0 : 8 * s;
            for (int k = 0;; ++k) {
                if (!p->reversed)
                    low -= p->fields[k];
                if (k == i) {
                    const double most = (1 << p->fields[k]) - 1;
                    return static_cast<double>(word >> low & static_cast<std::uint64_t>(most)) / most;
                }
                if (p->reversed)
                    low += p->fields[k];
            }
        }
        if (type_ == GL_FLOAT)
            return std::bit_cast<float>(static_cast<std::uint32_t>(word));
        const bool is_signed = type_ == GL_BYTE || type_ == GL_SHORT || type_ == GL_INT;
        const double whole = std::ldexp(1, 8 * s);
        double v = static_cast<double>(word);
        if (is_signed && v >= whole / 2)
            v -= whole;
        if (format_ == GL_COLOR_INDEX || format_ == GL_STENCIL_INDEX)
            return v;
        return is_signed ? (2 * v + 1) / (whole - 1) : v / (whole - 1);
    }

    /// Returns R, G, B and A after the final expansion.
    void color(const unsigned char* memory, int n, int m, double out[4]) const {
        const auto v = [&](int i) { return value(memory, n, m, i); };
        out[0] = out[1] = out[2] = 0;
        out[3] = 1;
        switch (format_) {
        case GL_RED:
            out[0] = v(0);
            break;
        case GL_GREEN:
            out[1] = v(0);
            break;
        case GL_BLUE:
            out[2] = v(0);
            break;
        case GL_ALPHA:
            out[3] = v(0);
            break;
        case GL_LUMINANCE_ALPHA:
            out[3] = v(1);
            [[fallthrough]];
        case GL_LUMINANCE:
            out[0] = out[1] = out[2] = v(0);
            break;
        case GL_RGBA:
            out[3] = v(3);
            [[fallthrough]];
        case GL_RGB:
            for (int c = 0; c < 3; ++c)
                out[c] = v(c);
            break;
        case GL_BGRA:
            out[3] = v(3);
            [[fallthrough]];
        default:
            for (int c = 0; c < 3; ++c)
                out[c] = v(2 - c);
        }
    }

  private:
    /// Returns k of GL 1.3, 3.6.4, in bytes.
    std::ptrdiff_t stride() const {
        const int a = store_.alignment;
        if (type_ == GL_BITMAP)
            return static_cast<std::ptrdiff_t>(a) * ((length_ + 8 * a - 1) / (8 * a));
        const int s = element_bytes(type_), n = packed(type_) != nullptr ? 1 : groups_of(format_);
        const int nl = n * length_;
        return s >= a ? static_cast<std::ptrdiff_t>(s) * nl
                      : static_cast<std::ptrdiff_t>(a) * ((s * nl + a - 1) / a);
    }

    GLenum format_, type_;
    Store store_;
    int length_;
    std::size_t size_;
};

} // namespace spangle::gl::test
