#include "gl/api/issue.hpp"

namespace spangle::gl {

namespace {

void refuse(GLenum code, const char* text) {
    if (Context* context = current_context(); context != nullptr)
        error(*context, code, text);
}

} // namespace

void refuse_null(const char* text) {
    refuse(GL_INVALID_VALUE, text);
}

void refuse_feature(const char* text) {
    refuse(GL_INVALID_OPERATION, text);
}

void refuse_inside(Context& context, const char* text) {
    error(context, GL_INVALID_OPERATION, text);
}

} // namespace spangle::gl
