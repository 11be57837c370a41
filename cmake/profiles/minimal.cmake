# For a lit, textured model in a parallel projection and the fast tier: what the smallest boards draw (boards/minimal). The build has only
# the spans of its list; a state that needs another span is an error.
set(SPANGLE_PROFILE_FEATURES LIGHTING)
set(SPANGLE_FUSED lit_textured_parallel)
set(SPANGLE_CHAIN 0)
set(SPANGLE_TIER_SET fast)
set(SPANGLE_COLOR_FORMATS rgb565)
set(SPANGLE_DEPTH_FORMATS z16)
set(SPANGLE_TEXTURE_FORMATS rgb565)
set(SPANGLE_TEXTURE_UNITS 1)
set(SPANGLE_TEXTURE_LEVELS 7)
set(SPANGLE_LIGHTS 1)
set(SPANGLE_LIGHT_KINDS none) # only ambient and diffuse light
set(SPANGLE_FULL_LIGHTING 0) # NORMALIZE and RESCALE_NORMAL are errors: normals must be unit vectors
set(SPANGLE_MODELVIEW_STACK 2)
set(SPANGLE_PROJECTION_STACK 1)
set(SPANGLE_TEXTURE_STACK 1)
set(SPANGLE_ARRAY_TYPES short)
set(SPANGLE_VERTEX_CACHE 1) # no cache: a vertex that indices name again is transformed again
set(SPANGLE_PRIMITIVES none) # only triangles
set(SPANGLE_PERSPECTIVE 0) # no division by the distance
set(SPANGLE_OPTIMIZE size)
set(SPANGLE_ARGUMENTS_INLINE 1) # the program calls few entry points
set(SPANGLE_DISPLAYS 1)
set(SPANGLE_EXTENTS 0) # frames are sent whole, without damage
set(SPANGLE_PACKET 2)
set(SPANGLE_CLIPPING 0) # no clipping: models must stand between the near and the far plane
set(SPANGLE_ARENA_REUSE 0) # memory that GL frees is not used again
