// The panels Spangle knows: a header for each family, and a table of all. Registers and times come from the
// controllers' datasheets; where a datasheet leaves the set-up to the module's maker, the values are those
// that modules are known to come up with.
#pragma once

#include <spangle/panels/gc9a01.hpp>
#include <spangle/panels/hx8347.hpp>
#include <spangle/panels/hx8357d.hpp>
#include <spangle/panels/ilitek.hpp>
#include <spangle/panels/oled_mono.hpp>
#include <spangle/panels/oled_windowed.hpp>
#include <spangle/panels/st7735.hpp>
#include <spangle/panels/st7789.hpp>
#include <spangle/panels/st7796s.hpp>

namespace spangle::hal::panels {

/// Every panel, as one table.
inline constexpr const PanelDesc* all[] = {
    &ili9341_240x320,    &st7789_240x320,  &st7789_240x280,   &st7789_240x240,       &st7789_172x320,
    &st7789_170x320,     &st7789_135x240,  &st7735_128x160,   &st7735_128x160_green, &st7735_128x128_green,
    &st7735_128x128_red, &st7735_80x160,   &st7735_80x160_26, &ili9342c_320x240,     &ili9486_320x480,
    &ili9488_320x480,    &st7796s_320x480, &hx8357d_320x480,  &gc9a01_240x240,       &ssd1306_128x64,
    &ssd1306_128x32,     &sh1106_128x64,   &ssd0303_96x16,    &ssd1327_128x128,      &ssd0323_128x64,
    &ssd1351_128x128,    &ssd1331_96x64,   &hx8347_240x320,
};

} // namespace spangle::hal::panels
