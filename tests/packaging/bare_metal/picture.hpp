#pragma once

#include <cstdint>

/// Draws and gives the picture's name; 0: something failed.
std::uint32_t picture_hash();
