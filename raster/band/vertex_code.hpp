// Vertices as a record stores them. They have the words that the set-up of a state reads, and no others.
#pragma once

#include <cstdint>
#include <type_traits>

#include "raster/span/of_tier.hpp"

namespace spangle::raster {

/// The attributes of a state's vertices, and the number of words that they take.
class VertexCode {
  public:
    static constexpr int most_words = static_cast<int>(sizeof(FixedVertex) / 4);

    explicit VertexCode(const DrawState& draw) : VertexCode(draw.needs, unsnaps(draw)) {}
    /// `rests` says that set-up reads what snapping has taken off the coordinates.
    VertexCode(const Needs& needs, bool rests) : attributes_(needs), has_snap_rests_(rests) {
        word_count_ = 4 + (has_snap_rests_ ? 1 : 0) + (needs.z ? 1 : 0) + 4 + (needs.secondary ? 3 : 0) +
                      (needs.fog ? 1 : 0);
        for (int i = 0; i < max_texture_units; ++i)
            word_count_ += needs.unit[i] ? words_of_unit + (needs.r[i] ? 1 : 0) : 0;
    }
    int words() const { return word_count_; }

    void encode(const FixedVertex& v, std::uint32_t* to) const {
        put(to, v.x);
        put(to, v.y);
        put(to, v.w_mantissa);
        put(to, pack_exponents(v));
        if (has_snap_rests_)
            put(to, pack_halves(v.x_rest, v.y_rest));
        put(to, v.color);
        if (attributes_.z)
            put(to, v.z);
        if (attributes_.secondary)
            put(to, v.secondary);
        if (attributes_.fog)
            put(to, v.fog_mantissa);
        for (int i = 0; i < max_texture_units; ++i) {
            if (!attributes_.unit[i])
                continue;
            put(to, v.tex[i]);
            if (attributes_.r[i])
                put(to, v.r[i]);
        }
    }

    void decode(const std::uint32_t* from, FixedVertex& v) const {
        v = FixedVertex{};
        std::uint32_t pair = 0;
        get(from, v.x);
        get(from, v.y);
        get(from, v.w_mantissa);
        get(from, pair);
        v.w_exponent = static_cast<std::int16_t>(pair >> 16);
        v.fog_exponent = static_cast<std::int16_t>(pair & 0xFFFF);
        if (has_snap_rests_) {
            get(from, pair);
#if SPANGLE_TIER_SET & 1
            v.x_rest = static_cast<std::int16_t>(pair >> 16);
            v.y_rest = static_cast<std::int16_t>(pair & 0xFFFF);
#endif
        }
        get(from, v.color);
        if (attributes_.z)
            get(from, v.z);
        if (attributes_.secondary)
            get(from, v.secondary);
        if (attributes_.fog)
            get(from, v.fog_mantissa);
        for (int i = 0; i < max_texture_units; ++i) {
            if (!attributes_.unit[i])
                continue;
            get(from, v.tex[i]);
            if (attributes_.r[i])
                get(from, v.r[i]);
        }
    }

  private:
    static constexpr int words_of_unit = static_cast<int>(sizeof(FixedVertex::TexCoord) / 4);

    /// The exponents of 1/w and of fog in one word. No bits are unused, so equal vertices have equal words.
    std::uint32_t pack_exponents(const FixedVertex& v) const {
        return pack_halves(v.w_exponent, attributes_.fog ? v.fog_exponent : std::int16_t{0});
    }
    static std::uint32_t pack_halves(std::int16_t high, std::int16_t low) {
        return std::uint32_t{static_cast<std::uint16_t>(high)} << 16 | static_cast<std::uint16_t>(low);
    }
    template <class T> static void put(std::uint32_t*& to, const T& value) {
        static_assert(sizeof(T) % 4 == 0);
        __builtin_memcpy(to, &value, sizeof(T));
        to += sizeof(T) / 4;
    }
    template <class T> static void get(const std::uint32_t*& from, T& value) {
        if constexpr (!std::is_const_v<T>) // a const member is one that no state of this build reads
            __builtin_memcpy(&value, from, sizeof(T));
        from += sizeof(T) / 4;
    }

    Needs attributes_;
    bool has_snap_rests_; ///< set-up reads what snapping has taken off the coordinates
    int word_count_;
};

} // namespace spangle::raster
