// The code that runs fragments is compiled once for each instruction set that a build can choose at run time.
// All names of that code lie in a namespace of the instruction set, so that no two sets share a function.
// Otherwise the linker would keep one of two equal functions, whose instructions the processor may lack.
// Types that all sets share lie outside of the namespace.
#pragma once

#ifndef SPANGLE_INSTRUCTIONS
/// The namespace of the instruction set. `base` is the set of the compiler's options, and avx2 is that of
/// chain_avx2.cpp.
#define SPANGLE_INSTRUCTIONS base
#endif
