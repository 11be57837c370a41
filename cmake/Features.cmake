# Optional systems (design 5): off means not compiled, and the command says so when it is called. The one list of them;
# gl/context/features.hpp turns all on where nobody asked.
set(SPANGLE_FEATURES)
macro(spangle_feature name text)
    option(SPANGLE_FEATURE_${name} "${text}" ON)
    list(APPEND SPANGLE_FEATURES ${name})
endmacro()

spangle_feature(LISTS "Display lists")
spangle_feature(LIGHTING "Lighting")
spangle_feature(FOG "Fog")
spangle_feature(POLYGON_MODE "Polygons as lines and points, edge flags")
spangle_feature(COLOR_INDEX "Colour indices as vertex attributes")
spangle_feature(ATTRIB_STACKS "PushAttrib and PushClientAttrib")
spangle_feature(SELECTION "Selection: name stack and hit records")
spangle_feature(FEEDBACK "Feedback")
spangle_feature(EVALUATORS "Evaluators")
spangle_feature(FIXED_POINT "Entry points of OES_fixed_point")
spangle_feature(GET_PROC_ADDRESS "eglGetProcAddress")
