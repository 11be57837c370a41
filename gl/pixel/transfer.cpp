#include "gl/pixel/transfer.hpp"

namespace spangle::gl {

#if SPANGLE_FEATURE_PIXEL_TRANSFER

namespace {

bool is_identity(Real scale, Real bias) {
    return scale == numeric::one && numeric::is_zero(bias);
}

Component scaled(Component c, Real scale, Real bias) {
    return is_identity(scale, bias) ? c : component(numeric::add(numeric::mul(to_real(c), scale), bias));
}

std::uint32_t map_entry(const PixelMap* map, std::uint32_t at) {
    return map != nullptr ? map->entries()[at] : 0;
}

std::uint32_t last_of(const PixelMap* map) {
    return map != nullptr ? static_cast<std::uint32_t>(map->size) - 1 : 0;
}

/// Returns the entry that an index selects. The sizes of maps that indices select from are powers of two.
std::uint32_t entry_at(const PixelMap* map, Index index) {
    return map_entry(map, rounded(index) & last_of(map));
}

[[gnu::noinline]] Index shifted_by(const PixelModeState& state, Index index) {
    return shifted(index, state.index_shift, state.index_offset);
}

} // namespace

Transfer::Transfer(const PixelModeState& state) : state_(state), has_map_(state.map_color) {
    for (int c = 0; c < 4; ++c)
        has_scale_or_bias_ = has_scale_or_bias_ || !is_identity(state.linear[c].scale, state.linear[c].bias);
}

void Transfer::transfer_color(Pixel& color) const {
    for (unsigned c = 0; c < 4; ++c) {
        Component& v = color.value[c];
        v = scaled(v, state_.linear[c].scale, state_.linear[c].bias);
        if (!has_map_)
            continue;
        const PixelMap* const map = state_.map[map_r_to_r + c];
        v = component(Real{map_entry(map, steps_of(v, last_of(map)))});
    }
}

Pixel Transfer::color_of(Index index) const {
    const Index moved = shifted_by(state_, index);
    Pixel color;
    for (unsigned c = 0; c < 4; ++c)
        color.value[c] = component(Real{entry_at(state_.map[map_i_to_r + c], moved)});
    return color;
}

Index Transfer::index(Index index) const {
    const Index moved = shifted_by(state_, index);
    if (!state_.map_color)
        return moved;
    const PixelMap* const map = state_.map[map_i_to_i];
    const std::uint32_t to = entry_at(map, moved);
    return map == nullptr || map->integers ? whole_index(to) : index_of(Real{to});
}

Index Transfer::stencil(Index index) const {
    const Index moved = shifted_by(state_, index);
    if (!state_.map_stencil)
        return moved;
    return whole_index(entry_at(state_.map[map_s_to_s], moved)); // map entries are integers
}

Component Transfer::depth(Component z) const {
    return scaled(z, state_.linear[4].scale, state_.linear[4].bias);
}

#else

Transfer::Transfer(const PixelModeState& state) : state_(state) {}

void Transfer::transfer_color(Pixel&) const {}

/// Returns the colour that the initial maps give. Each initial map has one entry, 0.
Pixel Transfer::color_of(Index) const {
    static_cast<void>(state_);
    const Component nothing = component(numeric::zero);
    return {{nothing, nothing, nothing, nothing}};
}

Index Transfer::index(Index index) const {
    return index;
}

Index Transfer::stencil(Index index) const {
    return index;
}

Component Transfer::depth(Component z) const {
    return z;
}

#endif

} // namespace spangle::gl
