// Rows of texture units (GL 1.3, tables 6.15 to 6.17).
#pragma once

#include "gl/context/state_row.hpp"

#define TARGET(NAME, I) of_unit(sizeof(TextureUnitState), SWITCH(NAME, texture.unit[0].enabled[I]))
#if SPANGLE_FEATURE_TEXGEN
#define TEXGEN(NAME, I) of_unit(sizeof(TextureUnitState), SWITCH(NAME, texture.unit[0].gen_on[I]))
#define TEXGENS of_unit(sizeof(TextureUnitState), HELD(texture.unit[0].gen))
#else // this build has no member for the state
#define TEXGEN(NAME, I) of_texgen(absent_switch(NAME))
#define TEXGENS in(Group::texture)
#endif

namespace spangle::gl {

inline constexpr auto texture_rows = std::to_array<WrittenRow>({
    in(Group::texture),
    of_texture_1d(TARGET(GL_TEXTURE_1D, 0)),
    of_feature(raster::has_textures, SPANGLE_TEXT("this build has no texture units (SPANGLE_TEXTURE_UNITS)"),
               TARGET(GL_TEXTURE_2D, 1)),
    of_texture_3d(TARGET(GL_TEXTURE_3D, 2)),
    of_cube_map(TARGET(GL_TEXTURE_CUBE_MAP, 3)),
    TEXGEN(GL_TEXTURE_GEN_S, 0),
    TEXGEN(GL_TEXTURE_GEN_T, 1),
    TEXGEN(GL_TEXTURE_GEN_R, 2),
    TEXGEN(GL_TEXTURE_GEN_Q, 3),
    TEXGENS,
    HELD(texture.active),
    of_texture_1d(computed<computed_state::binding>(GL_TEXTURE_BINDING_1D, Kind::integer, 1)),
    computed<computed_state::binding>(GL_TEXTURE_BINDING_2D, Kind::integer, 1),
    of_texture_3d(computed<computed_state::binding>(GL_TEXTURE_BINDING_3D, Kind::integer, 1)),
    of_cube_map(computed<computed_state::binding>(GL_TEXTURE_BINDING_CUBE_MAP, Kind::integer, 1)),
    in(Group::none),
    computed<computed_state::active_unit>(GL_ACTIVE_TEXTURE, Kind::integer, 1),
    computed<computed_state::active_unit>(GL_CLIENT_ACTIVE_TEXTURE, Kind::integer, 1),
    constant(GL_MAX_TEXTURE_UNITS, raster::has_textures ? texture_units : 0),
});

#undef TARGET
#undef TEXGEN
#undef TEXGENS

} // namespace spangle::gl
