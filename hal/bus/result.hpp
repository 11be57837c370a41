#pragma once
#include <spangle/hal/result.hpp>
