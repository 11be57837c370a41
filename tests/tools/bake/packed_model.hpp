// Bytes that claim to be a packed model, as the process that reads a file hands them over. The fuzzer and the
// everyday tests unpack and bake them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace bake_test {

/// Unpacks and bakes a model; the first byte chooses how it is baked. Returns false if the bytes are refused.
/// Aborts if an accepted model cannot be drawn, or its header is empty.
bool run_packed_model(const std::uint8_t* data, std::size_t bytes);

/// Returns models of every kind of part, with pictures.
std::vector<std::vector<std::uint8_t>> packed_models();

} // namespace bake_test
