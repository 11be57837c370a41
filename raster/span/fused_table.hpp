// Keys that have a loop of their own.
#pragma once

#include <cstddef>
#include <type_traits>

#include "raster/span/draw_state.hpp"
#include "raster/span/key.hpp"
#include "raster/span/path.hpp"
#include "raster/span/rows.hpp"

namespace spangle::raster {

struct FusedSpan {
    Key key;
    RowsFunction<Fixed> run;
    bool gray;                  ///< Variant::gray
    PathFunction walk;          ///< null where paths are drawn as rows
    const Shapes* shapes;       ///< null where all is drawn as rows
    bool guesses;               ///< colours are (Span::guess)
    RowsFunction<Fixed> narrow; ///< `run` with one lane only, for the tests; null in firmware
};

/// What runs the chain of a number system of the fixed policy.
AnyFunction chain_runner(Number number);

/// The whole table, for the tests.
const FusedSpan* fused_spans();
std::size_t fused_span_count();

static_assert(std::has_unique_object_representations_v<Key>, "keys are compared as bytes");

/// null: draw with the chain. A build without fused spans names none of them.
inline const FusedSpan* find_fused(const Key& key) {
    if constexpr (has_fused_spans) {
        const FusedSpan* const end = fused_spans() + fused_span_count();
        for (const FusedSpan* span = fused_spans(); span != end; ++span)
            if (__builtin_memcmp(&span->key, &key, sizeof key) == 0)
                return span;
    }
    return nullptr;
}

} // namespace spangle::raster
