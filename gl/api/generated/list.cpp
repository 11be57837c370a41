// Entry points: Display lists.
// Written by gl/api/generate.py from gl/api/commands: change those, not this.
#include "gl/api/components.hpp"
#include "gl/api/convert.hpp"
#include "gl/api/generated/commands.hpp"
#include "gl/api/generated/shapes.hpp"
#include "gl/api/issue.hpp"
#include "gl/api/params.hpp"

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

void GLAPIENTRY glNewList(GLuint, GLenum) {
    refuse_feature(SPANGLE_TEXT("glNewList: this build has no SPANGLE_FEATURE_LISTS"));
}

void GLAPIENTRY glEndList() {
    refuse_feature(SPANGLE_TEXT("glEndList: this build has no SPANGLE_FEATURE_LISTS"));
}

void GLAPIENTRY glCallList(GLuint) {
    refuse_feature(SPANGLE_TEXT("glCallList: this build has no SPANGLE_FEATURE_LISTS"));
}

void GLAPIENTRY glCallLists(GLsizei, GLenum, const void*) {
    refuse_feature(SPANGLE_TEXT("glCallLists: this build has no SPANGLE_FEATURE_LISTS"));
}

void GLAPIENTRY glListBase(GLuint) {
    refuse_feature(SPANGLE_TEXT("glListBase: this build has no SPANGLE_FEATURE_LISTS"));
}

GLuint GLAPIENTRY glGenLists(GLsizei) {
    refuse_feature(SPANGLE_TEXT("glGenLists: this build has no SPANGLE_FEATURE_LISTS"));
    return 0;
}

void GLAPIENTRY glDeleteLists(GLuint, GLsizei) {
    refuse_feature(SPANGLE_TEXT("glDeleteLists: this build has no SPANGLE_FEATURE_LISTS"));
}

GLboolean GLAPIENTRY glIsList(GLuint) {
    refuse_feature(SPANGLE_TEXT("glIsList: this build has no SPANGLE_FEATURE_LISTS"));
    return 0;
}

#endif

} // extern "C"
