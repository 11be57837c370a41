// Reads the elements of the enabled vertex arrays as canonical values (GL 1.3, 2.8).
#pragma once

#include <cstddef>

#include "gl/context/features.hpp"
#include "gl/vertex/arrays_state.hpp"

namespace spangle::gl {

/// Returns the bytes of one component of this type.
unsigned bytes_of(GLenum type);

/// Reads elements of one vertex array, which the constructor prepares.
class ArrayReader {
  public:
    ArrayReader() = default;
    /// If `normalized`, integers become fractions (GL 1.3, table 2.6).
    ArrayReader(const ClientArray& array, bool normalized);

    /// True if the array is enabled and its pointer is not null.
    bool on() const { return base_ != nullptr; }
    /// Returns the number of components of an element, 1 to 4, or 0 if the array is disabled.
    unsigned components() const { return on() ? components_ : 0; }

    /// True if elements are `count` aligned floats, which words() and word() can read.
    bool is_floats(unsigned count) const {
        return has_array_type(GL_FLOAT) && aligned_floats_ && components_ == count;
    }
    SPANGLE_INLINE const std::uint8_t* words(std::uint32_t index) const { return base_ + stride_ * index; }
    static std::uint32_t word(const std::uint8_t* at, int i) {
        std::uint32_t bits;
        __builtin_memcpy(&bits, __builtin_assume_aligned(at + 4 * i, 4), sizeof bits);
        return bits;
    }

    /// Reads the three components of an element of an array that is_floats(3).
    SPANGLE_INLINE static void read_3_floats(const std::uint8_t* at, Real* out) {
        out[0] = float_at(at);
        out[1] = float_at(at + 4);
        out[2] = float_at(at + 8);
    }

    /// Reads the components of an element. `out` keeps components beyond the array's size.
    template <int N> SPANGLE_INLINE void read(std::uint32_t index, Real (&out)[N]) const {
        if constexpr (!numeric::runs_inline)
            return read_some(index, out);
        const std::uint8_t* const at = base_ + stride_ * index;
        if (!has_array_type(GL_FLOAT) || !aligned_floats_)
            return convert(at, out);
        out[0] = float_at(at);
        if (components_ < 2)
            return;
        out[1] = float_at(at + 4);
        if (components_ < 3)
            return;
        out[2] = float_at(at + 8);
        if constexpr (N > 3)
            if (components_ > 3)
                out[3] = float_at(at + 12);
    }

  private:
    const std::uint8_t* base_ = nullptr;
    std::size_t stride_ = 0;
    GLenum type_ = GL_FLOAT;
    std::uint8_t components_ = 4;
    bool normalized_ = false;
    bool aligned_floats_ = false; ///< true if words() can read the elements, as for most arrays

    static Real float_at(const std::uint8_t* at) {
        const std::uint32_t bits = word(at, 0);
        return (bits >> 23 & 255) != 255 ? Real{bits} : numeric::from_float_bits(bits);
    }
    void convert(const std::uint8_t* at, Real* out) const;
    /// Does the work of read() for any number of components.
    SPANGLE_RUN_CALL void read_some(std::uint32_t index, Real* out) const {
        const std::uint8_t* const at = base_ + stride_ * index;
        if (!has_array_type(GL_FLOAT) || !aligned_floats_)
            return convert(at, out);
        for (unsigned c = 0; c < components_; ++c)
            out[c] = float_at(at + std::size_t{4} * c);
    }
};

/// All arrays that ArrayElement reads, as they are when a draw begins.
struct ElementReader {
    ArrayReader vertex, normal, color, tex_coord[texture_units];
    bool textured = false; ///< true if an array of tex_coord is enabled
    /// The arrays, if a rarely used one of them is enabled: index, edge_flag, fog_coord or secondary_color.
    /// Otherwise null.
    const ArraysState* seldom;

    explicit ElementReader(const ArraysState& arrays)
        : vertex(arrays.vertex, false), normal(arrays.normal, true), color(arrays.color, true),
          seldom(any_seldom(arrays) ? &arrays : nullptr) {
        for (int u = 0; u < texture_units; ++u)
            if (arrays.tex_coord[u].on()) {
                tex_coord[u] = ArrayReader(arrays.tex_coord[u], false);
                textured = true;
            }
    }

    static bool any_seldom(const ArraysState& arrays) {
        return (SPANGLE_FEATURE_COLOR_INDEX && arrays.index.enabled) ||
               (SPANGLE_FEATURE_POLYGON_MODE && arrays.edge_flag.enabled) ||
               (SPANGLE_FEATURE_FOG && arrays.fog_coord.enabled) ||
               (SPANGLE_FEATURE_SECONDARY_COLOR && arrays.secondary_color.enabled);
    }
};

/// Indices of the elements of a draw: consecutive from `first` on, or read from memory.
struct Indices {
    /// GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT or GL_UNSIGNED_INT: `data` holds the indices. GL_NONE: they are
    /// consecutive.
    GLenum type = GL_NONE;
    std::uint32_t first = 0;
    const void* data = nullptr;

    SPANGLE_INLINE std::uint32_t at(std::uint32_t i) const {
        if (type == GL_UNSIGNED_SHORT)
            return read<std::uint16_t>(i);
        if (type == GL_NONE)
            return first + i;
        return type == GL_UNSIGNED_INT ? read<std::uint32_t>(i) : read<std::uint8_t>(i);
    }

    /// Aligned indices of 16 bits, which are most frequent. A loop over them need not test their type.
    struct Shorts {
        const std::uint8_t* data;
        SPANGLE_INLINE std::uint32_t at(std::uint32_t i) const {
            std::uint16_t value;
            const std::uint8_t* const at = data + std::size_t{i} * sizeof value;
            __builtin_memcpy(&value, __builtin_assume_aligned(at, sizeof value), sizeof value);
            return value;
        }
        Shorts from(std::uint32_t n) const { return {data + std::size_t{n} * sizeof(std::uint16_t)}; }
    };
    /// Returns the indices as Shorts. `data` is null if they have another type or are not aligned.
    Shorts shorts() const {
        const bool aligned = (reinterpret_cast<std::uintptr_t>(data) & 1) == 0;
        return {type == GL_UNSIGNED_SHORT && aligned ? static_cast<const std::uint8_t*>(data) : nullptr};
    }

    /// Returns the indices from number n on.
    Indices from(std::uint32_t n) const {
        Indices rest = *this;
        if (type == GL_NONE)
            rest.first += n;
        else if (n != 0)
            rest.data = static_cast<const std::uint8_t*>(data) + std::size_t{n} * bytes_of(type);
        return rest;
    }

  private:
    template <class T> std::uint32_t read(std::uint32_t i) const {
        T value;
        __builtin_memcpy(&value, static_cast<const std::uint8_t*>(data) + std::size_t{i} * sizeof value,
                         sizeof value);
        return value;
    }
};

} // namespace spangle::gl
