// A charge gauge for a 240x240 display.
#pragma once

/// Draws the whole picture; `charge` from 0 to 100 percent.
void draw_gauge(int charge);
