# Every command of GL 1.3 and every format of textures and depths, in the balanced tier on 16-bit surfaces.
set(SPANGLE_PROFILE_FEATURES all)
set(SPANGLE_FUSED few)
set(SPANGLE_TIER_SET 2)         # balanced
set(SPANGLE_COLOR_FORMATS 1) # rgb565_be
set(SPANGLE_LINE_BATCH 2)
set(SPANGLE_SHORTCUTS 0)
set(SPANGLE_KERNELS_INLINE 0)
set(SPANGLE_SEED_TABLES 0)
set(SPANGLE_ARGUMENTS_INLINE 0)
