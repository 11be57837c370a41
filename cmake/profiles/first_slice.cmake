# The first slice of GL: primitives, matrices, lighting, textures, fog, blending and the tests of fragments, in the balanced tier on 16-bit
# surfaces. Display lists, the imaging paths and everything that came later are left out.
set(SPANGLE_PROFILE_FEATURES LIGHTING FOG)
set(SPANGLE_FUSED few)
set(SPANGLE_TIER_SET 2)            # balanced
set(SPANGLE_COLOR_FORMATS 1)    # rgb565_be
set(SPANGLE_DEPTH_FORMATS 3)    # none, z16
set(SPANGLE_TEXTURE_FORMATS 83) # a8, l8, rgb565, rgba8888
set(SPANGLE_TEXTURE_UNITS 1)
set(SPANGLE_LINE_BATCH 2)
set(SPANGLE_VERTEX_CACHE 1)
set(SPANGLE_SHORTCUTS 0)
set(SPANGLE_KERNELS_INLINE 0)
set(SPANGLE_SEED_TABLES 0)
set(SPANGLE_ARGUMENTS_INLINE 0)
