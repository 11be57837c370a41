// GetString returns vendor, renderer, the GL version of this build, and its extensions (GL 1.3, 6.1.11).
#include "gl/api/generated/commands.hpp"
#include "gl/api/generated/extensions.hpp"
#include "gl/context/context.hpp"
#include "gl/context/gl_version.hpp"
#include "gl/context/version.hpp"

namespace spangle::gl {

namespace {

#define NUMBER(version) version " Spangle " SPANGLE_VERSION
constexpr const char* version = gl_minor == 5   ? NUMBER("1.5")
                                : gl_minor == 4 ? NUMBER("1.4")
                                : gl_minor == 3 ? NUMBER("1.3")
                                                : NUMBER("1.0") " (a subset of 1.3)";
#undef NUMBER

} // namespace

namespace cmd {

const GLubyte* GetString(Context& context, GLenum name) {
    const char* text = nullptr;
    switch (name) {
    case GL_VENDOR:
        text = "Spangle";
        break;
    case GL_RENDERER:
        text = "Spangle fixed point";
        break;
    case GL_VERSION:
        text = version;
        break;
    case GL_EXTENSIONS:
        text = extensions;
        break;
    default:
        error(context, GL_INVALID_ENUM);
    }
    return reinterpret_cast<const GLubyte*>(text);
}

} // namespace cmd

} // namespace spangle::gl
