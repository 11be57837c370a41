// The whole HAL: displays, buses, panels and what they are made of.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/hal/bus.hpp>
#include <spangle/hal/display.hpp>
#include <spangle/hal/frame_display.hpp>
#include <spangle/hal/mapped_display.hpp>
#include <spangle/hal/orientation.hpp>
#include <spangle/hal/panel.hpp>
#include <spangle/hal/panel_display.hpp>
#include <spangle/hal/readback.hpp>
#include <spangle/hal/result.hpp>
#include <spangle/hal/window.hpp>
#include <spangle/panels.hpp>
