# For 64-bit Arm, from another machine: Debian's cross compiler, its packages unpacked by tools/aarch64/sysroot, programs run under qemu.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
# Highway's NEON target has the instructions for AES, which types defined within it must be allowed to use, too.
set(CMAKE_CXX_FLAGS_INIT -march=armv8-a+crypto)

set(VERISIM_SYSROOT ${CMAKE_CURRENT_LIST_DIR}/../build/aarch64-sysroot CACHE PATH "Where tools/aarch64/sysroot unpacked")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES VERISIM_SYSROOT)
get_filename_component(CMAKE_SYSROOT ${VERISIM_SYSROOT} REALPATH)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_CROSSCOMPILING_EMULATOR "qemu-aarch64-static;-L;${CMAKE_SYSROOT}")
