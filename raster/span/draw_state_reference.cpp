// The chain of the reference policy.
#include "raster/span/stage_index_reference.hpp"
#include "raster/span/stage_reference.hpp"

#include "raster/span/assemble.hpp"

namespace spangle::raster {

template <> void compile<DoubleVertex>(const FragmentState& state, const Surface& target, DrawState& draw) {
    prepare(draw, state, target);
    draw.words = false; // colours are combined, always
    if (!draw.nothing)
        assemble<Reference>(draw.variant[static_cast<unsigned>(Kind::full)],
                            make_key(state, target, Kind::full), state);
}

} // namespace spangle::raster
