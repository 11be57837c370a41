// All named boards in one table.
#pragma once

#include "gc9a01.hpp"
#include "hx8347_8080.hpp"
#include "hx8347_spi.hpp"
#include "hx8357d_spi.hpp"
#include "ili9341_8080.hpp"
#include "ili9341_spi.hpp"
#include "ili9342c.hpp"
#include "ili9486_8080.hpp"
#include "ili9488_spi.hpp"
#include "sh1106_i2c.hpp"
#include "ssd0303_i2c.hpp"
#include "ssd0323_spi.hpp"
#include "ssd1306_128x32.hpp"
#include "ssd1306_i2c.hpp"
#include "ssd1306_spi.hpp"
#include "ssd1327_i2c.hpp"
#include "ssd1327_spi.hpp"
#include "ssd1331_spi.hpp"
#include "ssd1351_spi.hpp"
#include "st7735_128x128.hpp"
#include "st7735_128x160.hpp"
#include "st7735_80x160.hpp"
#include "st7789_135x240.hpp"
#include "st7789_170x320.hpp"
#include "st7789_172x320.hpp"
#include "st7789_240.hpp"
#include "st7789_240x280.hpp"
#include "st7789_240x320.hpp"
#include "st7796s_spi.hpp"

namespace spangle::boards {

/// Every board of these headers, in the order in which tools list them.
inline constexpr const hal::Board* all[] = {
    &ili9341_spi,    &ili9341_8080,   &st7789_240,     &st7789_135x240, &st7789_240x320, &st7735_128x160,
    &st7789_240x280, &st7789_170x320, &st7789_172x320, &st7735_128x128, &st7735_80x160,  &ili9342c,
    &ili9486_8080,   &ili9488_spi,    &st7796s_spi,    &hx8357d_spi,    &gc9a01,         &ssd1306_i2c,
    &ssd1306_128x32, &ssd1306_spi,    &sh1106_i2c,     &ssd1327_spi,    &ssd1327_i2c,    &ssd0323_spi,
    &ssd0303_i2c,    &ssd1351_spi,    &ssd1331_spi,    &hx8347_8080,    &hx8347_spi,
};

} // namespace spangle::boards
