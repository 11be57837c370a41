#pragma once

#include <cstdint>

/// Draws the picture and returns its hash, or 0 if something failed.
std::uint32_t picture_hash();
