// The reference precisions, for hosts.
#pragma once

namespace spangle::egl {

/// Makes EGL_PRECISION_DOUBLE_SPANGLE and EGL_PRECISION_SHADOW_..._SPANGLE exist. Call it before contexts of
/// those precisions are made.
void use_reference_engines();

} // namespace spangle::egl
