#pragma once
#include <spangle/hal/bus.hpp>
