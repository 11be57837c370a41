// Names with a suffix, by which extensions call core commands, for programs that link them.
#include <spangle/GL/gl.h>

#define ALIAS(returns, name, command, parameters, arguments)                                                 \
    GLAPI returns GLAPIENTRY name parameters;                                                                \
    returns GLAPIENTRY name parameters {                                                                     \
        return command arguments;                                                                            \
    }

extern "C" {
#include "gl/api/generated/aliases.inc"
}
