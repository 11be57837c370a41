// A gauge of a battery's charge for a display of 240x240 pixels.
#pragma once

/// Draws the whole picture. `charge` is a percentage from 0 to 100.
void draw_gauge(int charge);
