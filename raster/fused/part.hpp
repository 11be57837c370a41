// A part of the table of fused spans. A key that is not in the table is drawn by the chain, with the same
// bytes but slower. A scene profile has its own table: SPANGLE_FUSED names a file in the form of
// raster/span/fused_list.inc.
#pragma once

#include <cstddef>
#include <utility>

#include "raster/fused/cases.hpp"
#include "raster/fused/table.hpp"
#include "raster/span/fused_keys.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

template <Key K> constexpr FusedSpan fused_entry() {
    using Case = FusedCase<K>;
#ifdef SPANGLE_FIRMWARE
    return {Case::key, &Case::run, Case::splits_gray, Case::walk(), nullptr, Case::guessed, nullptr};
#else
    return {Case::key,      &Case::run,    Case::splits_gray,           Case::walk(),
            Case::shapes(), Case::guessed, &Case::template run_lanes<1>};
#endif
}

template <std::size_t Part, class Indices = std::make_index_sequence<fused_part_size(Part)>> struct FusedPart;
template <std::size_t Part, std::size_t... I> struct FusedPart<Part, std::index_sequence<I...>> {
    static constexpr FusedSpan spans[] = {fused_entry<fused_list::keys[Part + I * fused_parts]>()...};
};

template <std::size_t Part> const FusedSpan* fused_part() {
    if constexpr (fused_part_size(Part) != 0)
        return FusedPart<Part>::spans;
    else
        return nullptr;
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
