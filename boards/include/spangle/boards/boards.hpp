// Every named board, as one table.
#pragma once

#include "ili9341_8080.hpp"
#include "ili9341_spi.hpp"
#include "st7735_128x160.hpp"
#include "st7789_135x240.hpp"
#include "st7789_240.hpp"
#include "st7789_240x320.hpp"

namespace spangle::boards {

inline constexpr const hal::Board* all[] = {
    &ili9341_spi, &ili9341_8080, &st7789_240, &st7789_135x240, &st7789_240x320, &st7735_128x160,
};

} // namespace spangle::boards
