// Bytes that claim to be a packed model, as the process that reads a file hands them over: what the fuzzer
// and the everyday tests run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace bake_test {

/// The first byte chooses how what comes out is baked. False: the bytes are refused. Aborts when what was
/// taken cannot be drawn, or its header is empty.
bool run_packed_model(const std::uint8_t* data, std::size_t bytes);

/// Models of every kind of part, with pictures.
std::vector<std::vector<std::uint8_t>> packed_models();

} // namespace bake_test
