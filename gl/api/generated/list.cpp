// Entry points: Display lists.
// Written by gl/api/generate.py from gl/api/commands: change those, not this.
#include "gl/api/components.hpp"
#include "gl/api/convert.hpp"
#include "gl/api/generated/commands.hpp"
#include "gl/api/generated/shapes.hpp"
#include "gl/api/issue.hpp"
#include "gl/api/params.hpp"
#include "gl/api/refused.hpp"

using namespace spangle::gl;
namespace numeric = spangle::numeric;

extern "C" {

#if SPANGLE_FEATURE_LISTS

void GLAPIENTRY glNewList(GLuint list, GLenum mode) {
    issue<family::NewList>(list, mode);
}

void GLAPIENTRY glEndList() {
    issue<family::EndList>();
}

void GLAPIENTRY glCallList(GLuint list) {
    issue<family::CallList>(list);
}

void GLAPIENTRY glCallLists(GLsizei n, GLenum type, const void* lists) {
    issue<family::CallLists>(n, type, lists);
}

void GLAPIENTRY glListBase(GLuint base) {
    issue<family::ListBase>(base);
}

GLuint GLAPIENTRY glGenLists(GLsizei range) {
    return ask<family::GenLists>(range);
}

void GLAPIENTRY glDeleteLists(GLuint list, GLsizei range) {
    issue<family::DeleteLists>(list, range);
}

GLboolean GLAPIENTRY glIsList(GLuint list) {
    return ask<family::IsList>(list);
}

#endif

#if !SPANGLE_FEATURE_LISTS

SPANGLE_REFUSED("glNewList: this build has no SPANGLE_FEATURE_LISTS", void GLAPIENTRY glNewList(GLuint, GLenum))

SPANGLE_REFUSED("glEndList: this build has no SPANGLE_FEATURE_LISTS", void GLAPIENTRY glEndList())

SPANGLE_REFUSED("glCallList: this build has no SPANGLE_FEATURE_LISTS", void GLAPIENTRY glCallList(GLuint))

SPANGLE_REFUSED("glCallLists: this build has no SPANGLE_FEATURE_LISTS", void GLAPIENTRY glCallLists(GLsizei, GLenum, const void*))

SPANGLE_REFUSED("glListBase: this build has no SPANGLE_FEATURE_LISTS", void GLAPIENTRY glListBase(GLuint))

GLuint GLAPIENTRY glGenLists(GLsizei) {
    refuse_feature(SPANGLE_TEXT("glGenLists: this build has no SPANGLE_FEATURE_LISTS"));
    return 0;
}

SPANGLE_REFUSED("glDeleteLists: this build has no SPANGLE_FEATURE_LISTS", void GLAPIENTRY glDeleteLists(GLuint, GLsizei))

GLboolean GLAPIENTRY glIsList(GLuint) {
    refuse_feature(SPANGLE_TEXT("glIsList: this build has no SPANGLE_FEATURE_LISTS"));
    return 0;
}

#endif

} // extern "C"
