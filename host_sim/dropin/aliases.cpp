// Core commands under the suffixed names of extensions, for programs that link those names.
#include <spangle/GL/gl.h>

#define ALIAS(returns, name, command, parameters, arguments)                                                 \
    GLAPI returns GLAPIENTRY name parameters;                                                                \
    returns GLAPIENTRY name parameters {                                                                     \
        return command arguments;                                                                            \
    }

extern "C" {
#include "gl/api/generated/aliases.inc"
}
