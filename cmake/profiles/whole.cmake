# Every command of GL 1.3 and every format of textures and depths, in the balanced tier on 16-bit surfaces.
set(SPANGLE_PROFILE_FEATURES all)
set(SPANGLE_FUSED few)
set(SPANGLE_TIER_SET balanced)
set(SPANGLE_COLOR_FORMATS rgb565)
set(SPANGLE_OPTIMIZE size)
