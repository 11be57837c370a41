# The list of all limits of a build: how much of each thing there is, and what the build can draw. The usual values are GL's own.
# Queries return what the build has. This table is the source. Three headers repeat the usual numbers for builds without CMake:
# raster/limits.hpp, raster/numeric/machine.hpp and gl/context/limits.hpp. tests/tools/profiles/options.py compares them with the table.
# boards/tools/profile.py reads the rows of this file, too, so each row keeps the form of its neighbours.
include(${CMAKE_CURRENT_LIST_DIR}/Choices.cmake)

set(SPANGLE_OPTIMIZE speed CACHE STRING "What the library is made for where both ways draw the same bytes: speed or size.")
set_property(CACHE SPANGLE_OPTIMIZE PROPERTY STRINGS speed size)

# spangle_limit(NAME usual "values" "text")
spangle_limit(TEXTURE_UNITS 2 "0..2" "Number of texture units. GL 1.3 asks for 2. With 0 nothing is textured.")
spangle_limit(TEXTURE_LEVELS 12 "1..12" "Number of levels of a texture. The largest texture has 2^(levels - 1) texels on each side.")
spangle_limit(LIGHTS 8 "1..8" "Number of lights. GL 1.3 asks for 8.")
spangle_limit(FULL_LIGHTING 1 "0|1" "With 1, normals may have any length, and diffuse colours may be 16 and more. With 0, GL_NORMALIZE, GL_RESCALE_NORMAL and such colours are errors.")
spangle_limit(MODELVIEW_STACK 32 "1.." "Number of matrices on the modelview stack. GL 1.3 asks for 32.")
spangle_limit(PROJECTION_STACK 2 "1.." "Number of matrices on the projection stack. GL 1.3 asks for 2.")
spangle_limit(TEXTURE_STACK 2 "1.." "Number of matrices on the texture stack of each unit. GL 1.3 asks for 2.")
spangle_limit(NAME_STACK 64 "1.." "Number of names on the name stack of selection. GL 1.3 asks for 64.")
spangle_limit(LIST_NESTING 64 "2.." "Number of display lists that may call each other. GL 1.3 asks for 64.")
spangle_limit(VERTEX_CACHE 0 "0.." "Number of transformed vertices that are kept for indices that come again. 1 keeps none. 0 keeps 80 in firmware and 8192 on hosts.")
spangle_limit(CLIP_SPARE 2 "0.." "Number of extra corners that clipping keeps for polygons that are not convex.")
spangle_limit(CLIPPING 1 "0|1" "With 1, primitives are cut at the view volume. With 0, a primitive that crosses the near or far plane is an error and is not drawn.")
spangle_limit(DISPLAYS 4 "1.." "Number of EGL displays that may exist at once.")
spangle_limit(ARENA_REUSE 1 "0|1" "With 1, memory that GL frees is used again. With 0 it is not, which suits programs that create all objects once.")
spangle_limit(ARENA_LOG2 0 "0|7..37" "Blocks of GL's memory are smaller than 2^ARENA_LOG2 bytes. 0 takes the number that suits the processor.")
spangle_limit(HOST_MEMORY_MB 64 "1..1024" "Megabytes of memory for GL in a program on a host that hands over none. Firmware always hands over its memory.")
spangle_limit(EXTENTS 1 "0|1" "With 1, surfaces record which columns of each row were drawn. With 0, only displays that are sent whole frames can be used.")
spangle_limit(PACKET 16 "2|4|8|16" "Number of fragments that pass between two stages of the chain at once. Smaller numbers save stack.")
spangle_limit(FUSED_SPANS 1 "0|1" "With 1, common states are drawn by loops of their own. With 0, the chain draws all states, with the same bytes.")
spangle_limit(CHAIN 1 "0|1" "With 1, the chain draws every state that has no loop of its own. With 0, such states are errors.")
spangle_limit(AFFINE_TEXTURES 1 "0|1" "With 1, texture coordinates are affine where the tier's bound allows it. With 0 they are always divided, and pictures may differ within the bound.")
spangle_limit(PERSPECTIVE 1 "0|1" "With 1, projections may have perspective. With 0, only parallel projections can be drawn; this needs CLIPPING 0.")

# spangle_names(NAME the_empty_set "text" the names, from bit 0 up, a dash for a bit without a name). The empty set is `none` with the bits
# that it still has, or a dash where the list must name something. Names stand for the enumerators of PixelFormat, DepthFormat, TexelFormat
# and Tier, for GL's types from GL_BYTE up, and for the bits in gl/context/limits.hpp; host_sim/profile and options.py check them.
spangle_names(TIER_SET - "Tiers of accuracy that the build has." exact balanced fast)
spangle_names(COLOR_FORMATS - "Formats of the surfaces that the build can draw on."
    rgb565 rgb565_le rgb888 rgba8888 rgb666 rgb444 rgb332 grey4 mono index8)
spangle_names(DEPTH_FORMATS none=1 "Formats of depth buffers. A surface may always be without one." - z16 z24s8)
spangle_names(TEXTURE_FORMATS - "Formats in which the build can store textures."
    a8 l8 i8 la88 rgb565 rgb888 rgba8888 rgba4444 rgba5551 rgb332 z16 z24 p4 p8 etc1)
spangle_names(PRIMITIVES none=0 "Primitives beside triangles, triangle strips and triangle fans. Polygons include quads." points lines polygons)
spangle_names(LIGHT_KINDS none=0 "Lighting beside ambient and diffuse light of directional lights. Local lights include spotlights and local viewers."
    specular local two_sided color_material)
spangle_names(ARRAY_TYPES - "Types of the components of vertex arrays, by their names in GL."
    byte unsigned_byte short unsigned_short int unsigned_int float - - - double - fixed)

# spangle_ways(NAME with_speed with_size "values" "text"): each way draws the same bytes. SPANGLE_OPTIMIZE chooses; the options are for
# measurements of ours.
spangle_ways(SHORTCUTS 1 0 "0|1" "With 1, frequent cases such as small triangles have code of their own.")
spangle_ways(KERNELS_INLINE 1 0 "0|1" "With 1, kernels are inline even in code that is compiled for size.")
spangle_ways(SEED_TABLES 1 0 "0|1" "With 1, first guesses of reciprocals, roots and logarithms are read from tables of 1.5 KB. With 0 they are computed.")
spangle_ways(ARGUMENTS_INLINE 1 0 "0|1" "With 1, each entry point converts its arguments itself. With 0, entry points share that code.")
spangle_ways(LINE_BATCH 0 2 "0|2..64" "Number of lines that are drawn together, an even number. 0 takes the number that suits the processor.")

spangle_contradictions()
