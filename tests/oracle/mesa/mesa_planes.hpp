// Draws random states with Mesa, in a program of its own.
#pragma once

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/oracle/mesa/states.hpp"

namespace spangle::oracle {

inline constexpr std::size_t bytes_of_drawing = std::size_t{state_size} * state_size * pixel_channels;

/// Returns the planes of `count` drawings, one behind the other; none if Mesa failed.
inline Planes draw_with_mesa(const Family& family, int first, int count) {
    const std::string file = testing::TempDir() + "mesa_states_" + family.id + std::to_string(getpid());
    const std::string command = "ASAN_OPTIONS=detect_leaks=0 GALLIUM_DRIVER=" + std::string(family.driver) +
                                " '" MESA_STATES "' " + std::string(family.id) + " '" + file + "' " +
                                std::to_string(first) + " " + std::to_string(count);
    if (std::system(command.c_str()) != 0)
        return {};
    Planes all(bytes_of_drawing * static_cast<std::size_t>(count));
    std::ifstream in(file, std::ios::binary);
    in.read(reinterpret_cast<char*>(all.data()), static_cast<std::streamsize>(all.size()));
    std::remove(file.c_str());
    return in ? all : Planes();
}

} // namespace spangle::oracle
