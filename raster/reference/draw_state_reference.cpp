// Compiles draws of the reference policy. They are always drawn by chains.
#include "raster/reference/stage_index_reference.hpp"
#include "raster/reference/stage_reference.hpp"

#include "raster/chain/assemble.hpp"

namespace spangle::raster {

template <> void compile<DoubleVertex>(const FragmentState& state, const Surface& target, DrawState& draw) {
    prepare(draw, state, target);
    draw.words = false; // the reference policy always combines colours
    if (!draw.nothing)
        assemble<Reference>(draw.variant[static_cast<unsigned>(Kind::full)],
                            make_key(state, target, Kind::full), state);
}

} // namespace spangle::raster
