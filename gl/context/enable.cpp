// Enable, Disable, IsEnabled (GL 1.3, 6.1.1).
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/derived.hpp"
#include "gl/context/hooks.hpp"
#include "gl/context/state_table.hpp"

namespace spangle::gl {

namespace {

/// Returns where the flag of a capability is stored. Null: the error is set. Client arrays are capabilities,
/// too. GL 1.3 has EnableClientState for client arrays, but every driver accepts them here, as
/// EXT_vertex_array did, and programs rely on that.
bool* find_flag(Context& context, GLenum cap) {
    const StateRow* const row = find_switch(cap);
    if (row == nullptr) {
        error(context, GL_INVALID_ENUM,
              cap - GL_LIGHT0 < 8u ? SPANGLE_TEXT("cap is beyond the lights of this build (SPANGLE_LIGHTS)")
                                   : nullptr);
        return nullptr;
    }
    if (row->left_out()) {
        error(context, GL_INVALID_OPERATION, row->missing);
        return nullptr;
    }
    return reinterpret_cast<bool*>(reinterpret_cast<unsigned char*>(&context) +
                                   offset_of(context, *row, cap, sizeof(bool)));
}

void set(Context& context, GLenum cap, bool on) {
    bool* const flag = find_flag(context, cap);
    if (flag == nullptr || *flag == on)
        return;
    *flag = on;
    const auto offset = reinterpret_cast<unsigned char*>(flag) - reinterpret_cast<unsigned char*>(&context);
    context.changed(derived_from(static_cast<std::size_t>(offset)));
#if SPANGLE_FEATURE_LIGHTING
    if (has_color_material && on && cap == GL_COLOR_MATERIAL)
        color_material_enabled(context);
#endif
}

} // namespace

namespace cmd {

void Enable(Context& context, GLenum cap) {
    set(context, cap, true);
}

void Disable(Context& context, GLenum cap) {
    set(context, cap, false);
}

GLboolean IsEnabled(Context& context, GLenum cap) {
    const bool* const flag = find_flag(context, cap);
    return flag != nullptr && *flag;
}

} // namespace cmd

} // namespace spangle::gl
