// Get{Boolean,Integer,Float,Double,Fixed}v, GetPointerv, GetError (GL 1.3, 2.5, 6.1.2, 6.1.11).
#include <cstring>

#include "gl/api/convert.hpp"
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/state_table.hpp"

namespace spangle::gl {

namespace {

/// Returns the row of `pname`, which must hold a pointer if `pointer`, and a value otherwise. Null: the error
/// is set.
const StateRow* find_row(Context& context, GLenum pname, const void* out, bool pointer) {
    const StateRow* const row = find_state(pname);
    if (row == nullptr || (row->source == Source::pointer) != pointer) {
        error(context, GL_INVALID_ENUM);
        return nullptr;
    }
    if (row->left_out()) {
        error(context, GL_INVALID_OPERATION, row->missing);
        return nullptr;
    }
    if (out == nullptr) {
        error(context, GL_INVALID_VALUE);
        return nullptr;
    }
    return row;
}

void get(Context& context, GLenum pname, void* out, convert::Number type) {
    const StateRow* const row = find_row(context, pname, out, false);
    if (row == nullptr)
        return;
    Param values[most_values];
    load_state(context, *row, pname, values);
    for (unsigned i = 0; i < row->count; ++i)
        convert::store_value(out, i, type, kind_of(row->source), values[i]);
}

} // namespace

namespace cmd {

void GetBooleanv(Context& context, GLenum pname, GLboolean* params) {
    get(context, pname, params, convert::Number::b);
}
void GetIntegerv(Context& context, GLenum pname, GLint* params) {
    get(context, pname, params, convert::Number::i);
}
void GetFloatv(Context& context, GLenum pname, GLfloat* params) {
    get(context, pname, params, convert::Number::f);
}
void GetDoublev(Context& context, GLenum pname, GLdouble* params) {
    get(context, pname, params, convert::Number::d);
}
void GetFixedvOES(Context& context, GLenum pname, GLfixed* params) {
    get(context, pname, params, convert::Number::x);
}

void GetPointerv(Context& context, GLenum pname, void** params) {
    if (const StateRow* const row = find_row(context, pname, params, true); row != nullptr)
        std::memcpy(params,
                    reinterpret_cast<const unsigned char*>(&context) +
                        offset_of(context, *row, pname, sizeof *params),
                    sizeof *params);
}

GLenum GetError(Context& context) {
    const GLenum code = context.error_code;
    context.error_code = GL_NO_ERROR;
    return code;
}

} // namespace cmd

} // namespace spangle::gl
