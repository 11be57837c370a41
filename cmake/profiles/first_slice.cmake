# The first slice of GL: primitives, matrices, lighting, textures, fog, blending and the tests of fragments, in the balanced tier on 16-bit
# surfaces. Display lists, the imaging paths and everything that came later are left out.
set(SPANGLE_PROFILE_FEATURES LIGHTING FOG)
set(SPANGLE_FUSED few)
set(SPANGLE_TIER_SET balanced)
set(SPANGLE_COLOR_FORMATS rgb565)
set(SPANGLE_DEPTH_FORMATS z16)
set(SPANGLE_TEXTURE_FORMATS a8 l8 rgb565 rgba8888)
set(SPANGLE_TEXTURE_UNITS 1)
set(SPANGLE_VERTEX_CACHE 1)
set(SPANGLE_OPTIMIZE size)
