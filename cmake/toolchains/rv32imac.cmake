# For RV32IMAC with Debian's gcc-riscv64-unknown-elf, which has no C++ headers. The build takes C++ headers from the Arm package, whose
# compiler has the same version, and C headers from picolibc.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR rv32imac)
set(CMAKE_CXX_COMPILER riscv64-unknown-elf-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(headers "-isystem /usr/include/newlib/c++/12.2.1 -isystem /usr/include/newlib/c++/12.2.1/arm-none-eabi -isystem /usr/lib/picolibc/riscv64-unknown-elf/include")
set(CMAKE_CXX_FLAGS_INIT "-march=rv32imac -mabi=ilp32 -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-tree-loop-distribute-patterns -ffunction-sections -fdata-sections ${headers}")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostartfiles -nostdlib -Wl,--gc-sections")
set(CMAKE_CXX_STANDARD_LIBRARIES -lgcc)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
