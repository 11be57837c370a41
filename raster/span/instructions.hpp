// The code that runs fragments is compiled once for each instruction set that a build can choose at run time.
// All names of that code lie in a namespace of the set, so that no two sets share a function: the linker
// would keep one of them, and a processor may lack its instructions. Types that all sets share lie outside of
// that namespace.
#pragma once

#ifndef SPANGLE_INSTRUCTIONS
/// The namespace of the set: base is what the compiler's options allow, and avx2 is that of chain_avx2.cpp.
#define SPANGLE_INSTRUCTIONS base
#endif
