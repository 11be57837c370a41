# A lit, textured model in a parallel projection and the fast tier, and nothing else: what the smallest boards draw (boards/minimal).
# Only the spans of the list are there; a state that needs another one is an error.
set(SPANGLE_PROFILE_FEATURES LIGHTING)
set(SPANGLE_FUSED lit_textured_parallel)
set(SPANGLE_CHAIN 0)
set(SPANGLE_TIER_SET 4)            # fast
set(SPANGLE_COLOR_FORMATS 1)    # rgb565_be
set(SPANGLE_DEPTH_FORMATS 3)    # none, z16
set(SPANGLE_TEXTURE_FORMATS 16) # rgb565
set(SPANGLE_TEXTURE_UNITS 1)
set(SPANGLE_TEXTURE_LEVELS 7)
set(SPANGLE_LIGHTS 1)
set(SPANGLE_LIGHT_KINDS 0)      # ambient and diffuse
set(SPANGLE_FULL_LIGHTING 0)    # normals are unit as they are given
set(SPANGLE_MODELVIEW_STACK 2)
set(SPANGLE_PROJECTION_STACK 1)
set(SPANGLE_TEXTURE_STACK 1)
set(SPANGLE_ARRAY_TYPES 4)       # shorts
set(SPANGLE_VERTEX_CACHE 1)      # none: what indices name again is transformed again
set(SPANGLE_LINE_BATCH 2)
set(SPANGLE_PRIMITIVES 0)       # triangles
set(SPANGLE_PERSPECTIVE 0)      # nothing is divided by its distance
set(SPANGLE_SHORTCUTS 0)
set(SPANGLE_KERNELS_INLINE 0)
set(SPANGLE_SEED_TABLES 0)
set(SPANGLE_DISPLAYS 1)
set(SPANGLE_EXTENTS 0)          # frames are sent whole
set(SPANGLE_PACKET 2)
set(SPANGLE_CLIPPING 0)         # models stand between the near and the far plane
set(SPANGLE_ARENA_REUSE 0)      # nothing is made anew
