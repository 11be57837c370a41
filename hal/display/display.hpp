#pragma once
#include <spangle/hal/display.hpp>
