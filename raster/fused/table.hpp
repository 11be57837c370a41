// The table of fused spans: the keys that have a loop of their own.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include "raster/span/draw_state.hpp"
#include "raster/span/fused_keys.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/key.hpp"
#include "raster/span/path.hpp"
#include "raster/span/rows.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

struct FusedSpan {
    Key key;
    RowsFunction<Fixed> run;
    bool gray;                  ///< `run` reads Span::gray (Variant::gray)
    PathFunction walk;          ///< null: paths are drawn as rows
    const Shapes* shapes;       ///< null: all triangles are drawn as rows
    bool guesses;               ///< colours may be guessed (Span::guess)
    RowsFunction<Fixed> narrow; ///< `run` with one lane only, for tests; null in firmware
};

/// The table is compiled in parts, each from its own file: a single file would take gigabytes to compile. The
/// short list of a profile is one part. Key i of the list is in part i % fused_parts.
inline constexpr std::size_t fused_span_count =
    has_fused_spans ? sizeof fused_list::keys / sizeof fused_list::keys[0] : 0;
inline constexpr std::size_t fused_parts = fused_span_count > 16 ? 8 : 1;
constexpr std::size_t fused_part_size(std::size_t part) {
    return part < fused_parts ? (fused_span_count + fused_parts - 1 - part) / fused_parts : 0;
}
/// The spans of a part; null where the part is empty.
template <std::size_t Part> const FusedSpan* fused_part();

static_assert(std::has_unique_object_representations_v<Key>, "keys are compared as bytes");

namespace inner {

inline const FusedSpan* find_among(const FusedSpan* span, std::size_t count, const Key& key) {
    // Hosts first compare the first word of a key, without a call, because most keys differ there.
    constexpr std::size_t first = numeric::wide_words ? sizeof(std::uint64_t) : 0;
    for (const FusedSpan* const end = span + count; span != end; ++span)
        if (__builtin_memcmp(&span->key, &key, first) == 0 &&
            __builtin_memcmp(&span->key, &key, sizeof key) == 0)
            return span;
    return nullptr;
}
template <std::size_t... Part>
inline const FusedSpan* find_fused(const Key& key, std::index_sequence<Part...>) {
    const FusedSpan* found = nullptr;
    static_cast<void>(
        (... || ((found = find_among(fused_part<Part>(), fused_part_size(Part), key)) != nullptr)));
    return found;
}
template <std::size_t... Part>
inline const FusedSpan* part_of(std::size_t part, std::index_sequence<Part...>) {
    const FusedSpan* const parts[] = {fused_part<Part>()...};
    return parts[part];
}

} // namespace inner

/// The fused span of a key; null where the chain draws the key. A build without fused spans refers to none of
/// them.
inline const FusedSpan* find_fused(const Key& key) {
    if constexpr (has_fused_spans)
        return inner::find_fused(key, std::make_index_sequence<fused_parts>());
    return nullptr;
}

/// Span i of the list. Only tests call this.
inline const FusedSpan& fused_span(std::size_t i) {
    return inner::part_of(i % fused_parts, std::make_index_sequence<fused_parts>())[i / fused_parts];
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
