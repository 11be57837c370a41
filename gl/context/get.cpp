// Get{Boolean,Integer,Float,Double,Fixed}v, GetPointerv, GetError (GL 1.3, 2.5, 6.1.2, 6.1.11).
#include <cstring>

#include "gl/api/convert.hpp"
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/state_table.hpp"

namespace spangle::gl {

namespace {

/// The row called `pname`, with its values; null after an error.
const StateRow* find_values(Context& context, GLenum pname, const void* out, Param (&values)[most_values]) {
    const StateRow* const row = find_state(pname);
    if (row == nullptr || row->source == Source::pointer) {
        error(context, GL_INVALID_ENUM);
        return nullptr;
    }
    if (row->left_out) {
        error(context, GL_INVALID_OPERATION, row->missing);
        return nullptr;
    }
    if (out == nullptr) {
        error(context, GL_INVALID_VALUE, SPANGLE_TEXT("glGet: null pointer"));
        return nullptr;
    }
    load_state(context, *row, values);
    return row;
}

template <class T> void get(Context& context, GLenum pname, T* out, T (*convert)(Kind, Param)) {
    Param values[most_values];
    if (const StateRow* const row = find_values(context, pname, out, values); row != nullptr)
        for (int i = 0; i < row->count; ++i)
            out[i] = convert(row->kind, values[i]);
}

} // namespace

namespace cmd {

void GetBooleanv(Context& context, GLenum pname, GLboolean* params) {
    get(context, pname, params, convert::to_boolean);
}
void GetIntegerv(Context& context, GLenum pname, GLint* params) {
    get(context, pname, params, convert::to_int);
}
void GetFloatv(Context& context, GLenum pname, GLfloat* params) {
    get(context, pname, params, convert::to_float);
}
void GetDoublev(Context& context, GLenum pname, GLdouble* params) {
    get(context, pname, params, convert::to_double);
}
void GetFixedvOES(Context& context, GLenum pname, GLfixed* params) {
    get(context, pname, params, convert::to_fixed);
}

void GetPointerv(Context& context, GLenum pname, void** params) {
    const StateRow* const row = find_state(pname);
    if (row == nullptr || row->source != Source::pointer)
        return error(context, GL_INVALID_ENUM);
    if (row->left_out)
        return error(context, GL_INVALID_OPERATION, row->missing);
    if (params == nullptr)
        return error(context, GL_INVALID_VALUE, SPANGLE_TEXT("glGetPointerv: null pointer"));
    std::memcpy(params, reinterpret_cast<const unsigned char*>(&context) + offset_of(context, *row),
                sizeof *params);
}

GLenum GetError(Context& context) {
    const GLenum code = context.error_code;
    context.error_code = GL_NO_ERROR;
    return code;
}

} // namespace cmd

} // namespace spangle::gl
